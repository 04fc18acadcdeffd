//! Inputs that are fixed: the text holds a number for them.

use crate::algebra::fraction::Fraction;
use crate::algebra::number::{Integer, Rational};

use super::double::nearest;

/// A quantity of a document whose number stands in the emitted text.
#[derive(Clone, Debug)]
pub struct Constant {
    /// Its name in programs.
    pub name: String,
    /// The element of the document's ring that it is.
    pub element: Fraction,
    /// A bound of its exact value from below.
    pub lower: Rational,
    /// A bound of its exact value from above; the same one where the value is rational.
    pub upper: Rational,
}

impl Constant {
    /// Whether a literal may stand for it: the double d that a compiler makes of the literal has
    /// |d − v| ≤ 2⁻⁵³·|v| for every v between the bounds.
    pub fn may_be(&self, literal: &Rational) -> bool {
        let Some(double) = nearest(literal) else {
            return false;
        };
        let zero = Rational::ZERO;
        let has_one_sign = self.lower >= zero || self.upper <= zero;
        // With one sign, |d − v| − 2⁻⁵³·|v| is convex in v: it is largest at a bound.
        let is_near = |value: &Rational| {
            let error = magnitude(&double - value);
            error * Rational::from(Integer::ONE << 53) <= magnitude(value.clone())
        };
        self.lower <= self.upper && has_one_sign && is_near(&self.lower) && is_near(&self.upper)
    }
}

fn magnitude(value: Rational) -> Rational {
    match value < Rational::ZERO {
        true => -value,
        false => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed(lower: Rational, upper: Rational) -> Constant {
        Constant {
            name: "r".into(),
            element: Fraction::constant(Rational::ZERO),
            lower,
            upper,
        }
    }

    fn quotient(above: i64, below: i64) -> Rational {
        Rational::from(above) / Rational::from(below)
    }

    #[test]
    fn a_literal_is_half_a_last_place_away_at_most() {
        let value = quotient(178, 10_000);
        let constant = fixed(value.clone(), value.clone());
        let place = quotient(1, 1 << 58);
        assert!(constant.may_be(&value));
        assert!(constant.may_be(&nearest(&value).unwrap()));
        assert!(!constant.may_be(&(nearest(&value).unwrap() + &place)));
        assert!(!constant.may_be(&-value.clone()));
        assert!(!constant.may_be(&Rational::ZERO));
        // Every value of an enclosure counts.
        let wide = fixed(value.clone(), &value + &place);
        assert!(!wide.may_be(&value));
        let tight = fixed(
            value.clone(),
            &value + quotient(1, 1 << 62) / Rational::from(1 << 30),
        );
        assert!(tight.may_be(&value));
    }

    #[test]
    fn zero_is_zero_and_nothing_else() {
        let zero = fixed(Rational::ZERO, Rational::ZERO);
        assert!(zero.may_be(&Rational::ZERO));
        assert!(!zero.may_be(&quotient(1, 1 << 60)));
        let tiny = quotient(1, 1 << 60);
        assert!(!fixed(-tiny.clone(), tiny.clone()).may_be(&Rational::ZERO));
        assert!(!fixed(tiny.clone(), -tiny).may_be(&Rational::ZERO));
    }
}
