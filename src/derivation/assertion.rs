//! Assertions become verdicts, by both routes.
//!
//! First every assertion is elaborated where it stands and its normal forms are compared
//! ([`Finding`]); when the document is read to its end, the sides are evaluated at points, and the
//! two routes together give the verdict ([`Judge`]).

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::sign::Signs;

use super::condition::Conditions;
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::elaboration::Elaborator;
use super::elaboration::error::algebra;
use super::elaboration::limit::check_order;
use super::evaluation::evaluator::Evaluator;
use super::evaluation::number::Number;
use super::evaluation::point::Size;
use super::foundation::Foundation;
use super::presentation::Presenter;
use super::quantity::{Value, common_unit};
use super::scope::Scope;
use super::syntax::{Comparison, Expectation, Expression, Label, Order, Relation, Span};
use super::verdict::{Claim, Condition, Explanation, Verdict, Witness};

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

/// Longer normal forms are not shown with a verdict.
const MOST_TERMS_TO_SHOW: usize = 100;

/// How far beyond the stated order the leading term of a residual is looked for.
const RESIDUAL_ORDERS: u32 = 3;

/// An assertion as the document makes it.
#[derive(Clone, Debug)]
pub struct Assertion {
    /// How it is called.
    pub label: Label,
    /// What the author expects.
    pub expectation: Expectation,
    /// What is asserted.
    pub relation: Relation,
    /// Of an approximation.
    pub order: Option<Order>,
    /// In words.
    pub description: Option<String>,
    /// The line on which it stands, counted from 1.
    pub line: usize,
    /// Where it stands.
    pub span: Span,
}

/// What the first route tells of an assertion.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The assertion.
    pub assertion: Assertion,
    outcome: Outcome,
    conditions: Vec<Condition>,
    residual: Option<Expression>,
    explanation: Explanation,
    names: BTreeSet<String>,
}

#[derive(Clone, Debug, PartialEq)]
enum Outcome {
    /// Units or shapes do not match.
    IllFormed(String),
    /// The normal forms agree, or the inequality follows from the assumptions.
    True,
    /// The normal forms agree up to the order, and not beyond.
    TrueToOrder,
    /// The normal forms differ, at the given degree in the small quantities for an approximation.
    Different(Option<u32>),
    /// The assumptions do not decide an inequality.
    Open,
    /// A point would not show anything, for the given reason.
    Unresolved(&'static str),
}

impl Elaborator {
    /// Compares the sides of an assertion in normal form.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where a side has no value for another reason than units and shapes.
    pub fn find(&mut self, assertion: &Assertion) -> Result<Finding, Diagnostic> {
        let span = &assertion.span;
        let ill_formed = |reason: String| {
            Ok(Finding {
                assertion: assertion.clone(),
                outcome: Outcome::IllFormed(reason),
                conditions: Vec::new(),
                residual: None,
                explanation: Explanation::default(),
                names: BTreeSet::new(),
            })
        };
        let relation = &assertion.relation;
        if let Some(order) = &assertion.order {
            check_order(order.order, span)?;
            if relation.comparison != Comparison::Equal {
                let message = "only an equation can hold to an order";
                return Err(
                    Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message)
                        .with_label("an inequality")
                        .with_help("leave out `to order …`, or compare with `==`"),
                );
            }
        }
        let sides = self
            .value(&relation.left)
            .and_then(|left| Ok((left, self.value(&relation.right)?)));
        let (left, right) = match sides {
            Ok(sides) => sides,
            Err(error) if matches!(error.kind, DiagnosticKind::Unit | DiagnosticKind::Shape) => {
                return ill_formed(error.message);
            }
            Err(error) => return Err(error),
        };
        if left.shape() != right.shape() {
            let shape = |value: &Value| format!("{}×{}", value.rows(), value.columns());
            return ill_formed(format!("left {}, right {}", shape(&left), shape(&right)));
        }
        for (a, b) in left.entries().iter().zip(right.entries()) {
            if common_unit(&a.unit, &b.unit).is_err() {
                let unit = |unit: &Option<super::unit::Unit>| {
                    unit.as_ref().map(ToString::to_string).unwrap_or_default()
                };
                return ill_formed(format!("left {}, right {}", unit(&a.unit), unit(&b.unit)));
            }
        }
        let wrap = |error| algebra(error, span);
        let differences: Vec<Fraction> = left
            .entries()
            .iter()
            .zip(right.entries())
            .map(|(a, b)| self.ring.difference(&a.value, &b.value).map_err(wrap))
            .collect::<Result<_, _>>()?;
        let (outcome, residual) = match (relation.comparison, &assertion.order) {
            (Comparison::Equal, None) => (self.compare(&differences), None),
            (Comparison::Equal, Some(order)) => self.compare_to_order(&differences, order, span)?,
            (comparison, _) => (
                self.compare_signs(&differences, comparison, relation)?,
                None,
            ),
        };
        let needed = std::mem::take(&mut self.conditions);
        let explanation = self.explanation(assertion, &left, &right)?;
        let names = self.value_names([&left, &right], span)?;
        Ok(Finding {
            assertion: assertion.clone(),
            outcome,
            conditions: self.present_conditions(&needed, span)?,
            residual: residual
                .map(|residual| self.present(&residual, span))
                .transpose()?,
            explanation,
            names,
        })
    }

