//! Matrices over any [`Arithmetic`].

use super::arithmetic::Arithmetic;

/// A rectangular array of entries, row by row; it has at least one row and one column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix<T> {
    rows: usize,
    columns: usize,
    entries: Vec<T>,
}

impl<T: Clone> Matrix<T> {
    /// The matrix with the given entry at each place (row, column), counted from 0.
    ///
    /// # Panics
    ///
    /// If there is no row or no column.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> T) -> Self {
        assert!(rows > 0 && columns > 0, "a matrix has rows and columns");
        let entries = (0..rows * columns)
            .map(|place| entry(place / columns, place % columns))
            .collect();
        Matrix {
            rows,
            columns,
            entries,
        }
    }

    /// Like [`Matrix::from_fn`], stopping at the first error.
    ///
    /// # Errors
    ///
    /// The first error of an entry.
    ///
    /// # Panics
    ///
    /// If there is no row or no column.
    pub fn try_from_fn<E>(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> Result<T, E>,
    ) -> Result<Self, E> {
        assert!(rows > 0 && columns > 0, "a matrix has rows and columns");
        let entries = (0..rows * columns)
            .map(|place| entry(place / columns, place % columns))
            .collect::<Result<Vec<T>, E>>()?;
        Ok(Matrix {
            rows,
            columns,
            entries,
        })
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// (rows, columns).
    pub fn shape(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }

    /// Whether there are as many rows as columns.
    pub fn is_square(&self) -> bool {
        self.rows == self.columns
    }

    /// The entry at a place that exists.
    ///
    /// # Panics
    ///
    /// If the place lies outside the matrix.
    pub fn at(&self, row: usize, column: usize) -> &T {
        assert!(column < self.columns, "column {column} of {}", self.columns);
        &self.entries[row * self.columns + column]
    }

    /// The entries, row by row.
    pub fn entries(&self) -> &[T] {
        &self.entries
    }

    /// The matrix of the images of the entries.
    pub fn map<U: Clone>(&self, image: impl FnMut(&T) -> U) -> Matrix<U> {
        Matrix {
            rows: self.rows,
            columns: self.columns,
            entries: self.entries.iter().map(image).collect(),
        }
    }

    /// Like [`Matrix::map`], stopping at the first error.
    ///
    /// # Errors
    ///
    /// The first error of an entry.
    pub fn try_map<U: Clone, E>(
        &self,
        image: impl FnMut(&T) -> Result<U, E>,
    ) -> Result<Matrix<U>, E> {
        let entries = self.entries.iter().map(image).collect::<Result<_, E>>()?;
        Ok(Matrix {
            rows: self.rows,
            columns: self.columns,
            entries,
        })
    }

    /// Aᵀ.
    pub fn transpose(&self) -> Self {
        Matrix::from_fn(self.columns, self.rows, |row, column| {
            self.at(column, row).clone()
        })
    }

    /// The matrix of the given rows and columns, in the given order.
    ///
    /// # Panics
    ///
    /// If there is no row or no column, or one lies outside the matrix.
    pub fn select(&self, rows: &[usize], columns: &[usize]) -> Self {
        Matrix::from_fn(rows.len(), columns.len(), |row, column| {
            self.at(rows[row], columns[column]).clone()
        })
    }

    /// A·B, for A with as many columns as B has rows: (A·B)ᵢⱼ = Σ_k aᵢₖ bₖⱼ.
    ///
    /// Complexity: rows(A)·columns(A)·columns(B) products of entries.
    ///
    /// # Errors
    ///
    /// Those of the arithmetic.
    ///
    /// # Panics
    ///
    /// If A has not as many columns as B has rows.
    pub fn product<A>(&self, other: &Self, arithmetic: &A) -> Result<Self, A::Error>
    where
        A: Arithmetic<Element = T>,
    {
        assert_eq!(self.columns, other.rows, "columns of A and rows of B");
        Matrix::try_from_fn(self.rows, other.columns, |row, column| {
            let mut sum = arithmetic.product(self.at(row, 0), other.at(0, column))?;
            for inner in 1..self.columns {
                let term = arithmetic.product(self.at(row, inner), other.at(inner, column))?;
                sum = arithmetic.sum(&sum, &term)?;
            }
            Ok(sum)
        })
    }

    /// The entries of two matrices of one shape, combined place by place.
    ///
    /// # Errors
    ///
    /// The first error of a combination.
    ///
    /// # Panics
    ///
    /// If the shapes differ.
    pub fn zip_with<E>(
        &self,
        other: &Self,
        mut combine: impl FnMut(&T, &T) -> Result<T, E>,
    ) -> Result<Self, E> {
        assert_eq!(self.shape(), other.shape(), "two matrices of one shape");
        Matrix::try_from_fn(self.rows, self.columns, |row, column| {
            combine(self.at(row, column), other.at(row, column))
        })
    }
}
