//! Matrices of nodes.

use std::collections::BTreeMap;

use super::graph::{Made, NodeId};
use super::sheet::Sheet;
use super::table::Table;
use super::{Failure, NoValue, Unknown};

/// Up to how many rows a determinant is found by minors, which divide by nothing.
const MOST_ROWS_BY_MINORS: usize = 7;

/// The row-reduced form of a matrix.
struct Reduced {
    rows: Vec<Vec<NodeId>>,
    /// The column of the pivot of each of the first rows.
    pivots: Vec<usize>,
    /// The product of what was divided by, with the sign of the exchanges.
    determinant: NodeId,
}

impl Sheet {
    /// The identity matrix.
    pub fn identity(&mut self, size: usize) -> Result<Table, Failure> {
        Table::made(size, size, |row, column| {
            self.graph.integer(i64::from(row == column))
        })
    }

    /// The image of every entry.
    pub fn each(
        &mut self,
        table: &Table,
        mut image: impl FnMut(&mut Sheet, NodeId) -> Made,
    ) -> Result<Table, Failure> {
        table.each(|entry| image(self, entry))
    }

    /// Parts of a matrix, which have values where all of its entries have one.
    pub fn of_whole(&mut self, parts: &Table, whole: &Table) -> Result<Table, Failure> {
        let mut needed = self.graph.integer(0)?;
        for entry in whole.entries() {
            needed = self.graph.guarded(needed, *entry)?;
        }
        parts.each(|part| self.graph.guarded(part, needed))
    }

    /// A·B, or a multiple of one of them where the other has one entry.
    pub fn table_product(&mut self, a: &Table, b: &Table) -> Result<Table, Failure> {
        if let Some(factor) = a.as_single() {
            return b.each(|entry| self.graph.product(factor, entry));
        }
        if let Some(factor) = b.as_single() {
            return a.each(|entry| self.graph.product(entry, factor));
        }
        let ((rows, inner), (height, columns)) = (a.shape(), b.shape());
        if inner != height {
            return Err(Unknown::Shape.into());
        }
        Table::made(rows, columns, |row, column| {
            let mut terms = Vec::new();
            for place in 0..inner {
                let (x, y) = (a.get(row, place)?, b.get(place, column)?);
                terms.push(self.graph.product(x, y)?);
            }
            self.total(terms)
        })
    }

    /// |A|
    pub fn determinant(&mut self, table: &Table) -> Made {
        let size = table.size()?;
        if size > MOST_ROWS_BY_MINORS {
            let reduced = self.reduced(table.lines(), size)?;
            return match reduced.pivots.len() == size {
                true => self.graph.by_detour(reduced.determinant),
                false => self.graph.integer(0),
            };
        }
        let columns: Vec<usize> = (0..size).collect();
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
        let row = table.size()? - columns.len();
        let mut sum = self.graph.integer(0)?;
        for (place, column) in columns.iter().enumerate() {
            let others = [&columns[..place], &columns[place + 1..]].concat();
            let entry = table.get(row, *column)?;
            // What stands beside a 0 matters only where it may have no value.
            if self.graph.is_zero(entry) && self.is_total(table) {
                continue;
            }
            let minor = self.minor(table, &others, known)?;
            let term = self.graph.product(entry, minor)?;
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
        let mut entries = table.entries().iter();
        entries.all(|entry| self.graph.is_total(*entry))
    }

    /// adj A
    pub fn adjugate(&mut self, table: &Table) -> Result<Table, Failure> {
        let size = table.size()?;
        let adjugate = Table::made(size, size, |row, column| {
            let minor = self.determinant(&table.without(column, row)?)?;
            match (row + column) % 2 {
                0 => Ok(minor),
                _ => self.graph.negative(minor),
            }
        })?;
        self.of_whole(&adjugate, table)
    }

    /// A⁻¹B
    pub fn solve(&mut self, a: &Table, b: &Table) -> Result<Table, Failure> {
        let size = a.size()?;
        if size <= MOST_ROWS_BY_MINORS {
            let determinant = self.determinant(a)?;
            if self.graph.is_zero(determinant) {
                return Err(NoValue::Singular.into());
            }
            let adjugate = self.adjugate(a)?;
            let product = self.table_product(&adjugate, b)?;
            return product.each(|entry| self.graph.quotient(entry, determinant));
        }
        let both = Table::stacked(&[a.transposed()?, b.transposed()?])?.transposed()?;
        let Reduced { rows, pivots, .. } = self.reduced(both.lines(), size)?;
        if pivots.len() < size {
            return Err(NoValue::Singular.into());
        }
        let (_, columns) = b.shape();
        Table::made(size, columns, |row, column| {
            self.graph.by_detour(rows[row][size + column])
        })
    }

    /// Columns that span {x : A·x = 0}, each with a 1 at a free place and zeros at the others.
    pub fn kernel(&mut self, table: &Table) -> Result<Table, Failure> {
        let (_, width) = table.shape();
        let Reduced { rows, pivots, .. } = self.reduced(table.lines(), width)?;
        let free = (0..width).filter(|column| !pivots.contains(column));
        let free: Vec<usize> = free.collect();
        let kernel = Table::made(width, free.len(), |place, column| {
            let pivot = pivots.iter().position(|pivot| *pivot == place);
            let entry = match pivot {
                Some(row) => self.graph.negative(rows[row][free[column]])?,
                None => self.graph.integer(i64::from(place == free[column]))?,
            };
            self.graph.by_detour(entry)
        })?;
        self.of_whole(&kernel, table)
    }

    /// The reduced form by Gauss and Jordan, with pivots in the first `width` columns that are not 0
    /// everywhere.
    fn reduced(&mut self, mut rows: Vec<Vec<NodeId>>, width: usize) -> Result<Reduced, Failure> {
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
        rows: &[Vec<NodeId>],
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
