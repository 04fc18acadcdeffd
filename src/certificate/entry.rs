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
    /// Two parts differ in their units, or shapes do not fit.
    IllFormed,
    /// The operations of an emitted function give what the document says.
    Program,
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
            Kind::IllFormed => "ill-formed",
            Kind::Program => "emitted function",
            Kind::Refutation => "refutation",
        }
    }
}

/// What is certified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A claim of this verdict.
    Claim(Verdict),
    /// The solution of a matching.
    Matching,
    /// An evaluator.
    Program,
}

impl Subject {
    /// A verdict, or what it is that has none.
    pub fn text(self) -> &'static str {
        match self {
            Subject::Claim(verdict) => verdict.text(),
            Subject::Matching => "matching",
            Subject::Program => "emitted function",
        }
    }

    /// Whether it is a claim that holds.
    pub fn holds(self) -> bool {
        matches!(self, Subject::Claim(Verdict::Holds | Verdict::HoldsWhere))
    }
}

/// What became of a claim, a matching or an evaluator.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its id; the name of an evaluator.
    pub id: String,
    /// Its label as it is written.
    pub label: String,
    /// The line on which it stands.
    pub line: usize,
    /// What it is.
    pub subject: Subject,
    /// What its theorems say, or why there are none.
    pub certificate: Result<Kind, Withheld>,
}
