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
