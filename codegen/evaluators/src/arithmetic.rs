//! What an evaluator asks of a number.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Numbers that an evaluator can be run on: doubles, doubles with a bound of their error, lanes of
/// doubles.
pub trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// A constant.
    fn constant(value: f64) -> Self;

    /// self·factor + addend: rounded twice, or once by the number types of the mode
    /// [`Fused`](super::dispatch::Mode::Fused).
    #[must_use]
    fn multiply_add(self, factor: Self, addend: Self) -> Self;

    /// √self
    #[must_use]
    fn square_root(self) -> Self;
}

impl Arithmetic for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        square_root(self)
    }
}

/// The square root, rounded to nearest.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn square_root(value: f64) -> f64 {
    value.sqrt()
}

/// The square root, rounded to nearest, by whole numbers: `core` has none.
#[cfg(not(feature = "std"))]
pub(super) fn square_root(value: f64) -> f64 {
    if value.is_nan() || value < 0.0 {
        return f64::NAN;
    }
    if value == 0.0 || value == f64::INFINITY {
        return value;
    }
    // value = mantissa·2^exponent with an even exponent and a mantissa of at least 108 bits, whose root
    // has at least 54: one more than a double.
    let bits = value.to_bits();
    let (mut mantissa, mut exponent) = match (bits >> 52) as i32 {
        0 => (u128::from(bits), -1074),
        biased => (u128::from(bits & ((1 << 52) - 1) | 1 << 52), biased - 1075),
    };
    let shift = mantissa.leading_zeros() as i32 - 18;
    let shift = shift + ((exponent - shift) & 1);
    mantissa <<= shift;
    exponent -= shift;
    let root = mantissa.isqrt();
    // A remainder is a bit beyond all others, which decides between two doubles.
    let odd = u64::from(root * root != mantissa);
    let root = (root as u64) << 1 | odd;
    // A conversion rounds to nearest; scaling by a power of two is exact, because no root is subnormal.
    let scale = f64::from_bits(((exponent / 2 - 1 + 1023) as u64) << 52);
    root as f64 * scale
}
