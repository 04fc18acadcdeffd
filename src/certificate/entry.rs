//! What became of a claim.

use crate::verdict::claim::Verdict;

use super::expression::Withheld;

/// What is certified of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Both sides have values and are equal.
    Equation,
    /// Both sides have values in the stated order.
    Inequality,
    /// K·v = λ·M·v, and v is not 0.
    Eigenpair,
    /// Taylor's polynomials of the stated order are equal, and those of a higher one are not always.
    Approximation,
    /// What a matching leaves of each power.
    Matching,
    /// There is an assignment under which both sides have values that differ.
    Refutation,
}

impl Kind {
    /// As JSON and terminal show it.
    pub const fn text(self) -> &'static str {
        match self {
            Kind::Equation => "equation",
            Kind::Inequality => "inequality",
            Kind::Eigenpair => "eigenpair",
            Kind::Approximation => "approximation",
            Kind::Matching => "matching",
            Kind::Refutation => "refutation",
        }
    }
}

/// What became of a claim.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The id of the claim or of the matching.
    pub id: String,
    /// Its label as it is written.
    pub label: String,
    /// The line on which it stands.
    pub line: usize,
    /// Its verdict; a matching has none.
    pub verdict: Option<Verdict>,
    /// What its theorems say, or why there are none.
    pub certificate: Result<Kind, Withheld>,
}

impl Entry {
    /// Its verdict in words.
    pub fn verdict(&self) -> &'static str {
        self.verdict.map_or("matching", Verdict::text)
    }
}
