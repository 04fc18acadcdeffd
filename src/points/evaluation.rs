//! A graph at an assignment.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;

use super::assignment::{Assigned, Assignment};
use super::describe::describe;
use super::enclosure::Enclosure;
use super::graph::{Graph, Node, NodeId, Variable};
use super::number::Number;
use super::real::{Real, Reals};
use super::{Failure, NoValue, Unknown};

/// How many values are kept at most before they are forgotten.
const MOST_VALUES: usize = 50_000;

/// What a series of many terms costs, in operations.
const PRICE_OF_A_SERIES: usize = 300;

/// The values of the nodes of a graph at an assignment.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// What is free.
    pub assignment: Assignment,
    reals: Reals,
    known: Vec<Option<Box<Result<Number, Failure>>>>,
    count: usize,
    /// How many operations may still be done.
    pub steps: usize,
}

impl Evaluation {
    /// An evaluation that knows no values yet.
    pub fn new(assignment: Assignment, reals: Reals) -> Self {
        Evaluation {
            assignment,
            reals,
            known: Vec::new(),
            count: 0,
            steps: usize::MAX,
        }
    }

    /// Forgets values where there are many.
    pub fn forget_many(&mut self) {
        if self.count > MOST_VALUES {
            self.forget();
        }
    }

    /// Forgets all values.
    pub fn forget(&mut self) {
        self.known = Vec::new();
        self.count = 0;
    }

    /// The value of a node.
    ///
    /// # Errors
    ///
    /// [`Failure`] where it has none at this assignment, or where that cannot be told.
    pub fn value(&mut self, graph: &Graph, id: NodeId) -> Result<Number, Failure> {
        self.known.resize(graph.size().max(self.known.len()), None);
        for part in graph.unknown_values(id, |part| self.known[Graph::place(part)].is_some()) {
            let value = self.compute(graph, part).and_then(moderate);
            let price = price(graph.node(part), &value);
            self.steps = self.steps.checked_sub(price).ok_or(Unknown::TooLarge)?;
            self.known[Graph::place(part)] = Some(Box::new(value));
            self.count += 1;
        }
        self.of(id).cloned()
    }

    /// How two numbers compare; nothing where they are not real, or where that is not known.
    pub fn compared(&self, a: &Number, b: &Number) -> Option<Ordering> {
        let (a, b) = (a.as_real()?, b.as_real()?);
        self.reals.sum(a, &self.reals.negative(b)).sign()
    }

    /// The value of a node that is known.
    fn of(&self, id: NodeId) -> Result<&Number, Failure> {
        match self.known[Graph::place(id)].as_deref() {
            Some(Ok(value)) => Ok(value),
            Some(Err(failure)) => Err(*failure),
            None => Err(Unknown::Unsupported.into()),
        }
    }

    /// The real value of a node that is known.
    fn real(&self, id: NodeId) -> Result<&Real, Failure> {
        let number = self.of(id)?;
        number.as_real().ok_or_else(|| number.not_real())
    }

    fn compute(&mut self, graph: &Graph, id: NodeId) -> Result<Number, Failure> {
        let reals = self.reals;
        match graph.node(id) {
            Node::Number(number) => Ok(reals.shortened(number.clone()).into()),
            Node::ImaginaryUnit => Ok(Number::new(Rational::ZERO.into(), Rational::ONE.into())),
            Node::Variable(id) => self.variable(graph.variable(*id)),
            Node::Cosine(id) => Ok(self.assignment.circle(graph.variable(*id))?.0.into()),
            Node::Sine(id) => Ok(self.assignment.circle(graph.variable(*id))?.1.into()),
            Node::Sum(a, b) => Ok(reals.total(self.of(*a)?, self.of(*b)?)),
            Node::Product(a, b) => Ok(reals.times(self.of(*a)?, self.of(*b)?)),
            Node::Quotient(a, b) => {
                let below = self.of(*b)?;
                let inverse = reals.inverse(below).ok_or(match below.is_zero() {
                    true => Failure::from(NoValue::DivisionByZero),
                    false => Failure::from(Unknown::Sign),
                })?;
                Ok(reals.times(self.of(*a)?, &inverse))
            }
            Node::Power(a, exponent) => Ok(reals.raised(self.of(*a)?, *exponent)),
            Node::Root(a) => {
                let square = self.real(*a)?;
                let root = reals.square_root(square).ok_or(match square.sign() {
                    Some(_) => Failure::from(NoValue::NegativeRadicand),
                    None => Failure::from(Unknown::Sign),
                })?;
                Ok(root.into())
            }
            Node::Direction { x, y, parallel } => self.direction(*x, *y, *parallel),
            Node::Function { .. } => self.function(graph, id),
            Node::Guarded { value, needed } => {
                self.of(*needed)?;
                self.of(*value).cloned()
            }
            Node::Detour(value) => self.of(*value).cloned().map_err(Failure::of_detour),
        }
    }

