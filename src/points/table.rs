//! Matrices of nodes: rows of one length.

use super::graph::{Made, NodeId};
use super::{Failure, Unknown};

/// Nodes in rows and columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    rows: usize,
    columns: usize,
    /// Row by row.
    entries: Vec<NodeId>,
}

impl Table {
    /// A table with one entry.
    pub fn single(entry: NodeId) -> Self {
        Table {
            rows: 1,
            columns: 1,
            entries: vec![entry],
        }
    }

    /// A table made entry by entry, from row and column.
    pub fn made(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> Made,
    ) -> Result<Self, Failure> {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let entries: Result<Vec<NodeId>, Failure> =
            places.map(|(row, column)| entry(row, column)).collect();
        Ok(Table {
            rows,
            columns,
            entries: entries?,
        })
    }

    /// A table of the same shape, made from each entry.
    pub fn each(&self, mut image: impl FnMut(NodeId) -> Made) -> Result<Self, Failure> {
        let entries = self.entries.iter().map(|entry| image(*entry));
        Ok(Table {
            entries: entries.collect::<Result<_, _>>()?,
            ..*self
        })
    }

    /// A table made from the entries at the same places of two of one shape.
    pub fn zipped(
        &self,
        other: &Table,
        mut image: impl FnMut(NodeId, NodeId) -> Made,
    ) -> Result<Self, Failure> {
        if self.shape() != other.shape() {
            return Err(Unknown::Shape.into());
        }
        let pairs = self.entries.iter().zip(&other.entries);
        let entries = pairs.map(|(a, b)| image(*a, *b));
        Ok(Table {
            entries: entries.collect::<Result<_, _>>()?,
            ..*self
        })
    }

    /// Tables of one width, each below the one before.
    pub fn stacked(tables: &[Table]) -> Result<Self, Failure> {
        let columns = tables.first().map_or(0, |table| table.columns);
        if tables.iter().any(|table| table.columns != columns) {
            return Err(Unknown::Shape.into());
        }
        Ok(Table {
            rows: tables.iter().map(|table| table.rows).sum(),
            columns,
            entries: tables.iter().flat_map(Table::entries).copied().collect(),
        })
    }

    /// How many rows and columns it has.
    pub fn shape(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }

    /// How many rows a table has with as many columns.
    pub fn size(&self) -> Result<usize, Failure> {
        match self.rows == self.columns {
            true => Ok(self.rows),
            false => Err(Unknown::Shape.into()),
        }
    }

    /// All entries, row by row.
    pub fn entries(&self) -> &[NodeId] {
        &self.entries
    }

    /// The entry, if there is only one.
    pub fn as_single(&self) -> Option<NodeId> {
        match self.entries[..] {
            [entry] => Some(entry),
            _ => None,
        }
    }

    /// An entry, counted from 0.
    pub fn get(&self, row: usize, column: usize) -> Made {
        match row < self.rows && column < self.columns {
            true => Ok(self.entries[row * self.columns + column]),
            false => Err(Unknown::Shape.into()),
        }
    }

    /// The row and the column of an entry, from its place in [`Table::entries`].
    pub fn position(&self, place: usize) -> (usize, usize) {
        (place / self.columns, place % self.columns)
    }

    /// The rows, for elimination.
    pub fn lines(&self) -> Vec<Vec<NodeId>> {
        let line = |row: usize| self.entries[row * self.columns..][..self.columns].to_vec();
        (0..self.rows).map(line).collect()
    }

    /// Aᵀ
    pub fn transposed(&self) -> Result<Self, Failure> {
        Table::made(self.columns, self.rows, |row, column| self.get(column, row))
    }

    /// The table without a row and a column.
    pub fn without(&self, row: usize, column: usize) -> Result<Self, Failure> {
        let skip = |place: usize, left_out: usize| place + usize::from(place >= left_out);
        let (rows, columns) = (self.rows.saturating_sub(1), self.columns.saturating_sub(1));
        Table::made(rows, columns, |i, j| {
            self.get(skip(i, row), skip(j, column))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::graph::Graph;

    #[test]
    fn shapes_that_do_not_fit_are_refused() {
        let mut graph = Graph::default();
        let mut table = |rows, columns| Table::made(rows, columns, |_, _| graph.integer(1));
        let (wide, high) = (table(1, 2).unwrap(), table(2, 1).unwrap());
        let shape = Err(Failure::from(Unknown::Shape));
        assert_eq!(wide.zipped(&high, |a, _| Ok(a)), shape);
        assert_eq!(Table::stacked(&[wide.clone(), high.clone()]), shape);
        assert_eq!(wide.get(1, 0).map(Table::single), shape);
        assert_eq!(wide.size().map(|_| wide.clone()), shape);
        assert_eq!(wide.transposed(), Ok(high));
    }
}
