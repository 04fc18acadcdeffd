//! Approximate eigenvalues, in a bounded number of steps.
//!
//! The implicit double-shift iteration stalls on some matrices whose eigenvalues come in groups of equal
//! size, as those of undamped motions do. A multiple of the unit matrix that is added first sets
//! them apart; it is subtracted again.

use std::iter::once_with;

use nalgebra::{DMatrix, Schur};
use num_complex::Complex;

use super::francis;
use super::system::MOST_ROWS;

/// The most iterations of one decomposition; 30 are plenty where it converges.
const MOST_ITERATIONS: usize = 200;

/// The shifts that are tried, as multiples of the largest entry of the matrix.
const SHIFTS: [f64; 8] = [0.0, 0.5, -0.5, 1.3, -1.3, 3.1, -3.1, 0.17];

/// Approximations to the eigenvalues of a real matrix with at most 16 rows: first by elimination and double steps,
/// which is quick, then by orthogonal steps, one set for each shift that converges. Complex ones come in conjugate
/// pairs. How good they are is for the caller to find out.
pub(super) fn approximate_eigenvalues(
    matrix: &DMatrix<f64>,
) -> impl Iterator<Item = Vec<Complex<f64>>> {
    let size = matrix.amax();
    let shifted = SHIFTS
        .into_iter()
        .map(move |multiple| by_schur(matrix, multiple * size));
    once_with(|| by_elimination(matrix))
        .chain(shifted)
        .flatten()
}

fn by_elimination(matrix: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    // Sections have six rows at most, and are many.
    match matrix.nrows() {
        0..=6 => by_elimination_of::<6>(matrix),
        _ => by_elimination_of::<MOST_ROWS>(matrix),
    }
}

fn by_elimination_of<const N: usize>(matrix: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let size = matrix.nrows();
    let mut rows = [[0.0; N]; N];
    for (row, column) in (0..size).flat_map(|row| (0..size).map(move |column| (row, column))) {
        rows[row][column] = matrix[(row, column)];
    }
    francis::eigenvalues(size, &rows).map(|own| own[..size].to_vec())
}

fn by_schur(matrix: &DMatrix<f64>, shift: f64) -> Option<Vec<Complex<f64>>> {
    let mut shifted = matrix.clone();
    for place in 0..matrix.nrows() {
        shifted[(place, place)] += shift;
    }
    let schur = Schur::try_new(shifted, f64::EPSILON, MOST_ITERATIONS)?;
    let values = schur.complex_eigenvalues();
    let values: Vec<_> = values.iter().map(|value| value - shift).collect();
    let are_finite = values.iter().all(|value| value.is_finite());
    are_finite.then_some(values)
}
