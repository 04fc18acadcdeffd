//! Gaussian elimination at a point.

use super::number::Number;
use super::number::extension::Extension;

/// A⁻¹B by Gaussian elimination on [A | B]; nothing where a column has no invertible pivot.
pub fn solution(
    matrix: &[Vec<Number>],
    right: &[Vec<Number>],
    extension: &Extension,
) -> Option<Vec<Vec<Number>>> {
    let size = matrix.len();
    let mut rows: Vec<Vec<Number>> = matrix
        .iter()
        .zip(right)
        .map(|(a, b)| a.iter().chain(b).cloned().collect())
        .collect();
    for column in 0..size {
        let (pivot, inverse) = (column..size).find_map(|row| {
            let inverse = extension.inverse(&rows[row][column])?;
            Some((row, inverse))
        })?;
        rows.swap(pivot, column);
        let normalised: Vec<Number> = rows[column]
            .iter()
            .map(|entry| extension.product(entry, &inverse))
            .collect();
        for row in &mut rows {
            let factor = row[column].clone();
            for (entry, pivot_entry) in row.iter_mut().zip(&normalised) {
                *entry = entry.difference(&extension.product(&factor, pivot_entry));
            }
        }
        rows[column] = normalised;
    }
    Some(rows.into_iter().map(|row| row[size..].to_vec()).collect())
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