    /// The names under which a point lists the values that sides are made of: `m`, `dt(x)`,
    /// `cos(alpha_0)`.
    fn value_names(&self, sides: [&Value; 2], span: &Span) -> Result<BTreeSet<String>, Diagnostic> {
        let presenter = Presenter {
            ring: &self.ring,
            scope: &self.scope,
        };
        let entries = sides.into_iter().flat_map(|side| side.entries());
        let polynomials =
            entries.flat_map(|entry| [entry.value.numerator(), entry.value.denominator()]);
        let symbols: BTreeSet<_> = polynomials.flat_map(Polynomial::symbols).collect();
        let mut names = BTreeSet::new();
        for symbol in symbols {
            let shown = presenter
                .symbol(symbol)
                .map_err(|error| algebra(error, span))?;
            shown.collect_values(&mut names);
        }
        Ok(names)
    }

    fn present_conditions(
        &self,
        conditions: &Conditions,
        span: &Span,
    ) -> Result<Vec<Condition>, Diagnostic> {
        let presenter = Presenter {
            ring: &self.ring,
            scope: &self.scope,
        };
        let present = |(requirement, polynomial): &(_, _)| {
            let expression = presenter.polynomial(polynomial);
            Ok(Condition {
                expression: expression.map_err(|error| algebra(error, span))?,
                requirement: *requirement,
            })
        };
        conditions.iter().map(present).collect()
    }

    fn compare(&self, differences: &[Fraction]) -> Outcome {
        if differences.iter().all(Fraction::is_zero) {
            return Outcome::True;
        }
        let hidden = differences.iter().any(|difference| {
            let symbols = difference.numerator().symbols();
            symbols
                .into_iter()
                .any(|symbol| match self.ring.generator(symbol) {
                    Generator::Direction { .. } => true,
                    Generator::FunctionValue { argument, .. } => {
                        let inside = argument.numerator().symbols();
                        inside.into_iter().any(|inside| {
                            matches!(self.ring.generator(inside), Generator::Direction { .. })
                        })
                    }
                    _ => false,
                })
        });
        if hidden {
            return Outcome::Unresolved(
                "the difference contains the angle of a vector, which may be one of the other angles",
            );
        }
        Outcome::Different(None)
    }

