//! An expression that is shown.

use serde::Serialize;

use super::mathematics::{expression, phrase};
use crate::derivation::shown::Shown;
use crate::language::notation::Notation;
use crate::report::shown::{Line, lines, size};

/// What the template is given of what is shown.
#[derive(Serialize)]
pub struct ShownView {
    /// In words, and how large.
    words: Vec<String>,
    /// HTML: the expression.
    expression: String,
    lines: Vec<LineView>,
    line: usize,
}

#[derive(Serialize)]
struct LineView {
    keyword: String,
    /// HTML.
    text: String,
}

impl ShownView {
    /// What a statement shows.
    pub fn new(shown: &Shown) -> Self {
        let lines = lines(shown, Notation::Latex).into_iter();
        let view = |Line {
                        keyword,
                        phrase: own,
                    }: Line| LineView {
            keyword,
            text: phrase(&own),
        };
        ShownView {
            words: shown
                .description
                .iter()
                .cloned()
                .chain(size(shown))
                .collect(),
            expression: expression(&shown.expression),
            lines: lines.map(view).collect(),
            line: shown.line,
        }
    }
}
