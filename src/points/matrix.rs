//! Matrices of nodes.

use std::collections::BTreeMap;

use super::graph::{Made, NodeId};
use super::sheet::Sheet;
use super::{Failure, NoValue};

/// Rows of nodes, all of one length.
pub type Table = Vec<Vec<NodeId>>;

/// Up to how many rows a determinant is found by minors, which divide by nothing.
const MOST_ROWS_BY_MINORS: usize = 7;

/// The row-reduced form of a matrix.
struct Reduced {
    rows: Table,
    /// The column of the pivot of each of the first rows.
    pivots: Vec<usize>,
    /// The product of what was divided by, with the sign of the exchanges.
    determinant: NodeId,
}

/// Whether a table has one entry.
pub fn is_single(table: &Table) -> bool {
    table.len() == 1 && table[0].len() == 1
}

/// Aᵀ
pub fn transpose(table: &Table) -> Table {
    let width = table.first().map_or(0, Vec::len);
    let column = |place: usize| table.iter().map(|row| row[place]).collect();
    (0..width).map(column).collect()
}

impl Sheet {
    /// The identity matrix.
    pub fn identity(&mut self, size: usize) -> Result<Table, Failure> {
        let (zero, one) = (self.graph.integer(0)?, self.graph.integer(1)?);
        let entry = |row, column| if row == column { one } else { zero };
        let row = |row| (0..size).map(|column| entry(row, column)).collect();
        Ok((0..size).map(row).collect())
    }

    /// The image of every entry.
    pub fn each(
        &mut self,
        table: &Table,
        mut image: impl FnMut(&mut Sheet, NodeId) -> Made,
    ) -> Result<Table, Failure> {
        let row = |row: &Vec<NodeId>| row.iter().map(|entry| image(self, *entry)).collect();
        table.iter().map(row).collect()
    }

    /// Parts of a matrix, which have values where all of its entries have one.
    pub fn of_whole(&mut self, parts: &Table, whole: &Table) -> Result<Table, Failure> {
        let mut needed = self.graph.integer(0)?;
        for entry in whole.iter().flatten() {
            needed = self.graph.guarded(needed, *entry)?;
        }
        self.each(parts, |sheet, part| sheet.graph.guarded(part, needed))
    }

    /// A·B, or a multiple of one of them where the other has one entry.
    pub fn table_product(&mut self, a: &Table, b: &Table) -> Result<Table, Failure> {
        if is_single(a) {
            return self.each(b, |sheet, entry| sheet.graph.product(a[0][0], entry));
        }
        if is_single(b) {
            return self.each(a, |sheet, entry| sheet.graph.product(entry, b[0][0]));
        }
        let columns = transpose(b);
        let mut rows = Vec::new();
        for row in a {
            let mut entries = Vec::new();
            for column in &columns {
                let mut terms = Vec::new();
                for (x, y) in row.iter().zip(column) {
                    terms.push(self.graph.product(*x, *y)?);
                }
                entries.push(self.total(terms)?);
            }
            rows.push(entries);
        }
        Ok(rows)
    }

    /// |A|
    pub fn determinant(&mut self, table: &Table) -> Made {
        if table.len() > MOST_ROWS_BY_MINORS {
            let reduced = self.reduced(table, table.len())?;
            return match reduced.pivots.len() == table.len() {
                true => self.graph.by_detour(reduced.determinant),
                false => self.graph.integer(0),
            };
        }
        let columns: Vec<usize> = (0..table.len()).collect();
        self.minor(table, &columns, &mut BTreeMap::new())
    }

    /// The minor of the last rows and as many columns.
    fn minor(
        &mut self,
        table: &Table,
        columns: &[usize],
        known: &mut BTreeMap<Vec<usize>, NodeId>,
    ) -> Made {
        if columns.is_empty() {
            return self.graph.integer(1);
        }
        if let Some(known) = known.get(columns) {
            return Ok(*known);
        }
        let row = &table[table.len() - columns.len()];
        let mut sum = self.graph.integer(0)?;
        for (place, column) in columns.iter().enumerate() {
            let others = [&columns[..place], &columns[place + 1..]].concat();
            // What stands beside a 0 matters only where it may have no value.
            if self.graph.is_zero(row[*column]) && self.is_total(table) {
                continue;
            }
            let minor = self.minor(table, &others, known)?;
            let term = self.graph.product(row[*column], minor)?;
            sum = match place % 2 {
                0 => self.graph.sum(sum, term)?,
                _ => self.graph.difference(sum, term)?,
            };
        }
        known.insert(columns.to_vec(), sum);
        Ok(sum)
    }

    /// Whether every entry has a value under every assignment.
    fn is_total(&self, table: &Table) -> bool {
        table
            .iter()
            .flatten()
            .all(|entry| self.graph.is_total(*entry))
    }

