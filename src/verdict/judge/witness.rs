//! Assignments under which the sides of an assertion differ.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::derivation::assertion::{Finding, Outcome};
use crate::derivation::scope::Scope;
use crate::points::evaluation::Evaluation;
use crate::points::graph::{Graph, NodeId};
use crate::points::number::Number;
use crate::points::{Failure, Search, Unknown, measured};
use crate::verdict::claim::{Coordinate, Witness};

use super::coordinate::coordinate;
use super::sides::{Difference, Sides};

/// How many assignments are looked at for a counterexample.
const MOST_POINTS: usize = 160;

/// How many more once one with sides is found that are not fractions.
const MOST_POINTS_AFTER: usize = 64;

/// Why no assignment shows that the sides of an assertion differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fruitless {
    /// No assignment satisfies the assumptions.
    NoPoint,
    /// A side has no value at any of them that is known; the reason at the last of them.
    NoValue(Failure),
    /// The sides differ where the conditions of the assertion are not met only.
    NoConditions,
    /// They stand in the relation at every assignment.
    Agreed,
}

/// Simple assignments, made when they are first asked for.
pub struct Candidates<'a> {
    scope: &'a Scope,
    search: Search,
    /// By the angles whose measure is a fraction.
    found: BTreeMap<BTreeSet<String>, Vec<Option<Evaluation>>>,
    /// How many operations they may still take for the assertion.
    pub steps: usize,
}

impl<'a> Candidates<'a> {
    /// None yet.
    pub fn new(search: Search, scope: &'a Scope) -> Self {
        Candidates {
            scope,
            search,
            found: BTreeMap::new(),
            steps: 0,
        }
    }

    /// The first assignment at which the sides of what may be refuted differ, one with sides that are
    /// fractions if there is one not much later.
    pub fn witness(
        &mut self,
        sides: &Sides,
        finding: &Finding,
        graph: &Graph,
    ) -> Result<Witness, Fruitless> {
        let degree = match finding.outcome {
            Outcome::Different(degree) => degree.map_or(0, |degree| degree as usize),
            _ => 0,
        };
        let (mut found, mut fruitless) = (None, Fruitless::NoPoint);
        let mut most = MOST_POINTS;
        let (mut steps, scope) = (self.steps, self.scope);
        let nodes = sides.nodes(degree);
        for place in 0..MOST_POINTS {
            if place >= most || steps == 0 {
                break;
            }
            let Some(evaluation) = self.at(place, &nodes, graph, &mut steps) else {
                continue;
            };
            evaluation.steps = steps;
            let tried = at_assignment(evaluation, sides, degree, finding, (graph, scope));
            steps = evaluation.steps;
            evaluation.forget();
            match tried {
                Ok((witness, is_exact)) if is_exact || found.is_none() => {
                    found = Some(witness);
                    most = if is_exact {
                        place
                    } else {
                        place + MOST_POINTS_AFTER
                    };
                }
                Ok(_) => {}
                Err(why) => fruitless = telling(fruitless, why),
            }
        }
        self.steps = steps;
        found.ok_or(fruitless)
    }

    /// Whether the sides of an approximation differ behind its order at some assignment.
    pub fn goes_beyond(&mut self, sides: &Sides, finding: &Finding, graph: &Graph) -> bool {
        let Some(degree) = sides.beyond else {
            return false;
        };
        let (nodes, scope) = (sides.nodes(degree), self.scope);
        let mut steps = self.steps;
        let mut places = 0..MOST_POINTS_AFTER;
        let found = places.any(|place| {
            let Some(evaluation) = self.at(place, &nodes, graph, &mut steps) else {
                return false;
            };
            evaluation.steps = steps;
            let tried = at_assignment(evaluation, sides, degree, finding, (graph, scope));
            steps = evaluation.steps;
            evaluation.forget();
            tried.is_ok()
        });
        self.steps = steps;
        found
    }

    /// An evaluation at one of the assignments, counted from 0, for some nodes: the angles whose measure
    /// they contain have a fraction for it.
    fn at(
        &mut self,
        place: usize,
        nodes: &[NodeId],
        graph: &Graph,
        steps: &mut usize,
    ) -> Option<&mut Evaluation> {
        let mut angles = measured(graph, nodes);
        angles.extend(self.search.measured.iter().cloned());
        let search = Search {
            measured: Arc::new(angles.clone()),
            ..self.search.clone()
        };
        let found = self.found.entry(angles).or_default();
        while found.len() <= place {
            found.push(search.find(graph, found.len() as u64, steps));
        }
        found.get_mut(place)?.as_mut()
    }
}

/// Which of two reasons tells more: one point that has a value outweighs those that have none.
fn telling(before: Fruitless, now: Fruitless) -> Fruitless {
    let weight = |why: &Fruitless| match why {
        Fruitless::NoPoint => 0,
        Fruitless::NoValue(_) => 1,
        Fruitless::NoConditions => 2,
        Fruitless::Agreed => 3,
    };
    match weight(&now) >= weight(&before) {
        true => now,
        false => before,
    }
}

/// Compares the sides of an assertion at an assignment that meets its conditions; a witness comes with
/// whether its sides are fractions.
fn at_assignment(
    evaluation: &mut Evaluation,
    sides: &Sides,
    degree: usize,
    finding: &Finding,
    (graph, scope): (&Graph, &Scope),
) -> Result<(Witness, bool), Fruitless> {
    let comparison = finding.assertion.relation.comparison;
    let difference = sides.difference(degree, evaluation, graph, comparison, false);
    let Some(Difference { place, entries }) = difference.map_err(Fruitless::NoValue)? else {
        return Err(Fruitless::Agreed);
    };
    if !sides.meets_conditions(evaluation, graph) {
        return Err(Fruitless::NoConditions);
    }
    // What is shown tells the sides apart.
    if !entries.iter().all(Number::is_legible) {
        return Err(Fruitless::NoValue(Unknown::Sign.into()));
    }
    let (left, _) = &sides.pairs[degree];
    let shown = evaluation.shown(graph, &sides.nodes(degree));
    let witness = Witness {
        point: shown
            .into_iter()
            .map(|one| Coordinate {
                name: coordinate(&one.name, scope),
                value: one.value,
                imaginary: one.imaginary,
            })
            .collect(),
        degree: finding.outcome.degree(),
        entry: left
            .as_single()
            .is_none()
            .then_some((place.0 + 1, place.1 + 1)),
        left: entries[0].display(),
        right: entries[1].display(),
    };
    Ok((witness, entries.iter().all(|entry| entry.is_exact())))
}
