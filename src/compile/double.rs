//! Which doubles rational numbers are rounded to, in exact arithmetic.

use dashu_base::{Abs, BitTest, DivRem};

use crate::algebra::number::{Integer, Rational};

/// The digits of a double.
const DIGITS: isize = 53;

/// The exponents of the lowest digits of doubles that are not subnormal.
const EXPONENTS: std::ops::RangeInclusive<isize> = -1074..=971;

/// The double that is nearest to a number, of two such the even one; none beyond the largest double
/// and between 0 and the least one with all its digits.
pub fn nearest(value: &Rational) -> Option<Rational> {
    if *value == Rational::ZERO {
        return Some(Rational::ZERO);
    }
    let above = value.numerator().clone();
    let below = Integer::from(value.denominator().clone());
    // |value| is between 2^(52 + exponent) and 2^(54 + exponent).
    let mut exponent = above.bit_len() as isize - below.bit_len() as isize - DIGITS;
    let mut digits = rounded(&above, &below, exponent);
    if digits.clone().abs().bit_len() as isize > DIGITS {
        exponent += 1;
        digits = rounded(&above, &below, exponent);
    }
    // Rounding up to 2^53 gives the next exponent, and the number is a double all the same.
    EXPONENTS
        .contains(&exponent)
        .then(|| Rational::from(digits) * power_of_two(exponent))
}

/// Whether a number is a double, and not a subnormal one.
pub fn is_double(value: &Rational) -> bool {
    nearest(value).as_ref() == Some(value)
}

/// above/(below·2^exponent), rounded to an integer, of two such the even one.
fn rounded(above: &Integer, below: &Integer, exponent: isize) -> Integer {
    let shift = exponent.unsigned_abs();
    let (above, below) = match exponent < 0 {
        true => (above << shift, below.clone()),
        false => (above.clone(), below << shift),
    };
    let (quotient, remainder) = (&above).div_rem(&below);
    let twice = remainder.abs() << 1;
    let is_odd = quotient.bit(0);
    match twice > below || (twice == below && is_odd) {
        true if above < Integer::ZERO => quotient - 1,
        true => quotient + 1,
        false => quotient,
    }
}

fn power_of_two(exponent: isize) -> Rational {
    let power = Rational::from(Integer::ONE << exponent.unsigned_abs());
    match exponent < 0 {
        true => Rational::ONE / power,
        false => power,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quotient(above: i128, below: i128) -> Rational {
        Rational::from(Integer::from(above)) / Rational::from(Integer::from(below))
    }

    #[test]
    fn numbers_are_rounded_as_in_the_standard() {
        let one = 1_i128 << 53;
        for (value, expected) in [
            (quotient(0, 1), quotient(0, 1)),
            (quotient(1, 2), quotient(1, 2)),
            (quotient(1, 3), quotient(6_004_799_503_160_661, 1 << 54)),
            (quotient(-1, 10), quotient(-3_602_879_701_896_397, 1 << 55)),
            // Half way: to the even one.
            (quotient(one + 1, 1), quotient(one, 1)),
            (quotient(one + 3, 1), quotient(one + 4, 1)),
            (quotient(-one - 3, 1), quotient(-one - 4, 1)),
            (
                quotient(2 * one - 1, 1),
                quotient(2 * one - 2, 1) + quotient(2, 1),
            ),
            (quotient(2 * one - 1, 2), quotient(one, 1)),
        ] {
            assert_eq!(nearest(&value), Some(expected), "{value}");
        }
    }

    #[test]
    fn the_range_is_that_of_doubles() {
        let largest = Rational::from((Integer::ONE << 1024) - (Integer::ONE << 971));
        assert!(is_double(&largest));
        assert_eq!(nearest(&(largest + power_of_two(971))), None);
        assert!(is_double(&power_of_two(-1022)));
        assert_eq!(nearest(&power_of_two(-1023)), None);
        assert!(!is_double(&quotient(1, 10)));
    }
}
