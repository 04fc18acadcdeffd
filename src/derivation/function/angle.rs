//! Sines and cosines, and the angles of vectors.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::error::AlgebraError;
use crate::derivation::diagnostic::Diagnostic;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{algebra, quantity, units};
use crate::derivation::quantity::{Quantities, Quantity, Value};
use crate::derivation::syntax::{Expression, Span};
use crate::derivation::unit::Unit;

impl Elaborator {
    /// The sine, cosine, tangent or cotangent of an angle.
    pub(super) fn circular(
        &mut self,
        function: &str,
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
            .ok_or_else(|| algebra(AlgebraError::NotAnAngle, &argument.span))?;
        let (cosine, sine) = self
            .ring
            .cosine_and_sine(&angle)
            .map_err(|error| algebra(error, span))?;
        let (above, below) = match function {
            "sin" => return Ok(Quantity::new(sine, Unit::one()).scalar()),
            "cos" => return Ok(Quantity::new(cosine, Unit::one()).scalar()),
            "tan" => (sine, cosine),
            _ => (cosine, sine),
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
        self.require_non_zero(&squares.value, span)?;
        let value = self.ring.direction(&first.value, &second.value);
        Ok(Quantity::new(value.map_err(|error| algebra(error, span))?, Unit::one()).scalar())
    }
}
