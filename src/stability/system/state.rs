//! The state matrix of a pencil in doubles, for approximate eigenvalues.

use crate::stability::francis;

use super::linear_equations::Factors;
use super::pencil::Pencil;
use super::{MOST_COORDINATES, MOST_ROWS};

/// A matrix of which the first rows and columns count.
type Matrix = francis::Matrix<MOST_ROWS>;

/// −M⁻¹K, n×n; `None` where M has no inverse in doubles.
pub(super) fn stiffness_over_mass(pencil: &Pencil) -> Option<Matrix> {
    let n = pencil.size;
    let state = state_matrix(pencil)?;
    let mut matrix = [[0.0; MOST_ROWS]; MOST_ROWS];
    for (own, row) in matrix.iter_mut().zip(&state[n..2 * n]) {
        own[..n].copy_from_slice(&row[..n]);
    }
    Some(matrix)
}

/// A = \[0, I; −M⁻¹K, −M⁻¹C\], 2n×2n; `None` where M has no inverse in doubles.
pub(super) fn state_matrix(pencil: &Pencil) -> Option<Matrix> {
    let n = pencil.size;
    let mut mass = [[0.0; MOST_COORDINATES]; MOST_COORDINATES];
    for (row, own) in mass[..n].iter_mut().zip(&pencil.powers[2].centre) {
        row[..n].copy_from_slice(&own[..n]);
    }
    let factors = Factors::new(n, mass, 0.0)?;
    let mut matrix = [[0.0; MOST_ROWS]; MOST_ROWS];
    (0..n).for_each(|place| matrix[place][n + place] = 1.0);
    for (power, column) in (0..2).flat_map(|power| (0..n).map(move |column| (power, column))) {
        let right = std::array::from_fn(|row| match row < n {
            true => -pencil.powers[power].centre[row][column],
            false => 0.0,
        });
        let solution = factors.solve(&right);
        for (row, entry) in matrix[n..2 * n].iter_mut().zip(solution) {
            row[power * n + column] = entry;
        }
    }
    matrix
        .iter()
        .flatten()
        .all(|own: &f64| own.is_finite())
        .then_some(matrix)
}
