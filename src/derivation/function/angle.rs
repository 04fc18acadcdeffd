//! Sines and cosines, and the angles of vectors.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{algebra, quantity, units};
use crate::derivation::quantity::{Quantities, Quantity, Value};
use crate::language::built_in::Circular;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Span};
use crate::language::unit::Unit;

impl Elaborator {
    /// The sine, cosine, tangent or cotangent of an angle.
    pub(super) fn circular(
        &mut self,
        function: Circular,
        argument: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let quantity = self.scalar(argument)?;
        if let Some(unit) = quantity.unit.filter(|unit| *unit != Unit::one()) {
            return Err(units(&unit, &Unit::one(), &argument.span)
                .with_help("sines and cosines are taken of angles"));
        }
        let angle = self
            .ring
            .angle(&quantity.value)
            .ok_or_else(|| no_angle(&quantity.value, &argument.span))?;
        let (cosine, sine) = self
            .ring
            .cosine_and_sine(&angle)
            .map_err(|error| algebra(error, span))?;
        let (above, below) = match function {
            Circular::Sine => return Ok(Quantity::new(sine, Unit::one()).scalar()),
            Circular::Cosine => return Ok(Quantity::new(cosine, Unit::one()).scalar()),
            Circular::Tangent => (sine, cosine),
            Circular::Cotangent => (cosine, sine),
        };
        let above = Quantity::new(above, Unit::one()).scalar();
        self.divide(&above, &Quantity::new(below, Unit::one()), span)
    }

    /// The angle of the vector (x, y), which must not vanish.
    pub(super) fn direction(
        &mut self,
        x: &Expression,
        y: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (first, second) = (self.scalar(x)?, self.scalar(y)?);
        let arithmetic = Quantities(&self.ring);
        let squares = arithmetic
            .product(&first, &first)
            .and_then(|a| arithmetic.sum(&a, &arithmetic.product(&second, &second)?))
            .map_err(|error| quantity(error, span))?;
        if squares.value.is_zero() {
            let message = "the zero vector has no angle";
            return Err(
                Diagnostic::new(DiagnosticKind::DivisionByZero, span.clone(), message)
                    .with_label("both components are 0")
                    .with_help("give a component that is not 0"),
            );
        }
        self.require_non_zero(&squares.value, span)?;
        let value = match self.ring.direction(&first.value, &second.value) {
            Err(AlgebraError::UnknownSign) => return Err(self.unknown_length(&squares, span)?),
            value => value.map_err(|error| algebra(error, span))?,
        };
        Ok(Quantity::new(value, Unit::one()).scalar())
    }

    /// The error for a vector whose length is a root that cannot be taken.
    fn unknown_length(&self, squares: &Quantity, span: &Span) -> Result<Diagnostic, Diagnostic> {
        let shown = Notation::Unicode.expression(&self.present(&squares.value, span)?);
        let message = format!("the length of this vector, the root of {shown}, cannot be told");
        let error = Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message);
        Ok(error
            .with_label("its length depends on a sign that is not known")
            .with_help("state the sign of what is squared: `parameter … > 0` or `assume … > 0`"))
    }
}

/// The error for a sine or cosine of what is no angle.
fn no_angle(argument: &Fraction, span: &Span) -> Diagnostic {
    let error = algebra(AlgebraError::NotAnAngle, span);
    match argument.as_constant() {
        Some(_) => error
            .with_label("a number, whose sine is not known exactly")
            .with_help(
                "declare an angle in its place, such as `angle φ`, and leave its value open",
            ),
        None => error,
    }
}
