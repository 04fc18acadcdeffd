//! One claim among others.

use crate::language::notation::Notation;
use crate::report::details::{Extent, details};
use crate::report::words::{self, CERTIFIED};
use crate::verdict::claim::Claim;

use super::page::Page;
use super::palette::{self, ALARM, FAINT, GOOD, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// The columns of a mark and a verdict; all else stands to the right of them.
const INDENT: usize = 15;
/// The column of the later lines of an expression.
const CONTINUATION: usize = INDENT + 2;
/// How many lines an overview gives to a statement.
const MOST_LINES_OF_STATEMENT: usize = 4;
/// How many lines an overview gives to a formula below the verdict.
const MOST_LINES_OF_DETAIL: usize = 3;

/// Writes a claim: its verdict, its name, what it says, and what stands below the verdict.
pub fn write(page: &mut Page, path: &str, claim: &Claim) {
    headline(page, claim);
    if let Some(surprise) = words::surprise(claim) {
        let place = Run::words(format!(" {path}:{}", claim.line), FAINT);
        page.prose(&[spaces(INDENT)], &[Run::words(surprise, ALARM), place]);
    }
    let statement = words::statement(claim, Notation::Unicode);
    let mut is_shortened = page.expression(
        &[spaces(INDENT)],
        CONTINUATION,
        &statement,
        MOST_LINES_OF_STATEMENT,
    );
    for detail in details(claim, Notation::Unicode, Extent::Overview) {
        is_shortened |= detail.is_shortened;
        match detail.phrase.as_mathematics() {
            Some(formula) => {
                let keyword = Run::words(format!("{} ", detail.keyword), FAINT);
                let prefix = [spaces(INDENT), keyword];
                is_shortened |=
                    page.expression(&prefix, CONTINUATION, formula, MOST_LINES_OF_DETAIL);
            }
            None => page.phrase(INDENT, detail.keyword, &detail.phrase),
        }
    }
    if is_shortened {
        page.hint(INDENT, &format!("… in full: --explain {}", claim.label.id));
    }
}

/// `✓ holds        (1) the mass centre is a point of the body`
pub fn headline(page: &mut Page, claim: &Claim) {
    let style = palette::of_claim(claim);
    let verdict = words::verdict(claim.verdict);
    page.prose(&column(&verdict, INDENT, style), &name(claim));
}

/// `(1) the mass centre is a point of the body`
pub fn name(claim: &Claim) -> Vec<Run> {
    let mut runs = Vec::new();
    if claim.is_certified == Some(true) {
        runs.push(Run::words(format!("{CERTIFIED} "), GOOD));
    }
    runs.push(Run::words(words::label(&claim.label), STRONG));
    if let Some(description) = &claim.description {
        runs.push(Run::words(format!(" {description}"), PLAIN));
    }
    runs
}
