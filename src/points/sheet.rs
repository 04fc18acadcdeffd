//! A graph, with what tells which of its nodes are equal everywhere.

use crate::algebra::number::Rational;

use super::evaluation::Evaluation;
use super::formal::Formal;
use super::graph::{Graph, Made, NodeId};
use super::number::Number;
use super::{Failure, Unknown};

/// Numbers that nobody can know who writes the text that they depend on: two for each modulus with which an
/// identity is checked.
pub type Salt = [[u64; 2]; 2];

/// At how many assignments values are compared.
const ENOUGH: usize = 2;

/// A graph that can tell which of its nodes are equal under every assignment.
///
/// A coincidence at an assignment is none of these identities.
#[derive(Debug)]
pub struct Sheet {
    /// The graph.
    pub graph: Graph,
    /// Values modulo large numbers, by which identities are recognised.
    formal: Vec<Formal>,
    /// Evaluations at large random numbers that satisfy what is assumed.
    pub generic: Vec<Evaluation>,
}

impl Sheet {
    /// A sheet with some evaluations.
    pub fn new(graph: Graph, generic: Vec<Evaluation>, salt: Salt) -> Self {
        Sheet {
            graph,
            formal: salt.map(Formal::new).into(),
            generic,
        }
    }

    /// Forgets the nodes from a place on, and the values of all.
    pub fn forget(&mut self, size: usize) {
        self.graph.truncate(size);
        self.formal
            .iter_mut()
            .for_each(|formal| formal.forget(size));
        self.generic.iter_mut().for_each(Evaluation::forget);
    }

    /// Whether a node is 0 under every assignment at which it has a value.
    ///
    /// # Errors
    ///
    /// [`Unknown::Identity`] where that cannot be told: roots and the angles of vectors may depend
    /// on each other.
    pub fn vanishes(&mut self, id: NodeId) -> Result<bool, Failure> {
        if let Some(number) = self.graph.as_number(id) {
            return Ok(number.is_zero());
        }
        match self.vanishes_formally(id) {
            None => return Err(Unknown::Identity.into()),
            Some(true) => return Ok(true),
            Some(false) if !self.graph.is_branched(id) => return Ok(false),
            Some(false) => {}
        }
        let graph = &self.graph;
        let values = self
            .generic
            .iter_mut()
            .map(|generic| generic.value(graph, id));
        let mut values = values.flatten();
        match values.any(|value| value.differs_from_zero()) {
            true => Ok(false),
            false => Err(Unknown::Identity.into()),
        }
    }

    /// Whether a node is 0 where roots and the angles of vectors are independent of what they are taken of;
    /// nothing where it has no value modulo some of the numbers.
    fn vanishes_formally(&mut self, id: NodeId) -> Option<bool> {
        let graph = &self.graph;
        let seen = self
            .formal
            .iter_mut()
            .map(|formal| formal.vanishes(graph, id));
        let seen: Option<Vec<bool>> = seen.collect();
        Some(seen?.into_iter().all(|vanishes| vanishes))
    }

    /// Whether a node is seen to be 0 without a look at assignments.
    pub fn surely_vanishes(&mut self, id: NodeId) -> bool {
        match self.graph.as_number(id) {
            Some(number) => number.is_zero(),
            None => self.vanishes_formally(id) == Some(true),
        }
    }

    /// Whether two nodes are seen to be equal without a look at assignments.
    pub fn is_surely_same(&mut self, a: NodeId, b: NodeId) -> bool {
        let difference = self.graph.difference(a, b);
        difference.is_ok_and(|difference| self.surely_vanishes(difference))
    }

    /// Whether two nodes are equal under every assignment at which both have values.
    ///
    /// # Errors
    ///
    /// Those of [`Sheet::vanishes`].
    pub fn is_same(&mut self, a: NodeId, b: NodeId) -> Result<bool, Failure> {
        if a == b {
            return Ok(true);
        }
        let difference = self.graph.difference(a, b)?;
        self.vanishes(difference)
    }

    /// Whether two nodes agree: they are equal, or have values that may be equal, to so many binary digits,
    /// at some assignments.
    ///
    /// # Errors
    ///
    /// [`Failure`] where they have values at none of them.
    pub fn agree(&mut self, a: NodeId, b: NodeId, digits: i64) -> Result<bool, Failure> {
        if self.is_surely_same(a, b) {
            return Ok(true);
        }
        let (mut seen, mut why) = (0, Failure::from(Unknown::Sign));
        for evaluation in &mut self.generic {
            let value = |id| evaluation.value(&self.graph, id);
            match [a, b].map(value) {
                [Ok(a), Ok(b)] if !a.may_be(&b) => return Ok(false),
                [Ok(a), Ok(b)] if a.is_narrow(&a, digits) && b.is_narrow(&b, digits) => seen += 1,
                [Err(failure), _] | [_, Err(failure)] => why = failure,
                _ => {}
            }
            if seen == ENOUGH {
                break;
            }
        }
        match seen {
            0 => Err(why),
            _ => Ok(true),
        }
    }

    /// The value of a node at the first assignment at which it has one.
    pub fn sample(&mut self, id: NodeId) -> Option<Number> {
        let graph = &self.graph;
        let mut values = self
            .generic
            .iter_mut()
            .map(|generic| generic.value(graph, id));
        values.find_map(Result::ok)
    }

    /// Σ aᵢ
    pub fn total(&mut self, terms: impl IntoIterator<Item = NodeId>) -> Made {
        let mut sum = self.graph.number(Rational::ZERO)?;
        for term in terms {
            sum = self.graph.sum(sum, term)?;
        }
        Ok(sum)
    }
}
