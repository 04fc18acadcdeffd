//! Running error analysis: a double together with a bound of its distance from the exact result.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::arithmetic::{Arithmetic, square_root};

/// Half a unit in the last place of 1: a sum, difference, product, quotient or root r has a rounding
/// error of at most HALF_UNIT·|r|, if it is not subnormal.
const HALF_UNIT: f64 = f64::EPSILON / 2.0;

/// The smallest double above 0; twice the largest rounding error of a subnormal result.
const SMALLEST: f64 = f64::from_bits(1);

/// A value and a bound of its error: the exact result of the same operations on the same inputs is in
/// `value - error ..= value + error`.
///
/// Inputs count as exact. The bound is rigorous: whatever is rounded while it is computed is rounded
/// up. It is infinite where nothing is known: after an overflow, after a division by what may be 0, and
/// for the root of what may be negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The same bits that evaluation in doubles gives.
    pub value: f64,
    /// How far the exact result can be from it.
    pub error: f64,
}

impl Bounded {
    /// A number that is exact.
    #[inline]
    pub const fn exact(value: f64) -> Self {
        let error = if value.is_finite() {
            0.0
        } else {
            f64::INFINITY
        };
        Bounded { value, error }
    }

    /// The sign of the exact result, if the bound decides it.
    #[inline]
    pub fn sign(self) -> Option<Ordering> {
        if self.value > self.error {
            Some(Ordering::Greater)
        } else if -self.value > self.error {
            Some(Ordering::Less)
        } else if self.value == 0.0 && self.error == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// A value with the bounds of what it inherits from its operands and of its own rounding.
    #[inline]
    fn new(value: f64, inherited: f64, rounding: f64) -> Self {
        let error = sum_above(inherited, rounding);
        let known = value.is_finite() && !error.is_nan();
        Bounded {
            value,
            error: if known { error } else { f64::INFINITY },
        }
    }
}

/// An upper bound of a + b, which are not negative.
#[inline]
fn sum_above(a: f64, b: f64) -> f64 {
    let sum = a + b;
    // A sum with 0 is exact.
    if a == 0.0 || b == 0.0 {
        sum
    } else {
        sum.next_up()
    }
}

/// An upper bound of a·b, which are not negative.
#[inline]
fn product_above(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        0.0
    } else {
        (a * b).next_up()
    }
}

/// An upper bound of the rounding error of a sum or root, which is exact where it is subnormal.
#[inline]
fn rounding(result: f64) -> f64 {
    product_above(HALF_UNIT, result.abs())
}

/// An upper bound of the rounding error of a product or quotient.
#[inline]
fn rounding_with_underflow(result: f64) -> f64 {
    if result.abs() <= f64::MIN_POSITIVE {
        SMALLEST
    } else {
        rounding(result)
    }
}

impl Add for Bounded {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let exact = self.value == 0.0 || other.value == 0.0;
        let rounding = if exact { 0.0 } else { rounding(value) };
        Bounded::new(value, sum_above(self.error, other.error), rounding)
    }
}

impl Sub for Bounded {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        // (a + δ)(b + ε) − ab = aε + bδ + δε
        let value = self.value * other.value;
        let first = product_above(self.value.abs(), other.error);
        let second = product_above(other.value.abs(), self.error);
        let third = product_above(self.error, other.error);
        let inherited = sum_above(sum_above(first, second), third);
        let exact = self.value == 0.0 || other.value == 0.0;
        let rounding = if exact {
            0.0
        } else {
            rounding_with_underflow(value)
        };
        Bounded::new(value, inherited, rounding)
    }
}

impl Div for Bounded {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        // (a + δ)/(b + ε) − a/b = (δ − (a/b)ε)/(b + ε)
        let value = self.value / other.value;
        let below = match other.error == 0.0 {
            true => other.value.abs(),
            false => (other.value.abs() - other.error).next_down(),
        };
        if below.is_nan() || below <= 0.0 {
            let error = f64::INFINITY;
            return Bounded { value, error };
        }
        let exact = self.value == 0.0;
        let rounding = if exact {
            0.0
        } else {
            rounding_with_underflow(value)
        };
        let quotient = sum_above(value.abs(), rounding);
        let above = sum_above(self.error, product_above(quotient, other.error));
        let inherited = if above == 0.0 {
            0.0
        } else {
            (above / below).next_up()
        };
        Bounded::new(value, inherited, rounding)
    }
}

impl Neg for Bounded {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Bounded {
            value: -self.value,
            error: self.error,
        }
    }
}

impl Add<f64> for Bounded {
    type Output = Self;

    #[inline]
    fn add(self, other: f64) -> Self {
        self + Bounded::exact(other)
    }
}

impl Sub<f64> for Bounded {
    type Output = Self;

    #[inline]
    fn sub(self, other: f64) -> Self {
        self - Bounded::exact(other)
    }
}

impl Mul<f64> for Bounded {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        self * Bounded::exact(other)
    }
}

impl Div<f64> for Bounded {
    type Output = Self;

    #[inline]
    fn div(self, other: f64) -> Self {
        self / Bounded::exact(other)
    }
}

impl Arithmetic for Bounded {
    #[inline]
    fn constant(value: f64) -> Self {
        Bounded::exact(value)
    }

    #[inline]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    #[inline]
    fn square_root(self) -> Self {
        let value = square_root(self.value);
        if self.error > self.value {
            let error = f64::INFINITY;
            return Bounded { value, error };
        }
        // |√(a + δ) − √a| ≤ |δ|/√a
        let inherited = match self.error == 0.0 {
            true => 0.0,
            false => (self.error / value.next_down()).next_up(),
        };
        Bounded::new(value, inherited, rounding(value))
    }
}
