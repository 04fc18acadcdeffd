//! Matrices of numbers, for evaluation only.

use std::collections::BTreeMap;

use super::number::{Extension, Number};
use super::point::Tag;

/// Determinants of larger matrices are not expanded first.
const MOST_ROWS_TO_EXPAND: usize = 6;

/// A number, and the sum of angles that it is the measure of (at the point itself, nilpotent
/// elements aside) where it is one.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The number.
    pub number: Number,
    /// The angle.
    pub angle: Option<Tag>,
}

impl From<Number> for Sample {
    fn from(number: Number) -> Self {
        // 0 is the empty sum of angles.
        let angle = number.base().is_zero().then(Tag::new);
        Sample { number, angle }
    }
}

/// Rows of numbers, all of one length.
pub type Table = Vec<Vec<Sample>>;

/// A table with one entry.
pub fn single(number: Number) -> Table {
    vec![vec![Sample::from(number)]]
}

/// The numbers of a table.
pub fn numbers(table: &Table) -> Vec<Vec<Number>> {
    table
        .iter()
        .map(|row| row.iter().map(|sample| sample.number.clone()).collect())
        .collect()
}

/// A table of numbers that are no angles.
pub fn samples(numbers: Vec<Vec<Number>>) -> Table {
    numbers
        .into_iter()
        .map(|row| row.into_iter().map(Sample::from).collect())
        .collect()
}

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

/// |A| by expansion along the rows, each minor of the last rows computed once; of large matrices by
/// elimination, if it finds its pivots.
pub fn determinant(matrix: &[Vec<Number>], extension: &Extension) -> Number {
    if matrix.len() > MOST_ROWS_TO_EXPAND {
        let nothing: Vec<Vec<Number>> = vec![Vec::new(); matrix.len()];
        if let Some((determinant, _)) = eliminate(matrix, &nothing, extension) {
            return determinant;
        }
    }
    minor(
        matrix,
        &(0..matrix.len()).collect::<Vec<_>>(),
        extension,
        &mut BTreeMap::new(),
    )
}

/// The minor of the last rows and as many columns.
fn minor(
    matrix: &[Vec<Number>],
    columns: &[usize],
    extension: &Extension,
    known: &mut BTreeMap<Vec<usize>, Number>,
) -> Number {
    if columns.is_empty() {
        return Number::from(1);
    }
    if let Some(known) = known.get(columns) {
        return known.clone();
    }
    let row = &matrix[matrix.len() - columns.len()];
    let mut sum = Number::default();
    for (place, column) in columns
        .iter()
        .enumerate()
        .filter(|(_, column)| !row[**column].is_zero())
    {
        let others = [&columns[..place], &columns[place + 1..]].concat();
        let term = extension.product(&row[*column], &minor(matrix, &others, extension, known));
        sum = if place % 2 == 0 {
            sum.sum(&term)
        } else {
            sum.difference(&term)
        };
    }
    known.insert(columns.to_vec(), sum.clone());
    sum
}

/// adj A, from the minors.
pub fn adjugate(matrix: &[Vec<Number>], extension: &Extension) -> Vec<Vec<Number>> {
    let size = matrix.len();
    let cofactor = |row: usize, column: usize| {
        if size == 1 {
            return Number::from(1);
        }
        let minor = determinant(&without(matrix, column, row), extension);
        if (row + column).is_multiple_of(2) {
            minor
        } else {
            minor.negative()
        }
    };
    (0..size)
        .map(|row| (0..size).map(|column| cofactor(row, column)).collect())
        .collect()
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

fn without(matrix: &[Vec<Number>], row: usize, column: usize) -> Vec<Vec<Number>> {
    let rows = matrix.iter().enumerate().filter(|(index, _)| *index != row);
    rows.map(|(_, line)| {
        let entries = line
            .iter()
            .enumerate()
            .filter(|(index, _)| *index != column);
        entries.map(|(_, entry)| entry.clone()).collect()
    })
    .collect()
}
