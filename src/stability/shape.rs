//! Mode shapes.

use nalgebra::{DMatrix, SVD};
use num_complex::Complex;

use super::ball::Ball;
use super::given::Given;
use super::model::{Model, impedance};

/// A vector q with (λ²M + λC + K) q = 0: the shape of the motion of an eigenvalue λ, in x, y and rθ, its
/// largest entry 1.
///
/// `place` is `None` for an eigenvalue that stands alone; of k eigenvalues that coincide, each takes
/// another place from 0. A defective one has one shape, and a further place gives no eigenvector. `None`
/// if the singular values do not converge within 1000 iterations.
pub(super) fn mode_shape(
    model: &Model,
    value: Complex<f64>,
    place: Option<usize>,
) -> Option<Vec<Complex<f64>>> {
    let entries = model.dynamic_stiffness(Ball::exact(value / model.frequency_unit));
    let matrix = entries.map(|row| row.map(|entry| entry[0].centre));
    let alone = || with_largest_one(&column_of_adjugate(&matrix)[..model.freedom()]);
    match place {
        None => alone().or_else(|| null_vector(&matrix, model.freedom(), 0)),
        Some(place) => null_vector(&matrix, model.freedom(), place),
    }
}

/// The largest column of the adjugate of B: with B adj(B) = |B| = 0 each column is a null vector.
fn column_of_adjugate(matrix: &[[Complex<f64>; 3]; 3]) -> [Complex<f64>; 3] {
    let cross = |a: [Complex<f64>; 3], b: [Complex<f64>; 3]| {
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            a[j] * b[k] - a[k] * b[j]
        })
    };
    let [first, second, third] = *matrix;
    let mut columns = [
        cross(second, third),
        cross(third, first),
        cross(first, second),
    ];
    let size = |column: &[Complex<f64>; 3]| column.iter().map(Complex::norm_sqr).sum::<f64>();
    columns.sort_by(|one, other| size(other).total_cmp(&size(one)));
    columns[0]
}

/// The shape of the motion of an eigenvalue that stands alone, of a section with all coordinates free and without
/// aerodynamic stiffness.
pub(super) fn free_shape(given: &Given<f64>, value: Complex<f64>) -> [Complex<f64>; 3] {
    let own = given.equations();
    let real = |own: f64| Complex::new(own, 0.0);
    let natural = given.parameters.natural_frequencies;
    let entry = |i: usize, j: usize| {
        let damping = own.structural_damping[i][j] + own.aerodynamic_damping[i][j];
        let natural = (i == j).then_some(Complex::new(0.0, natural[i]));
        impedance(value, real(own.mass[i][j]), real(damping), natural)
    };
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    column_of_adjugate(&rows)
}

/// The right singular vector of the `place`-th smallest singular value of the first n rows and columns.
fn null_vector(
    matrix: &[[Complex<f64>; 3]; 3],
    n: usize,
    place: usize,
) -> Option<Vec<Complex<f64>>> {
    let matrix = DMatrix::from_fn(n, n, |i, j| matrix[i][j]);
    let svd = SVD::try_new(matrix, false, true, f64::EPSILON, 1000)?;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
    let row = *order.get(place)?;
    // The rows are the conjugates of the vectors.
    let vector: Vec<Complex<f64>> = svd.v_t?.row(row).iter().map(Complex::conj).collect();
    with_largest_one(&vector)
}

/// A multiple of a vector, its largest entry 1; `None` for 0 and what is not finite.
fn with_largest_one(vector: &[Complex<f64>]) -> Option<Vec<Complex<f64>>> {
    let larger = |a: &&Complex<f64>, b: &&Complex<f64>| a.norm_sqr().total_cmp(&b.norm_sqr());
    let largest = vector.iter().max_by(larger)?;
    let is_usable = largest.norm_sqr().is_normal();
    is_usable.then(|| vector.iter().map(|entry| entry / largest).collect())
}
