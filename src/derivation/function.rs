//! The built-in functions of documents.

mod angle;
mod calculus;
mod matrix;
mod polynomial;

use super::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use super::elaboration::Elaborator;
use super::elaboration::error::{argument_count, shape};
use super::elaboration::matrix::identity;
use super::quantity::Value;
use super::syntax::{Expression, Name, Span};

/// What documents can call without declaring it.
pub const NAMES: [&str; 24] = [
    "sin",
    "cos",
    "tan",
    "cot",
    "sqrt",
    "angle",
    "dt",
    "d",
    "det",
    "transpose",
    "inverse",
    "adjugate",
    "trace",
    "diagonal",
    "identity",
    "zero",
    "row",
    "column",
    "submatrix",
    "kernel",
    "solve",
    "coefficient",
    "hurwitz",
    "truncate",
];

/// How many arguments a built-in function takes; the entries of `diagonal` are one or more.
fn arity(name: &str) -> usize {
    match name {
        "angle" | "d" | "solve" | "zero" | "row" | "column" => 2,
        "submatrix" | "coefficient" | "hurwitz" | "truncate" => 3,
        _ => 1,
    }
}

/// How a built-in function is called.
fn usage(name: &str) -> &'static str {
    match name {
        "sin" | "cos" | "tan" | "cot" => "write a call for each angle, such as `sin(α)`",
        "sqrt" => "write a call for each root: `sqrt(a)`",
        "angle" => "write `angle(x, y)`, with the components of the vector side by side",
        "dt" => "write `dt(a)`, or `dt([a; b])` for several",
        "d" => "write `d(f, x)`, or `d([f; g], [x; y])` for several",
        "det" | "adjugate" | "inverse" | "trace" | "transpose" | "kernel" => {
            "write one matrix between the brackets, such as `det([a, b; c, d])`"
        }
        "solve" => "write `solve(M, b)`, with a column for b, such as `[1; 2]`",
        "identity" => "write `identity(n)`: it is square",
        "zero" => "write `zero(n, k)`, for n rows and k columns",
        "row" | "column" => "write `row(M, n)` or `column(M, n)`",
        "submatrix" => "write `submatrix(M, [1, 2], [1, 3])`: the matrix, its rows, its columns",
        "coefficient" => "write `coefficient(p, λ, n)`, for the coefficient of λⁿ",
        "hurwitz" => "write `hurwitz(p, λ, n)`, for the n-th determinant",
        _ => "write `truncate(a, [x; y], n)`: the expression, the small quantities, the order",
    }
}

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