    fn compare_to_order(
        &mut self,
        differences: &[Fraction],
        order: &Order,
        span: &Span,
    ) -> Result<(Outcome, Option<Fraction>), Diagnostic> {
        let small = self.variables(&order.small)?;
        let wrap = |error| algebra(error, span);
        let mut leading: Option<(u32, Fraction)> = None;
        for difference in differences {
            let found = self
                .ring
                .leading_part(difference, &small, order.order + RESIDUAL_ORDERS)
                .map_err(wrap)?;
            let earlier = leading
                .as_ref()
                .is_none_or(|(least, _)| found.as_ref().is_some_and(|(degree, _)| degree < least));
            if earlier && found.is_some() {
                leading = found;
            }
        }
        Ok(match leading {
            _ if differences.iter().all(Fraction::is_zero) => (Outcome::True, None),
            Some((degree, _)) if degree <= order.order => (Outcome::Different(Some(degree)), None),
            Some((_, residual)) => (Outcome::TrueToOrder, Some(residual)),
            None => (Outcome::TrueToOrder, None),
        })
    }

    fn compare_signs(
        &mut self,
        differences: &[Fraction],
        comparison: Comparison,
        relation: &Relation,
    ) -> Result<Outcome, Diagnostic> {
        let span = &relation.left.span;
        let [difference] = differences else {
            let message = "matrices have no order";
            return Err(
                Diagnostic::new(DiagnosticKind::Shape, span.clone(), message)
                    .with_label("a matrix")
                    .with_help("compare their entries, such as `A[1, 2] < B[1, 2]`"),
            );
        };
        let signs = self
            .ring
            .signs(difference)
            .map_err(|error| algebra(error, span))?;
        let wanted = allowed(comparison);
        let possible = |sign: fn(Signs) -> bool| sign(signs) && !sign(wanted);
        let violated = possible(|signs| signs.negative)
            || possible(|signs| signs.zero)
            || possible(|signs| signs.positive);
        Ok(match violated {
            false => Outcome::True,
            true if self.is_transcendental(difference) => Outcome::Unresolved(
                "an angle stands beside its own sine or cosine, which a rational point cannot follow",
            ),
            true => Outcome::Open,
        })
    }

    /// Whether an angle stands beside a sine or cosine of it: a point of the relations gives them
    /// values that do not belong together, which shows nothing about an inequality.
    fn is_transcendental(&self, element: &Fraction) -> bool {
        let symbols = element
            .numerator()
            .symbols()
            .into_iter()
            .chain(element.denominator().symbols());
        let symbols: Vec<_> = symbols.collect();
        symbols
            .iter()
            .any(|symbol| match self.ring.generator(*symbol) {
                Generator::Cosine { angle } | Generator::Sine { angle } => angle
                    .coefficients()
                    .any(|(inside, _)| symbols.contains(&inside)),
                _ => false,
            })
    }

    fn explanation(
        &self,
        assertion: &Assertion,
        left: &Value,
        right: &Value,
    ) -> Result<Explanation, Diagnostic> {
        let Relation {
            left: a, right: b, ..
        } = &assertion.relation;
        let definitions = Foundation::of(&self.scope, [a, b]);
        let present = |value: &Value| -> Result<Vec<Option<Expression>>, Diagnostic> {
            let entries = value.entries().iter().map(|entry| {
                let terms = entry.value.numerator().len() + entry.value.denominator().len();
                let short = (terms <= MOST_TERMS_TO_SHOW).then_some(&entry.value);
                short
                    .map(|value| self.present(value, &assertion.span))
                    .transpose()
            });
            entries.collect()
        };
        let unit = left
            .entries()
            .iter()
            .chain(right.entries())
            .find_map(|entry| entry.unit.clone());
        Ok(Explanation {
            definitions,
            left: present(left)?,
            right: present(right)?,
            unit: unit.map(|unit| unit.to_string()),
            points: 0,
        })
    }
}

