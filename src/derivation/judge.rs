//! The verdicts on assertions: what the first route found, with the second at points.

pub mod matching;
mod points;
mod sides;
mod witness;

use std::collections::BTreeMap;
use std::panic::resume_unwind;
use std::thread;

use crate::algebra::sign::Signs;

use super::assertion::{Assertion, Finding, Outcome};
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::evaluation::evaluator::{Evaluator, Failure};
use super::scope::Scope;
use super::syntax::{Name, Relation, Span};
use super::verdict::{Claim, Verdict, Witness};

use matching::MatchingCheck;
use points::{NO_POINT, Points, random_point, simple_point};
use sides::{compare, sides};
use witness::{Fruitless, witness};

/// At how many random points every assertion is evaluated.
const POINTS: usize = 2;

/// How many random points are tried before an assertion is given up that has no value at most of them.
const MOST_CHECKPOINTS: usize = 24;

/// Evaluates assertions at points of a finished document and gives the verdicts.
pub struct Judge<'a> {
    /// Random points at which identities are checked.
    checkpoints: Points<'a>,
    /// Points at which counterexamples are looked for, simple ones first.
    candidates: Points<'a>,
}

/// What became of a check at a point: passed, or impossible for a reason; an error where it fails.
pub type Checked = Result<Result<(), Failure>, Diagnostic>;

impl<'a> Judge<'a> {
    /// A judge over the names of a document, at points that satisfy its assumptions.
    pub fn new(
        scope: &'a Scope,
        assumptions: &'a [Relation],
        signs: BTreeMap<String, Signs>,
    ) -> Self {
        let points = |choose| Points::new(scope, assumptions, signs.clone(), choose);
        Judge {
            checkpoints: points(random_point),
            candidates: points(simple_point),
        }
    }

    /// The verdicts on findings, with the matchings checked too; the points are taken side by side.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where the two routes disagree, which is a mistake of this program, or where a
    /// matching cannot be checked.
    pub fn judge_all(
        &mut self,
        findings: &'a [Finding],
        matchings: &'a [MatchingCheck],
    ) -> Result<Vec<Claim>, Diagnostic> {
        self.checkpoints.at(POINTS - 1);
        let checkpoints = self.checkpoints.found().take(POINTS);
        let candidates = &mut self.candidates;
        let (checked, witnesses) = thread::scope(|threads| {
            let checked = checkpoints.map(|evaluator| {
                threads.spawn(|| {
                    let findings = findings.iter().map(|finding| check(evaluator, finding));
                    let findings: Vec<Checked> = findings.collect();
                    let matchings = matchings.iter().map(|matching| matching.check(evaluator));
                    (findings, matchings.collect::<Vec<Checked>>())
                })
            });
            let checked: Vec<_> = checked.collect();
            let witnesses = findings.iter().map(|finding| witness(candidates, finding));
            let witnesses: Vec<Result<Witness, Fruitless>> = witnesses.collect();
            let join = |thread: thread::ScopedJoinHandle<'_, _>| {
                thread.join().unwrap_or_else(|panic| resume_unwind(panic))
            };
            (checked.into_iter().map(join).collect::<Vec<_>>(), witnesses)
        });
        let (mut of_findings, mut of_matchings): (Vec<_>, Vec<_>) = checked
            .into_iter()
            .map(|(findings, matchings)| (findings.into_iter(), matchings.into_iter()))
            .unzip();
        let mut claims = Vec::new();
        for (finding, witness) in findings.iter().zip(witnesses) {
            let known = of_findings.iter_mut().filter_map(Iterator::next).collect();
            let points = self.enough(known, |evaluator| check(evaluator, finding))?;
            claims.push(claim(finding, points, witness));
        }
        for matching in matchings {
            let known = of_matchings.iter_mut().filter_map(Iterator::next).collect();
            let points = self.enough(known, |evaluator| matching.check(evaluator))?;
            matching.conclude(points)?;
        }
        Ok(claims)
    }

    /// Carries out a check at as many random points as are needed, of which the first are known: how
    /// many those were, or why there are not enough. Points at which something has no value are passed
    /// over.
    fn enough(
        &mut self,
        known: Vec<Checked>,
        check: impl Fn(&mut Evaluator<'a>) -> Checked,
    ) -> Result<Result<usize, Failure>, Diagnostic> {
        let mut known = known.into_iter();
        let (mut passed, mut reason) = (0, NO_POINT.to_string());
        for count in 0..MOST_CHECKPOINTS {
            let checked = match (known.next(), self.checkpoints.at(count)) {
                (Some(checked), _) => checked,
                (None, Some(evaluator)) => check(evaluator),
                (None, None) => break,
            };
            match checked? {
                Ok(()) => passed += 1,
                Err(why) => reason = why,
            }
            if passed == POINTS {
                return Ok(Ok(POINTS));
            }
        }
        Ok(Err(reason))
    }
}

