//! The built-in functions of documents at a point.

use crate::derivation::evaluation::determinant::{adjugate, determinant};
use crate::derivation::evaluation::elimination::null_space;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::evaluation::table::{
    Table, identity, numbers, samples, select, single, transpose,
};
use crate::derivation::syntax::{Expression, Node};

use super::context::{Change, Context};
use super::interpolation::hurwitz;
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// What a built-in function gives.
    pub(super) fn built_in(
        &mut self,
        function: &str,
        arguments: &'a [Expression],
        context: Context,
    ) -> Result<Table, Failure> {
        match (function, arguments) {
            ("sin" | "cos" | "tan" | "cot", [angle]) => {
                let angle = self.scalar(angle, context)?;
                let (cosine, sine) = self.circular(&angle)?;
                let (above, below) = match function {
                    "sin" => (sine, Number::from(1)),
                    "cos" => (cosine, Number::from(1)),
                    "tan" => (sine, cosine),
                    _ => (cosine, sine),
                };
                let inverse = self.reciprocal(&below)?;
                Ok(single(self.point.extension.product(&above, &inverse)))
            }
            ("sqrt", [square]) => {
                let square = self.number(square, context)?;
                Ok(single(self.root(&square)?))
            }
            ("angle", [x, y]) => {
                let x = self.number(x, context)?;
                let y = self.number(y, context)?;
                Ok(vec![vec![self.direction(&x, &y)?]])
            }
            ("dt", [inner]) => Ok(samples(self.differential(inner, Change::Time, context)?)),
            ("d", [value, variables]) => self.jacobian(value, variables, context),
            ("coefficient", [polynomial, variable, power]) => {
                let power = self.natural(power, context)?;
                let key = self.key(variable, context)?;
                let coefficients = self.interpolation(polynomial, &key, context)?;
                Ok(single(coefficients.get(power).cloned().unwrap_or_default()))
            }
            ("hurwitz", [polynomial, variable, size]) => {
                let size = self.natural(size, context)?;
                let key = self.key(variable, context)?;
                let mut coefficients = self.interpolation(polynomial, &key, context)?;
                // The degree is that of the polynomial before anything is replaced in it.
                let general = Context::of(0).in_frame(context.frame);
                let degree = self.interpolation(polynomial, &key, general)?.len();
                coefficients.resize(coefficients.len().max(degree), Number::default());
                let matrix = hurwitz(&coefficients, size);
                Ok(single(determinant(&matrix, &self.point.extension)))
            }
            ("truncate", [value, small, order]) => {
                let order = self.natural(order, context)? as u32;
                let keys = self.keys(small, context)?.into_iter().collect();
                let parts = self.expansion(value, keys, order, context)?;
                let sum = parts.into_iter().reduce(|sum, part| {
                    let rows = sum.iter().zip(&part);
                    rows.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.sum(b)).collect())
                        .collect()
                });
                Ok(samples(sum.unwrap_or_default()))
            }
            _ => self.matrix_function(function, arguments, context),
        }
    }

    fn matrix_function(
        &mut self,
        function: &str,
        arguments: &'a [Expression],
        context: Context,
    ) -> Result<Table, Failure> {
        match (function, arguments) {
            ("det", [matrix]) => {
                let matrix = numbers(&self.table(matrix, context)?);
                Ok(single(determinant(&matrix, &self.point.extension)))
            }
            ("adjugate", [matrix]) => {
                let matrix = numbers(&self.table(matrix, context)?);
                Ok(samples(adjugate(&matrix, &self.point.extension)))
            }
            ("inverse", [matrix]) => {
                let matrix = self.table(matrix, context)?;
                self.solve(&matrix, &identity(matrix.len()))
            }
            ("solve", [matrix, right]) => {
                let matrix = self.table(matrix, context)?;
                let right = self.table(right, context)?;
                self.solve(&matrix, &right)
            }
            ("kernel", [matrix]) => {
                let matrix = numbers(&self.table(matrix, context)?);
                let found = null_space(&matrix, &self.point.extension);
                Ok(samples(found.ok_or("a pivot is not invertible")?))
            }
            ("transpose", [matrix]) => Ok(transpose(&self.table(matrix, context)?)),
            ("trace", [matrix]) => {
                let matrix = self.table(matrix, context)?;
                let diagonal = matrix.iter().enumerate().map(|(place, row)| &row[place]);
                let trace = diagonal.fold(Number::default(), |sum, entry| sum.sum(&entry.number));
                Ok(single(trace))
            }
            ("diagonal", entries) => {
                let mut table = identity(entries.len());
                for (place, entry) in entries.iter().enumerate() {
                    table[place][place] = self.scalar(entry, context)?;
                }
                Ok(table)
            }
            ("identity", [size]) => Ok(identity(self.natural(size, context)?)),
            ("zero", [rows, columns]) => {
                let rows = self.natural(rows, context)?;
                let columns = self.natural(columns, context)?;
                Ok(vec![vec![Sample::from(Number::default()); columns]; rows])
            }
            ("row", [matrix, place]) => {
                let matrix = self.table(matrix, context)?;
                let place = self.natural(place, context)?;
                select(&matrix, &[place], &every(matrix[0].len()))
            }
            ("column", [matrix, place]) => {
                let matrix = self.table(matrix, context)?;
                let place = self.natural(place, context)?;
                select(&matrix, &every(matrix.len()), &[place])
            }
            ("submatrix", [matrix, rows, columns]) => {
                let matrix = self.table(matrix, context)?;
                let rows = self.places(rows, context)?;
                let columns = self.places(columns, context)?;
                select(&matrix, &rows, &columns)
            }
            _ => Err(format!("{function} cannot be evaluated at a point")),
        }
    }

    fn places(&mut self, list: &'a Expression, context: Context) -> Result<Vec<usize>, Failure> {
        match &list.node {
            Node::Matrix(rows) => rows
                .iter()
                .flatten()
                .map(|entry| self.natural(entry, context))
                .collect(),
            _ => Ok(vec![self.natural(list, context)?]),
        }
    }
}

/// All rows or columns, counted from 1.
fn every(count: usize) -> Vec<usize> {
    (1..=count).collect()
}