    /// The value of a variable. That it has a sign that the variable admits is not left to those who draw it.
    fn variable(&self, variable: &Variable) -> Result<Number, Failure> {
        let (value, signs) = (self.assignment.value(variable)?, variable.signs);
        let is_admitted = signs == Signs::ANY
            || match value.as_real().and_then(Real::sign) {
                Some(Ordering::Less) => signs.negative,
                Some(Ordering::Equal) => signs.zero,
                Some(Ordering::Greater) => signs.positive,
                None => false,
            };
        is_admitted
            .then_some(value)
            .ok_or(Unknown::NoAssignment.into())
    }

    /// The angle of a vector.
    fn direction(
        &self,
        x: NodeId,
        y: NodeId,
        parallel: Option<[NodeId; 3]>,
    ) -> Result<Number, Failure> {
        let (x, y) = (self.real(x)?, self.real(y)?);
        if x.is_zero() && y.is_zero() {
            return Err(NoValue::ZeroVector.into());
        }
        if let Some([angle, cosine, sine]) = parallel {
            let (cosine, sine) = (self.real(cosine)?, self.real(sine)?);
            let product = |a: &Real, b: &Real| self.reals.product(a, b);
            let along = self.reals.sum(&product(x, cosine), &product(y, sine));
            if along.sign().ok_or(Unknown::Sign)?.is_gt() {
                return self.of(angle).cloned();
            }
        }
        if y.is_zero() && x.sign().is_some_and(|sign| sign.is_gt()) {
            return Ok(Real::Exact(Rational::ZERO).into());
        }
        let angle = Enclosure::direction(&x.enclosure(), &y.enclosure());
        let angle = angle.ok_or(Unknown::Sign)?;
        Ok(Real::Enclosed(angle).into())
    }

    fn function(&mut self, graph: &Graph, id: NodeId) -> Result<Number, Failure> {
        let Node::Function {
            function,
            order,
            argument,
            reference,
        } = graph.node(id)
        else {
            return Err(Unknown::Unsupported.into());
        };
        let value = self.real(*argument)?.clone();
        let bare = self.real(*reference).ok().cloned();
        let label = || match bare.is_some_and(|bare| bare.may_be(&value)) {
            true => None,
            false => Some(describe(graph, *argument).unwrap_or(value.display())),
        };
        let name = (*function, graph.function_name(*function));
        let value = self.assignment.function(name, *order, &value, label)?;
        Ok(value.into())
    }

    /// What the assignment gives the variables and functions that some nodes rest on.
    pub fn shown(&mut self, graph: &Graph, roots: &[NodeId]) -> Vec<Assigned> {
        let mut shown = BTreeMap::new();
        for id in graph.within(roots) {
            let found = match graph.node(id) {
                Node::Variable(id) | Node::Cosine(id) | Node::Sine(id) => {
                    self.assignment.shown(graph.variable(*id))
                }
                Node::Function {
                    function,
                    order,
                    argument,
                    ..
                } => {
                    let name = (*function, graph.function_name(*function));
                    let argument = self.value(graph, *argument).ok();
                    let argument = argument.and_then(|argument| argument.as_real().cloned());
                    let of = |argument| self.assignment.shown_function(name, *order, &argument);
                    argument.and_then(of).into_iter().collect()
                }
                _ => Vec::new(),
            };
            shown.extend(found.into_iter().map(|one| (one.name.clone(), one)));
        }
        shown.into_values().collect()
    }
}

/// What the value of a node costs, in operations on numbers of one word.
fn price(node: &Node, value: &Result<Number, Failure>) -> usize {
    let words = value.as_ref().map_or(0, Number::words);
    match node {
        Node::Direction { .. } | Node::Cosine(_) | Node::Sine(_) => PRICE_OF_A_SERIES,
        // Fractions are reduced in about so many steps.
        _ => 1 + words * words / 8,
    }
}

/// The number, if it is neither too large nor too small to be worked with.
fn moderate(number: Number) -> Result<Number, Failure> {
    let is_extreme = |part: &Real| match part {
        Real::Enclosed(enclosure) => enclosure.is_extreme(),
        Real::Exact(_) => false,
    };
    match is_extreme(&number.real) || number.imaginary.as_ref().is_some_and(is_extreme) {
        true => Err(Unknown::TooLarge.into()),
        false => Ok(number),
    }
}
