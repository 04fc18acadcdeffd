//! What expressions are.

use crate::derivation::shown::Shown;
use crate::language::notation::Notation;
use crate::report::shown::{Line, lines, size};

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// The columns of the word `shown` among claims; all else stands to the right of them.
const INDENT: usize = 15;
/// The columns of the words before lines of their own, and of the later lines of an expression.
const KEYWORD: usize = 15;
/// How many lines an overview gives to an expression.
const MOST_LINES_OF_OVERVIEW: usize = 4;
/// How many lines an expression gets that was asked for.
const MOST_LINES: usize = 40;

/// Writes what an expression is by the names of a document.
pub fn shown(path: &str, shown: &Shown, width: usize) -> String {
    let mut page = Page::new(width);
    let expression = Notation::Unicode.expression(&shown.expression);
    page.expression(&[], 2, &expression, MOST_LINES);
    if let Some(words) = words(shown) {
        page.prose(&[], &[Run::words(words, PLAIN)]);
    }
    page.hint(0, path);
    page.gap();
    let mut is_shortened = false;
    for Line { keyword, phrase } in lines(shown, Notation::Unicode) {
        match phrase.as_mathematics() {
            Some(formula) => {
                let keyword = column(&format!("  {keyword}"), KEYWORD, FAINT);
                is_shortened |= page.expression(&keyword, KEYWORD + 2, formula, MOST_LINES);
            }
            None => page.column(KEYWORD, &keyword, &phrase),
        }
    }
    if is_shortened {
        page.gap();
        page.hint(2, "… in full: --format json");
    }
    page.finish()
}

/// Writes what a document shows, among its claims.
pub fn write(page: &mut Page, shown: &Shown) {
    page.gap();
    let column = column("· shown", INDENT, FAINT);
    let expression = Notation::Unicode.expression(&shown.expression);
    match words(shown) {
        Some(words) => {
            page.prose(&column, &[Run::words(words, STRONG)]);
            page.expression(
                &[spaces(INDENT)],
                INDENT + 2,
                &expression,
                MOST_LINES_OF_OVERVIEW,
            );
        }
        None => {
            page.expression(&column, INDENT + 2, &expression, MOST_LINES_OF_OVERVIEW);
        }
    }
    let mut is_shortened = false;
    for Line { keyword, phrase } in lines(shown, Notation::Unicode) {
        match phrase.as_mathematics() {
            Some(formula) => {
                let prefix = [spaces(INDENT), Run::words(format!("{keyword} "), FAINT)];
                is_shortened |=
                    page.expression(&prefix, INDENT + 2, formula, MOST_LINES_OF_OVERVIEW);
            }
            None => page.phrase(INDENT, &keyword, &phrase),
        }
    }
    if is_shortened {
        page.hint(INDENT, "… in full: `sextic show`");
    }
}

/// What it is in words, and how large.
fn words(shown: &Shown) -> Option<String> {
    match (&shown.description, size(shown)) {
        (Some(words), Some(size)) => Some(format!("{words}: {size}")),
        (Some(words), None) => Some(words.clone()),
        (None, size) => size,
    }
}
