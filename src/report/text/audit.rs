//! What became of a document, claim by claim and in sum.

use crate::derivation::audit::Audit;
use crate::derivation::verdict::Claim;
use crate::report::summary::Summary;
use crate::report::words;

use super::claim;
use super::page::Page;
use super::palette::{self, ALARM, FAINT, GOOD, STRONG};
use super::run::{Run, spaces};

/// Writes all verdicts on a document, and what they come to.
pub fn audit(audit: &Audit, width: usize) -> String {
    let mut page = Page::new(width);
    if let Some(title) = &audit.title {
        page.heading(title);
    }
    page.hint(0, &audit.path);
    for claim in &audit.claims {
        page.gap();
        claim::write(&mut page, claim);
    }
    summary(&mut page, &Summary::new(audit));
    page.finish()
}

fn summary(page: &mut Page, summary: &Summary) {
    if !summary.counts.is_empty() {
        page.heading("In sum");
    }
    for (verdict, count) in &summary.counts {
        let style = palette::of_verdict(*verdict);
        let count = Run::words(format!("  {count:>4} "), STRONG);
        page.prose(&[count], &[Run::words(words::verdict(*verdict), style)]);
    }
    for (heading, claims) in summary.failures() {
        list(page, heading, claims);
    }
    if !summary.surprises.is_empty() {
        list(page, "Not as the document expects", &summary.surprises);
    }
    page.gap();
    let style = if summary.surprises.is_empty() {
        GOOD
    } else {
        ALARM
    };
    page.prose(&[], &[Run::words(summary.conclusion(), style)]);
}

/// `  ✗ (8, printed) printed with m in the damping term`
fn list(page: &mut Page, heading: &str, claims: &[&Claim]) {
    page.heading(heading);
    for claim in claims {
        let mark = Run::words(words::mark(claim.verdict), palette::of_claim(claim));
        let mut runs = claim::name(claim);
        let expected = words::expectation(claim.expectation);
        if !claim.as_expected() {
            let found = claim.verdict.text();
            runs.push(Run::words(
                format!(" (expected “{expected}”, found “{found}”)"),
                FAINT,
            ));
        }
        page.prose(&[spaces(2), mark, spaces(1)], &runs);
    }
}
