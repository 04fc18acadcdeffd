//! The built-in functions of documents.

mod angle;
mod calculus;
mod matrix;
mod polynomial;

use super::elaboration::Elaborator;
use super::elaboration::error::{argument_count, shape};
use super::elaboration::matrix::identity;
use super::quantity::Value;
use crate::language::built_in::{NAMES, arity, usage};
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
        let name = function.ascii.as_str();
        if !NAMES.contains(&name) {
            return Err(self.unknown_function(function, span));
        }
        if order > 0 {
            let message = format!("the built-in function `{function}` has no primes");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("a prime asks for the derivative of a declared function")
                    .with_help("differentiate with `d(…, x)` or `dt(…)`"),
            );
        }
        match (name, arguments) {
            ("sin" | "cos" | "tan" | "cot", [angle]) => self.circular(name, angle, span),
            ("angle", [x, y]) => self.direction(x, y, span),
            ("sqrt", [square]) => {
                let square = self.scalar(square)?;
                Ok(self.root(&square, span)?.scalar())
            }
            ("dt", [inner]) => self.time_derivative(inner, span),
            ("d", [value, variables]) => self.jacobian(value, variables, span),
            ("truncate", [value, small, order]) => self.truncation(value, small, order, span),
            ("coefficient", [polynomial, variable, power]) => {
                self.coefficient(polynomial, variable, power)
            }
            ("hurwitz", [polynomial, variable, size]) => {
                self.hurwitz(polynomial, variable, size, span)
            }
            ("det", [matrix]) => {
                let matrix = self.square(matrix)?;
                if matrix.shape() == (1, 1) {
                    return Err(shape(span, "a determinant is that of a matrix".into())
                        .with_label("this is a single number")
                        .with_help("for an absolute value write `sqrt((…)^2)`"));
                }
                Ok(self.determinant(&matrix, span)?.scalar())
            }
            ("adjugate", [matrix]) => {
                let matrix = self.square(matrix)?;
                self.adjugate(&matrix, span)
            }
            ("inverse", [matrix]) => {
                let value = self.square(matrix)?;
                self.inverse(&value, &matrix.span)
            }
            ("solve", [matrix, right]) => self.solution(matrix, right, span),
            ("kernel", [matrix]) => self.kernel(matrix, span),
            ("transpose", [matrix]) => Ok(self.value(matrix)?.transpose()),
            ("trace", [matrix]) => self.trace(matrix, span),
            ("diagonal", [_, ..]) => self.diagonal(arguments, span),
            ("identity", [size]) => Ok(identity(self.positive(size)?)),
            ("zero", [rows, columns]) => self.zero_matrix(rows, columns),
            ("row", [matrix, place]) => self.row_of(matrix, place),
            ("column", [matrix, place]) => self.column_of(matrix, place),
            ("submatrix", [matrix, rows, columns]) => self.submatrix(matrix, rows, columns, span),
            _ => {
                let (wanted, given) = (arity(name), arguments.len());
                Err(argument_count(function, wanted, given, usage(name), span))
            }
        }
    }

    fn unknown_function(&self, function: &Name, span: &Span) -> Diagnostic {
        let functions = self
            .scope
            .entries()
            .map(|entry| entry.name.unicode.as_str());
        let help = match nearest(&function.unicode, functions.chain(NAMES)) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", NAMES.join(", ")),
        };
        let message = format!("`{function}` is not a function known here");
        Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
            .with_label("unknown function")
            .with_help(help)
    }
}
