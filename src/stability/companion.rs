//! The characteristic polynomial and its roots: the textbook's way, with its loss of digits stated.

use nalgebra::{ComplexField, DMatrix};
use num_complex::Complex;
use polynomial::Polynomial;
use sextic_evaluators::characteristic_polynomial::characteristic_polynomial as evaluated;

use super::approximation::approximate_eigenvalues;
use super::ball::Ball;
use super::eigenvalue::{Spectrum, best_spectrum};
use super::enclosure::error_bounds;
use super::error::StabilityError;
use super::forces::Forces;
use super::given::Given;
use super::model::Model;

/// The eigenvalues as roots of the characteristic polynomial, Eq. (19), by its companion matrix.
///
/// With all coordinates free, force coefficients given and no aerodynamic stiffness, those of the polynomial
/// come from the generated evaluator, otherwise from the determinant of λ²M + λ(C_s + C_a) + K + K_a, which bounds
/// their errors in either case. Rounding moves roots that lie δ apart by about ε/δ² and more, relatively; the errors that are given count
/// that.
///
/// At most 8 Schur decompositions of at most 200 iterations, and as many times 36 Taylor expansions.
///
/// # Errors
///
/// [`StabilityError::NoEigenvalues`] if nothing converged or no error could be bounded.
pub fn eigenvalues(model: &Model) -> Result<Spectrum, StabilityError> {
    let coefficients = coefficients(model);
    let matrix = companion_matrix(&monic(&coefficients, model.freedom()));
    let bounds = |values: &[_]| error_bounds(values, |point| shifted(&coefficients, point));
    best_spectrum(
        approximate_eigenvalues(&matrix),
        bounds,
        model.frequency_unit,
    )
}

/// The characteristic polynomial, Eq. (19): monic, of degree 2n, for λ in units of the power of 2
/// below the largest natural frequency in rad/s, so that its coefficients are of one size.
pub fn characteristic_polynomial(model: &Model) -> Polynomial<f64> {
    monic(&coefficients(model), model.freedom())
}

fn monic(coefficients: &[Ball; 7], freedom: usize) -> Polynomial<f64> {
    let real = coefficients[..=2 * freedom].iter().map(|own| own.centre.re);
    let leading = coefficients[2 * freedom].centre.re;
    Polynomial::new(real.map(|own| own / leading).collect())
}

/// The companion matrix of a monic polynomial z^N + c_{N−1} z^{N−1} + … + c_0, N×N: ones below the
/// diagonal, −c_0 to −c_{N−1} down the last column. Its eigenvalues are the roots.
pub fn companion_matrix<T: ComplexField>(polynomial: &Polynomial<T>) -> DMatrix<T> {
    let coefficients = polynomial.data();
    let degree = coefficients.len().saturating_sub(1);
    DMatrix::from_fn(degree, degree, |row, column| {
        if column + 1 == degree {
            -coefficients[row].clone()
        } else if row == column + 1 {
            T::one()
        } else {
            T::zero()
        }
    })
}

/// The coefficients with bounds of their errors, for λ in units of the model.
fn coefficients(model: &Model) -> [Ball; 7] {
    let p = model.section().parameters();
    let Forces::Coefficients(c) = p.forces else {
        return model.taylor(Ball::ZERO);
    };
    if !p.free.are_all() || p.aerodynamic_stiffness {
        return model.taylor(Ball::ZERO);
    }
    let given = Given::of(p).in_units_of(model.frequency_unit);
    let out = evaluated(&given.characteristic_polynomial_inputs(&c));
    let values = [out.c_0, out.c_1, out.c_2, out.c_3, out.c_4, out.c_5];
    let determinant = model.taylor(Ball::ZERO);
    let leading = determinant[6];
    // The determinant has bounds that count the sums of angles and their sines.
    let apart = |power: usize| {
        let apart = Ball::exactly(values[power]) * leading + -determinant[power];
        apart.largest() / leading.smallest() * (1.0 + 8.0 * f64::EPSILON)
    };
    std::array::from_fn(|power| match values.get(power) {
        Some(&value) => Ball::real(value, apart(power)),
        None => Ball::ONE,
    })
}

/// The coefficients of p(c + μ) in powers of μ, by repeated division by μ (Horner, Taylor).
fn shifted(coefficients: &[Ball; 7], point: Complex<f64>) -> [Ball; 7] {
    let mut shifted = *coefficients;
    for lowest in 0..shifted.len() {
        for power in (lowest..shifted.len() - 1).rev() {
            shifted[power] = shifted[power] + shifted[power + 1] * Ball::exact(point);
        }
    }
    shifted
}
