//! Matrices of values of a program.

use std::cell::RefCell;
use std::convert::Infallible;

use sextic_codegen::program::{Operation, Program};

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::determinant::determinant;
use crate::algebra::matrix::Matrix;
use crate::language::built_in::{BuiltIn, Declared};
use crate::language::syntax::Expression;

use super::{Context, Obstacle, Polynomial, Table, Translator, divisor, scalar};

/// Polynomials whose coefficients are values of a program: to compute is to append operations.
struct Values<'a>(RefCell<&'a mut Program>);

impl Arithmetic for Values<'_> {
    type Element = Polynomial;
    type Error = Infallible;

    fn zero(&self) -> Polynomial {
        Polynomial::default()
    }

    fn one(&self) -> Polynomial {
        Polynomial::monomial(0, self.0.borrow_mut().constant(1.into()))
    }

    fn is_zero(&self, a: &Polynomial) -> bool {
        a.is_zero()
    }

    fn sum(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Infallible> {
        Ok(a.sum(b, &mut self.0.borrow_mut()))
    }

    fn negative(&self, a: &Polynomial) -> Polynomial {
        a.negative(&mut self.0.borrow_mut())
    }

    fn product(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Infallible> {
        Ok(a.product(b, &mut self.0.borrow_mut()))
    }

    fn difference(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Infallible> {
        Ok(a.difference(b, &mut self.0.borrow_mut()))
    }
}

impl Translator<'_> {
    fn values(&mut self) -> Values<'_> {
        Values(RefCell::new(&mut self.program))
    }

    /// The image of every entry.
    pub(super) fn each(
        &mut self,
        table: &Table,
        mut image: impl FnMut(&Polynomial, &mut Program) -> Polynomial,
    ) -> Table {
        table.map(|entry| image(entry, &mut self.program))
    }

    /// A + B, say.
    pub(super) fn zip(
        &mut self,
        a: &Table,
        b: &Table,
        image: fn(&Polynomial, &Polynomial, &mut Program) -> Polynomial,
    ) -> Result<Table, Obstacle> {
        if a.shape() != b.shape() {
            return Err(Obstacle::Structure);
        }
        Ok(Matrix::from_fn(a.rows(), a.columns(), |row, column| {
            image(a.at(row, column), b.at(row, column), &mut self.program)
        }))
    }

    /// A·B; a scalar multiplies every entry.
    pub(super) fn product(&mut self, a: &Table, b: &Table) -> Result<Table, Obstacle> {
        if let [factor] = a.entries() {
            return Ok(self.each(b, |entry, program| factor.product(entry, program)));
        }
        if let [factor] = b.entries() {
            return Ok(self.each(a, |entry, program| entry.product(factor, program)));
        }
        if a.columns() != b.rows() {
            return Err(Obstacle::Structure);
        }
        let Ok(product) = a.product(b, &self.values());
        Ok(product)
    }

    /// A matrix of matrices as one.
    pub(super) fn blocks(
        &mut self,
        rows: &[Vec<Expression>],
        context: Context,
    ) -> Result<Table, Obstacle> {
        let mut lines: Vec<Vec<Polynomial>> = Vec::new();
        for row in rows {
            let above = lines.len();
            for block in row {
                let block = self.table(block, context)?;
                lines.resize(lines.len().max(above + block.rows()), Vec::new());
                for (line, entries) in lines[above..]
                    .iter_mut()
                    .zip(block.entries().chunks(block.columns()))
                {
                    line.extend_from_slice(entries);
                }
            }
        }
        rectangle(lines)
    }

    pub(super) fn entry(
        &mut self,
        matrix: &Expression,
        indices: &[Expression],
        context: Context,
    ) -> Result<Table, Obstacle> {
        let table = self.table(matrix, context)?;
        let mut places = Vec::new();
        for index in indices {
            places.push(self.natural(index, context)?);
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [column] if table.rows() == 1 => (1, column),
            [row] => (row, 1),
            _ => return Err(Obstacle::Structure),
        };
        let (rows, columns) = table.shape();
        match (1..=rows).contains(&row) && (1..=columns).contains(&column) {
            true => Ok(scalar(table.at(row - 1, column - 1).clone())),
            false => Err(Obstacle::Structure),
        }
    }

    fn natural(&mut self, expression: &Expression, context: Context) -> Result<usize, Obstacle> {
        let natural = self
            .elaborator
            .natural(&self.passed(expression, context.frame));
        natural.map_err(|error| Obstacle::Refused(error.message))
    }

    /// A built-in function that keeps the structure of its arguments.
    pub(super) fn built_in(
        &mut self,
        function: &str,
        arguments: &[Expression],
        context: Context,
    ) -> Result<Table, Obstacle> {
        let call = Declared::of(function).and_then(|declared| declared.call(arguments));
        match call.ok_or(Obstacle::Structure)? {
            BuiltIn::Root(square) => {
                let square = self.single(square, context)?;
                let square = divisor(&square)?;
                let root = self.program.push(Operation::SquareRoot(square));
                Ok(scalar(Polynomial::monomial(0, root)))
            }
            BuiltIn::Determinant(matrix) => {
                let matrix = self.table(matrix, context)?;
                self.determinant(&matrix)
            }
            BuiltIn::Transpose(matrix) => Ok(self.table(matrix, context)?.transpose()),
            BuiltIn::Trace(matrix) => {
                let matrix = self.table(matrix, context)?;
                let values = self.values();
                let mut diagonal =
                    (0..matrix.rows().min(matrix.columns())).map(|at| matrix.at(at, at));
                let Ok(trace) =
                    diagonal.try_fold(values.zero(), |sum, entry| values.sum(&sum, entry));
                Ok(scalar(trace))
            }
            BuiltIn::Diagonal(entries) => {
                let mut diagonal = Vec::new();
                for entry in entries {
                    diagonal.push(self.single(entry, context)?);
                }
                let size = diagonal.len();
                Ok(Matrix::from_fn(size, size, |row, column| {
                    match row == column {
                        true => diagonal[row].clone(),
                        false => Polynomial::default(),
                    }
                }))
            }
            BuiltIn::Coefficient(polynomial, variable, power) => {
                let power = self.natural(power, context)? as u32;
                let inside = self.with_variable(variable, context)?;
                let coefficient = self.single(polynomial, inside)?.coefficient(power);
                let coefficient = coefficient.map(|node| Polynomial::monomial(0, node));
                Ok(scalar(coefficient.unwrap_or_default()))
            }
            BuiltIn::Hurwitz(polynomial, variable, size) => {
                let size = self.natural(size, context)?;
                let inside = self.with_variable(variable, context)?;
                let polynomial = self.single(polynomial, inside)?;
                if size == 0 {
                    return Err(Obstacle::Structure);
                }
                self.determinant(&hurwitz_matrix(&polynomial, size))
            }
            BuiltIn::Circular(..)
            | BuiltIn::Direction(..)
            | BuiltIn::Rate(_)
            | BuiltIn::Jacobian(..)
            | BuiltIn::Inverse(_)
            | BuiltIn::Adjugate(_)
            | BuiltIn::Identity(_)
            | BuiltIn::Zero(..)
            | BuiltIn::Row(..)
            | BuiltIn::Column(..)
            | BuiltIn::Submatrix(..)
            | BuiltIn::Kernel(_)
            | BuiltIn::Solution(..)
            | BuiltIn::Truncation(..) => Err(Obstacle::Structure),
        }
    }

    /// |A| by expansion along the rows, each minor of the last rows computed once.
    fn determinant(&mut self, matrix: &Table) -> Result<Table, Obstacle> {
        if !matrix.is_square() {
            return Err(Obstacle::Structure);
        }
        let Ok(value) = determinant(matrix, &self.values());
        Ok(scalar(value))
    }

    /// The value of an expression with one entry.
    pub(super) fn single(
        &mut self,
        expression: &Expression,
        context: Context,
    ) -> Result<Polynomial, Obstacle> {
        match self.table(expression, context)?.entries() {
            [entry] => Ok(entry.clone()),
            _ => Err(Obstacle::Structure),
        }
    }
}

/// Lines of one length as a matrix.
fn rectangle(lines: Vec<Vec<Polynomial>>) -> Result<Table, Obstacle> {
    let columns = lines.first().map_or(0, Vec::len);
    if columns == 0 || lines.iter().any(|line| line.len() != columns) {
        return Err(Obstacle::Structure);
    }
    Ok(Matrix::from_fn(lines.len(), columns, |row, column| {
        lines[row][column].clone()
    }))
}

/// The leading principal part of Hurwitz' matrix of a polynomial.
fn hurwitz_matrix(polynomial: &Polynomial, size: usize) -> Table {
    let degree = polynomial.degree() as usize;
    Matrix::from_fn(size, size, |row, column| {
        let index = (2 * column + 1)
            .checked_sub(row)
            .filter(|index| *index <= degree);
        let node = index.and_then(|index| polynomial.coefficient((degree - index) as u32));
        node.map(|node| Polynomial::monomial(0, node))
            .unwrap_or_default()
    })
}
