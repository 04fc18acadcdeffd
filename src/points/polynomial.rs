//! The coefficients of polynomials, by series in the variable or in its inverse.

use rustc_hash::FxHashSet;

use super::derivative::By;
use super::graph::{Made, Node, NodeId};
use super::series::Expansion;
use super::sheet::Sheet;
use super::{Failure, Unknown};

/// The most terms of a polynomial.
const MOST_TERMS: usize = 40;

/// What a node is in a variable, as it is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Constant,
    Polynomial,
    Other,
}

impl Sheet {
    /// The coefficient of a power of a variable, as far as steps find it that it does not ask for.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoPolynomial`] where it is not found.
    pub fn coefficient(&mut self, node: NodeId, by: By, power: u32) -> Made {
        let found = match self.is_written_polynomial(node, by) {
            true => self.rising_coefficient(node, by, power),
            false => self.falling_coefficients(node, by).map(|falling| {
                let place = falling.len().checked_sub(power as usize + 1);
                place.map(|place| falling[place])
            }),
        };
        match found.map_err(Failure::of_detour)? {
            Some(found) => self.graph.by_detour(found),
            None => self.graph.integer(0),
        }
    }

    /// The coefficient of a power in what is written as a polynomial; nothing where it is 0.
    fn rising_coefficient(
        &mut self,
        node: NodeId,
        by: By,
        power: u32,
    ) -> Result<Option<NodeId>, Failure> {
        let mut expansion = Expansion::by_powers(by, 1, power as usize + 1, self)?;
        expansion.of(node, self)?.term(i64::from(power))
    }

    /// Whether a node is made of a variable by sums, products and powers, so that it is a polynomial in it.
    fn is_written_polynomial(&self, root: NodeId, by: By) -> bool {
        let mut moving = FxHashSet::default();
        self.graph.below(&[root]).into_iter().all(|id| {
            let role = self.role(self.graph.node(id), by, &moving);
            if role == Role::Polynomial {
                moving.insert(id);
            }
            role != Role::Other
        })
    }

    /// What a node is in a variable, if it is known which of its parts move with it.
    fn role(&self, node: &Node, by: By, moving: &FxHashSet<NodeId>) -> Role {
        let mut moves = false;
        node.visit(&mut |part| moves |= moving.contains(&part));
        match (node, by) {
            (Node::Variable(id), By::Variable(own)) if *id == own => Role::Polynomial,
            (Node::Cosine(id) | Node::Sine(id), By::Variable(own)) if *id == own => Role::Other,
            (
                Node::Function {
                    function,
                    order,
                    argument,
                    ..
                },
                By::Function(own, k, place),
            ) if (*function, *order) == (own, k) => match *argument == place && !moves {
                true => Role::Polynomial,
                false => Role::Other,
            },
            _ if !moves => Role::Constant,
            (Node::Quotient(_, below), _) if moving.contains(below) => Role::Other,
            (Node::Sum(..) | Node::Product(..) | Node::Quotient(..), _) => Role::Polynomial,
            (Node::Power(..) | Node::Guarded { .. } | Node::Detour(_), _) => Role::Polynomial,
            _ => Role::Other,
        }
    }

    /// The coefficients of a polynomial in a variable, that of the highest power first.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoPolynomial`] where it is not seen to be one, or its degree is too high.
    pub fn falling_coefficients(&mut self, node: NodeId, by: By) -> Result<Vec<NodeId>, Failure> {
        let mut length = 8;
        let coefficients = loop {
            match self.falling_terms(node, by, length) {
                Err(Failure::Unknown(Unknown::NoExpansion)) if length < MOST_TERMS => length *= 2,
                Err(Failure::Unknown(Unknown::NoExpansion)) => {
                    return Err(Unknown::NoPolynomial.into());
                }
                found => break found.map_err(Failure::of_detour)?,
            }
        };
        if !self.is_written_polynomial(node, by) {
            let variable = self.occurrence(by, node)?;
            let polynomial = self.polynomial(&coefficients, variable)?;
            if !self.is_same(polynomial, node)? {
                return Err(Unknown::NoPolynomial.into());
            }
        }
        let found = coefficients.into_iter();
        found.map(|one| self.graph.by_detour(one)).collect()
    }

    /// The terms of a node by falling powers of a variable, from its degree to that of the power 0.
    fn falling_terms(
        &mut self,
        node: NodeId,
        by: By,
        length: usize,
    ) -> Result<Vec<NodeId>, Failure> {
        let mut expansion = Expansion::by_powers(by, -1, length, self)?;
        let series = expansion.of(node, self)?;
        let Some(series) = expansion.leading(&series, self)? else {
            return Ok(Vec::new());
        };
        let zero = self.graph.integer(0)?;
        let powers = series.first..=0;
        powers
            .map(|power| Ok(series.term(power)?.unwrap_or(zero)))
            .collect()
    }

    /// The node of a variable, as it occurs in another one.
    fn occurrence(&mut self, by: By, node: NodeId) -> Made {
        match by {
            By::Variable(id) => self.graph.free(id),
            By::Function(own, k, place) => {
                let mut nodes = self.graph.below(&[node]).into_iter();
                let found = nodes.find(|id| match self.graph.node(*id) {
                    Node::Function {
                        function,
                        order,
                        argument,
                        ..
                    } => (*function, *order, *argument) == (own, k, place),
                    _ => false,
                });
                found.ok_or(Unknown::NoPolynomial.into())
            }
            By::Time => Err(Unknown::NoVariable.into()),
        }
    }

    /// Σ cₖ vⁿ⁻ᵏ
    fn polynomial(&mut self, falling: &[NodeId], variable: NodeId) -> Made {
        let mut sum = self.graph.integer(0)?;
        for coefficient in falling {
            let raised = self.graph.product(sum, variable)?;
            sum = self.graph.sum(raised, *coefficient)?;
        }
        Ok(sum)
    }
}
