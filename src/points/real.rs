//! Real numbers: exact fractions as long as they are short, else enclosures.

use std::borrow::Cow;
use std::cmp::Ordering;

use dashu_base::{BitTest, SquareRoot, UnsignedAbs};

use crate::algebra::number::{Integer, Rational};

use super::enclosure::{DIGITS, Enclosure};

/// A real number.
#[derive(Clone, Debug)]
pub enum Real {
    /// A fraction.
    Exact(Rational),
    /// A number that is known within bounds.
    Enclosed(Enclosure),
}

impl From<Rational> for Real {
    fn from(number: Rational) -> Self {
        Real::Exact(number)
    }
}

impl Real {
    /// How long its fraction or its bounds are, in words.
    pub fn words(&self) -> usize {
        match self {
            Real::Exact(number) => bits(number) / 64,
            Real::Enclosed(_) => 2 * DIGITS / 64,
        }
    }

    /// Bounds of the number.
    pub fn enclosure(&self) -> Cow<'_, Enclosure> {
        match self {
            Real::Exact(number) => Cow::Owned(Enclosure::from(number)),
            Real::Enclosed(enclosure) => Cow::Borrowed(enclosure),
        }
    }

    /// The number, if it is known exactly.
    pub fn as_rational(&self) -> Option<&Rational> {
        match self {
            Real::Exact(number) => Some(number),
            Real::Enclosed(_) => None,
        }
    }

    /// Whether it is known to be 0.
    pub fn is_zero(&self) -> bool {
        self.as_rational().is_some_and(Rational::is_zero)
    }

    /// How it compares with 0; nothing where that is not known.
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Real::Exact(number) => Some(number.cmp(&Rational::ZERO)),
            Real::Enclosed(enclosure) if enclosure.is_positive() => Some(Ordering::Greater),
            Real::Enclosed(enclosure) if enclosure.is_negative() => Some(Ordering::Less),
            Real::Enclosed(_) => None,
        }
    }

    /// Whether the two may be one number.
    pub fn may_be(&self, other: &Real) -> bool {
        match (self, other) {
            (Real::Exact(a), Real::Exact(b)) => a == b,
            (a, b) => a.enclosure().meets(&b.enclosure()),
        }
    }

    /// Whether enough of it is known to be shown.
    pub fn is_legible(&self) -> bool {
        match self {
            Real::Exact(_) => true,
            Real::Enclosed(enclosure) => enclosure.is_legible(),
        }
    }

    /// As a person reads it: a fraction, or the digits that are known.
    pub fn display(&self) -> String {
        const DIGITS_SHOWN: usize = 20;
        match self {
            Real::Exact(number) => number.to_string(),
            Real::Enclosed(enclosure) => enclosure.display(DIGITS_SHOWN),
        }
    }
}

fn bits(number: &Rational) -> usize {
    number.numerator().bit_len() + number.denominator().bit_len()
}

/// Arithmetic of real numbers, which keeps fractions as long as they are not longer than so many bits.
#[derive(Clone, Copy, Debug)]
pub struct Reals {
    /// The most bits of numerator and denominator of an exact number.
    pub longest: usize,
}

impl Reals {
    /// The exact number, or bounds of it where it is too long.
    pub fn shortened(self, number: Rational) -> Real {
        let bits = bits(&number);
        match bits <= self.longest {
            true => Real::Exact(number),
            false => Real::Enclosed(Enclosure::from(&number)),
        }
    }

    /// −a
    pub fn negative(self, a: &Real) -> Real {
        match a {
            Real::Exact(a) => Real::Exact(-a.clone()),
            Real::Enclosed(a) => Real::Enclosed(a.negative()),
        }
    }

    /// a + b
    pub fn sum(self, a: &Real, b: &Real) -> Real {
        match (a, b) {
            (Real::Exact(a), Real::Exact(b)) => self.shortened(a + b),
            (a, b) if b.is_zero() => a.clone(),
            (a, b) if a.is_zero() => b.clone(),
            (a, b) => Real::Enclosed(a.enclosure().sum(&b.enclosure())),
        }
    }

