//! The built-in functions of documents.

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
        match (function, arguments) {
            ("sin" | "cos" | "tan" | "cot", [angle]) => {
                let angle = self.scalar(angle)?;
                let (cosine, sine) = self.sheet.cosine_and_sine(angle)?;
                Ok(Table::single(match function {
                    "sin" => sine,
                    "cos" => cosine,
                    "tan" => self.sheet.graph.quotient(sine, cosine)?,
                    _ => self.sheet.graph.quotient(cosine, sine)?,
                }))
            }
            ("sqrt", [square]) => {
                let square = self.scalar(square)?;
                Ok(Table::single(self.sheet.graph.root(square)?))
            }
            ("angle", [x, y]) => {
                let (x, y) = (self.scalar(x)?, self.scalar(y)?);
                Ok(Table::single(self.sheet.direction(x, y)?))
            }
            ("dt", [inner]) => self.rate(inner),
            ("d", [value, variables]) => self.jacobian(value, variables),
            ("truncate", [value, small, order]) => self.truncation(value, small, order),
            ("coefficient", [polynomial, variable, power]) => {
                let power = self.natural(power)?;
                let variable = self.scalar(variable)?;
                let variable = self.variable_of(variable)?;
                let polynomial = self.scalar(polynomial)?;
                let coefficient = self.sheet.coefficient(polynomial, variable, power)?;
                Ok(Table::single(
                    self.sheet.graph.guarded(coefficient, polynomial)?,
                ))
            }
            ("hurwitz", [polynomial, variable, size]) => {
                let size = self.natural(size)? as usize;
                Ok(Table::single(self.hurwitz(polynomial, variable, size)?))
            }
            _ => self.matrix_function(function, arguments),
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

    fn matrix_function(
        &mut self,
        function: &str,
        arguments: &'a [Expression],
    ) -> Result<Table, Failure> {
        match (function, arguments) {
            ("det", [matrix]) => {
                let matrix = self.table(matrix)?;
                Ok(Table::single(self.sheet.determinant(&matrix)?))
            }
            ("adjugate", [matrix]) => {
                let matrix = self.table(matrix)?;
                self.sheet.adjugate(&matrix)
            }
            ("inverse", [matrix]) => {
                let matrix = self.table(matrix)?;
                let identity = self.sheet.identity(matrix.size()?)?;
                self.sheet.solve(&matrix, &identity)
            }
            ("solve", [matrix, right]) => {
                let (matrix, right) = (self.table(matrix)?, self.table(right)?);
                self.sheet.solve(&matrix, &right)
            }
            ("kernel", [matrix]) => {
                let matrix = self.table(matrix)?;
                self.sheet.kernel(&matrix)
            }
            ("transpose", [matrix]) => self.table(matrix)?.transposed(),
            ("trace", [matrix]) => {
                let matrix = self.table(matrix)?;
                let diagonal = (0..matrix.size()?).map(|place| matrix.get(place, place));
                let diagonal: Vec<_> = diagonal.collect::<Result<_, _>>()?;
                let trace = Table::single(self.sheet.total(diagonal)?);
                self.sheet.of_whole(&trace, &matrix)
            }
            ("diagonal", entries) => {
                let size = entries.len();
                Table::made(size, size, |row, column| match row == column {
                    true => self.scalar(&entries[row]),
                    false => self.sheet.graph.integer(0),
                })
            }
            ("identity", [size]) => {
                let size = self.natural(size)? as usize;
                self.sheet.identity(size)
            }
            ("zero", [rows, columns]) => {
                let (rows, columns) = (
                    self.natural(rows)? as usize,
                    self.natural(columns)? as usize,
                );
                Table::made(rows, columns, |_, _| self.sheet.graph.integer(0))
            }
            _ => self.part(function, arguments),
        }
    }

    /// A part of a matrix.
    fn part(&mut self, function: &str, arguments: &'a [Expression]) -> Result<Table, Failure> {
        let [matrix, first, others @ ..] = arguments else {
            return Err(Unknown::Unsupported.into());
        };
        let matrix = self.table(matrix)?;
        let first = self.places(first)?;
        let (height, width) = matrix.shape();
        let (rows, columns) = match (function, others) {
            ("row", []) => (first, (1..=width).collect()),
            ("column", []) => ((1..=height).collect(), first),
            ("submatrix", [columns]) => (first, self.places(columns)?),
            _ => return Err(Unknown::Unsupported.into()),
        };
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
