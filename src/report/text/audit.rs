//! What became of a document, claim by claim and in sum.

use crate::derivation::matching::Matched;
use crate::language::notation::Notation;
use crate::report::summary::Summary;
use crate::report::{premises, refusals, residuals, words};
use crate::verdict::audit::Audit;
use crate::verdict::claim::Claim;

use super::claim;
use super::page::Page;
use super::palette::{self, ALARM, FAINT, GOOD, PLAIN, STRONG};
use super::run::{Run, spaces};
use super::shown;

/// Writes all verdicts on a document, and what they come to.
pub fn audit(audit: &Audit, width: usize) -> String {
    let mut page = Page::new(width);
    if let Some(title) = &audit.title {
        page.heading(title);
    }
    page.hint(0, &audit.path);
    for (keyword, phrase) in premises::lines(audit, Notation::Unicode) {
        page.column(KEYWORD, keyword, &phrase);
    }
    statements(&mut page, audit);
    summary(&mut page, audit, &Summary::new(audit));
    page.finish()
}

/// The claims, and what is shown in its place among them.
fn statements(page: &mut Page, audit: &Audit) {
    let mut shown = audit.shown.iter().peekable();
    for claim in &audit.claims {
        while let Some(own) = shown.next_if(|own| own.line < claim.line) {
            shown::write(page, own);
        }
        page.gap();
        claim::write(page, &audit.path, claim);
    }
    shown.for_each(|own| shown::write(page, own));
}

/// How wide the words before a premise are.
const KEYWORD: usize = 12;

fn summary(page: &mut Page, audit: &Audit, summary: &Summary) {
    let path = &audit.path;
    if !summary.counts.is_empty() {
        page.heading("In sum");
    }
    for (verdict, count) in &summary.counts {
        let style = palette::of_verdict(*verdict);
        let count = Run::words(format!("  {count:>4} "), STRONG);
        page.prose(&[count], &[Run::words(words::verdict(*verdict), style)]);
    }
    matchings(page, summary.matchings);
    for (heading, claims) in summary.failures() {
        list(page, path, heading, claims);
    }
    if !summary.surprises.is_empty() {
        list(
            page,
            path,
            "Not as the document expects",
            &summary.surprises,
        );
    }
    for (heading, lines) in refusals::lists(audit) {
        page.heading(heading);
        for line in lines {
            page.prose(&[spaces(2)], &[Run::words(line, PLAIN)]);
        }
    }
    page.gap();
    let style = match summary.surprises.as_slice() {
        _ if !audit.mistakes.is_empty() => ALARM,
        [] if summary.counts.is_empty() => STRONG,
        [] => GOOD,
        _ => ALARM,
    };
    page.prose(&[], &[Run::words(summary.conclusion(), style)]);
}

/// `  (20) closed_form: 4 of 7 powers matched exactly`
fn matchings(page: &mut Page, matchings: &[Matched]) {
    if !matchings.is_empty() {
        page.heading("Matchings");
    }
    for matched in matchings {
        let style = match residuals::warning(matched) {
            Some(_) => ALARM,
            None => STRONG,
        };
        let label = Run::words(words::label(&matched.label), style);
        let overview = residuals::overview(matched, Notation::Unicode).plain();
        let runs = [label, Run::words(format!(" {overview}"), PLAIN)];
        page.prose(&[spaces(2)], &runs);
    }
}

/// `  ✗ (8, printed) printed with m in the damping term`
fn list(page: &mut Page, path: &str, heading: &str, claims: &[&Claim]) {
    page.heading(heading);
    for claim in claims {
        let mark = Run::words(words::mark(claim.verdict), palette::of_claim(claim));
        let mut runs = claim::name(claim);
        let expected = words::expectation(claim.expectation);
        if !claim.as_expected() {
            let (found, line) = (claim.verdict.text(), claim.line);
            let place = format!(" (expected “{expected}”, found “{found}”) {path}:{line}");
            runs.push(Run::words(place, FAINT));
        }
        page.prose(&[spaces(2), mark, spaces(1)], &runs);
    }
}
