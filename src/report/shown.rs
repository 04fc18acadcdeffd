//! What is said of an expression that is shown.

use crate::derivation::shown::{Entry, Shown};
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Node};
use crate::language::unit::Unit;

use super::phrase::Phrase;
use super::words;

/// A line below an expression that is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// What is said: `normal form`, `factored`, `unit`, `conditions`, or the place of an entry.
    pub keyword: String,
    /// What is said of it.
    pub phrase: Phrase,
}

impl Line {
    fn new(keyword: impl Into<String>, phrase: Phrase) -> Self {
        let keyword = keyword.into();
        Line { keyword, phrase }
    }
}

/// What an expression is, entry by entry, and where it has a value.
pub fn lines(shown: &Shown, notation: Notation) -> Vec<Line> {
    let is_matrix = shown.scalar().is_none();
    let entries = shown.places().flat_map(|((row, column), entry)| {
        let keyword = match is_matrix {
            true => format!("[{row}, {column}]"),
            false => "normal form".to_string(),
        };
        of_entry(keyword, entry, notation)
    });
    let mut lines: Vec<Line> = entries.collect();
    lines.push(Line::new("conditions", conditions(shown, notation)));
    lines
}

/// What stands left of its value in an equation: of an evaluator's output the name of that alone.
pub fn left(shown: &Shown) -> Expression {
    let own = |asked: &Expression| match &asked.node {
        Node::Name(name) => name.of_output().map(|(_, output)| Expression::name(output)),
        _ => None,
    };
    let left = match &shown.expression.node {
        Node::Index(matrix, places) => {
            let entry = |matrix| Expression::made(Node::Index(Box::new(matrix), places.clone()));
            own(matrix).map(entry)
        }
        _ => own(&shown.expression),
    };
    left.unwrap_or_else(|| shown.expression.clone())
}

/// `a 3×3 matrix`, of what is no single number.
pub fn size(shown: &Shown) -> Option<String> {
    let is_matrix = shown.scalar().is_none();
    is_matrix.then(|| format!("a {}×{} matrix", shown.rows(), shown.columns))
}

fn of_entry(keyword: String, entry: &Entry, notation: Notation) -> Vec<Line> {
    let formula = |expression| Phrase::of_mathematics(notation.expression(expression));
    let mut lines = vec![Line::new(keyword, formula(&entry.normal_form))];
    if entry.factored != entry.normal_form {
        lines.push(Line::new("factored", formula(&entry.factored)));
    }
    if let Some(unit) = &entry.unit {
        let words = format!("{}; {}", of_unit(unit), terms(entry));
        lines.push(Line::new("unit", Phrase::of_words(words)));
    }
    lines
}

fn of_unit(unit: &Unit) -> String {
    match *unit == Unit::one() {
        true => "a pure number".to_string(),
        false => unit.to_string(),
    }
}

/// `7 terms`, `7 terms above the line, 2 below`
fn terms(entry: &Entry) -> String {
    let above = words::counted(entry.terms, "term");
    match entry.terms_below {
        0 | 1 => above,
        below => format!("{above} above the line, {below} below"),
    }
}

/// `L_g ≠ 0 and r − L_g > 0`
fn conditions(shown: &Shown, notation: Notation) -> Phrase {
    if shown.conditions.is_empty() {
        return Phrase::of_words("none");
    }
    let conditions = shown.conditions.iter();
    let written = conditions.map(|own| words::condition(own, notation));
    Phrase::default().list(written, " and ")
}