    /// a·b
    pub fn product(self, a: &Real, b: &Real) -> Real {
        match (a, b) {
            (Real::Exact(a), Real::Exact(b)) => self.shortened(a * b),
            (a, b) if a.is_zero() || b.is_zero() => Real::Exact(Rational::ZERO),
            (a, b) => Real::Enclosed(a.enclosure().product(&b.enclosure())),
        }
    }

    /// 1/a; nothing where a may be 0.
    pub fn reciprocal(self, a: &Real) -> Option<Real> {
        match a {
            Real::Exact(a) if a.is_zero() => None,
            Real::Exact(a) => Some(self.shortened(Rational::ONE / a)),
            Real::Enclosed(a) => a.reciprocal().map(Real::Enclosed),
        }
    }

    /// √a ≥ 0; nothing where a may be below 0.
    pub fn square_root(self, a: &Real) -> Option<Real> {
        match a {
            Real::Exact(a) if *a < Rational::ZERO => None,
            Real::Exact(a) => match exact_root(a) {
                Some(root) => Some(self.shortened(root)),
                None => Enclosure::from(a).square_root().map(Real::Enclosed),
            },
            Real::Enclosed(a) => a.square_root().map(Real::Enclosed),
        }
    }

    /// aⁿ
    pub fn power(self, a: &Real, exponent: u32) -> Real {
        let (mut result, mut square, mut rest) = (Real::Exact(Rational::ONE), a.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(&result, &square);
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square);
            }
        }
        result
    }
}

/// √q of a fraction that is the square of one.
pub fn exact_root(square: &Rational) -> Option<Rational> {
    if *square < Rational::ZERO {
        return None;
    }
    let root = square.numerator().clone().unsigned_abs().sqrt();
    let below = square.denominator().sqrt();
    let root = Rational::from_parts(Integer::from(root), below);
    (&root * &root == *square).then_some(root)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// √n − 1 for n > 1.
    fn enclosed(n: i32) -> Real {
        let reals = Reals { longest: 64 };
        let root = reals.square_root(&Rational::from(n).into());
        reals.sum(&root.expect("a root"), &Rational::from(-1).into())
    }

    #[test]
    fn what_is_exactly_0_or_1_is_known_to_be() {
        let reals = Reals { longest: 64 };
        let (zero, one) = (Real::from(Rational::ZERO), Real::from(Rational::ONE));
        let own = enclosed(2);
        assert!(reals.product(&own, &zero).is_zero() && reals.product(&zero, &own).is_zero());
        for same in [reals.sum(&own, &zero), reals.sum(&zero, &own)] {
            assert!(same.may_be(&own) && same.as_rational().is_none());
        }
        assert_eq!(reals.power(&own, 0).as_rational(), one.as_rational());
        let four = Rational::from(4) / Rational::from(9);
        let root = reals.square_root(&four.into()).expect("a root");
        assert_eq!(root.display(), "2/3");
        assert!(reals.square_root(&Rational::from(-4).into()).is_none());
        assert!(reals.reciprocal(&zero).is_none());
    }

    #[test]
    fn a_sign_is_known_or_not() {
        let reals = Reals { longest: 64 };
        let own = enclosed(2);
        let nothing = reals.sum(&own, &reals.negative(&own));
        for (number, sign) in [
            (own.clone(), Some(Ordering::Greater)),
            (reals.negative(&own), Some(Ordering::Less)),
            (nothing, None),
            (Rational::ZERO.into(), Some(Ordering::Equal)),
            (Rational::from(-1).into(), Some(Ordering::Less)),
        ] {
            assert_eq!(number.sign(), sign, "{number:?}");
        }
    }

    #[test]
    fn long_fractions_are_enclosed() {
        let reals = Reals { longest: 64 };
        let long = Rational::from(Integer::ONE << 62);
        assert!(reals.shortened(long.clone()).as_rational().is_some());
        let longer = reals.shortened(&long * &long);
        assert!(longer.as_rational().is_none() && longer.may_be(&(&long * &long).into()));
    }
}
