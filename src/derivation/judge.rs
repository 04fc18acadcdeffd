//! The verdicts on assertions: what the first route found, with the second at points.

mod sides;
mod witness;

use std::collections::BTreeMap;

use crate::algebra::sign::Signs;

use super::assertion::{Assertion, Finding, Outcome};
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::evaluation::evaluator::Evaluator;
use super::evaluation::point::Size;
use super::scope::Scope;
use super::syntax::{Name, Relation, Span};
use super::verdict::{Claim, Verdict};

use sides::{compare, sides};

/// At how many random points every assertion is evaluated.
const POINTS: usize = 2;

/// How many random points are tried before an assertion is given up that has no value at most of them.
const MOST_CHECKPOINTS: usize = 24;

/// How many points are tried to find one that satisfies the assumptions, or that refutes.
const MOST_ATTEMPTS: u64 = 400;

/// Numbers large enough that two different expressions do not agree by chance.
const LARGE: Size = Size {
    numerator: 1_000_000,
    denominator: 1,
};

/// Numbers on both sides of 1, for assumptions that whole numbers do not satisfy.
const MIXED: Size = Size {
    numerator: 1_000,
    denominator: 1_000,
};

/// Numbers small enough to check by hand; later ones are larger.
const SMALL: [Size; 3] = [
    Size {
        numerator: 3,
        denominator: 1,
    },
    Size {
        numerator: 5,
        denominator: 2,
    },
    Size {
        numerator: 40,
        denominator: 9,
    },
];

/// Evaluates assertions at points of a finished document and gives the verdicts.
pub struct Judge<'a> {
    scope: &'a Scope,
    assumptions: &'a [Relation],
    signs: BTreeMap<String, Signs>,
    large: Vec<Evaluator<'a>>,
    small: Vec<Evaluator<'a>>,
}

impl<'a> Judge<'a> {
    /// A judge over the names of a document, at points that satisfy its assumptions.
    pub fn new(
        scope: &'a Scope,
        assumptions: &'a [Relation],
        signs: BTreeMap<String, Signs>,
    ) -> Self {
        Judge {
            scope,
            assumptions,
            signs,
            large: Vec::new(),
            small: Vec::new(),
        }
    }

