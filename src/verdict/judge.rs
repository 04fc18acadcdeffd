//! The verdicts on assertions: what the first route found, with the second at assignments.

mod coordinate;
pub mod matching;
mod sides;
mod witness;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::algebra::sign::Signs;
use crate::points::evaluation::Evaluation;
use crate::points::graph::{Graph, Kind};
use crate::points::meaning::{Meaning, Meanings};
use crate::points::unfolding::Unfolding;
use crate::points::{
    Assumed, DEGENERATE_PLACES, Failure, NoValue, Purpose, Salt, Search, Sheet, Unknown, measured,
};

use super::claim::{Claim, Verdict, Witness};
use crate::derivation::assertion::{Assertion, Finding, Outcome};
use crate::derivation::scope::{self, Scope, SymbolKind};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Comparison, Name, Relation};

use matching::MatchingCheck;
use sides::{Agreement, Sides};
use witness::{Candidates, Fruitless};

/// At how many random assignments every assertion is evaluated.
const POINTS: usize = 2;

/// How many random assignments there are for assertions that have no value at most of them.
const MOST_CHECKPOINTS: u64 = 12;

/// How many nodes are kept for the next assertions, which may use the same definitions.
const MOST_NODES_KEPT: usize = 50_000;

/// How many operations the points may take for one document, and for one assertion.
const STEPS: [usize; 2] = [12_000_000, 2_000_000];

/// Why there are too few points.
const NO_POINT: &str = "no assignment was found that satisfies the assumptions";

/// Whose mistake it is where the routes disagree, and what to do.
pub const FAULT: &str = "this is a mistake of sextic, not of the document: please report it";

/// Evaluates assertions at assignments and gives the verdicts.
pub struct Judge<'a> {
    scope: &'a Scope,
    assumptions: &'a [Relation],
    signs: BTreeMap<String, Signs>,
    salt: Salt,
}

impl<'a> Judge<'a> {
    /// A judge over the names of a document, at assignments that satisfy its assumptions; the salt
    /// depends on the text of the document.
    pub fn new(
        scope: &'a Scope,
        assumptions: &'a [Relation],
        signs: BTreeMap<String, Signs>,
        salt: Salt,
    ) -> Self {
        Judge {
            scope,
            assumptions,
            signs,
            salt,
        }
    }

    /// The verdicts on findings, and of each matching what is wrong with it, if anything is.
    pub fn judge_all(
        &self,
        findings: &'a [Finding],
        matchings: &'a [MatchingCheck],
    ) -> (Vec<Claim>, Vec<Option<Diagnostic>>) {
        let meanings = meanings(self.scope, &self.signs);
        let mut court = Court::new(self, &meanings);
        let claims = findings.iter().map(|finding| court.claim(finding));
        let claims = claims.collect();
        let wrong = matchings.iter().map(|matching| {
            court.renew();
            matching.check(&mut court.unfolding).err()
        });
        (claims, wrong.collect())
    }
}

/// What the names of a document mean, without the elements of the ring.
fn meanings<'a>(scope: &'a Scope, signs: &BTreeMap<String, Signs>) -> Meanings<'a> {
    let entries = scope.entries();
    let meaning = |entry: &'a scope::Entry| {
        let name = entry.name.ascii.as_str();
        let signs = signs.get(name).copied().unwrap_or(Signs::ANY);
        (name, meaning(&entry.meaning, signs))
    };
    entries.map(meaning).collect()
}

fn meaning(meaning: &scope::Meaning, signs: Signs) -> Meaning<'_> {
    let variable = |kind| Meaning::Variable(kind, signs);
    match meaning {
        &scope::Meaning::Symbol { kind, .. } => match kind {
            SymbolKind::Parameter => variable(Kind::Real),
            SymbolKind::Complex => variable(Kind::Complex),
            SymbolKind::Angle => variable(Kind::Angle),
            SymbolKind::Coordinate => variable(Kind::Coordinate),
            SymbolKind::AngularCoordinate => variable(Kind::AngularCoordinate),
            SymbolKind::Imaginary => Meaning::ImaginaryUnit,
        },
        scope::Meaning::Function { reference, .. } => Meaning::Function(reference),
        scope::Meaning::Definition { expression, .. } => Meaning::Definition(expression),
        scope::Meaning::Template {
            arguments,
            expression,
        } => Meaning::Template(arguments, expression),
        scope::Meaning::Substitution { replacements, .. } => Meaning::Substitution(replacements),
    }
}

/// Where the assertions of one document are judged.
struct Court<'a> {
    unfolding: Unfolding<'a>,
    candidates: Candidates<'a>,
    /// Evaluations at assignments where values are missing more often than elsewhere.
    degenerate: Vec<Evaluation>,
    /// How many nodes the assumptions have.
    nodes: usize,
    /// Why there are no assignments.
    unsatisfied: Option<Failure>,
    /// How many operations are left for the document.
    steps: usize,
}

