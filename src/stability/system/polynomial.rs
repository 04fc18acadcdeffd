//! The characteristic polynomial of a system, exactly or enclosed with many digits.

use num_complex::Complex;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::determinant::determinant;
use crate::algebra::interval::{Interval, Intervals};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::univariate::Univariate;
use crate::stability::ball::Ball;

use super::arithmetic::ball;
use super::entries::Matrices;
use super::gaussian::Gaussian;

/// |λ²M + λC + K| in powers of λ.
///
/// Complexity: n 2ⁿ⁻¹ products of polynomials.
pub(super) fn characteristic_polynomial<A: Arithmetic>(
    matrices: &Matrices<A::Element>,
    arithmetic: &A,
) -> Result<Vec<A::Element>, A::Error> {
    let in_lambda = Univariate(arithmetic);
    let entry = |row: usize, column: usize| {
        let powers = [0, 1, 2].map(|power| matrices.at(power, row, column).clone());
        in_lambda.polynomial(powers.to_vec())
    };
    let size = matrices.size;
    let found = determinant(&Matrix::from_fn(size, size, entry), &in_lambda)?;
    // What is known to vanish is left out, but not the powers.
    let mut all = found;
    all.resize(2 * size + 1, arithmetic.zero());
    Ok(all)
}

/// The coefficients of an enclosed polynomial about a complex point, rounded to balls of doubles.
pub(super) fn taylor(
    polynomial: &[Interval],
    point: Complex<f64>,
    intervals: &Intervals,
) -> Option<Vec<Ball>> {
    let part = |own: f64| Some(intervals.rational(&Rational::try_from(own).ok()?));
    let at = [part(point.re)?, part(point.im)?];
    let complex = Gaussian(intervals);
    let coefficients: Vec<_> = polynomial
        .iter()
        .map(|own| [own.clone(), intervals.zero()])
        .collect();
    let Ok(shifted) = Univariate(&complex).shifted(&coefficients, &at);
    let rounded = |[re, im]: &[Interval; 2]| {
        let (re, im) = (ball(re, intervals), ball(im, intervals));
        Ball {
            centre: Complex::new(re.centre, im.centre),
            radius: (re.radius + im.radius) * (1.0 + 4.0 * f64::EPSILON),
        }
    };
    Some(shifted.iter().map(rounded).collect())
}
