//! The built-in functions of documents.

use crate::language::built_in::{BuiltIn, Circular, Declared};
use crate::language::syntax::{Expression, Node as Written};
use crate::points::graph::Made;
use crate::points::table::Table;
use crate::points::{Failure, Unknown};

use super::Unfolding;

impl<'a> Unfolding<'a> {
    /// What a built-in function gives.
    pub(super) fn built_in(
        &mut self,
        function: &str,
        arguments: &'a [Expression],
    ) -> Result<Table, Failure> {
        let declared = Declared::of(function).ok_or(Unknown::Unsupported)?;
        match declared.call(arguments).ok_or(Unknown::Unsupported)? {
            BuiltIn::Circular(function, angle) => {
                let angle = self.scalar(angle)?;
                let (cosine, sine) = self.sheet.cosine_and_sine(angle)?;
                Ok(Table::single(match function {
                    Circular::Sine => sine,
                    Circular::Cosine => cosine,
                    Circular::Tangent => self.sheet.graph.quotient(sine, cosine)?,
                    Circular::Cotangent => self.sheet.graph.quotient(cosine, sine)?,
                }))
            }
            BuiltIn::Root(square) => {
                let square = self.scalar(square)?;
                Ok(Table::single(self.sheet.graph.root(square)?))
            }
            BuiltIn::Direction(x, y) => {
                let (x, y) = (self.scalar(x)?, self.scalar(y)?);
                Ok(Table::single(self.sheet.direction(x, y)?))
            }
            BuiltIn::Rate(inner) => self.rate(inner),
            BuiltIn::Jacobian(value, variables) => self.jacobian(value, variables),
            BuiltIn::Truncation(value, small, order) => self.truncation(value, small, order),
            BuiltIn::Coefficient(polynomial, variable, power) => {
                let power = self.natural(power)?;
                let variable = self.scalar(variable)?;
                let variable = self.variable_of(variable)?;
                let polynomial = self.scalar(polynomial)?;
                let coefficient = self.sheet.coefficient(polynomial, variable, power)?;
                Ok(Table::single(
                    self.sheet.graph.guarded(coefficient, polynomial)?,
                ))
            }
            BuiltIn::Hurwitz(polynomial, variable, size) => {
                let size = self.natural(size)? as usize;
                Ok(Table::single(self.hurwitz(polynomial, variable, size)?))
            }
            BuiltIn::Row(matrix, row) => self.part(matrix, Some(row), None),
            BuiltIn::Column(matrix, column) => self.part(matrix, None, Some(column)),
            BuiltIn::Submatrix(matrix, rows, columns) => {
                self.part(matrix, Some(rows), Some(columns))
            }
            BuiltIn::Determinant(matrix) => {
                let matrix = self.table(matrix)?;
                Ok(Table::single(self.sheet.determinant(&matrix)?))
            }
            BuiltIn::Adjugate(matrix) => {
                let matrix = self.table(matrix)?;
                self.sheet.adjugate(&matrix)
            }
            BuiltIn::Inverse(matrix) => {
                let matrix = self.table(matrix)?;
                let identity = self.sheet.identity(matrix.size()?)?;
                self.sheet.solve(&matrix, &identity)
            }
            BuiltIn::Solution(matrix, right) => {
                let (matrix, right) = (self.table(matrix)?, self.table(right)?);
                self.sheet.solve(&matrix, &right)
            }
            BuiltIn::Kernel(matrix) => {
                let matrix = self.table(matrix)?;
                self.sheet.kernel(&matrix)
            }
            BuiltIn::Transpose(matrix) => self.table(matrix)?.transposed(),
            BuiltIn::Trace(matrix) => {
                let matrix = self.table(matrix)?;
                let diagonal = (0..matrix.size()?).map(|place| matrix.get(place, place));
                let diagonal: Vec<_> = diagonal.collect::<Result<_, _>>()?;
                let trace = Table::single(self.sheet.total(diagonal)?);
                self.sheet.of_whole(&trace, &matrix)
            }
            BuiltIn::Diagonal(entries) => {
                let size = entries.len();
                Table::made(size, size, |row, column| match row == column {
                    true => self.scalar(&entries[row]),
                    false => self.sheet.graph.integer(0),
                })
            }
            BuiltIn::Identity(size) => {
                let size = self.natural(size)? as usize;
                self.sheet.identity(size)
            }
            BuiltIn::Zero(rows, columns) => {
                let (rows, columns) = (
                    self.natural(rows)? as usize,
                    self.natural(columns)? as usize,
                );
                Table::made(rows, columns, |_, _| self.sheet.graph.integer(0))
            }
        }
    }

    /// The leading principal minor of Hurwitz' matrix (a₁, a₃, …; a₀, a₂, …; 0, a₁, …) of
    /// a₀λⁿ + a₁λⁿ⁻¹ + … + aₙ.
    fn hurwitz(
        &mut self,
        polynomial: &'a Expression,
        variable: &'a Expression,
        size: usize,
    ) -> Made {
        let variable = self.scalar(variable)?;
        let variable = self.variable_of(variable)?;
        let polynomial = self.scalar(polynomial)?;
        let coefficients = self.sheet.falling_coefficients(polynomial, variable)?;
        let zero = self.sheet.graph.integer(0)?;
        let entry = |row: usize, column: usize| {
            let place = (2 * column + 2).checked_sub(row + 1);
            let coefficient = place.and_then(|place| coefficients.get(place));
            coefficient.copied().unwrap_or(zero)
        };
        let matrix = Table::made(size, size, |row, column| Ok(entry(row, column)))?;
        let determinant = self.sheet.determinant(&matrix)?;
        self.sheet.graph.guarded(determinant, polynomial)
    }

    /// A part of a matrix: these rows and columns, or all.
    fn part(
        &mut self,
        matrix: &'a Expression,
        rows: Option<&'a Expression>,
        columns: Option<&'a Expression>,
    ) -> Result<Table, Failure> {
        let matrix = self.table(matrix)?;
        let (height, width) = matrix.shape();
        let mut places = |named: Option<&'a Expression>, all| match named {
            Some(named) => self.places(named),
            None => Ok((1..=all).collect()),
        };
        let (rows, columns) = (places(rows, height)?, places(columns, width)?);
        let place = |place: usize| place.checked_sub(1).ok_or(Unknown::Shape);
        let part = Table::made(rows.len(), columns.len(), |row, column| {
            matrix.get(place(rows[row])?, place(columns[column])?)
        })?;
        self.sheet.of_whole(&part, &matrix)
    }

    fn places(&mut self, list: &'a Expression) -> Result<Vec<usize>, Failure> {
        match &list.node {
            Written::Matrix(rows) => {
                let entries = rows.iter().flatten();
                entries
                    .map(|entry| Ok(self.natural(entry)? as usize))
                    .collect()
            }
            _ => Ok(vec![self.natural(list)? as usize]),
        }
    }
}
