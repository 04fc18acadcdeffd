//! Matrices of numbers, for evaluation only.

use super::evaluator::Failure;
use super::number::Number;
use super::number::extension::Extension;
use super::sample::Sample;

/// Rows of numbers, all of one length.
pub type Table = Vec<Vec<Sample>>;

/// A table with one entry.
pub fn single(number: Number) -> Table {
    vec![vec![Sample::from(number)]]
}

/// The entry of a table with one entry.
///
/// # Errors
///
/// The reason where it has more or none.
pub fn only(table: &Table) -> Result<&Sample, Failure> {
    match (table.len(), table.first().map(Vec::as_slice)) {
        (1, Some([sample])) => Ok(sample),
        _ => Err("a single number is needed".into()),
    }
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

/// The identity matrix.
pub fn identity(size: usize) -> Table {
    let entry = |row: usize, column: usize| Sample::from(Number::from(i64::from(row == column)));
    (0..size)
        .map(|row| (0..size).map(|column| entry(row, column)).collect())
        .collect()
}

/// The image of every entry.
pub fn each(table: &Table, image: impl Fn(&Sample) -> Sample) -> Table {
    table
        .iter()
        .map(|row| row.iter().map(&image).collect())
        .collect()
}

/// The entries of two tables, combined in pairs.
pub fn zip_with(a: &Table, b: &Table, combine: impl Fn(&Sample, &Sample) -> Sample) -> Table {
    let rows = a.iter().zip(b);
    rows.map(|(a, b)| a.iter().zip(b).map(|(a, b)| combine(a, b)).collect())
        .collect()
}

/// A·B, or a multiple of one of them where the other has one entry.
pub fn product(a: &Table, b: &Table, extension: &Extension) -> Table {
    let is_single = |table: &Table| table.len() == 1 && table[0].len() == 1;
    if is_single(a) {
        return each(b, |entry| a[0][0].product(entry, extension));
    }
    if is_single(b) {
        return each(a, |entry| b[0][0].product(entry, extension));
    }
    let entry = |row: &[Sample], column: usize| {
        let terms = row
            .iter()
            .zip(b)
            .map(|(x, line)| extension.product(&x.number, &line[column].number));
        Sample::from(terms.fold(Number::default(), |sum, term| sum.sum(&term)))
    };
    let width = b.first().map_or(0, Vec::len);
    a.iter()
        .map(|row| (0..width).map(|column| entry(row, column)).collect())
        .collect()
}

/// Aᵀ.
pub fn transpose(table: &Table) -> Table {
    let width = table.first().map_or(0, Vec::len);
    let column = |place: usize| table.iter().map(|row| row[place].clone()).collect();
    (0..width).map(column).collect()
}

/// Some rows and columns, counted from 1.
///
/// # Errors
///
/// The reason where there is no such row or column.
pub fn select(table: &Table, rows: &[usize], columns: &[usize]) -> Result<Table, Failure> {
    let entry = |row: usize, column: usize| -> Option<Sample> {
        table
            .get(row.checked_sub(1)?)?
            .get(column.checked_sub(1)?)
            .cloned()
    };
    rows.iter()
        .map(|row| columns.iter().map(|column| entry(*row, *column)).collect())
        .collect::<Option<Table>>()
        .ok_or("no such row or column".into())
}