    /// adj A
    pub fn adjugate(&mut self, table: &Table) -> Result<Table, Failure> {
        let size = table.len();
        let mut rows = vec![Vec::new(); size];
        for (row, entries) in rows.iter_mut().enumerate() {
            for column in 0..size {
                let without = without(table, column, row);
                let minor = self.determinant(&without)?;
                let minor = match (row + column) % 2 {
                    0 => minor,
                    _ => self.graph.negative(minor)?,
                };
                entries.push(minor);
            }
        }
        self.of_whole(&rows, table)
    }

    /// A⁻¹B
    pub fn solve(&mut self, a: &Table, b: &Table) -> Result<Table, Failure> {
        if a.len() <= MOST_ROWS_BY_MINORS {
            let determinant = self.determinant(a)?;
            if self.graph.is_zero(determinant) {
                return Err(NoValue::Singular.into());
            }
            let adjugate = self.adjugate(a)?;
            let product = self.table_product(&adjugate, b)?;
            return self.each(&product, |sheet, entry| {
                sheet.graph.quotient(entry, determinant)
            });
        }
        let both: Table = a
            .iter()
            .zip(b)
            .map(|(a, b)| [a.clone(), b.clone()].concat())
            .collect();
        let reduced = self.reduced(&both, a.len())?;
        if reduced.pivots.len() < a.len() {
            return Err(NoValue::Singular.into());
        }
        let right = reduced.rows.iter().map(|row| row[a.len()..].to_vec());
        let right: Table = right.collect();
        self.each(&right, |sheet, entry| sheet.graph.by_detour(entry))
    }

    /// Columns that span {x : A·x = 0}, each with a 1 at a free place and zeros at the others.
    pub fn kernel(&mut self, table: &Table) -> Result<Table, Failure> {
        let width = table.first().map_or(0, Vec::len);
        let Reduced { rows, pivots, .. } = self.reduced(table, width)?;
        let free: Vec<usize> = (0..width)
            .filter(|column| !pivots.contains(column))
            .collect();
        let mut kernel = vec![Vec::new(); width];
        for (place, line) in kernel.iter_mut().enumerate() {
            for column in &free {
                line.push(match pivots.iter().position(|pivot| *pivot == place) {
                    Some(row) => self.graph.negative(rows[row][*column])?,
                    None => self.graph.integer(i64::from(place == *column))?,
                });
            }
        }
        let kernel = self.each(&kernel, |sheet, entry| sheet.graph.by_detour(entry))?;
        self.of_whole(&kernel, table)
    }

    /// The reduced form by Gauss and Jordan, with pivots in the first `width` columns that are not 0
    /// everywhere.
    fn reduced(&mut self, table: &Table, width: usize) -> Result<Reduced, Failure> {
        let mut rows = table.clone();
        let mut pivots = Vec::new();
        let mut determinant = self.graph.integer(1)?;
        for column in 0..width {
            let rank = pivots.len();
            let Some(found) = self.pivot(&rows, rank, column)? else {
                continue;
            };
            if found != rank {
                rows.swap(rank, found);
                determinant = self.graph.negative(determinant)?;
            }
            let pivot = rows[rank][column];
            determinant = self.graph.product(determinant, pivot)?;
            let normal: Result<Vec<NodeId>, Failure> = rows[rank]
                .iter()
                .map(|entry| self.graph.quotient(*entry, pivot))
                .collect();
            let normal = normal?;
            for (index, row) in rows.iter_mut().enumerate() {
                let factor = row[column];
                if index != rank && !self.graph.is_zero(factor) {
                    for (entry, above) in row.iter_mut().zip(&normal) {
                        let part = self.graph.product(factor, *above)?;
                        *entry = self.graph.difference(*entry, part)?;
                    }
                }
            }
            rows[rank] = normal;
            pivots.push(column);
        }
        Ok(Reduced {
            rows,
            pivots,
            determinant,
        })
    }

    /// The first row, from one on, whose entry in a column is not 0 everywhere; a number if there is one.
    fn pivot(
        &mut self,
        rows: &Table,
        from: usize,
        column: usize,
    ) -> Result<Option<usize>, Failure> {
        let is_number = |sheet: &Sheet, row: usize| {
            let number = sheet.graph.as_number(rows[row][column]);
            number.is_some_and(|number| !number.is_zero())
        };
        if let Some(row) = (from..rows.len()).find(|row| is_number(self, *row)) {
            return Ok(Some(row));
        }
        for (place, row) in rows.iter().enumerate().skip(from) {
            if !self.vanishes(row[column])? {
                return Ok(Some(place));
            }
        }
        Ok(None)
    }
}

/// A matrix without a row and a column.
fn without(table: &Table, row: usize, column: usize) -> Table {
    let rows = table.iter().enumerate().filter(|(place, _)| *place != row);
    rows.map(|(_, line)| {
        let entries = line
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != column);
        entries.map(|(_, entry)| *entry).collect()
    })
    .collect()
}
