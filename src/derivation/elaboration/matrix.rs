//! Matrices: made of blocks, their entries, determinants and inverses.

use crate::algebra::determinant::{adjugate, determinant};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::linear_system::{Solution, solve};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::derivation::quantity::{Quantities, Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Span};
use crate::language::unit::Unit;

use super::Elaborator;
use super::error::{algebra, quantity, shape};
use super::limit::{check_minors, check_sides};

impl Elaborator {
    /// A matrix of blocks: the entries of a row have equally many rows, the rows equally many columns.
    pub(super) fn blocks(
        &mut self,
        rows: &[Vec<Expression>],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let mut lines: Vec<Vec<Quantity>> = Vec::new();
        for row in rows {
            let mut band: Vec<Vec<Quantity>> = Vec::new();
            for (place, block) in row.iter().enumerate() {
                let value = self.value(block)?;
                if place == 0 {
                    band = vec![Vec::new(); value.rows()];
                } else if band.len() != value.rows() {
                    let message = "the blocks of a row have different heights";
                    return Err(shape(&block.span, message.into())
                        .with_label(format!("height {}, not {}", value.rows(), band.len()))
                        .with_help("blocks side by side have equally many rows"));
                }
                for (index, line) in band.iter_mut().enumerate() {
                    line.extend((0..value.columns()).map(|column| value.at(index, column).clone()));
                }
            }
            lines.extend(band);
        }
        let width = lines.first().map_or(0, Vec::len);
        if lines.iter().any(|line| line.len() != width) {
            let widths: Vec<String> = lines.iter().map(|line| line.len().to_string()).collect();
            return Err(
                shape(span, "the rows of a matrix have different lengths".into())
                    .with_label(format!("lengths {}", widths.join(", ")))
                    .with_help("`,` stands between the entries of a row, `;` between rows"),
            );
        }
        check_sides(lines.len(), width, span)?;
        Ok(Matrix::from_fn(lines.len(), width, |row, column| {
            lines[row][column].clone()
        }))
    }

    /// `M[i, j]`, or `v[i]` of a vector.
    pub(super) fn entry(
        &mut self,
        matrix: &Expression,
        indices: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let mut places = Vec::new();
        for index in indices {
            places.push(self.natural(index)?);
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [place] if value.columns() == 1 => (place, 1),
            [place] if value.rows() == 1 => (1, place),
            _ => {
                return Err(
                    shape(span, "an entry of a matrix has a row and a column".into())
                        .with_help("write `M[1, 3]`, or `v[2]` for a vector"),
                );
            }
        };
        let (rows, columns) = value.shape();
        if row < 1 || column < 1 || row > rows || column > columns {
            return Err(shape(
                span,
                format!("a {rows}×{columns} matrix has no entry [{row}, {column}]"),
            )
            .with_help("rows and columns count from 1"));
        }
        Ok(value.at(row - 1, column - 1).clone().scalar())
    }

    /// A⁻¹; |A| must not vanish.
    pub fn inverse(&mut self, matrix: &Value, span: &Span) -> Result<Value, Diagnostic> {
        if !matrix.is_square() {
            let (rows, columns) = matrix.shape();
            return Err(
                shape(span, format!("a {rows}×{columns} matrix has no inverse"))
                    .with_help("only square matrices have one"),
            );
        }
        let singular = || {
            let message = "the determinant of this matrix is identically 0";
            Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                .with_label("has no inverse")
                .with_help("look at its null space with `kernel(…)`")
        };
        if self.minors_are_few(matrix, span).is_ok() {
            let below = self.determinant(matrix, span)?;
            let above = self.adjugate(matrix, span)?;
            if below.value.is_zero() {
                return Err(singular());
            }
            return self.divide(&above, &below, span);
        }
        let solved = self
            .solved(matrix, &identity(matrix.rows()), span)?
            .ok_or_else(singular)?;
        self.divide(&solved.numerators, &solved.determinant, span)
    }

    /// Whether the minors of all entries are few enough to compute; those of numbers are better left to
    /// elimination.
    fn minors_are_few(&self, matrix: &Value, span: &Span) -> Result<(), Diagnostic> {
        const MOST_ROWS_OF_NUMBERS: usize = 4;
        let is_number = |entry: &Quantity| entry.value.as_constant().is_some();
        let of_numbers = matrix.entries().iter().all(is_number);
        let weight = match of_numbers && matrix.rows() > MOST_ROWS_OF_NUMBERS {
            true => usize::MAX >> 1,
            false => matrix.rows().pow(2).div_ceil(50),
        };
        check_minors(matrix, weight, span)
    }

    /// The solution of A·X = B, by minors where they are few, else by elimination; none where A is
    /// singular.
    pub fn solved(
        &self,
        matrix: &Value,
        right: &Value,
        span: &Span,
    ) -> Result<Option<Solution<Quantity>>, Diagnostic> {
        let units = one_unit(matrix).zip(one_unit(right));
        match (self.minors_are_few(matrix, span), units) {
            (Ok(()), _) => {
                let solved = solve(matrix, right, &Quantities(&self.ring));
                let solved = solved.map_err(|error| quantity(error, span))?;
                Ok(Some(solved).filter(|solved| !solved.determinant.value.is_zero()))
            }
            (Err(_), Some((unit, of_right))) => {
                self.eliminated(matrix, &unit, right, &of_right, span)
            }
            (Err(refused), None) => Err(refused),
        }
    }

