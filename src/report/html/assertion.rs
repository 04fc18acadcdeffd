//! An assertion with its verdict.

use serde::Serialize;

use super::mathematics::{formula, phrase};
use crate::language::notation::Notation;
use crate::report::details::{Extent, details, route};
use crate::report::words::{self, CERTIFIED};
use crate::verdict::claim::{Claim, Verdict};

/// What the template is given of an assertion.
#[derive(Serialize)]
pub struct AssertionView {
    /// What it is called within its page.
    pub anchor: String,
    /// What `sextic audit --explain` calls it.
    pub id: String,
    /// `(8, printed)`
    pub label: String,
    /// `holds`, in the style sheet.
    pub class: &'static str,
    /// `✓ holds`
    pub verdict: String,
    /// Where the verdict is not the one that the author expects.
    pub surprise: Option<String>,
    /// In words.
    pub description: Option<String>,
    /// HTML: the equation.
    statement: String,
    details: Vec<DetailView>,
    /// ⊢, if a certificate states it as a theorem.
    certified: Option<&'static str>,
    /// How the verdict was reached.
    route: String,
    line: usize,
}

#[derive(Serialize)]
struct DetailView {
    keyword: &'static str,
    /// HTML.
    text: String,
}

impl AssertionView {
    /// A claim of the document whose anchors begin with `prefix`.
    pub fn new(claim: &Claim, prefix: &str) -> Self {
        let details = details(claim, Notation::Latex, Extent::Full);
        AssertionView {
            anchor: format!("{prefix}-claim-{}", claim.label.id),
            id: claim.label.id.clone(),
            label: words::label(&claim.label),
            class: class(claim.verdict),
            verdict: words::verdict(claim.verdict),
            surprise: words::surprise(claim),
            description: claim.description.clone(),
            statement: formula(&words::statement(claim, Notation::Latex)),
            details: details
                .iter()
                .map(|detail| DetailView {
                    keyword: detail.keyword,
                    text: phrase(&detail.phrase),
                })
                .collect(),
            certified: claim.is_certified.filter(|is_so| *is_so).map(|_| CERTIFIED),
            route: route(claim),
            line: claim.line,
        }
    }
}

/// What the style sheet calls a verdict.
pub const fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds | Verdict::HoldsWhere => "holds",
        Verdict::Approximate => "approximate",
        Verdict::Refuted | Verdict::IllFormed => "fails",
        Verdict::Undecided | Verdict::Skipped => "undecided",
    }
}
