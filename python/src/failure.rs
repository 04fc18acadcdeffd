//! Mistakes, as exceptions with the words of the command.

use pyo3::prelude::*;
use sextic::language::diagnostic::{Diagnostic, SourceFile, render};
use sextic::report::advice::Advice;

/// Where the exceptions are defined.
const EXCEPTIONS: &str = "sextic.errors";

/// What is wrong, before Python is there to say it.
pub enum Failure {
    /// With what was asked.
    Input(Advice),
    /// With a document, at a place of it.
    Document(Box<(Diagnostic, SourceFile)>),
}

impl From<Advice> for Failure {
    fn from(advice: Advice) -> Self {
        Failure::Input(advice)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| match exception(py, &failure) {
            Ok(exception) => PyErr::from_value(exception),
            Err(error) => error,
        })
    }
}

/// The exception of a failure.
fn exception<'py>(py: Python<'py>, failure: &Failure) -> PyResult<Bound<'py, PyAny>> {
    let exceptions = py.import(EXCEPTIONS)?;
    match failure {
        Failure::Input(Advice { message, help }) => {
            exceptions.getattr("InputError")?.call1((message, help))
        }
        Failure::Document(at) => of_document(py, &at.0, &at.1),
    }
}

/// The exception of a mistake in a document.
pub fn of_document<'py>(
    py: Python<'py>,
    diagnostic: &Diagnostic,
    source: &SourceFile,
) -> PyResult<Bound<'py, PyAny>> {
    let (line, column) = source.line_and_column(&diagnostic.span);
    let shown = render(diagnostic, source, false);
    let kind = diagnostic.kind.code();
    let (message, help) = (&diagnostic.message, &diagnostic.help);
    py.import(EXCEPTIONS)?.getattr("DocumentError")?.call1((
        message,
        help,
        &source.path,
        line,
        column,
        kind,
        shown,
    ))
}
