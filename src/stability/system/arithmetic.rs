//! What the program of a system is run in: doubles with a bound, enclosures with many digits, exact sums of sines.

use sextic_codegen::arithmetic::Arithmetic;

use crate::algebra::arithmetic::Arithmetic as Ring;
use crate::algebra::budget::Exhausted;
use crate::algebra::interval::{Interval, Intervals};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};

use super::real::Real;

/// Why a program has no value in an arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::stability) enum NoValue {
    /// It divides by what is 0, or not told from it.
    Division,
    /// It takes the root of what is negative, or not told from that.
    Root,
    /// The value is no finite sum of sines and cosines, or is too long.
    NotExact,
}

impl From<Exhausted> for NoValue {
    fn from(_: Exhausted) -> Self {
        NoValue::NotExact
    }
}

/// The double nearest to a number, and how far it is away; infinite where there is none.
pub(super) fn nearest(number: &Rational) -> Real {
    let centre = number.to_f64().value();
    match Rational::try_from(centre) {
        Ok(exact) => Real::new(centre, above(&(number - exact))),
        Err(_) => Real::new(centre, f64::INFINITY),
    }
}

/// A double that is not below a number's absolute value.
pub(super) fn above(number: &Rational) -> f64 {
    match number.is_zero() {
        true => 0.0,
        false => number.to_f64().value().abs() * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE,
    }
}

/// All numbers of an interval.
pub(super) fn ball(interval: &Interval, intervals: &Intervals) -> Real {
    let [low, high] = intervals.bounds(interval);
    let centre = ((&low + &high) / Rational::from(2)).to_f64().value();
    let Ok(exact) = Rational::try_from(centre) else {
        return Real::new(centre, f64::INFINITY);
    };
    let [below, over] = [&exact - low, high - exact].map(|own| above(&own));
    Real::new(centre, below.max(over))
}

/// Doubles with a bound of their error.
pub(super) struct Reals;

impl Arithmetic for Reals {
    type Value = Real;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<Real, NoValue> {
        Ok(nearest(value))
    }

    fn negative(&mut self, a: &Real) -> Result<Real, NoValue> {
        Ok(-*a)
    }

    fn sum(&mut self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        Ok(*a + *b)
    }

    fn difference(&mut self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        Ok(*a - *b)
    }

    fn product(&mut self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        Ok(*a * *b)
    }

    fn quotient(&mut self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        a.quotient(*b).ok_or(NoValue::Division)
    }

    fn square_root(&mut self, a: &Real) -> Result<Real, NoValue> {
        a.square_root().ok_or(NoValue::Root)
    }
}

impl Ring for Reals {
    type Element = Real;
    type Error = std::convert::Infallible;

    fn zero(&self) -> Real {
        Real::ZERO
    }

    fn one(&self) -> Real {
        Real::ONE
    }

    fn is_zero(&self, a: &Real) -> bool {
        a.is_zero()
    }

    fn sum(&self, a: &Real, b: &Real) -> Result<Real, Self::Error> {
        Ok(*a + *b)
    }

    fn negative(&self, a: &Real) -> Real {
        -*a
    }

    fn product(&self, a: &Real, b: &Real) -> Result<Real, Self::Error> {
        Ok(*a * *b)
    }
}

/// Enclosures with any number of digits.
pub(super) struct Enclosures<'a>(pub &'a Intervals);

impl Arithmetic for Enclosures<'_> {
    type Value = Interval;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<Interval, NoValue> {
        Ok(self.0.rational(value))
    }

    fn negative(&mut self, a: &Interval) -> Result<Interval, NoValue> {
        Ok(self.0.negative(a))
    }

    fn sum(&mut self, a: &Interval, b: &Interval) -> Result<Interval, NoValue> {
        let Ok(sum) = self.0.sum(a, b);
        Ok(sum)
    }

    fn difference(&mut self, a: &Interval, b: &Interval) -> Result<Interval, NoValue> {
        let Ok(difference) = self.0.difference(a, b);
        Ok(difference)
    }

    fn product(&mut self, a: &Interval, b: &Interval) -> Result<Interval, NoValue> {
        let Ok(product) = self.0.product(a, b);
        Ok(product)
    }

    fn quotient(&mut self, a: &Interval, b: &Interval) -> Result<Interval, NoValue> {
        self.0.quotient(a, b).ok_or(NoValue::Division)
    }

    fn square_root(&mut self, a: &Interval) -> Result<Interval, NoValue> {
        self.0.square_root(a).ok_or(NoValue::Root)
    }
}