    /// An evaluator at a point, if that satisfies the assumptions.
    fn evaluator(&self, seed: u64, size: Size) -> Option<Evaluator<'a>> {
        let mut evaluator = Evaluator::new(self.scope, seed, size, self.signs.clone());
        let admissible = self.assumptions.iter().all(|assumption| {
            let left = evaluator.evaluate(&assumption.left);
            let right = evaluator.evaluate(&assumption.right);
            matches!((left, right), (Ok(left), Ok(right))
                if compare(&left, &right, assumption.comparison) == Some(true))
        });
        admissible.then_some(evaluator)
    }

    /// One of the random points at which identities are checked, made when it is first asked for.
    fn checkpoint(&mut self, count: usize) -> Option<&mut Evaluator<'a>> {
        while self.large.len() <= count {
            let next = self.large.len() as u64;
            let found = (0..MOST_ATTEMPTS).find_map(|attempt| {
                let size = if attempt % 4 == 0 { LARGE } else { MIXED };
                self.evaluator(next * MOST_ATTEMPTS + attempt, size)
            });
            self.large.push(found?);
        }
        self.large.get_mut(count)
    }

    /// Carries out a check at as many random points as are needed: how many those were, or why there
    /// are not enough. Points at which something has no value are passed over.
    pub fn at_checkpoints(
        &mut self,
        mut check: impl FnMut(&mut Evaluator<'a>) -> Result<Result<(), String>, Diagnostic>,
    ) -> Result<Result<usize, String>, Diagnostic> {
        let (mut passed, mut reason) = (
            0,
            "no point was found that satisfies the assumptions".to_string(),
        );
        for count in 0..MOST_CHECKPOINTS {
            let Some(evaluator) = self.checkpoint(count) else {
                break;
            };
            match check(evaluator)? {
                Ok(()) => passed += 1,
                Err(why) => reason = why,
            }
            if passed == POINTS {
                return Ok(Ok(POINTS));
            }
        }
        Ok(Err(reason))
    }

    /// The points at which counterexamples are looked for, simple ones first.
    fn candidates(&mut self, count: usize) -> Option<&mut Evaluator<'a>> {
        while self.small.len() <= count {
            let next = self.small.len() as u64;
            let found = (0..MOST_ATTEMPTS).find_map(|attempt| {
                let larger = next / 40 + attempt / 100;
                let size = SMALL[(larger as usize).min(SMALL.len() - 1)];
                self.evaluator(1_000_000 + next * MOST_ATTEMPTS + attempt, size)
            });
            self.small.push(found?);
        }
        self.small.get_mut(count)
    }

    /// The verdict on a finding.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where the two routes disagree, which is a mistake of this program.
    pub fn judge(&mut self, finding: &'a Finding) -> Result<Claim, Diagnostic> {
        let mut claim = undecided(finding);
        match &finding.outcome {
            Outcome::IllFormed(reason) => {
                claim.verdict = Verdict::IllFormed;
                claim.reason = Some(reason.clone());
            }
            Outcome::True | Outcome::TrueToOrder => match self.confirm(finding)? {
                Ok(points) => {
                    claim.points = points;
                    claim.verdict = verdict_on_truth(finding);
                    if claim.verdict == Verdict::Approximate {
                        claim.neglected = beyond_order(&finding.assertion);
                    }
                }
                Err(reason) => claim.reason = Some(reason),
            },
            Outcome::Different(_) | Outcome::Open => match self.witness(finding) {
                Some(witness) => {
                    claim.witness = Some(witness);
                    claim.verdict = Verdict::Refuted;
                }
                None => claim.reason = Some(no_witness(&finding.outcome).to_string()),
            },
            Outcome::Unresolved(reason) => claim.reason = Some((*reason).to_string()),
        }
        Ok(claim)
    }

    /// Evaluates both sides at the checkpoints: how many there were, or why it cannot be done.
    fn confirm(&mut self, finding: &'a Finding) -> Result<Result<usize, String>, Diagnostic> {
        let assertion = &finding.assertion;
        self.at_checkpoints(|evaluator| {
            let sides = match sides(evaluator, assertion, assertion.order.as_ref()) {
                Ok(sides) => sides,
                Err(reason) => return Ok(Err(format!("cannot be evaluated at a point: {reason}"))),
            };
            for (left, right) in sides {
                match compare(&left, &right, assertion.relation.comparison) {
                    Some(true) => {}
                    Some(false) => return Err(disagreement(&assertion.span)),
                    None => return Ok(Err("the sides cannot be compared at a point".into())),
                }
            }
            Ok(Ok(()))
        })
    }
}

/// The claim that a finding is, before it is judged.
fn undecided(finding: &Finding) -> Claim {
    let assertion = &finding.assertion;
    Claim {
        label: assertion.label.clone(),
        line: assertion.line,
        statement: assertion.relation.clone(),
        description: assertion.description.clone(),
        expectation: assertion.expectation,
        verdict: Verdict::Undecided,
        conditions: finding.conditions.clone(),
        neglected: None,
        residual: finding.residual.clone(),
        witness: None,
        reason: None,
        sides: finding.sides.clone(),
        points: 0,
    }
}

/// The verdict on what is true on both routes.
fn verdict_on_truth(finding: &Finding) -> Verdict {
    match (&finding.outcome, finding.conditions.is_empty()) {
        (Outcome::TrueToOrder, _) => Verdict::Approximate,
        (_, true) => Verdict::Holds,
        (_, false) => Verdict::HoldsWhere,
    }
}

/// What an approximation leaves out: the first order, and the small quantities.
fn beyond_order(assertion: &Assertion) -> Option<(u32, Vec<Name>)> {
    let order = assertion.order.as_ref()?;
    let small = order.small.iter().map(|small| small.value.clone());
    Some((order.order + 1, small.collect()))
}

/// Why nothing is refuted without a point.
fn no_witness(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Open => {
            "the signs of the parameters do not decide it, and no point contradicts it"
        }
        _ => "the normal forms differ, but no point was found at which the sides do",
    }
}

fn disagreement(span: &Span) -> Diagnostic {
    let message = "the two routes to a verdict disagree";
    Diagnostic::new(DiagnosticKind::Disagreement, span.clone(), message)
        .with_label("equal in normal form, different at a point")
        .with_help("this is a mistake of sextic, not of the document: please report it")
}
