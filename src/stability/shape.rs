//! Mode shapes.

use nalgebra::{DMatrix, SVD};
use num_complex::Complex;

use super::model::Model;

/// The shape of the motion of an eigenvalue λ: the vector q with (λ²M + λC + K) q = 0, as the right
/// singular vector of the `place`-th smallest singular value, 0 for the smallest.
///
/// In x, y and rθ, its largest entry 1. Of k eigenvalues that coincide, each takes another place; a
/// defective one has one shape, and a further place gives no eigenvector. `None` if the singular
/// values do not converge within 1000 iterations.
pub(super) fn mode_shape(
    model: &Model,
    value: Complex<f64>,
    place: usize,
) -> Option<Vec<Complex<f64>>> {
    let n = model.freedom();
    let entries = model.dynamic_stiffness(value / model.frequency_unit);
    let matrix = DMatrix::from_fn(n, n, |i, j| entries[i][j][0].centre);
    let svd = SVD::try_new(matrix, false, true, f64::EPSILON, 1000)?;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
    let row = *order.get(place)?;
    // The rows are the conjugates of the vectors.
    let vector: Vec<Complex<f64>> = svd.v_t?.row(row).iter().map(Complex::conj).collect();
    let largest = vector
        .iter()
        .copied()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    Some(vector.iter().map(|entry| entry / largest).collect())
}
