//! Both sides of an assertion, and its conditions, as nodes.

use std::cmp::Ordering;

use crate::derivation::assertion::{Finding, Outcome};
use crate::derivation::condition::Requirement;
use crate::language::syntax::{Comparison, Order};
use crate::points::evaluation::Evaluation;
use crate::points::graph::{Graph, NodeId};
use crate::points::number::Number;
use crate::points::unfolding::Unfolding;
use crate::points::{Failure, Sheet, Table, Unknown};

/// How many binary digits of two sides must agree.
pub const DIGITS: i64 = 64;

/// What two sides are at an assignment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// They stand in the relation, as far as is known.
    Agrees,
    /// They certainly do not, or one of them has no value.
    Contradicts,
    /// A condition is not met, or not known to be.
    OutsideOfConditions,
}

/// Both sides of an assertion: as they are, or the parts of each degree of an approximation.
pub struct Sides {
    /// Left and right, by degree.
    pub pairs: Vec<(Table, Table)>,
    /// Of an approximation, the degree behind its order at which the sides differ.
    pub beyond: Option<usize>,
    conditions: Vec<(Requirement, NodeId)>,
}

/// Where two sides differ.
pub struct Difference {
    /// The row and column of the entry, counted from 0.
    pub place: (usize, usize),
    /// Both entries.
    pub entries: [Number; 2],
}

