//! What became of the assertions of a document.

use crate::algebra::number::Rational;

use crate::derivation::assertion::{Assertion, Misfit};
use crate::derivation::condition::Condition;
use crate::derivation::quantity::Value;
use crate::language::notation::Notation;
use crate::language::syntax::{Expectation, Expression, Label, Name, Relation};

/// What the engine found of an assertion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// True, with nothing assumed but what the document declares.
    Holds,
    /// True where the conditions hold that its steps needed.
    HoldsWhere,
    /// True up to the stated order in the small quantities, and not exactly.
    Approximate,
    /// False; a point shows it.
    Refuted,
    /// Without meaning: units or shapes do not match.
    IllFormed,
    /// The engine cannot tell.
    Undecided,
    /// Not judged: it builds on a statement that was refused.
    Skipped,
}

impl Verdict {
    /// As JSON and terminal show it.
    pub const fn text(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::HoldsWhere => "holds where",
            Verdict::Approximate => "approximate",
            Verdict::Refuted => "refuted",
            Verdict::IllFormed => "ill-formed",
            Verdict::Undecided => "undecided",
            Verdict::Skipped => "skipped",
        }
    }

    /// Whether an author who expected this got it; `undecided` and `skipped` are never
    /// expected.
    pub const fn meets(self, expectation: Expectation) -> bool {
        matches!(
            (expectation, self),
            (Expectation::Holds, Verdict::Holds | Verdict::HoldsWhere)
                | (Expectation::Refuted, Verdict::Refuted)
                | (Expectation::Approximate, Verdict::Approximate)
                | (Expectation::IllFormed, Verdict::IllFormed)
        )
    }
}

/// The value that an assignment gives something.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    /// An expression such as `m` or `cos(α_0)`.
    pub name: Expression,
    /// Its value, or the real part of that.
    pub value: Rational,
    /// The imaginary part of a complex value.
    pub imaginary: Option<Rational>,
}

/// An assignment under which two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// What the assignment is, as far as it matters.
    pub point: Vec<Coordinate>,
    /// Of an approximation, the degree in the small quantities of the terms that differ; the sides
    /// are these terms.
    pub degree: Option<u32>,
    /// The row and column, counted from 1, at which two matrices differ.
    pub entry: Option<(usize, usize)>,
    /// The left side there: a fraction, or the digits that are known.
    pub left: String,
    /// The right side there, in the same way.
    pub right: String,
}

/// An assertion of a document and what became of it.
#[derive(Clone, Debug)]
pub struct Claim {
    /// How the document calls it.
    pub label: Label,
    /// The line on which it stands, counted from 1.
    pub line: usize,
    /// What it says.
    pub statement: Relation,
    /// In words.
    pub description: Option<String>,
    /// What the author expects.
    pub expectation: Expectation,
    /// What the engine found.
    pub verdict: Verdict,
    /// What the steps needed.
    pub conditions: Vec<Condition>,
    /// What an approximation leaves out: the order and the small quantities.
    pub neglected: Option<(u32, Vec<Name>)>,
    /// Of an approximation, the leading term of left − right.
    pub residual: Option<Expression>,
    /// Of a refutation, what left − right is, if the author says it and it is so.
    pub difference: Option<Expression>,
    /// Of a refutation, where the sides differ.
    pub witness: Option<Witness>,
    /// Of what is ill-formed, what does not fit together.
    pub misfit: Option<Misfit>,
    /// Why an assertion is ill-formed, undecided or skipped.
    pub reason: Option<String>,
    /// The normal forms of both sides; nothing where they cannot be compared.
    pub sides: Option<(Value, Value)>,
    /// At how many random places both sides were compared and found equal or in order: assignments, or
    /// random numbers modulo a large prime.
    pub points: usize,
    /// Whether a certificate states what was found as a theorem; nothing where that was not looked for.
    pub is_certified: Option<bool>,
    /// Whether it is undecided since the two routes disagree, which is a mistake of this program.
    pub fault: bool,
}

impl Claim {
    /// The claim that an assertion is, before anything is found of it.
    pub fn undecided(assertion: &Assertion) -> Self {
        Claim {
            label: assertion.label.clone(),
            line: assertion.line,
            statement: assertion.relation.clone(),
            description: assertion.description.clone(),
            expectation: assertion.expectation,
            verdict: Verdict::Undecided,
            conditions: Vec::new(),
            neglected: None,
            residual: None,
            difference: None,
            witness: None,
            misfit: None,
            reason: None,
            sides: None,
            points: 0,
            is_certified: None,
            fault: false,
        }
    }

    /// Whether the assertion quotes the source: its label ends in `printed` or in `stated`.
    pub fn is_quotation(&self) -> bool {
        let last = self.label.text.rsplit(',').next().unwrap_or_default();
        matches!(last.trim(), "printed" | "stated")
    }

    /// Whether the verdict is the one that the author expects.
    pub fn as_expected(&self) -> bool {
        self.verdict.meets(self.expectation)
    }

    /// Takes over what became of the claim that left − right is what the author says; a refutation stands on it, too.
    pub(crate) fn differ_by(&mut self, claim: &Claim) {
        if claim.verdict.meets(Expectation::Holds) {
            self.difference = Some(claim.statement.right.clone());
            self.conditions.extend(claim.conditions.iter().cloned());
            return;
        }
        if self.verdict == Verdict::Refuted {
            let stated = Notation::Unicode.expression(&claim.statement.right);
            let found = claim.verdict.text();
            let why = claim
                .reason
                .as_ref()
                .map_or(String::new(), |own| format!(", {own}"));
            self.verdict = Verdict::Undecided;
            self.witness = None;
            self.reason = Some(format!(
                "the sides differ, but that left − right is {stated} is {found}{why}"
            ));
        }
        self.fault |= claim.fault;
    }
}
