//! Polynomials in a variable: their coefficients and Hurwitz determinants.

use std::collections::BTreeMap;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::differential::Differential;
use crate::algebra::fraction::Fraction;
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::symbol::Symbol;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::algebra;
use crate::derivation::quantity::{Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Span};

impl Elaborator {
    /// The coefficient of a power of the variable.
    pub(super) fn coefficient(
        &mut self,
        polynomial: &Expression,
        variable: &Expression,
        power: &Expression,
    ) -> Result<Value, Diagnostic> {
        let power = self.natural(power)?;
        let (variable, polynomial, coefficients) = self.coefficients(polynomial, variable)?;
        let per = variable
            .unit
            .unwrap_or_default()
            .power(&Rational::from(-(power as i64)));
        let coefficient = coefficients.get(&(power as u32)).cloned();
        Ok(Quantity {
            value: coefficient.unwrap_or(self.ring.zero()),
            unit: polynomial.unit.map(|unit| unit.product(&per)),
        }
        .scalar())
    }

    /// The leading principal minor of size k of Hurwitz' matrix (a₁, a₃, …; a₀, a₂, …; 0, a₁, …) of
    /// a₀λⁿ + a₁λⁿ⁻¹ + … + aₙ.
    pub(super) fn hurwitz(
        &mut self,
        polynomial: &Expression,
        variable: &Expression,
        size: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (variable, polynomial, coefficients) = self.coefficients(polynomial, variable)?;
        let degree = coefficients.keys().next_back().copied().unwrap_or(0);
        let size = self.positive(size)?;
        if size > degree as usize {
            let message = format!("a polynomial of degree {degree} has no minor of size {size}");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("too large")
                    .with_help(format!("its Hurwitz matrix has the sizes 1, …, {degree}")),
            );
        }
        let per = variable.unit.unwrap_or_default();
        let entry = |row: usize, column: usize| {
            let place = 2 * (column + 1);
            let index = place
                .checked_sub(row + 1)
                .filter(|index| *index <= degree as usize);
            let power = index.map(|index| degree - index as u32);
            let value = power.and_then(|power| coefficients.get(&power).cloned());
            let unit = power
                .zip(polynomial.unit.as_ref())
                .map(|(power, unit)| unit.product(&per.power(&Rational::from(-i64::from(power)))));
            Quantity {
                unit: value.as_ref().and(unit),
                value: value.unwrap_or(self.ring.zero()),
            }
        };
        let matrix = Matrix::from_fn(size, size, entry);
        Ok(self.determinant(&matrix, span)?.scalar())
    }

    /// A variable, a polynomial, and its coefficients by the power of the variable.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where the expression is no polynomial in the variable.
    fn coefficients(
        &mut self,
        polynomial: &Expression,
        variable: &Expression,
    ) -> Result<(Quantity, Quantity, BTreeMap<u32, Fraction>), Diagnostic> {
        let quantity = self.scalar(variable)?;
        let symbol = self.symbol(&quantity, &variable.span)?;
        let value = self.scalar(polynomial)?;
        let coefficients = self.coefficients_of(&value.value, symbol, &polynomial.span)?;
        Ok((quantity, value, coefficients))
    }

    /// The coefficients of an element that is a polynomial in a symbol.
    pub(crate) fn coefficients_of(
        &mut self,
        value: &Fraction,
        symbol: Symbol,
        span: &Span,
    ) -> Result<BTreeMap<u32, Fraction>, Diagnostic> {
        let mut coefficients = BTreeMap::new();
        let partial = Differential::partial(symbol, &self.ring);
        let mut polynomial = !value.denominator().contains(symbol);
        for (power, coefficient) in value.numerator().coefficients_in(symbol) {
            let coefficient = self.ring.fraction(&coefficient, value.denominator());
            let coefficient = coefficient.map_err(|error| algebra(error, span))?;
            let change = self.ring.differentiate(&coefficient, &partial);
            polynomial &= change.map_err(|error| algebra(error, span))?.is_zero();
            coefficients.insert(power, coefficient);
        }
        if polynomial {
            return Ok(coefficients);
        }
        let message = "this is not a polynomial in the variable";
        Err(
            Diagnostic::new(DiagnosticKind::NotPolynomial, span.clone(), message)
                .with_label("the variable stands below a line, under a root or in an angle")
                .with_help(
                    "multiply by what stands below the line, or expand it with `truncate(…)` first",
                ),
        )
    }
}