/// The signs that left − right may have.
fn allowed(comparison: Comparison) -> Signs {
    match comparison {
        Comparison::Equal => Signs::ZERO,
        Comparison::Less => Signs::NEGATIVE,
        Comparison::LessOrEqual => Signs::NON_NEGATIVE.opposite(),
        Comparison::Greater => Signs::POSITIVE,
        Comparison::GreaterOrEqual => Signs::NON_NEGATIVE,
    }
}

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

    fn evaluator(&self, seed: u64, size: Size) -> Option<Evaluator<'a>> {
        let mut evaluator = Evaluator::new(self.scope, seed, size, self.signs.clone());
        let admissible = self.assumptions.iter().all(|assumption| {
            let left = evaluator.evaluate(&assumption.left);
            let right = evaluator.evaluate(&assumption.right);
            matches!((left, right), (Ok(left), Ok(right))
                if compare_numbers(&left, &right, assumption.comparison) == Some(true))
        });
        admissible.then_some(evaluator)
    }

    /// One of the random points at which identities are checked, made when it is first asked for.
    fn checkpoint(&mut self, count: usize) -> Option<&mut Evaluator<'a>> {
        while self.large.len() <= count {
            let next = self.large.len() as u64;
            let found = (0..MOST_ATTEMPTS)
                .find_map(|attempt| self.evaluator(next * MOST_ATTEMPTS + attempt, LARGE));
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
        let (mut passed, mut reason) = (0, "no point satisfies the assumptions".to_string());
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
            let size = SMALL[(next as usize / 40).min(SMALL.len() - 1)];
            let found = (0..MOST_ATTEMPTS).find_map(|attempt| {
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
        let assertion = &finding.assertion;
        let mut claim = Claim {
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
            explanation: finding.explanation.clone(),
        };
        match &finding.outcome {
            Outcome::IllFormed(reason) => {
                claim.verdict = Verdict::IllFormed;
                claim.reason = Some(reason.clone());
            }
            Outcome::True | Outcome::TrueToOrder => match self.confirm(finding)? {
                Ok(points) => {
                    claim.explanation.points = points;
                    claim.verdict = match (&finding.outcome, finding.conditions.is_empty()) {
                        (Outcome::TrueToOrder, _) => Verdict::Approximate,
                        (_, true) => Verdict::Holds,
                        (_, false) => Verdict::HoldsWhere,
                    };
                    if let (Outcome::TrueToOrder, Some(order)) =
                        (&finding.outcome, &assertion.order)
                    {
                        let small = order
                            .small
                            .iter()
                            .map(|small| small.value.clone())
                            .collect();
                        claim.neglected = Some((order.order + 1, small));
                    }
                }
                Err(reason) => claim.reason = Some(reason),
            },
            Outcome::Different(_) | Outcome::Open => {
                match self.witness(finding) {
                    Some(witness) => {
                        claim.witness = Some(witness);
                        claim.verdict = Verdict::Refuted;
                    }
                    None => {
                        claim.reason = Some(match &finding.outcome {
                        Outcome::Open => "the signs of the parameters do not decide it, and no \
                                          point contradicts it"
                            .into(),
                        _ => "the normal forms differ, but no point was found at which the sides do"
                            .to_string(),
                    });
                    }
                }
            }
            Outcome::Unresolved(reason) => claim.reason = Some((*reason).to_string()),
        }
        Ok(claim)
    }

    /// Evaluates both sides at the checkpoints: how many there were, or why it cannot be done.
    fn confirm(&mut self, finding: &'a Finding) -> Result<Result<usize, String>, Diagnostic> {
        let assertion = &finding.assertion;
        self.at_checkpoints(|evaluator| {
            let sides = match side_parts(evaluator, assertion, assertion.order.as_ref()) {
                Ok(sides) => sides,
                Err(reason) => return Ok(Err(format!("cannot be evaluated at a point: {reason}"))),
            };
            for (left, right) in sides {
                match compare_numbers(&left, &right, assertion.relation.comparison) {
                    Some(true) => {}
                    Some(false) => return Err(disagreement(&assertion.span)),
                    None => return Ok(Err("the sides cannot be compared at a point".into())),
                }
            }
            Ok(Ok(()))
        })
    }

    /// The first point at which the sides differ.
    fn witness(&mut self, finding: &'a Finding) -> Option<Witness> {
        const MOST_POINTS: usize = 160;
        let assertion = &finding.assertion;
        let degree = match &finding.outcome {
            Outcome::Different(degree) => *degree,
            _ => None,
        };
        let order = assertion.order.as_ref().filter(|_| degree.is_some());
        let mut irrational = None;
        for count in 0..MOST_POINTS {
            let Some(evaluator) = self.candidates(count) else {
                break;
            };
            let Ok(sides) = side_parts(evaluator, assertion, order) else {
                continue;
            };
            let side = match degree {
                Some(degree) => sides.into_iter().nth(degree as usize),
                None => sides.into_iter().next(),
            };
            let Some((left, right)) = side else { continue };
            let comparison = assertion.relation.comparison;
            if compare_numbers(&left, &right, comparison) != Some(false) {
                continue;
            }
            let (row, column) = first_difference(&left, &right).unwrap_or((0, 0));
            let (a, b) = (&left[row][column], &right[row][column]);
            let point = evaluator.point();
            let drawn = point
                .drawn()
                .iter()
                .filter(|(name, _)| is_shown(name, &finding.names));
            let witness = Witness {
                point: drawn
                    .map(|(name, value)| (name.clone(), value.clone()))
                    .collect(),
                entry: (left.len() > 1 || left[0].len() > 1).then_some((row + 1, column + 1)),
                left: a.display(&point.extension),
                right: b.display(&point.extension),
            };
            if a.as_rational().is_some() && b.as_rational().is_some() {
                return Some(witness);
            }
            irrational.get_or_insert(witness);
        }
        irrational
    }
}

type Numbers = Vec<Vec<Number>>;

/// Both sides at a point: as they are, or part by part for an approximation.
fn side_parts<'a>(
    evaluator: &mut Evaluator<'a>,
    assertion: &'a Assertion,
    order: Option<&Order>,
) -> Result<Vec<(Numbers, Numbers)>, String> {
    let Relation { left, right, .. } = &assertion.relation;
    match order {
        None => Ok(vec![(
            evaluator.evaluate(left)?,
            evaluator.evaluate(right)?,
        )]),
        Some(order) => {
            let small: Vec<&str> = order
                .small
                .iter()
                .map(|name| name.value.ascii.as_str())
                .collect();
            let left = evaluator.parts(left, &small, order.order)?;
            let right = evaluator.parts(right, &small, order.order)?;
            Ok(left.into_iter().zip(right).collect())
        }
    }
}