impl Sides {
    /// The sides of an assertion; those of an approximation to the degree that is asked about.
    pub fn of<'a>(finding: &'a Finding, unfolding: &mut Unfolding<'a>) -> Result<Self, Failure> {
        let relation = &finding.assertion.relation;
        let beyond = match finding.outcome {
            Outcome::TrueToOrder(beyond) => beyond.map(|degree| degree as usize),
            _ => None,
        };
        // What is equal to every order is compared as it is.
        let order = finding.assertion.order.as_ref();
        let order = order.filter(|_| finding.outcome != Outcome::True);
        let pairs: Vec<(Table, Table)> = match order {
            Some(order) => {
                let small = small_names(order);
                let highest = beyond.unwrap_or(0).max(order.order.value as usize) as u32;
                let left = unfolding.parts(&relation.left, &small, highest)?;
                let right = unfolding.parts(&relation.right, &small, highest)?;
                left.into_iter().zip(right).collect()
            }
            None => vec![(
                unfolding.table(&relation.left)?,
                unfolding.table(&relation.right)?,
            )],
        };
        if pairs
            .iter()
            .any(|(left, right)| left.shape() != right.shape())
        {
            return Err(Unknown::Shape.into());
        }
        let mut conditions = Vec::new();
        for condition in &finding.conditions {
            let node = match order {
                None => unfolding.scalar(&condition.expression)?,
                Some(order) => {
                    let parts = unfolding.parts(&condition.expression, &small_names(order), 0)?;
                    let part = parts.first().and_then(Table::as_single);
                    part.ok_or(Unknown::Shape)?
                }
            };
            conditions.push((condition.requirement, node));
        }
        Ok(Sides {
            pairs,
            beyond,
            conditions,
        })
    }

    /// The nodes of the sides of a degree, of both.
    pub fn nodes(&self, degree: usize) -> Vec<NodeId> {
        let (left, right) = &self.pairs[degree];
        [left.entries(), right.entries()].concat()
    }

    /// Whether the sides are seen to be equal without a look at assignments, up to the order of an
    /// approximation.
    pub fn are_surely_same(&self, sheet: &mut Sheet) -> bool {
        let mut pairs = self.compared().iter();
        pairs.all(|(left, right)| {
            let mut entries = left.entries().iter().zip(right.entries());
            entries.all(|(a, b)| sheet.is_surely_same(*a, *b))
        })
    }

    /// Whether both sides have values under every assignment.
    pub fn are_total(&self, graph: &Graph) -> bool {
        let mut pairs = self.compared().iter();
        pairs.all(|(left, right)| {
            let mut entries = left.entries().iter().chain(right.entries());
            entries.all(|entry| graph.is_total(*entry))
        })
    }

    /// The sides, or their parts up to the order of an approximation.
    fn compared(&self) -> &[(Table, Table)] {
        &self.pairs[..self.beyond.unwrap_or(self.pairs.len())]
    }

    /// Whether the sides stand in their relation at an assignment, up to the order of an approximation.
    ///
    /// # Errors
    ///
    /// [`Unknown`] where a side is not known, or not well enough.
    pub fn at(
        &self,
        evaluation: &mut Evaluation,
        graph: &Graph,
        comparison: Comparison,
    ) -> Result<Agreement, Unknown> {
        if !self.meets_conditions(evaluation, graph) {
            return Ok(Agreement::OutsideOfConditions);
        }
        for degree in 0..self.compared().len() {
            match self.difference(degree, evaluation, graph, comparison, true) {
                Ok(None) => {}
                Ok(Some(_)) | Err(Failure::NoValue(_)) => return Ok(Agreement::Contradicts),
                Err(Failure::Unknown(why)) => return Err(why),
            }
        }
        Ok(Agreement::Agrees)
    }

    /// Whether both sides have values at an assignment.
    ///
    /// # Errors
    ///
    /// [`Unknown`] where that is not known.
    pub fn exist_at(
        &self,
        evaluation: &mut Evaluation,
        graph: &Graph,
    ) -> Result<Agreement, Unknown> {
        if !self.meets_conditions(evaluation, graph) {
            return Ok(Agreement::OutsideOfConditions);
        }
        let sides = self.compared().iter().flat_map(|(a, b)| [a, b]);
        let entries = sides.flat_map(Table::entries);
        for entry in entries.filter(|entry| !graph.is_total(**entry)) {
            match evaluation.value(graph, *entry) {
                Ok(_) => {}
                Err(Failure::NoValue(_)) => return Ok(Agreement::Contradicts),
                Err(Failure::Unknown(why)) => return Err(why),
            }
        }
        Ok(Agreement::Agrees)
    }

    /// Whether all conditions are known to be met.
    pub fn meets_conditions(&self, evaluation: &mut Evaluation, graph: &Graph) -> bool {
        let mut conditions = self.conditions.iter();
        conditions.all(|(requirement, node)| {
            let Ok(value) = evaluation.value(graph, *node) else {
                return false;
            };
            match requirement {
                Requirement::NonZero => value.differs_from_zero(),
                Requirement::Positive => {
                    let sign = value.as_real().and_then(|real| real.sign());
                    sign == Some(Ordering::Greater)
                }
            }
        })
    }

    /// The first entry at which the sides certainly do not stand in the relation.
    ///
    /// # Errors
    ///
    /// [`Failure`] where a side has no value, or is not known well enough if all entries must be.
    pub fn difference(
        &self,
        degree: usize,
        evaluation: &mut Evaluation,
        graph: &Graph,
        comparison: Comparison,
        must_be_known: bool,
    ) -> Result<Option<Difference>, Failure> {
        let (left, right) = &self.pairs[degree];
        let mut found = None;
        let entries = left.entries().iter().zip(right.entries());
        for (place, (a, b)) in entries.enumerate() {
            let entries = [evaluation.value(graph, *a)?, evaluation.value(graph, *b)?];
            let stands = stand(evaluation, &entries, comparison, must_be_known)?;
            if !stands && found.is_none() {
                let place = left.position(place);
                found = Some(Difference { place, entries });
            }
        }
        Ok(found)
    }
}

/// Whether two numbers stand in a relation, as far as is known.
fn stand(
    evaluation: &Evaluation,
    [a, b]: &[Number; 2],
    comparison: Comparison,
    must_be_known: bool,
) -> Result<bool, Failure> {
    if comparison == Comparison::Equal {
        let is_narrow = || a.is_narrow(a, DIGITS) && b.is_narrow(b, DIGITS);
        return match a.may_be(b) {
            true if must_be_known && !is_narrow() => Err(Unknown::Sign.into()),
            may_be => Ok(may_be),
        };
    }
    for side in [a, b] {
        if side.as_real().is_none() {
            return Err(side.not_real());
        }
    }
    match evaluation.compared(a, b) {
        Some(order) => Ok(comparison.holds(order)),
        None => Err(Unknown::Sign.into()),
    }
}

/// The ASCII names of small quantities.
fn small_names(order: &Order) -> Vec<&str> {
    let names = order.small.iter();
    names.map(|name| name.value.ascii.as_str()).collect()
}
