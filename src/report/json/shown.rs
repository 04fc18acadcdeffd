//! The JSON of what is shown.

use serde::Serialize;

use crate::derivation::shown::{Entry, Shown};
use crate::language::notation::Notation;
use crate::report::words;

use super::ascii;

/// What an expression is.
#[derive(Serialize)]
struct ShownObject<'a> {
    expression: String,
    description: Option<&'a str>,
    rows: usize,
    columns: usize,
    entries: Vec<EntryObject>,
    conditions: Vec<String>,
}

#[derive(Serialize)]
struct EntryObject {
    row: usize,
    column: usize,
    normal_form: String,
    factored: String,
    /// Nothing for a 0 that fits every unit.
    unit: Option<String>,
    terms: usize,
    terms_below: usize,
}

/// A statement of a document.
#[derive(Serialize)]
pub(super) struct StatementObject<'a> {
    line: usize,
    #[serde(flatten)]
    shown: ShownObject<'a>,
}

/// An expression by the names of a document.
#[derive(Serialize)]
struct AnswerObject<'a> {
    path: &'a str,
    #[serde(flatten)]
    shown: ShownObject<'a>,
}

/// Writes what an expression is by the names of a document.
pub fn shown(path: &str, shown: &Shown) -> String {
    let shown = object(shown);
    super::write(&AnswerObject { path, shown })
}

/// What a statement of a document shows.
pub(super) fn statement(shown: &Shown) -> StatementObject<'_> {
    StatementObject {
        line: shown.line,
        shown: object(shown),
    }
}

fn object(shown: &Shown) -> ShownObject<'_> {
    let conditions = shown.conditions.iter();
    ShownObject {
        expression: ascii(&shown.expression),
        description: shown.description.as_deref(),
        rows: shown.rows(),
        columns: shown.columns,
        entries: shown.places().map(entry).collect(),
        conditions: conditions
            .map(|own| words::condition(own, Notation::Ascii))
            .collect(),
    }
}

fn entry(((row, column), entry): ((usize, usize), &Entry)) -> EntryObject {
    EntryObject {
        row,
        column,
        normal_form: ascii(&entry.normal_form),
        factored: ascii(&entry.factored),
        unit: entry.unit.as_ref().map(ToString::to_string),
        terms: entry.terms,
        terms_below: entry.terms_below,
    }
}