/// Whether two tables stand in a relation; nothing where that cannot be told.
fn compare_numbers(left: &Numbers, right: &Numbers, comparison: Comparison) -> Option<bool> {
    if comparison == Comparison::Equal {
        return Some(first_difference(left, right).is_none());
    }
    let [[a]] = [left.first()?.as_slice()] else {
        return None;
    };
    let [[b]] = [right.first()?.as_slice()] else {
        return None;
    };
    let difference = a.difference(b).as_rational()?;
    let wanted = allowed(comparison);
    Some(match difference.cmp(&Rational::ZERO) {
        std::cmp::Ordering::Less => wanted.negative,
        std::cmp::Ordering::Equal => wanted.zero,
        std::cmp::Ordering::Greater => wanted.positive,
    })
}

fn first_difference(left: &Numbers, right: &Numbers) -> Option<(usize, usize)> {
    let mut places =
        (0..left.len()).flat_map(|row| (0..left[row].len()).map(move |column| (row, column)));
    places.find(|(row, column)| {
        let other = right.get(*row).and_then(|line| line.get(*column));
        other.is_none_or(|other| !left[*row][*column].difference(other).is_zero())
    })
}

/// Whether a point shows a value: its own name is wanted, or it is a value of a function that is.
fn is_shown(value: &str, names: &BTreeSet<String>) -> bool {
    let function = value
        .split_once('(')
        .map(|(function, _)| format!("{function}("));
    names.contains(value) || function.is_some_and(|function| names.contains(&function))
}

fn disagreement(span: &Span) -> Diagnostic {
    let message = "the two routes to a verdict disagree";
    Diagnostic::new(DiagnosticKind::Disagreement, span.clone(), message)
        .with_label("equal in normal form, different at a point")
        .with_help("this is a mistake of sextic, not of the document: please report it")
}
