//! Sines and cosines of numbers, between rational bounds.

use crate::algebra::number::{Integer, Rational};

/// Rational bounds of a real number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure {
    /// Not above it.
    pub lower: Rational,
    /// Not below it.
    pub upper: Rational,
}

impl Enclosure {
    /// A rational number itself.
    pub fn exact(value: Rational) -> Self {
        Enclosure {
            lower: value.clone(),
            upper: value,
        }
    }
}

/// The bounds are closer than 2^−BITS.
const BITS: usize = 160;

/// cos(q) for a number q of radians.
///
/// The partial sums of Σ (−1)ⁿ q²ⁿ/(2n)!: from the first term on that is smaller than the one before
/// it, two neighbours enclose the limit. The number of terms grows with |q|.
pub fn cosine(angle: &Rational) -> Enclosure {
    series(Rational::ONE, angle, 0)
}

/// sin(q) for a number q of radians: Σ (−1)ⁿ q²ⁿ⁺¹/(2n + 1)!.
pub fn sine(angle: &Rational) -> Enclosure {
    series(angle.clone(), angle, 1)
}

/// The alternating series whose first term is given with its power of q.
fn series(first: Rational, angle: &Rational, power: u32) -> Enclosure {
    let square = angle * angle;
    let small = Rational::ONE / Rational::from(Integer::from(2).pow(BITS));
    let (mut term, mut sum, mut power) = (first.clone(), first, power);
    loop {
        let divisor = Rational::from((power + 1) * (power + 2));
        // From here on every term is smaller than the one before it.
        let is_falling = square < divisor;
        term = -(term * &square) / divisor;
        power += 2;
        let next = &sum + &term;
        let size = if term < Rational::ZERO {
            -term.clone()
        } else {
            term.clone()
        };
        if is_falling && size < small {
            let (lower, upper) = if sum < next { (sum, next) } else { (next, sum) };
            return Enclosure { lower, upper };
        }
        sum = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Rational {
        super::super::fixed::number_of(text).expect("a number")
    }

    #[test]
    fn bounds_hold_digits_that_are_known() {
        // 30 digits of each, from tables.
        for (angle, cosine_of, sine_of) in [
            ("0", "1", "0"),
            (
                "1",
                "0.540302305868139717400936607443",
                "0.841470984807896506652502321630",
            ),
            (
                "-0.5",
                "0.877582561890372716116281582604",
                "-0.479425538604203000273287935216",
            ),
            (
                "10",
                "-0.839071529076452452258863947824",
                "-0.544021110889369813404747661851",
            ),
        ] {
            let near = number("1e-30");
            for (bounds, known) in [
                (cosine(&number(angle)), cosine_of),
                (sine(&number(angle)), sine_of),
            ] {
                let known = number(known);
                assert!(bounds.lower <= bounds.upper);
                assert!(&bounds.upper - &bounds.lower < number("1e-40"), "{angle}");
                assert!(
                    bounds.lower <= &known + &near && &known - &near <= bounds.upper,
                    "{angle}"
                );
            }
        }
    }

    #[test]
    fn the_squares_add_up_to_one() {
        for angle in ["0.3", "-2.75", "6.2", "22/7"] {
            let (cosine, sine) = (cosine(&number(angle)), sine(&number(angle)));
            let sum = &cosine.lower * &cosine.lower + &sine.lower * &sine.lower;
            let off = sum - Rational::ONE;
            assert!(off < number("1e-40") && -off < number("1e-40"), "{angle}");
        }
    }
}
