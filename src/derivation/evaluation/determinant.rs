//! Determinants and adjugates at a point.

use std::collections::BTreeMap;

use super::number::Number;
use super::number::extension::Extension;

/// |A| by elimination; where no pivot is invertible although it is not 0, by expansion along the rows.
pub fn determinant(matrix: &[Vec<Number>], extension: &Extension) -> Number {
    product_of_pivots(matrix.to_vec(), extension).unwrap_or_else(|| {
        let columns: Vec<usize> = (0..matrix.len()).collect();
        minor(matrix, &columns, extension, &mut BTreeMap::new())
    })
}

fn product_of_pivots(mut rows: Vec<Vec<Number>>, extension: &Extension) -> Option<Number> {
    let product = |a: &Number, b: &Number| extension.product(a, b);
    let mut determinant = Number::from(1);
    for column in 0..rows.len() {
        let below = column..rows.len();
        let pivot = below.clone().find_map(|row| {
            let inverse = extension.inverse(&rows[row][column])?;
            Some((row, inverse))
        });
        let Some((pivot, inverse)) = pivot else {
            let mut entries = below.map(|row| &rows[row][column]);
            return entries.all(Number::is_zero).then(Number::default);
        };
        if pivot != column {
            rows.swap(pivot, column);
            determinant = determinant.negative();
        }
        determinant = product(&determinant, &rows[column][column]);
        let (above, below) = rows.split_at_mut(column + 1);
        for row in below.iter_mut().filter(|row| !row[column].is_zero()) {
            let factor = product(&row[column], &inverse);
            for (entry, above) in row.iter_mut().zip(&above[column]).skip(column + 1) {
                *entry = entry.difference(&product(&factor, above));
            }
        }
    }
    Some(determinant)
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
