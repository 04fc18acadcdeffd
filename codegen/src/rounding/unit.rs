//! Units in the last place of an exact number.

use dashu_base::{Abs, BitTest};

use crate::program::Rational;

/// The distance of a double from an exact value, in units in the last place of that value; infinite if
/// the double is.
pub fn units(found: f64, exact: &Rational) -> f64 {
    match Rational::try_from(found) {
        Ok(found) => difference(&found, exact),
        Err(_) => f64::INFINITY,
    }
}

/// The distance of two numbers in units in the last place of the second.
pub(super) fn difference(found: &Rational, exact: &Rational) -> f64 {
    if found == exact {
        return 0.0;
    }
    let unit = unit_in_the_last_place(exact);
    ((found - exact).abs() / unit).to_f64().value()
}

/// The distance between the doubles around a value: 2^(e − 52) for 2^e ≤ |value| < 2^(e + 1), at least
/// that of the subnormal ones.
fn unit_in_the_last_place(value: &Rational) -> Rational {
    let magnitude = value.clone().abs();
    let two = Rational::from(2);
    let power = |exponent: isize| two.pow(exponent);
    if magnitude.is_zero() {
        return power(-1074);
    }
    let above = magnitude.numerator().bit_len() as isize;
    let below = magnitude.denominator().bit_len() as isize;
    let mut exponent = above - below;
    if power(exponent) > magnitude {
        exponent -= 1;
    }
    power(exponent.max(-1022) - 52)
}
