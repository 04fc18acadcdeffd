//! Hurwitz' determinants over any exact numbers.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::determinant::leading_minors;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::matrix::Matrix;

/// The first `count` of H_1 to H_n of a polynomial of degree n, given by its coefficients, that of λ⁰ first.
///
/// ```text
/// H_k = |a_1 a_3 a_5 …; a_0 a_2 a_4 …; 0 a_1 a_3 …; …|, k×k, for a_0 λⁿ + a_1 λⁿ⁻¹ + … + a_n
/// ```
///
/// With a_0 > 0 all are positive exactly where every root has a negative real part (Hurwitz).
///
/// Complexity: at most n·2ⁿ⁻¹ products for all of them.
///
/// # Errors
///
/// Those of the arithmetic.
pub(super) fn hurwitz_determinants<A: Arithmetic>(
    coefficients: &[A::Element],
    count: usize,
    arithmetic: &A,
) -> Result<Vec<A::Element>, A::Error> {
    let degree = coefficients.len().saturating_sub(1);
    let entry = |row: usize, column: usize| {
        let place = (2 * column + 1).checked_sub(row);
        let power = place.and_then(|place| degree.checked_sub(place));
        power.map_or_else(|| arithmetic.zero(), |power| coefficients[power].clone())
    };
    let count = count.min(degree);
    if count == 0 {
        return Ok(Vec::new());
    }
    leading_minors(&Matrix::from_fn(count, count, entry), arithmetic).collect()
}

/// The signs of H_1/H_0, H_2/H_1, …, H_n/H_{n−1} by Routh's scheme, up to the first that is not positive for certain;
/// the leading coefficient H_0 is above 0.
///
/// ```text
/// c_{k+1,j} = c_{k−1,j+1} − c_{k−1,0}/c_{k,0} c_{k,j+1}
/// ```
///
/// As long as all are positive, they have the signs of the determinants; one below 0 behind these is one determinant
/// below 0. Complexity: n²/4 products and n quotients.
pub(super) fn routh_signs(coefficients: &[Interval], intervals: &Intervals) -> Vec<KnownSign> {
    let row = |first: usize| -> Vec<Interval> {
        let down = coefficients.iter().rev().skip(first).step_by(2);
        down.cloned().collect()
    };
    let (mut above, mut own) = (row(0), row(1));
    let mut signs = Vec::with_capacity(coefficients.len());
    while signs.len() + 1 < coefficients.len() {
        let sign = own.first().map_or(KnownSign::Zero, Interval::sign);
        signs.push(sign);
        let next = match sign {
            KnownSign::Positive => next_row(&above, &own, intervals),
            _ => None,
        };
        let Some(next) = next else { break };
        (above, own) = (own, next);
    }
    signs
}

/// The next row of Routh's scheme; `None` where nothing can be divided by the first entry.
fn next_row(above: &[Interval], own: &[Interval], intervals: &Intervals) -> Option<Vec<Interval>> {
    let factor = intervals.quotient(above.first()?, own.first()?)?;
    let entry = |(place, upper): (usize, &Interval)| {
        let Some(right) = own.get(place + 1) else {
            return upper.clone();
        };
        let Ok(product) = intervals.product(&factor, right);
        let Ok(difference) = intervals.difference(upper, &product);
        difference
    };
    Some(above.iter().skip(1).enumerate().map(entry).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::number::Rational;
    use proptest::prelude::*;

    proptest! {
        /// Two ways to the same signs, as far as the scheme goes.
        #[test]
        fn the_scheme_has_the_signs_of_the_determinants(lower in prop::collection::vec(-9_i64..30, 1..8)) {
            let intervals = Intervals::new(128);
            let polynomial: Vec<Interval> = lower.iter().chain([&1]).map(|own| intervals.rational(&Rational::from(*own))).collect();
            let signs = routh_signs(&polynomial, &intervals);
            let Ok(determinants) = hurwitz_determinants(&polynomial, lower.len(), &intervals);
            for (place, sign) in signs.iter().enumerate() {
                if *sign != KnownSign::Unknown {
                    prop_assert_eq!(*sign, determinants[place].sign());
                }
                prop_assert!(place + 1 == signs.len() || *sign == KnownSign::Positive);
            }
            let is_stable = determinants.iter().all(|own| own.sign() == KnownSign::Positive);
            prop_assert_eq!(is_stable, signs.len() == lower.len() && signs.iter().all(|own| *own == KnownSign::Positive));
        }
    }
}
