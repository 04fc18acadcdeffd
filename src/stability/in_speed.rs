//! Polynomials in the wind speed whose coefficients are exact sums of sines: numbers that programs are run in.

use sextic_codegen::arithmetic::Arithmetic;

use crate::algebra::arithmetic::Arithmetic as Ring;
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::system::arithmetic::{NoValue, rational};

/// The coefficients of a polynomial in the wind speed, that of the power 0 first.
pub(super) type InSpeed = Vec<Sum>;

/// Polynomials in the wind speed; what divides must be a rational number, and there are no roots.
pub(super) struct InSpeeds<'a>(pub &'a TrigonometricSums);

impl InSpeeds<'_> {
    /// A polynomial that does not depend on the speed.
    pub fn constant(&self, own: Sum) -> InSpeed {
        Univariate(self.0).polynomial(vec![own])
    }
}

impl Arithmetic for InSpeeds<'_> {
    type Value = InSpeed;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<InSpeed, NoValue> {
        Ok(InSpeeds::constant(self, Sum::from(value.clone())))
    }

    fn negative(&mut self, a: &InSpeed) -> Result<InSpeed, NoValue> {
        Ok(Univariate(self.0).negative(a))
    }

    fn sum(&mut self, a: &InSpeed, b: &InSpeed) -> Result<InSpeed, NoValue> {
        Ok(Univariate(self.0).sum(a, b)?)
    }

    fn difference(&mut self, a: &InSpeed, b: &InSpeed) -> Result<InSpeed, NoValue> {
        Ok(Univariate(self.0).difference(a, b)?)
    }

    fn product(&mut self, a: &InSpeed, b: &InSpeed) -> Result<InSpeed, NoValue> {
        Ok(Univariate(self.0).product(a, b)?)
    }

    fn quotient(&mut self, a: &InSpeed, b: &InSpeed) -> Result<InSpeed, NoValue> {
        let number = match b.as_slice() {
            [] => return Err(NoValue::Division),
            [number] => rational(number).ok_or(NoValue::NotExact)?,
            _ => return Err(NoValue::NotExact),
        };
        let factor = Rational::ONE / number;
        Ok(a.iter().map(|own| own.scaled(&factor)).collect())
    }

    fn square_root(&mut self, _: &InSpeed) -> Result<InSpeed, NoValue> {
        Err(NoValue::Root)
    }
}
