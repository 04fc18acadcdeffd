//! Linear systems and null spaces.

use super::arithmetic::{Arithmetic, Division};
use super::determinant::{adjugate, determinant};
use super::matrix::Matrix;

/// The numerators Nᵢ and the determinant Δ of a square system A·x = b: Δ·xᵢ = Nᵢ (Cramer).
#[derive(Clone, Debug)]
pub struct Solution<T> {
    /// N, a column.
    pub numerators: Matrix<T>,
    /// Δ = |A|; the system is singular where it vanishes.
    pub determinant: T,
}

/// Solves A·x = b without any division: N = adj A·b and Δ = |A|.
///
/// Complexity: n² determinants of n − 1 rows for n unknowns.
///
/// # Errors
///
/// Those of the arithmetic; a singular system is no error here, its Δ is 0.
///
/// # Panics
///
/// If the matrix is not square, or b is no column of as many rows.
///
/// ```
/// use sextic::algebra::{
///     budget::Budget, fraction::Fraction, linear_system::solve, matrix::Matrix, number::Rational,
///     ring::Ring,
/// };
///
/// let ring = Ring::new(Budget::new(10_000));
/// let number = |n: i32| Fraction::from(Rational::from(n));
/// // 2 x + y = 5, x − y = 1 has x = 2, y = 1; Δ = −3.
/// let matrix = Matrix::from_fn(2, 2, |i, j| number([[2, 1], [1, -1]][i][j]));
/// let solution = solve(&matrix, &Matrix::from_fn(2, 1, |i, _| number([5, 1][i])), &ring)?;
/// assert_eq!(solution.determinant, number(-3));
/// assert_eq!(solution.numerators.entries(), [number(-6), number(-3)]);
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
pub fn solve<A: Arithmetic>(
    matrix: &Matrix<A::Element>,
    right: &Matrix<A::Element>,
    arithmetic: &A,
) -> Result<Solution<A::Element>, A::Error> {
    Ok(Solution {
        numerators: adjugate(matrix, arithmetic)?.product(right, arithmetic)?,
        determinant: determinant(matrix, arithmetic)?,
    })
}

/// A basis of {x : A·x = 0}, each vector a column with a 1 at a free place, zeros at the others.
///
/// The entries the elimination divided by are returned too: the basis is right where none of them
/// vanishes.
///
/// Complexity: rows·columns·rank operations on entries.
///
/// # Errors
///
/// Those of the arithmetic.
///
/// ```
/// use sextic::algebra::{
///     arithmetic::Arithmetic, budget::Budget, linear_system::null_space, matrix::Matrix, ring::Ring,
/// };
///
/// let ring = Ring::new(Budget::new(10_000));
/// // x + y = 0 has the solutions (−1, 1)·y.
/// let found = null_space(&Matrix::from_fn(1, 2, |_, _| ring.one()), &ring)?;
/// assert_eq!(found.basis.len(), 1);
/// assert_eq!(found.basis[0].entries(), [ring.negative(&ring.one()), ring.one()]);
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
pub fn null_space<A: Division>(
    matrix: &Matrix<A::Element>,
    arithmetic: &A,
) -> Result<NullSpace<A::Element>, A::Error> {
    let (row_count, column_count) = matrix.shape();
    let mut rows: Vec<Vec<A::Element>> = (0..row_count)
        .map(|row| {
            (0..column_count)
                .map(|column| matrix.at(row, column).clone())
                .collect()
        })
        .collect();
    let mut pivot_columns = Vec::new();
    let mut pivots = Vec::new();
    for column in 0..column_count {
        let rank = pivot_columns.len();
        let found = (rank..row_count).find(|&row| !arithmetic.is_zero(&rows[row][column]));
        let Some(pivot_row) = found else { continue };
        rows.swap(rank, pivot_row);
        let pivot = rows[rank][column].clone();
        for entry in &mut rows[rank] {
            *entry = arithmetic.quotient(entry, &pivot)?;
        }
        let normalised = rows[rank].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index == rank || arithmetic.is_negligible(&row[column]) {
                continue;
            }
            let factor = row[column].clone();
            for (entry, pivot_entry) in row.iter_mut().zip(&normalised) {
                let term = arithmetic.product(&factor, pivot_entry)?;
                *entry = arithmetic.difference(entry, &term)?;
            }
        }
        pivot_columns.push(column);
        pivots.push(pivot);
    }
    let free = (0..column_count).filter(|column| !pivot_columns.contains(column));
    let basis = free
        .map(|free_column| {
            Matrix::from_fn(column_count, 1, |place, _| {
                if place == free_column {
                    arithmetic.one()
                } else if let Some(row) = pivot_columns.iter().position(|c| *c == place) {
                    arithmetic.negative(&rows[row][free_column])
                } else {
                    arithmetic.zero()
                }
            })
        })
        .collect();
    Ok(NullSpace { basis, pivots })
}

/// What [`null_space`] finds.
#[derive(Clone, Debug)]
pub struct NullSpace<T> {
    /// Columns that span it; empty where only 0 is mapped to 0.
    pub basis: Vec<Matrix<T>>,
    /// What was divided by.
    pub pivots: Vec<T>,
}
