//! Matrices: their parts and kinds, linear systems and null spaces.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::linear_system::null_space;
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{quantity, shape};
use crate::derivation::elaboration::limit::check_sides;
use crate::derivation::quantity::{Quantities, Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Node, Span};

impl Elaborator {
    /// The sum of the diagonal.
    pub(super) fn trace(&mut self, matrix: &Expression, span: &Span) -> Result<Value, Diagnostic> {
        let matrix = self.square(matrix)?;
        let arithmetic = Quantities(&self.ring);
        let mut diagonal = (0..matrix.rows()).map(|place| matrix.at(place, place));
        let trace = diagonal.try_fold(arithmetic.zero(), |sum, entry| arithmetic.sum(&sum, entry));
        Ok(trace.map_err(|error| quantity(error, span))?.scalar())
    }

    /// The matrix with a diagonal and zeros elsewhere.
    pub(super) fn diagonal(
        &mut self,
        diagonal: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let size = diagonal.len();
        check_sides(size, size, span)?;
        let mut entries = Vec::new();
        for entry in diagonal {
            entries.push(self.scalar(entry)?);
        }
        let zero = Quantity::number(Rational::ZERO);
        Ok(Matrix::from_fn(size, size, |row, column| {
            if row == column {
                entries[row].clone()
            } else {
                zero.clone()
            }
        }))
    }

    /// The matrix of zeros.
    pub(super) fn zero_matrix(
        &mut self,
        rows: &Expression,
        columns: &Expression,
    ) -> Result<Value, Diagnostic> {
        let (rows, columns) = (self.positive(rows)?, self.positive(columns)?);
        Ok(Matrix::from_fn(rows, columns, |_, _| {
            Quantity::number(Rational::ZERO)
        }))
    }

    /// A row of a matrix.
    pub(super) fn row_of(
        &mut self,
        matrix: &Expression,
        place: &Expression,
    ) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let place = self.place(place, value.rows())?;
        Ok(value.select(&[place], &every(value.columns())))
    }

    /// A column of a matrix.
    pub(super) fn column_of(
        &mut self,
        matrix: &Expression,
        place: &Expression,
    ) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let place = self.place(place, value.columns())?;
        Ok(value.select(&every(value.rows()), &[place]))
    }

    /// Some rows and columns of a matrix.
    pub(super) fn submatrix(
        &mut self,
        matrix: &Expression,
        rows: &Expression,
        columns: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let rows = self.places(rows, value.rows())?;
        let columns = self.places(columns, value.columns())?;
        check_sides(rows.len(), columns.len(), span)?;
        Ok(value.select(&rows, &columns))
    }

    /// The columns that span {x : A·x = 0}, side by side.
    pub(super) fn kernel(&mut self, matrix: &Expression, span: &Span) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let found =
            null_space(&value, &Quantities(&self.ring)).map_err(|error| quantity(error, span))?;
        for pivot in &found.pivots {
            self.require_non_zero(&pivot.value, span)?;
        }
        if found.basis.is_empty() {
            let message = "only 0 is mapped to 0 by this matrix";
            return Err(
                Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                    .with_label("has no null space")
                    .with_help(
                        "its determinant is not 0 for all values; take it `at` values where it is",
                    ),
            );
        }
        Ok(Matrix::from_fn(
            value.columns(),
            found.basis.len(),
            |row, column| found.basis[column].at(row, 0).clone(),
        ))
    }

    /// A⁻¹·b; |A| must not vanish.
    pub(super) fn solution(
        &mut self,
        matrix: &Expression,
        right: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let a = self.square(matrix)?;
        let b = self.value(right)?;
        if b.rows() != a.rows() {
            return Err(shape(
                span,
                "the right side has not as many rows as the matrix".into(),
            )
            .with_label(format!("{} rows, not {}", b.rows(), a.rows()))
            .with_help("the right side of n equations is a column with n entries"));
        }
        let singular = || {
            let message = "this linear system is singular: its determinant is identically 0";
            Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                .with_label("has no unique solution")
                .with_help(
                    "put other equations in the place of those that follow from the rest; \
                     `kernel(…)` of the matrix shows what they leave open",
                )
        };
        let solved = self.solved(&a, &b, span)?.ok_or_else(singular)?;
        self.divide(&solved.numerators, &solved.determinant, span)
    }

    /// What an expression is, if that is a square matrix.
    pub(super) fn square(&mut self, matrix: &Expression) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        if value.is_square() {
            return Ok(value);
        }
        let (rows, columns) = value.shape();
        Err(shape(
            &matrix.span,
            format!("a square matrix is needed, not {rows}×{columns}"),
        )
        .with_help("`submatrix(…)` takes rows and columns out of a matrix"))
    }

    /// A number of rows or columns.
    pub(super) fn positive(&mut self, expression: &Expression) -> Result<usize, Diagnostic> {
        let number = self.natural(expression)?;
        if number > 0 {
            return Ok(number);
        }
        Err(shape(
            &expression.span,
            "a matrix has at least one row and one column".into(),
        )
        .with_help("write 1 or more"))
    }

    /// A row or column, counted from 1 in the document and from 0 here.
    fn place(&mut self, expression: &Expression, count: usize) -> Result<usize, Diagnostic> {
        let place = self.natural(expression)?;
        if (1..=count).contains(&place) {
            return Ok(place - 1);
        }
        Err(shape(
            &expression.span,
            format!("there is no row or column {place}"),
        )
        .with_label(format!("not one of 1, …, {count}"))
        .with_help("rows and columns count from 1"))
    }

    fn places(&mut self, list: &Expression, count: usize) -> Result<Vec<usize>, Diagnostic> {
        match &list.node {
            Node::Matrix(rows) => rows
                .iter()
                .flatten()
                .map(|entry| self.place(entry, count))
                .collect(),
            _ => Ok(vec![self.place(list, count)?]),
        }
    }
}

fn every(count: usize) -> Vec<usize> {
    (0..count).collect()
}