impl<'a> Court<'a> {
    fn new(judge: &Judge<'a>, meanings: &'a Meanings<'a>) -> Self {
        let mut search = Search {
            signs: Arc::new(judge.signs.clone()),
            measured: Arc::default(),
            assumed: Vec::new(),
            purpose: Purpose::Trust,
        };
        let graph = Graph::default();
        let generic = search.find_all(&graph, MOST_CHECKPOINTS);
        let mut unfolding = Unfolding::new(meanings, Sheet::new(graph, generic, judge.salt));
        let assumed = judge.assumptions.iter().map(|relation| {
            Ok(Assumed {
                left: unfolding.scalar(&relation.left)?,
                comparison: relation.comparison,
                right: unfolding.scalar(&relation.right)?,
            })
        });
        let assumed: Result<Vec<Assumed>, Failure> = assumed.collect();
        let unsatisfied = assumed.as_ref().err().copied();
        search.assumed = assumed.unwrap_or_default();
        let sides = search.assumed.iter().flat_map(|one| [one.left, one.right]);
        let sides: Vec<_> = sides.collect();
        search.measured = Arc::new(measured(&unfolding.sheet.graph, &sides));
        let sheet = &mut unfolding.sheet;
        if !search.assumed.is_empty() {
            sheet.generic = search.find_all(&sheet.graph, MOST_CHECKPOINTS);
        }
        search.purpose = Purpose::Existence;
        let degenerate = search.find_all(&sheet.graph, DEGENERATE_PLACES);
        search.purpose = Purpose::Show;
        Court {
            degenerate,
            nodes: sheet.graph.size(),
            unfolding,
            candidates: Candidates::new(search, judge.scope),
            unsatisfied,
            steps: STEPS[0],
        }
    }

    /// Whether nothing can be judged, since no assignment satisfies the assumptions.
    fn is_empty(&self) -> bool {
        self.unsatisfied.is_some() || self.unfolding.sheet.generic.is_empty()
    }

    /// Allows the operations of one assertion, as far as the document has some left.
    fn renew(&mut self) {
        let sheet = &mut self.unfolding.sheet;
        let evaluations = sheet.generic.len() + self.degenerate.len();
        let allowed = self.steps.min(STEPS[1]);
        self.candidates.steps = allowed;
        let steps = allowed / evaluations.max(1);
        for evaluation in sheet.generic.iter_mut().chain(&mut self.degenerate) {
            evaluation.steps = steps;
            evaluation.forget_many();
        }
        if sheet.graph.size() > self.nodes + MOST_NODES_KEPT {
            self.unfolding.forget(self.nodes);
            self.degenerate.iter_mut().for_each(Evaluation::forget);
        }
    }

    /// The verdict on a finding.
    fn claim(&mut self, finding: &'a Finding) -> Claim {
        let mut claim = undecided(finding);
        match &finding.outcome {
            Outcome::IllFormed { reason, misfit } => {
                claim.verdict = Verdict::IllFormed;
                claim.reason = Some(reason.clone());
                claim.misfit = Some(misfit.clone());
                return claim;
            }
            _ if self.is_empty() => {
                claim.reason = Some(NO_POINT.to_owned());
                return claim;
            }
            _ => {}
        }
        self.renew();
        let before = self.left();
        match Sides::of(finding, &mut self.unfolding) {
            Ok(sides) => self.judge(finding, &sides, &mut claim),
            Err(Failure::NoValue(_)) if is_true(&finding.outcome) => fault_of_routes(&mut claim),
            Err(failure) => claim.reason = Some(no_value(&finding.outcome, failure)),
        }
        self.steps = self
            .steps
            .saturating_sub(before.saturating_sub(self.left()));
        claim
    }

    /// How many operations the assertion may still take.
    fn left(&self) -> usize {
        let generic = self.unfolding.sheet.generic.iter();
        let all = generic.chain(&self.degenerate);
        all.map(|evaluation| evaluation.steps).sum::<usize>() + self.candidates.steps
    }

    fn judge(&mut self, finding: &Finding, sides: &Sides, claim: &mut Claim) {
        match is_true(&finding.outcome) {
            true => {
                let sheet = &mut self.unfolding.sheet;
                match agreement(sides, finding, sheet, &mut self.degenerate) {
                    Ok(points) => self.found_true(finding, sides, points, claim),
                    Err(Disagreement::Fault) => fault_of_routes(claim),
                    Err(Disagreement::TooFew(failure)) => {
                        claim.reason = Some(no_value(&finding.outcome, failure));
                    }
                }
            }
            false => {
                let sheet = &self.unfolding.sheet;
                match self.candidates.witness(sides, finding, &sheet.graph) {
                    Ok(witness) => refuted(claim, witness),
                    Err(fruitless) => claim.reason = Some(no_witness(&finding.outcome, &fruitless)),
                }
            }
        }
    }

