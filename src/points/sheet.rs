//! A graph, and assignments at which it is seen which nodes are equal everywhere.

use crate::algebra::number::Rational;

use super::Failure;
use super::evaluation::Evaluation;
use super::graph::{Graph, Made, NodeId};
use super::number::Number;

/// At how many assignments polynomials and quotients are compared.
const FEW: usize = 2;

/// At how many assignments nodes are compared that depend on signs.
const MANY: usize = 8;

/// How many binary digits an identity is checked to.
const DIGITS: i64 = 100;

/// A graph that can tell which of its nodes are equal under every assignment.
///
/// Two nodes are taken for equal where they are at several assignments with large random numbers, to a
/// hundred binary digits. A coincidence at an assignment that is looked at later is none of these.
#[derive(Debug)]
pub struct Sheet {
    /// The graph.
    pub graph: Graph,
    /// Evaluations at large random numbers that satisfy what is assumed.
    pub generic: Vec<Evaluation>,
}

impl Sheet {
    /// Whether a node is 0 under every assignment at which it has a value.
    ///
    /// # Errors
    ///
    /// [`Failure::UnknownIdentity`] where it has a value at none of the assignments.
    pub fn vanishes(&mut self, id: NodeId) -> Result<bool, Failure> {
        if let Some(number) = self.graph.as_number(id) {
            return Ok(number.is_zero());
        }
        let wanted = if self.graph.is_branched(id) {
            MANY
        } else {
            FEW
        };
        let mut seen = 0;
        for evaluation in &mut self.generic {
            let Ok(value) = evaluation.value(&self.graph, id) else {
                continue;
            };
            if value.differs_from_zero() {
                return Ok(false);
            }
            seen += usize::from(value.is_exact() || value.is_narrow(&value, DIGITS));
            if seen == wanted {
                break;
            }
        }
        match seen {
            0 => Err(Failure::UnknownIdentity),
            _ => Ok(true),
        }
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