/// Exact sums of sines and cosines of rational angles.
///
/// What divides must be a rational number, and a radicand the square of one: other quotients and roots are no such
/// sums.
pub(super) struct Sums<'a>(pub &'a TrigonometricSums);

impl Sums<'_> {
    fn product_of(&self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        Ok(self.0.product(a, b)?)
    }
}

/// A sum without sines as the number that it is.
pub(in crate::stability) fn rational(sum: &Sum) -> Option<Rational> {
    let mut terms = sum.terms();
    match (terms.next(), terms.next()) {
        (None, _) => Some(Rational::ZERO),
        (Some((angle, [own, _])), None) if angle.is_zero() => Some(own.clone()),
        _ => None,
    }
}

impl Arithmetic for Sums<'_> {
    type Value = Sum;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<Sum, NoValue> {
        Ok(Sum::from(value.clone()))
    }

    fn negative(&mut self, a: &Sum) -> Result<Sum, NoValue> {
        Ok(self.0.negative(a))
    }

    fn sum(&mut self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        Ok(self.0.sum(a, b)?)
    }

    fn difference(&mut self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        Ok(self.0.difference(a, b)?)
    }

    fn product(&mut self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        self.product_of(a, b)
    }

    fn quotient(&mut self, a: &Sum, b: &Sum) -> Result<Sum, NoValue> {
        match rational(b) {
            Some(below) if below.is_zero() => Err(NoValue::Division),
            Some(below) => Ok(a.scaled(&(Rational::ONE / below))),
            None => Err(NoValue::NotExact),
        }
    }

    fn square_root(&mut self, a: &Sum) -> Result<Sum, NoValue> {
        let radicand = rational(a).ok_or(NoValue::NotExact)?;
        if radicand < Rational::ZERO {
            return Err(NoValue::Root);
        }
        let root = exact_root(&radicand).ok_or(NoValue::NotExact)?;
        Ok(Sum::from(root))
    }
}

/// √a of a number that is a square and not below 0.
fn exact_root(square: &Rational) -> Option<Rational> {
    use dashu_base::{SquareRoot, UnsignedAbs};
    let above = square.numerator().clone().unsigned_abs().sqrt();
    let below = square.denominator().sqrt();
    let root = Rational::from(above) / Rational::from(below);
    (&root * &root == *square).then_some(root)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::budget::Budget;

    #[test]
    fn roots_and_quotients_are_exact_where_they_are_rational() {
        let sums = TrigonometricSums::new(Budget::new(100));
        let mut exact = Sums(&sums);
        let number =
            |above: i32, below: i32| Sum::from(Rational::from(above) / Rational::from(below));
        assert_eq!(exact.square_root(&number(9, 4)), Ok(number(3, 2)));
        assert_eq!(exact.square_root(&number(2, 1)), Err(NoValue::NotExact));
        assert_eq!(exact.square_root(&number(-4, 1)), Err(NoValue::Root));
        let sine = Sum::sine(&Rational::ONE);
        assert_eq!(
            exact.quotient(&sine, &number(2, 1)),
            Ok(sine.scaled(&(Rational::from(1) / Rational::from(2))))
        );
        assert_eq!(exact.quotient(&sine, &number(0, 1)), Err(NoValue::Division));
        assert_eq!(exact.quotient(&sine, &sine), Err(NoValue::NotExact));
    }

    #[test]
    fn the_nearest_double_counts_what_it_leaves() {
        let tenth = Rational::from(1) / Rational::from(10);
        let own = nearest(&tenth);
        assert!(own.centre == 0.1 && own.radius > 0.0 && own.radius < 1e-17);
        assert_eq!(nearest(&Rational::from(3)), Real::exact(3.0));
        let huge = (0..400).fold(Rational::ONE, |power, _| power * Rational::from(10));
        assert!(!nearest(&huge).is_finite());
    }
}
