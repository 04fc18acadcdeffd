//! The modes of a section by its state matrix: the numerical standard.

use num_complex::Complex;

use super::approximation::approximate_eigenvalues;
use super::ball::Ball;
use super::eigenvalue::{Spectrum, best_spectrum};
use super::enclosure::error_bounds;
use super::error::StabilityError;
use super::model::Model;

/// The eigenvalues of the state matrix, Eq. (16).
///
/// They are approximated by a Schur decomposition of the state matrix; their errors are bounded with the
/// characteristic polynomial |λ²M + λ(C_s + C_a) + K + K_a|, expanded about each of them without forming
/// its coefficients in λ, whose rounding would cost most digits. The bounds count the rounding of
/// the matrices, for the sines and cosines of the angles as they are rounded, and hold for eigenvalues
/// that coincide and for defective ones.
///
/// At most 8 decompositions of at most 200 iterations, and as many times 36 determinants.
///
/// # Errors
///
/// [`StabilityError::NoEigenvalues`] if nothing converged or no error could be bounded.
pub fn eigenvalues(model: &Model) -> Result<Spectrum, StabilityError> {
    let bounds = |values: &[_]| error_bounds(values, |point| model.taylor(Ball::exact(point)));
    let matrix = model.scaled_state_matrix();
    best_spectrum(
        approximate_eigenvalues(&matrix),
        bounds,
        model.frequency_unit,
    )
}

/// Bounds of the errors of approximations to the three eigenvalues with positive frequencies: the exact ones
/// can be assigned one to one, none farther away than this. `None` where nothing is known.
///
/// As for [`eigenvalues`], by the characteristic polynomial about each of them: what a closed form leaves
/// out is bounded for the section at hand, in 1/s.
pub fn error_bounds_of(model: &Model, values: &[Complex<f64>; 3]) -> [Option<f64>; 3] {
    let [a, b, c] = values.map(|value| value / model.frequency_unit);
    let six = [a, b, c, a.conj(), b.conj(), c.conj()];
    let bounds = error_bounds(&six, |point| model.taylor(Ball::exact(point)));
    [0, 1, 2].map(|place| {
        let bound = bounds.as_ref()?.errors[place] * model.frequency_unit;
        bound.is_finite().then_some(bound)
    })
}
