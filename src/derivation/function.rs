//! The built-in functions of documents.

mod angle;
mod calculus;
mod matrix;
mod polynomial;

use super::elaboration::Elaborator;
use super::elaboration::error::{argument_count, shape};
use super::elaboration::matrix::identity;
use super::quantity::Value;
use crate::language::built_in::{BuiltIn, Declared, names};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use crate::language::syntax::{Expression, Name, Span};

impl Elaborator {
    /// What a built-in function gives.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where there is no such function or it does not take these arguments.
    pub(super) fn built_in(
        &mut self,
        function: &Name,
        order: u32,
        arguments: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let Some(declared) = Declared::of(&function.ascii) else {
            return Err(self.unknown_function(function, span));
        };
        if order > 0 {
            let message = format!("the built-in function `{function}` has no primes");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("a prime asks for the derivative of a declared function")
                    .with_help("differentiate with `d(…, x)` or `dt(…)`"),
            );
        }
        match declared.call(arguments) {
            Some(call) => self.value_of_call(call, span),
            None => {
                let (wanted, given) = (declared.count(), arguments.len());
                let usage = declared.usage;
                Err(argument_count(function, wanted, given, usage, span))
            }
        }
    }

    fn value_of_call(&mut self, call: BuiltIn<'_>, span: &Span) -> Result<Value, Diagnostic> {
        match call {
            BuiltIn::Circular(function, angle) => self.circular(function, angle, span),
            BuiltIn::Direction(x, y) => self.direction(x, y, span),
            BuiltIn::Root(square) => {
                let square = self.scalar(square)?;
                Ok(self.root(&square, span)?.scalar())
            }
            BuiltIn::Rate(inner) => self.time_derivative(inner, span),
            BuiltIn::Jacobian(value, variables) => self.jacobian(value, variables, span),
            BuiltIn::Truncation(value, small, order) => self.truncation(value, small, order, span),
            BuiltIn::Coefficient(polynomial, variable, power) => {
                self.coefficient(polynomial, variable, power)
            }
            BuiltIn::Hurwitz(polynomial, variable, size) => {
                self.hurwitz(polynomial, variable, size, span)
            }
            BuiltIn::Determinant(matrix) => {
                let matrix = self.square(matrix)?;
                if matrix.shape() == (1, 1) {
                    return Err(shape(span, "a determinant is that of a matrix".into())
                        .with_label("this is a single number")
                        .with_help("for an absolute value write `sqrt((…)^2)`"));
                }
                Ok(self.determinant(&matrix, span)?.scalar())
            }
            BuiltIn::Adjugate(matrix) => {
                let matrix = self.square(matrix)?;
                self.adjugate(&matrix, span)
            }
            BuiltIn::Inverse(matrix) => {
                let value = self.square(matrix)?;
                self.inverse(&value, &matrix.span)
            }
            BuiltIn::Solution(matrix, right) => self.solution(matrix, right, span),
            BuiltIn::Kernel(matrix) => self.kernel(matrix, span),
            BuiltIn::Transpose(matrix) => Ok(self.value(matrix)?.transpose()),
            BuiltIn::Trace(matrix) => self.trace(matrix, span),
            BuiltIn::Diagonal(entries) => self.diagonal(entries, span),
            BuiltIn::Identity(size) => Ok(identity(self.positive(size)?)),
            BuiltIn::Zero(rows, columns) => self.zero_matrix(rows, columns),
            BuiltIn::Row(matrix, place) => self.row_of(matrix, place),
            BuiltIn::Column(matrix, place) => self.column_of(matrix, place),
            BuiltIn::Submatrix(matrix, rows, columns) => {
                self.submatrix(matrix, rows, columns, span)
            }
        }
    }

    fn unknown_function(&self, function: &Name, span: &Span) -> Diagnostic {
        let functions = self
            .scope
            .entries()
            .map(|entry| entry.name.unicode.as_str());
        let help = match nearest(&function.unicode, functions.chain(names())) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
        };
        let message = format!("`{function}` is not a function known here");
        Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
            .with_label("unknown function")
            .with_help(help)
    }
}
