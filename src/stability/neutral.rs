//! Divisors λ² + ν of a characteristic polynomial: motions that neither grow nor die out.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Exhausted;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::trigonometric_sum::TrigonometricSums;
use crate::algebra::univariate::Univariate;

use super::in_speed::InSpeed;

/// The digits with which a divisor is ruled out.
const DIGITS: usize = 128;

/// A polynomial in powers of λ, each in powers of the speed, divided by λ² + ν as often as each ν allows, and how often
/// that was. Exact; what is no divisor is nearly always told from one by enclosures, which cost little.
///
/// # Errors
///
/// If the sums become too long.
pub(super) fn without_pairs(
    mut polynomial: Vec<InSpeed>,
    squares: &[InSpeed],
    sums: &TrigonometricSums,
) -> Result<(Vec<InSpeed>, usize), Exhausted> {
    let in_speed = Univariate(sums);
    let in_lambda = Univariate(&in_speed);
    let intervals = Intervals::new(DIGITS);
    let enclosed = |polynomial: &[InSpeed]| -> Vec<Vec<Interval>> {
        polynomial
            .iter()
            .map(|powers| enclosure(powers, &intervals))
            .collect()
    };
    let (mut count, mut about) = (0, enclosed(&polynomial));
    for square in squares {
        let pair = vec![square.clone(), in_speed.zero(), in_speed.one()];
        let near = enclosure(square, &intervals);
        while polynomial.len() > 2 && may_divide(&near, &about, &intervals) {
            let (quotient, rest) = in_lambda.pseudo_division(&polynomial, &pair)?;
            if !rest.is_empty() {
                break;
            }
            about = enclosed(&quotient);
            (polynomial, count) = (quotient, count + 1);
        }
    }
    Ok((polynomial, count))
}

/// Enclosures of the coefficients.
pub(super) fn enclosure(powers: &InSpeed, intervals: &Intervals) -> InSpeed<Interval> {
    let enclosed = powers.iter().map(|own| intervals.enclosure(own));
    Univariate(intervals).polynomial(enclosed.collect())
}

/// Whether even and odd part may vanish where λ² = −ν, at every speed.
pub(super) fn may_divide(
    square: &InSpeed<Interval>,
    polynomial: &[InSpeed<Interval>],
    intervals: &Intervals,
) -> bool {
    let in_speed = Univariate(intervals);
    let at = in_speed.negative(square);
    let vanishes = |first: usize| {
        let powers: Vec<_> = polynomial.iter().skip(first).step_by(2).cloned().collect();
        let Ok(value) = Univariate(&in_speed).value(&powers, &at);
        let is_open = |own: &Interval| matches!(own.sign(), KnownSign::Zero | KnownSign::Unknown);
        value.iter().all(is_open)
    };
    vanishes(1) && vanishes(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::budget::Budget;
    use crate::algebra::number::Rational;
    use crate::algebra::trigonometric_sum::TrigonometricSum as Sum;

    fn number(own: i64) -> Sum {
        Sum::from(Rational::from(own))
    }

    #[test]
    fn divisors_are_taken_as_often_as_they_divide() {
        let sums = TrigonometricSums::new(Budget::new(100_000));
        let in_speed = Univariate(&sums);
        let in_lambda = Univariate(&in_speed);
        let sine = Sum::sine(&Rational::from(1));
        // (λ² + 4)² (λ² + 3 − U²) (λ² + U sin 1 λ + 2)
        let constant = |own: i64| vec![number(own)];
        let four = vec![constant(4), vec![], constant(1)];
        let turn = vec![number(3), Sum::default(), number(-1)];
        let moving = vec![turn.clone(), vec![], constant(1)];
        let others = vec![constant(2), vec![Sum::default(), sine], constant(1)];
        let product = [&four, &four, &moving]
            .into_iter()
            .try_fold(others.clone(), |product, own| {
                in_lambda.product(&product, own)
            });
        let product = product.expect("short");
        for (squares, expected, count) in [
            (
                vec![constant(4)],
                in_lambda.product(&moving, &others).expect("short"),
                2,
            ),
            (vec![constant(4), turn.clone()], others.clone(), 3),
            (
                vec![constant(2), constant(3), turn],
                in_lambda
                    .product(&in_lambda.product(&four, &four).expect("short"), &others)
                    .expect("short"),
                1,
            ),
        ] {
            let found = without_pairs(product.clone(), &squares, &sums).expect("short");
            assert_eq!(found, (expected, count));
        }
        // Nothing but pairs leaves 1.
        let (rest, count) = without_pairs(four, &[constant(4)], &sums).expect("short");
        assert_eq!((rest, count), (vec![constant(1)], 1));
    }
}
