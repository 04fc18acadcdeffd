//! Polynomials on a range, by coefficients that bound them there.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::{Integer, Rational};

/// A polynomial on 0..1 as Σ bⱼ (d over j) tʲ (1 − t)ᵈ⁻ʲ: its values lie between the least and the largest bⱼ.
#[derive(Clone, Debug)]
pub(super) struct Bernstein(Vec<Interval>);

impl Bernstein {
    /// Of a polynomial in powers of t, divided by the power of t that divides it for certain.
    ///
    /// bⱼ = Σ aᵢ (j over i)/(d over i), i ≤ j
    pub fn new(coefficients: &[Interval], intervals: &Intervals) -> Self {
        let is_zero = |own: &&Interval| own.sign() == KnownSign::Zero;
        let skipped = coefficients.iter().take_while(is_zero).count();
        let coefficients = &coefficients[skipped..];
        let degree = coefficients.len().saturating_sub(1);
        let form = |j: usize| {
            let mut sum = intervals.zero();
            for (i, own) in coefficients.iter().enumerate().take(j + 1) {
                let weight = Rational::from(binomial(j, i)) / Rational::from(binomial(degree, i));
                let Ok(term) = intervals.product(&intervals.rational(&weight), own);
                let Ok(next) = intervals.sum(&sum, &term);
                sum = next;
            }
            sum
        };
        Bernstein((0..=degree).map(form).collect())
    }

    /// The sign that the polynomial has on the whole range, its ends included.
    pub fn sign(&self) -> KnownSign {
        common_sign(self.0.iter().map(Interval::sign))
    }

    /// The sign that its derivative has on the whole range.
    pub fn slope_sign(&self) -> KnownSign {
        common_sign(self.0.windows(2).map(|pair| pair[1].compared(&pair[0])))
    }

    /// The polynomial on both halves of the range, by de Casteljau: quadratic in the degree.
    pub fn halves(&self) -> (Self, Self) {
        let mut row = self.0.clone();
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        while let (Some(first), Some(last)) = (row.first(), row.last()) {
            lower.push(first.clone());
            upper.push(last.clone());
            row = row
                .windows(2)
                .map(|pair| pair[0].middle(&pair[1]))
                .collect();
        }
        upper.reverse();
        (Bernstein(lower), Bernstein(upper))
    }
}

/// The one sign of all, if there is one.
fn common_sign(mut signs: impl Iterator<Item = KnownSign>) -> KnownSign {
    let first = signs.next().unwrap_or(KnownSign::Zero);
    match signs.all(|own| own == first) {
        true => first,
        false => KnownSign::Unknown,
    }
}

/// n over k
fn binomial(n: usize, k: usize) -> Integer {
    (0..k).fold(Integer::ONE, |product, i| {
        product * Integer::from(n - i) / Integer::from(i + 1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The value at a number, by Horner's rule.
    fn value(coefficients: &[i64], at: &Rational) -> Rational {
        let step = |sum: Rational, own: &i64| sum * at + Rational::from(*own);
        coefficients.iter().rev().fold(Rational::ZERO, step)
    }

    proptest! {
        #[test]
        fn a_sign_is_that_of_all_values(coefficients in prop::collection::vec(-9_i64..10, 1..8), path in prop::collection::vec(any::<bool>(), 0..6)) {
            prop_assume!(coefficients[0] != 0);
            let intervals = Intervals::new(64);
            let exact: Vec<Interval> = coefficients.iter().map(|own| intervals.rational(&Rational::from(*own))).collect();
            let mut form = Bernstein::new(&exact, &intervals);
            let (mut from, mut width) = (Rational::ZERO, Rational::ONE);
            for is_upper in path {
                let (lower, upper) = form.halves();
                width /= Rational::from(2);
                if is_upper {
                    from += &width;
                }
                form = if is_upper { upper } else { lower };
            }
            let values: Vec<Rational> = (0..=8).map(|part| {
                let at = &from + &width * Rational::from(part) / Rational::from(8);
                value(&coefficients, &at)
            }).collect();
            match form.sign() {
                KnownSign::Positive => prop_assert!(values.iter().all(|own| *own > Rational::ZERO)),
                KnownSign::Negative => prop_assert!(values.iter().all(|own| *own < Rational::ZERO)),
                _ => (),
            }
            match form.slope_sign() {
                KnownSign::Positive => prop_assert!(values.windows(2).all(|pair| pair[0] < pair[1])),
                KnownSign::Negative => prop_assert!(values.windows(2).all(|pair| pair[0] > pair[1])),
                _ => (),
            }
            // The first and the last coefficient are the values at the ends.
            for (own, expected) in [(form.0.first(), values.first()), (form.0.last(), values.last())] {
                let (Some(own), Some(expected)) = (own, expected) else { panic!("no ends") };
                let [low, high] = intervals.bounds(own);
                prop_assert!(&low <= expected && expected <= &high);
            }
        }
    }

    #[test]
    fn what_has_no_root_on_a_range_is_seen_at_once() {
        let intervals = Intervals::new(64);
        let number = |own: i64| intervals.rational(&Rational::from(own));
        // 2 − t, t (2 − t) and t − 2
        for (coefficients, sign) in [
            (vec![2, -1], KnownSign::Positive),
            (vec![0, 2, -1], KnownSign::Positive),
            (vec![-2, 1], KnownSign::Negative),
            (vec![-1, 2], KnownSign::Unknown),
            (vec![], KnownSign::Zero),
        ] {
            let coefficients: Vec<Interval> = coefficients.into_iter().map(number).collect();
            assert_eq!(Bernstein::new(&coefficients, &intervals).sign(), sign);
        }
    }
}
