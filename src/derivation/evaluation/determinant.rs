//! Determinants and adjugates at a point.

use std::collections::BTreeMap;

use super::elimination::eliminate;
use super::number::Number;
use super::number::extension::Extension;

/// Determinants of larger matrices are not expanded first.
const MOST_ROWS_TO_EXPAND: usize = 6;

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
