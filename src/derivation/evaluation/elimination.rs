//! Gaussian elimination at a point.

use super::number::Number;
use super::number::extension::Extension;

/// Gaussian elimination on [A | B] with a square A: (|A|, A⁻¹B), the latter where A is invertible.
///
/// A pivot must be invertible, not only different from 0; nothing where there is none although the
/// determinant may not be 0.
pub fn eliminate(
    matrix: &[Vec<Number>],
    right: &[Vec<Number>],
    extension: &Extension,
) -> Option<(Number, Vec<Vec<Number>>)> {
    let size = matrix.len();
    let mut rows: Vec<Vec<Number>> = matrix
        .iter()
        .zip(right)
        .map(|(a, b)| a.iter().chain(b).cloned().collect())
        .collect();
    let mut determinant = Number::from(1);
    for column in 0..size {
        let pivot = (column..size).find(|row| extension.inverse(&rows[*row][column]).is_some());
        let Some(pivot) = pivot else {
            let all_zero = (column..size).all(|row| rows[row][column].is_zero());
            return all_zero.then(|| (Number::default(), Vec::new()));
        };
        if pivot != column {
            rows.swap(pivot, column);
            determinant = determinant.negative();
        }
        determinant = extension.product(&determinant, &rows[column][column]);
        let inverse = extension.inverse(&rows[column][column])?;
        let normalised: Vec<Number> = rows[column]
            .iter()
            .map(|entry| extension.product(entry, &inverse))
            .collect();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != column {
                let factor = row[column].clone();
                for (entry, pivot_entry) in row.iter_mut().zip(&normalised) {
                    *entry = entry.difference(&extension.product(&factor, pivot_entry));
                }
            }
        }
        rows[column] = normalised;
    }
    Some((
        determinant,
        rows.into_iter().map(|row| row[size..].to_vec()).collect(),
    ))
}

/// The columns that span {x : A·x = 0}, each with a 1 at a free place and zeros at the others; nothing
/// where a pivot is neither 0 nor invertible.
pub fn null_space(matrix: &[Vec<Number>], extension: &Extension) -> Option<Vec<Vec<Number>>> {
    let mut rows = matrix.to_vec();
    let width = rows.first().map_or(0, Vec::len);
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..width {
        let rank = pivots.len();
        let Some(found) = (rank..rows.len()).find(|row| !rows[*row][column].is_zero()) else {
            continue;
        };
        rows.swap(rank, found);
        let inverse = extension.inverse(&rows[rank][column])?;
        let normalised: Vec<Number> = rows[rank]
            .iter()
            .map(|entry| extension.product(entry, &inverse))
            .collect();
        for row in &mut rows {
            let factor = row[column].clone();
            for (entry, pivot_entry) in row.iter_mut().zip(&normalised) {
                *entry = entry.difference(&extension.product(&factor, pivot_entry));
            }
        }
        rows[rank] = normalised;
        pivots.push(column);
    }
    let free: Vec<usize> = (0..width)
        .filter(|column| !pivots.contains(column))
        .collect();
    let entry = |place: usize, column: usize| match pivots.iter().position(|pivot| *pivot == place)
    {
        Some(row) => rows[row][column].negative(),
        None => Number::from(i64::from(place == column)),
    };
    Some(
        (0..width)
            .map(|place| free.iter().map(|column| entry(place, *column)).collect())
            .collect(),
    )
}
