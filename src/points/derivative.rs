//! Derivatives of nodes.

use rustc_hash::FxHashMap;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;

use super::Unknown;
use super::graph::{FunctionId, Made, Node, NodeId, Variable, VariableId};
use super::sheet::Sheet;

/// What a node is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Time.
    Time,
    /// A variable.
    Variable(VariableId),
    /// f⁽ᵏ⁾ at an argument.
    Function(FunctionId, u32, NodeId),
}

/// Derivatives by one variable, each found once.
#[derive(Debug)]
pub struct Derivative {
    by: By,
    known: FxHashMap<NodeId, NodeId>,
}

impl Derivative {
    /// No derivative yet.
    pub fn new(by: By) -> Self {
        Derivative {
            by,
            known: FxHashMap::default(),
        }
    }

    /// The derivative of a node, which exists where the node does.
    ///
    /// # Errors
    ///
    /// [`Unknown::TooLarge`], and those of [`Sheet::is_same`].
    pub fn of(&mut self, root: NodeId, sheet: &mut Sheet) -> Made {
        for id in sheet.graph.unknown(root, |id| self.known.contains_key(&id)) {
            let derivative = self.rule(id, sheet)?;
            self.known.insert(id, derivative);
        }
        sheet.graph.guarded(self.known[&root], root)
    }

    /// The derivative of a node by those of what it rests on.
    fn rule(&self, id: NodeId, sheet: &mut Sheet) -> Made {
        let of = |part: &NodeId| self.known.get(part).copied().ok_or(Unknown::Unsupported);
        let node = sheet.graph.node(id).clone();
        match &node {
            Node::Number(_) | Node::ImaginaryUnit => sheet.graph.integer(0),
            Node::Variable(variable) => self.of_variable(*variable, sheet),
            Node::Cosine(variable) => {
                let turn = self.of_variable(*variable, sheet)?;
                let sine = sheet.graph.sine(*variable)?;
                let minus = sheet.graph.negative(sine)?;
                sheet.graph.product(minus, turn)
            }
            Node::Sine(variable) => {
                let turn = self.of_variable(*variable, sheet)?;
                let cosine = sheet.graph.cosine(*variable)?;
                sheet.graph.product(cosine, turn)
            }
            Node::Sum(a, b) => sheet.graph.sum(of(a)?, of(b)?),
            Node::Product(a, b) => {
                let left = sheet.slope(of(a)?, *b)?;
                let right = sheet.slope(of(b)?, *a)?;
                sheet.graph.sum(left, right)
            }
            Node::Quotient(a, b) => {
                // a′/b − (a/b)·(b′/b)
                let (change, below) = (of(a)?, of(b)?);
                let first = match sheet.graph.is_zero(change) {
                    true => change,
                    false => sheet.graph.quotient(change, *b)?,
                };
                if sheet.graph.is_zero(below) {
                    return Ok(first);
                }
                let relative = sheet.graph.quotient(below, *b)?;
                let second = sheet.graph.product(id, relative)?;
                sheet.graph.difference(first, second)
            }
            Node::Power(a, exponent) => {
                let power = sheet.graph.power(*a, i64::from(*exponent) - 1)?;
                let slope = sheet.graph.scaled(power, Rational::from(*exponent))?;
                sheet.slope(of(a)?, slope)
            }
            Node::Root(a) => {
                let change = of(a)?;
                // A root that does not move has a slope where it is 0, too.
                if sheet.surely_vanishes(change) {
                    return sheet.graph.integer(0);
                }
                let twice = sheet.graph.scaled(id, Rational::from(2))?;
                sheet.graph.quotient(change, twice)
            }
            Node::Direction { x, y, .. } => sheet.turning(*x, *y, of(x)?, of(y)?),
            Node::Function {
                function,
                order,
                argument,
                reference,
            } => {
                if let By::Function(by, k, place) = self.by
                    && (by, k) == (*function, *order)
                    && sheet.is_same(*argument, place)?
                {
                    return sheet.graph.integer(1);
                }
                let change = of(argument)?;
                let slope = sheet
                    .graph
                    .function(*function, order + 1, *argument, *reference)?;
                sheet.slope(change, slope)
            }
            Node::Guarded { value, needed } => {
                let change = of(value)?;
                sheet.graph.guarded(change, *needed)
            }
            Node::Detour(value) => sheet.graph.by_detour(of(value)?),
        }
    }

    fn of_variable(&self, id: VariableId, sheet: &mut Sheet) -> Made {
        match self.by {
            By::Variable(by) => sheet.graph.integer(i64::from(by == id)),
            By::Time if sheet.graph.variable(id).is_moving() => {
                let variable = sheet.graph.variable(id).clone();
                let order = variable.order + 1;
                let rate = sheet.graph.variable_id(Variable {
                    order,
                    signs: Signs::ANY,
                    ..variable
                });
                sheet.graph.free(rate)
            }
            _ => sheet.graph.integer(0),
        }
    }
}

impl Sheet {
    /// a′·b, which is 0 where a does not change.
    fn slope(&mut self, change: NodeId, slope: NodeId) -> Made {
        match self.graph.is_zero(change) {
            true => Ok(change),
            false => self.graph.product(change, slope),
        }
    }

    /// (x dy − y dx)/(x² + y²)
    pub fn turning(&mut self, x: NodeId, y: NodeId, dx: NodeId, dy: NodeId) -> Made {
        let (one, other) = (self.slope(dy, x)?, self.slope(dx, y)?);
        let across = self.graph.difference(one, other)?;
        if self.graph.is_zero(across) {
            return Ok(across);
        }
        let square = self.square_of_length(x, y)?;
        self.graph.quotient(across, square)
    }

    /// x² + y²
    pub fn square_of_length(&mut self, x: NodeId, y: NodeId) -> Made {
        let (x, y) = (self.graph.power(x, 2)?, self.graph.power(y, 2)?);
        self.graph.sum(x, y)
    }
}
