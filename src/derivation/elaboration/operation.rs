//! Sums, products, quotients, powers and roots.

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::derivation::quantity::{Quantities, Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{BinaryOperator, Expression, Span};
use crate::language::unit::{Unit, small_integer};

use super::Elaborator;
use super::error::{algebra, mismatch, quantity, sides};
use super::matrix::identity;

impl Elaborator {
    /// What an operator makes of two expressions.
    pub(super) fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &Expression,
        right: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        if operator == BinaryOperator::Power {
            return self.power(left, right, span);
        }
        let (a, b) = (self.value(left)?, self.value(right)?);
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => {
                if a.shape() != b.shape() {
                    return Err(mismatch("added", &a, &b, left, right, span));
                }
                let sum = a.zip_with(&b, |a, b| match operator {
                    BinaryOperator::Add => Quantities(&self.ring).sum(a, b),
                    _ => Quantities(&self.ring).difference(a, b),
                });
                sum.map_err(|error| sides(error, left, right, span))
            }
            BinaryOperator::Multiply => {
                let arithmetic = Quantities(&self.ring);
                let product = if a.shape() == (1, 1) {
                    b.try_map(|entry| arithmetic.product(a.at(0, 0), entry))
                } else if b.shape() == (1, 1) {
                    a.try_map(|entry| arithmetic.product(entry, b.at(0, 0)))
                } else if a.columns() == b.rows() {
                    a.product(&b, &arithmetic)
                } else {
                    return Err(mismatch("multiplied", &a, &b, left, right, span));
                };
                product.map_err(|error| sides(error, left, right, span))
            }
            BinaryOperator::Divide | BinaryOperator::Power => {
                if b.shape() != (1, 1) {
                    return Err(mismatch("divided", &a, &b, left, right, span)
                        .with_help("divide by a number, or multiply with `inverse(…)`"));
                }
                self.divide(&a, b.at(0, 0), &right.span)
            }
        }
    }

    /// Every entry divided by one quantity, which is required not to be 0.
    pub fn divide(&mut self, a: &Value, b: &Quantity, span: &Span) -> Result<Value, Diagnostic> {
        self.require_non_zero(&b.value, span)?;
        a.try_map(|entry| Quantities(&self.ring).quotient(entry, b))
            .map_err(|error| quantity(error, span))
    }

    /// Notes that an element must not be 0.
    pub fn require_non_zero(&mut self, element: &Fraction, span: &Span) -> Result<(), Diagnostic> {
        self.conditions
            .divide(element, &self.ring)
            .map_err(|error| algebra(error, span))
    }

    fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let Some(number) = self.number(exponent)? else {
            return Err(Diagnostic::new(
                DiagnosticKind::Unsupported,
                exponent.span.clone(),
                "an exponent must be a number",
            )
            .with_label("not a number")
            .with_help("integers and, of single quantities, halves are understood"));
        };
        let value = self.value(base)?;
        if let Some(count) = small_integer(&number) {
            return self.integer_power(&value, count, base, span);
        }
        let twice = &number + &number;
        match small_integer(&twice) {
            Some(halves) if value.shape() == (1, 1) => {
                let root = self.root(value.at(0, 0), span)?.scalar();
                self.integer_power(&root, halves, base, span)
            }
            _ => Err(Diagnostic::new(
                DiagnosticKind::Unsupported,
                exponent.span.clone(),
                format!("the exponent {number} is not supported"),
            )
            .with_label("neither an integer nor a half")
            .with_help("integers and, of single quantities, halves are understood")),
        }
    }

    fn integer_power(
        &mut self,
        base: &Value,
        exponent: i64,
        at: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        if base.shape() == (1, 1) {
            let base = base.at(0, 0);
            if exponent < 0 {
                self.require_non_zero(&base.value, &at.span)?;
            }
            let value = self
                .ring
                .power(&base.value, exponent)
                .map_err(|error| algebra(error, span))?;
            let unit = base
                .unit
                .as_ref()
                .map(|unit| unit.power(&Rational::from(exponent)));
            return Ok(Quantity {
                value,
                unit: if exponent == 0 {
                    Some(Unit::one())
                } else {
                    unit
                },
            }
            .scalar());
        }
        check_power(base, exponent, span)?;
        if exponent < 0 {
            return self.inverse(base, &at.span);
        }
        let mut power = identity(base.rows());
        for _ in 0..exponent {
            power = power
                .product(base, &Quantities(&self.ring))
                .map_err(|error| quantity(error, span))?;
        }
        Ok(power)
    }

    /// √q, which is real for q ≥ 0.
    pub fn root(&mut self, square: &Quantity, span: &Span) -> Result<Quantity, Diagnostic> {
        let value = self
            .ring
            .square_root(&square.value)
            .map_err(|error| algebra(error, span))?;
        self.conditions
            .root(&square.value, &self.ring)
            .map_err(|error| algebra(error, span))?;
        let half = Rational::ONE / Rational::from(2);
        Ok(Quantity {
            value,
            unit: square.unit.as_ref().map(|unit| unit.power(&half)),
        })
    }
}

/// Allows a power of a matrix.
fn check_power(base: &Value, exponent: i64, span: &Span) -> Result<(), Diagnostic> {
    let (rows, columns) = base.shape();
    let (kind, label) = match (base.is_square(), exponent) {
        (true, -1..=8) => return Ok(()),
        (true, _) => (DiagnosticKind::Budget, "not one of −1, 0, 1, …, 8"),
        (false, _) => (DiagnosticKind::Shape, "not square"),
    };
    let message = format!("a {rows}×{columns} matrix to the power {exponent}");
    Err(Diagnostic::new(kind, span.clone(), message)
        .with_label(label)
        .with_help("square matrices have the powers −1, 0, 1, …, 8"))
}
