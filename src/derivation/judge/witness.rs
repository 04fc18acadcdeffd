//! Points at which the sides of an assertion differ.

use std::collections::BTreeSet;

use crate::derivation::assertion::{Finding, Outcome};
use crate::derivation::verdict::Witness;

use super::Judge;
use super::sides::{compare, first_difference, sides};

/// How many points are looked at for a counterexample.
const MOST_POINTS: usize = 160;

impl<'a> Judge<'a> {
    /// The first point at which the sides differ, one with rational sides if there is one.
    pub(super) fn witness(&mut self, finding: &'a Finding) -> Option<Witness> {
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
            let Ok(sides) = sides(evaluator, assertion, order) else {
                continue;
            };
            let side = match degree {
                Some(degree) => sides.into_iter().nth(degree as usize),
                None => sides.into_iter().next(),
            };
            let Some((left, right)) = side else { continue };
            let comparison = assertion.relation.comparison;
            if compare(&left, &right, comparison) != Some(false) {
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

/// Whether a point shows a value: its own name is wanted, or it is a value of a function that is.
fn is_shown(value: &str, names: &BTreeSet<String>) -> bool {
    let function = value
        .split_once('(')
        .map(|(function, _)| format!("{function}("));
    names.contains(value) || function.is_some_and(|function| names.contains(&function))
}
