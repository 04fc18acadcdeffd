//! Approximate eigenvalues, in a bounded number of steps.
//!
//! The implicit double-shift iteration stalls on matrices whose eigenvalues come in groups of equal
//! size, as those of undamped motions do. A multiple of the unit matrix that is added first sets
//! them apart; it is subtracted again.

use nalgebra::{DMatrix, Schur};
use num_complex::Complex;

/// The most iterations of one decomposition; 30 are plenty where it converges.
const MOST_ITERATIONS: usize = 200;

/// The shifts that are tried, as multiples of the largest entry of the matrix.
const SHIFTS: [f64; 8] = [0.0, 0.5, -0.5, 1.3, -1.3, 3.1, -3.1, 0.17];

/// Approximations to the eigenvalues of a real matrix, one set for each shift that converges; complex
/// ones come in conjugate pairs. How good they are is for the caller to find out.
pub(super) fn approximate_eigenvalues(
    matrix: &DMatrix<f64>,
) -> impl Iterator<Item = Vec<Complex<f64>>> {
    let size = matrix.amax();
    SHIFTS.into_iter().filter_map(move |multiple| {
        let shift = multiple * size;
        let mut shifted = matrix.clone();
        for place in 0..matrix.nrows() {
            shifted[(place, place)] += shift;
        }
        let schur = Schur::try_new(shifted, f64::EPSILON, MOST_ITERATIONS)?;
        let values = schur.complex_eigenvalues();
        let values: Vec<_> = values.iter().map(|value| value - shift).collect();
        values
            .iter()
            .all(|value| value.is_finite())
            .then_some(values)
    })
}