    /// The verdict on what is true on both routes.
    fn found_true(&mut self, finding: &Finding, sides: &Sides, points: usize, claim: &mut Claim) {
        claim.points = points;
        let Outcome::TrueToOrder(_) = finding.outcome else {
            claim.verdict = match finding.conditions.is_empty() {
                true => Verdict::Holds,
                false => Verdict::HoldsWhere,
            };
            return;
        };
        let graph = &self.unfolding.sheet.graph;
        match sides.beyond.is_some() && self.candidates.goes_beyond(sides, finding, graph) {
            true => {
                claim.verdict = Verdict::Approximate;
                claim.neglected = beyond_order(&finding.assertion);
            }
            false => {
                let reason = "the sides are equal up to the order, but no further term was found \
                              that is not 0: claim it with a higher order, or as an equation";
                claim.reason = Some(reason.to_owned());
            }
        }
    }
}

/// Why what the first route found true is not confirmed.
enum Disagreement {
    /// The sides differ at an assignment, or one of them has no value there.
    Fault,
    /// They have values at too few.
    TooFew(Failure),
}

/// At how many random assignments the sides of what the first route found true agree; nor may a degenerate
/// assignment contradict it.
fn agreement(
    sides: &Sides,
    finding: &Finding,
    sheet: &mut Sheet,
    degenerate: &mut [Evaluation],
) -> Result<usize, Disagreement> {
    let comparison = finding.assertion.relation.comparison;
    let is_sure = comparison == Comparison::Equal && sides.are_surely_same(sheet);
    if is_sure && sides.are_total(&sheet.graph) {
        return Ok(POINTS);
    }
    let (graph, generic) = (&sheet.graph, &mut sheet.generic);
    let at = |evaluation: &mut Evaluation| match is_sure {
        true => sides.exist_at(evaluation, graph),
        false => sides.at(evaluation, graph, comparison),
    };
    let mut degenerate = degenerate.iter_mut();
    if degenerate.any(|evaluation| at(evaluation) == Ok(Agreement::Contradicts)) {
        return Err(Disagreement::Fault);
    }
    let enough = if is_sure { 1 } else { POINTS };
    let (mut passed, mut why) = (0, Failure::from(Unknown::Sign));
    for evaluation in generic {
        match at(evaluation) {
            Ok(Agreement::Agrees) => passed += 1,
            Ok(Agreement::Contradicts) => return Err(Disagreement::Fault),
            Ok(Agreement::OutsideOfConditions) => why = NoValue::DivisionByZero.into(),
            Err(unknown) => why = unknown.into(),
        }
        if passed == enough {
            break;
        }
    }
    match passed {
        _ if is_sure => Ok(POINTS),
        0 => Err(Disagreement::TooFew(why)),
        _ => Ok(passed),
    }
}

/// The verdict where the second route contradicts the first.
fn fault_of_routes(claim: &mut Claim) {
    claim.fault = true;
    claim.reason = Some(format!("the two routes to a verdict disagree: {FAULT}"));
}

fn refuted(claim: &mut Claim, witness: Witness) {
    claim.witness = Some(witness);
    claim.verdict = Verdict::Refuted;
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

/// What an approximation leaves out: the first order, and the small quantities.
fn beyond_order(assertion: &Assertion) -> Option<(u32, Vec<Name>)> {
    let order = assertion.order.as_ref()?;
    let small = order.small.iter().map(|small| small.value.clone());
    Some((order.order.value + 1, small.collect()))
}

/// Whether the first route found an assertion true.
const fn is_true(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::True | Outcome::TrueToOrder(_))
}

/// What the first route found of an assertion that is not certain.
const fn found(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Open => "the signs of the parameters do not decide it",
        Outcome::Different(_) => "the normal forms differ",
        _ => "the normal forms agree",
    }
}

/// Why nothing is certain of what has no value at the points.
fn no_value(outcome: &Outcome, failure: Failure) -> String {
    let found = found(outcome);
    format!("{found}, but it cannot be evaluated at a point: {failure}")
}

/// Why nothing is refuted without a point.
fn no_witness(outcome: &Outcome, fruitless: &Fruitless) -> String {
    let contradicts = match outcome {
        Outcome::Open => "no point contradicts it",
        _ => "no point was found at which the sides do",
    };
    let found = found(outcome);
    match fruitless {
        Fruitless::NoPoint => format!("{found}, but {NO_POINT}"),
        Fruitless::NoValue(failure) => no_value(outcome, *failure),
        Fruitless::NoConditions => {
            format!("{found}, but no point was found that satisfies its conditions")
        }
        Fruitless::Agreed => match outcome {
            Outcome::Open => format!("{found}, and {contradicts}"),
            _ => format!("{found}, but {contradicts}"),
        },
    }
}

/// A matching that fails at a point, or has no value there.
fn fault(span: &crate::language::syntax::Span, message: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Disagreement, span.clone(), message).with_help(FAULT)
}
