//! Polynomials in the wind speed, whose coefficients are exact or enclosed.

use std::convert::Infallible;

use sextic_codegen::arithmetic::Arithmetic;

use crate::algebra::arithmetic::Arithmetic as Ring;
use crate::algebra::interval::{Interval, Intervals};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::system::arithmetic::{NoValue, rational};

/// The coefficients of a polynomial in the wind speed, that of the power 0 first.
pub(super) type InSpeed<E = Sum> = Vec<E>;

/// What a coefficient may be.
pub(super) trait Coefficients: Ring<Error: Into<NoValue>> {
    /// A number.
    fn number(&self, own: &Rational) -> Self::Element;

    /// cos and sin of an angle.
    fn direction(&self, angle: &Rational) -> [Self::Element; 2];

    /// A quotient, where it is known what divides.
    fn quotient(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, NoValue>;
}

/// Exact ones; what divides must be a rational number.
impl Coefficients for TrigonometricSums {
    fn number(&self, own: &Rational) -> Sum {
        Sum::from(own.clone())
    }

    fn direction(&self, angle: &Rational) -> [Sum; 2] {
        [Sum::cosine(angle), Sum::sine(angle)]
    }

    fn quotient(&self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        let number = rational(b).ok_or(NoValue::NotExact)?;
        match number.is_zero() {
            true => Err(NoValue::Division),
            false => Ok(a.scaled(&(Rational::ONE / number))),
        }
    }
}

/// Enclosures.
impl Coefficients for Intervals {
    fn number(&self, own: &Rational) -> Interval {
        self.rational(own)
    }

    fn direction(&self, angle: &Rational) -> [Interval; 2] {
        self.cosine_and_sine(angle)
    }

    fn quotient(&self, a: &Interval, b: &Interval) -> Result<Interval, NoValue> {
        Intervals::quotient(self, a, b).ok_or(NoValue::Division)
    }
}

impl From<Infallible> for NoValue {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

/// Polynomials in the wind speed; what divides must not depend on it, and there are no roots.
pub(super) struct InSpeeds<'a, C>(pub &'a C);

impl<C: Coefficients> InSpeeds<'_, C> {
    /// A polynomial that does not depend on the speed.
    pub fn constant(&self, own: C::Element) -> InSpeed<C::Element> {
        Univariate(self.0).polynomial(vec![own])
    }
}

impl<C: Coefficients> Arithmetic for InSpeeds<'_, C> {
    type Value = InSpeed<C::Element>;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<Self::Value, NoValue> {
        Ok(InSpeeds::constant(self, self.0.number(value)))
    }

    fn negative(&mut self, a: &Self::Value) -> Result<Self::Value, NoValue> {
        Ok(Univariate(self.0).negative(a))
    }

    fn sum(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, NoValue> {
        Univariate(self.0).sum(a, b).map_err(Into::into)
    }

    fn difference(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, NoValue> {
        Univariate(self.0).difference(a, b).map_err(Into::into)
    }

    fn product(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, NoValue> {
        Univariate(self.0).product(a, b).map_err(Into::into)
    }

    fn quotient(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, NoValue> {
        match b.as_slice() {
            [] => Err(NoValue::Division),
            [number] => a.iter().map(|own| self.0.quotient(own, number)).collect(),
            _ => Err(NoValue::NotExact),
        }
    }

    fn square_root(&mut self, _: &Self::Value) -> Result<Self::Value, NoValue> {
        Err(NoValue::Root)
    }
}
