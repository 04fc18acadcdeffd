//! Verdicts and matchings for programs.
//!
//! Expressions are text in ASCII names with `**` for powers, which SymPy reads; nothing is shortened.

mod audit;
mod matching;
mod pairs;

use serde::Serialize;

use crate::derivation::notation::Notation;
use crate::derivation::syntax::Expression;

pub use audit::{audits, explanation};
pub use matching::matchings;

/// Indented JSON, ended by a line break.
fn write(document: &impl Serialize) -> String {
    // Only a map with keys other than text could fail, and there is none.
    serde_json::to_string_pretty(document).unwrap_or_default() + "\n"
}

/// An expression as Python reads it.
fn ascii(expression: &Expression) -> String {
    Notation::Ascii.expression(expression)
}