/// Evaluates both sides of what the first route found true.
fn check<'a>(evaluator: &mut Evaluator<'a>, finding: &'a Finding) -> Checked {
    if !finding.outcome.is_true() {
        return Ok(Ok(()));
    }
    let assertion = &finding.assertion;
    let sides = match sides(evaluator, assertion, assertion.order.as_ref()) {
        Ok(sides) => sides,
        Err(reason) => return Ok(Err(format!("cannot be evaluated at a point: {reason}"))),
    };
    for (left, right) in sides {
        let extension = &evaluator.point().extension;
        match compare(&left, &right, assertion.relation.comparison, extension) {
            Some(true) => {}
            Some(false) => return Err(disagreement(&assertion.span)),
            None => return Ok(Err("the sides cannot be compared at a point".into())),
        }
    }
    Ok(Ok(()))
}

/// The claim that a finding becomes with what the points showed.
fn claim(
    finding: &Finding,
    points: Result<usize, Failure>,
    witness: Result<Witness, Fruitless>,
) -> Claim {
    let mut claim = undecided(finding);
    match (&finding.outcome, points, witness) {
        (Outcome::IllFormed(reason), ..) => {
            claim.verdict = Verdict::IllFormed;
            claim.reason = Some(reason.clone());
        }
        (Outcome::True | Outcome::TrueToOrder, Ok(points), _) => {
            claim.points = points;
            claim.verdict = verdict_on_truth(finding);
            if claim.verdict == Verdict::Approximate {
                claim.neglected = beyond_order(&finding.assertion);
            }
        }
        (Outcome::True | Outcome::TrueToOrder, Err(reason), _) => claim.reason = Some(reason),
        (Outcome::Different(_) | Outcome::Open, _, Ok(witness)) => {
            claim.witness = Some(witness);
            claim.verdict = Verdict::Refuted;
        }
        (Outcome::Different(_) | Outcome::Open, _, Err(fruitless)) => {
            claim.reason = Some(no_witness(&finding.outcome, &fruitless));
        }
        (Outcome::Unresolved(reason), ..) => claim.reason = Some((*reason).to_string()),
    }
    claim
}

/// The claim that a finding is, before it is judged.
fn undecided(finding: &Finding) -> Claim {
    Claim {
        conditions: finding.conditions.clone(),
        residual: finding.residual.clone(),
        sides: finding.sides.clone(),
        ..Claim::undecided(&finding.assertion)
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
    Some((order.order.value + 1, small.collect()))
}

/// Why nothing is refuted without a point.
fn no_witness(outcome: &Outcome, fruitless: &Fruitless) -> String {
    let (found, contradicts) = match outcome {
        Outcome::Open => (
            "the signs of the parameters do not decide it",
            "no point contradicts it",
        ),
        _ => (
            "the normal forms differ",
            "no point was found at which the sides do",
        ),
    };
    match fruitless {
        Fruitless::NoPoint => format!("{found}, but {NO_POINT}"),
        Fruitless::NoValue(reason) => {
            format!("{found}, but it cannot be evaluated at a point: {reason}")
        }
        Fruitless::NoOrder => {
            format!("{found}, and at points its sides are numbers without an order")
        }
        Fruitless::NoConditions => {
            format!("{found}, but no point was found that satisfies its conditions")
        }
        Fruitless::Agreed => match outcome {
            Outcome::Open => format!("{found}, and {contradicts}"),
            _ => format!("{found}, but {contradicts}"),
        },
    }
}

fn disagreement(span: &Span) -> Diagnostic {
    let message = "the two routes to a verdict disagree";
    Diagnostic::new(DiagnosticKind::Disagreement, span.clone(), message)
        .with_label("equal in normal form, different at a point")
        .with_help("this is a mistake of sextic, not of the document: please report it")
}
