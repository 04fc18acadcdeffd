//! The steps behind one verdict.

use crate::language::notation::Notation;
use crate::language::syntax::Expression;
use crate::report::details::{Extent, details, route};
use crate::report::words;
use crate::verdict::audit::Audit;
use crate::verdict::claim::Claim;

use super::claim;
use super::page::Page;
use super::palette::{self, ALARM, FAINT, PLAIN};
use super::run::{Run, spaces};

/// The column of the later lines of an expression.
const CONTINUATION: usize = 6;

/// Writes how the verdict on a claim of a document was reached.
pub fn explanation(audit: &Audit, claim: &Claim, width: usize) -> String {
    let mut page = Page::new(width);
    claim::headline(&mut page, claim);
    page.place(&audit.path, claim.line);

    page.heading("Statement");
    write(&mut page, "", &words::statement(claim, Notation::Unicode));
    let explanation = audit.explain(claim);
    if !explanation.definitions.is_empty() {
        page.heading("Rests on");
    }
    for (left, right) in &explanation.definitions {
        let [left, right] = [left, right].map(|side| Notation::Unicode.expression(side));
        write(&mut page, &format!("{left} := "), &right);
    }
    normal_forms(&mut page, &explanation.left, &explanation.right);
    if let Some(unit) = &explanation.unit {
        let unit = if unit == "1" { "a pure number" } else { unit };
        let of = if explanation.left.len() > 1 {
            "Unit of the first entry"
        } else {
            "Unit"
        };
        page.heading(of);
        write(&mut page, "", unit);
    }
    verdict(&mut page, claim);
    page.finish()
}

fn normal_forms(page: &mut Page, left: &[Option<Expression>], right: &[Option<Expression>]) {
    if left.is_empty() && right.is_empty() {
        return;
    }
    if left == right {
        page.heading("Both sides in normal form");
        return entries(page, left);
    }
    page.heading("The left side in normal form");
    entries(page, left);
    page.heading("The right side in normal form");
    entries(page, right);
}

fn entries(page: &mut Page, entries: &[Option<Expression>]) {
    let digits = entries.len().to_string().len();
    for (number, entry) in (1..).zip(entries) {
        let prefix = match entries.len() {
            1 => String::new(),
            count => format!("entry {number:>digits$} of {count}  "),
        };
        match entry {
            Some(entry) => write(page, &prefix, &Notation::Unicode.expression(entry)),
            None => page.hint(2, &format!("{prefix}too long to read")),
        }
    }
}

fn verdict(page: &mut Page, claim: &Claim) {
    page.heading("Verdict");
    let mut runs = vec![
        Run::words(words::verdict(claim.verdict), palette::of_claim(claim)),
        Run::words(format!(": {}", route(claim)), PLAIN),
    ];
    if claim.as_expected() {
        runs.push(Run::words(" (as the document expects)", FAINT));
    }
    page.prose(&[spaces(2)], &runs);
    if let Some(surprise) = words::surprise(claim) {
        page.prose(&[spaces(2)], &[Run::words(surprise, ALARM)]);
    }
    for detail in details(claim, Notation::Unicode, Extent::Full) {
        match detail.phrase.as_mathematics() {
            Some(formula) => write(page, &format!("{} ", detail.keyword), formula),
            None => page.phrase(2, detail.keyword, &detail.phrase),
        }
    }
}

/// An expression in full behind a faint prefix.
fn write(page: &mut Page, prefix: &str, expression: &str) {
    let prefix = [spaces(2), Run::words(prefix, FAINT)];
    page.expression(&prefix, CONTINUATION, expression, usize::MAX);
}