    /// The same by elimination, where the entries have one unit on either side.
    fn eliminated(
        &self,
        matrix: &Value,
        unit: &Unit,
        right: &Value,
        of_right: &Unit,
        span: &Span,
    ) -> Result<Option<Solution<Quantity>>, Diagnostic> {
        let solved = match self
            .ring
            .eliminated_solution(&values(matrix), &values(right))
        {
            Err(AlgebraError::DivisionByZero) => return Ok(None),
            solved => solved.map_err(|error| algebra(error, span))?,
        };
        let size = Rational::from(matrix.rows());
        let of_others = unit.power(&(&size - Rational::ONE));
        let of_numerators = of_others.product(of_right);
        // By Cramer's rule a column of B stands in the place of that of the unknown.
        let numerators = Matrix::from_fn(matrix.rows(), right.columns(), |unknown, column| {
            with_unit(
                solved.numerators.at(unknown, column),
                &of_numerators,
                matrix.rows(),
                |row, place| match place == unknown {
                    true => right.at(row, column).fits_every_unit(),
                    false => matrix.at(row, place).fits_every_unit(),
                },
            )
        });
        Ok(Some(Solution {
            numerators,
            determinant: Quantity::new(solved.determinant, unit.power(&size)),
        }))
    }

    /// |A| of a square matrix.
    pub fn determinant(&self, matrix: &Value, span: &Span) -> Result<Quantity, Diagnostic> {
        let refused = match check_minors(matrix, 1, span) {
            Ok(()) => {
                let found = determinant(matrix, &Quantities(&self.ring));
                return found.map_err(|error| quantity(error, span));
            }
            Err(refused) => refused,
        };
        let unit = one_unit(matrix).ok_or(refused)?;
        let found = self.ring.eliminated_determinant(&values(matrix));
        let found = found.map_err(|error| algebra(error, span))?;
        let size = matrix.rows();
        let unit = unit.power(&Rational::from(size));
        Ok(with_unit(&found, &unit, size, |row, column| {
            matrix.at(row, column).fits_every_unit()
        }))
    }

    /// adj A of a square matrix.
    pub fn adjugate(&self, matrix: &Value, span: &Span) -> Result<Value, Diagnostic> {
        if let Err(refused) = check_minors(matrix, matrix.rows().pow(2).div_ceil(50), span) {
            // Of a matrix that is not singular it is what solves A·X = |A|·1.
            let solved = self.solved(matrix, &identity(matrix.rows()), span)?;
            return solved.map(|solved| solved.numerators).ok_or(refused);
        }
        adjugate(matrix, &Quantities(&self.ring)).map_err(|error| quantity(error, span))
    }
}

/// The unit of all entries that are not 0, if it is one.
fn one_unit(matrix: &Value) -> Option<Unit> {
    let mut units = matrix
        .entries()
        .iter()
        .filter_map(|entry| entry.unit.as_ref());
    let first = units.next().cloned().unwrap_or_default();
    units.all(|unit| *unit == first).then_some(first)
}

fn values(matrix: &Value) -> Matrix<Fraction> {
    matrix.map(|entry| entry.value.clone())
}

/// A determinant as a quantity: it fits every unit where each of its products has a factor that does.
fn with_unit(
    value: &Fraction,
    unit: &Unit,
    size: usize,
    fits_every_unit: impl Fn(usize, usize) -> bool,
) -> Quantity {
    let has_unit =
        !value.is_zero() || has_transversal(size, &|row, column| !fits_every_unit(row, column));
    Quantity {
        value: value.clone(),
        unit: has_unit.then(|| unit.clone()),
    }
}

/// Whether each row can have a column of its own in which its entry is as wanted.
fn has_transversal(size: usize, wanted: &impl Fn(usize, usize) -> bool) -> bool {
    let mut rows = vec![None; size];
    (0..size).all(|row| finds_column(row, wanted, &mut rows, &mut vec![false; size]))
}

/// Finds a column for one more row, where the rows that have one may move to others.
fn finds_column(
    row: usize,
    wanted: &impl Fn(usize, usize) -> bool,
    rows: &mut [Option<usize>],
    tried: &mut [bool],
) -> bool {
    for column in 0..rows.len() {
        if wanted(row, column) && !std::mem::replace(&mut tried[column], true) {
            let other = rows[column];
            if other.is_none_or(|other| finds_column(other, wanted, rows, tried)) {
                rows[column] = Some(row);
                return true;
            }
        }
    }
    false
}

/// The identity matrix.
pub fn identity(size: usize) -> Value {
    Matrix::from_fn(size, size, |row, column| {
        Quantity::number(if row == column {
            Rational::ONE
        } else {
            Rational::ZERO
        })
    })
}
