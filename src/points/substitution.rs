//! Replacements of variables in nodes.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::graph::{FunctionId, Made, Node, NodeId, VariableId};
use super::sheet::Sheet;
use super::{Failure, Unknown};

/// What replaces what, all at once.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    /// Variables.
    pub variables: BTreeMap<VariableId, NodeId>,
    /// Values f⁽ᵏ⁾(a) of functions.
    pub functions: Vec<((FunctionId, u32, NodeId), NodeId)>,
    known: FxHashMap<NodeId, NodeId>,
    circles: BTreeMap<VariableId, (NodeId, NodeId)>,
}

impl Substitution {
    /// A node with the replacements written in.
    ///
    /// # Errors
    ///
    /// [`Failure`] where what comes out has no value anywhere, or cannot be followed.
    pub fn of(&mut self, root: NodeId, sheet: &mut Sheet) -> Made {
        for id in sheet.graph.unknown(root, |id| self.known.contains_key(&id)) {
            let image = self.rule(id, sheet);
            let image = image.map_err(|failure| sheet.graph.failure_within(root, failure))?;
            self.known.insert(id, image);
        }
        Ok(self.known[&root])
    }

    fn rule(&mut self, id: NodeId, sheet: &mut Sheet) -> Made {
        let node = sheet.graph.node(id).clone();
        let of = |part: &NodeId| self.known.get(part).copied().ok_or(Unknown::Unsupported);
        match &node {
            Node::Number(_) | Node::ImaginaryUnit => Ok(id),
            Node::Variable(variable) => Ok(self.variables.get(variable).copied().unwrap_or(id)),
            Node::Cosine(variable) | Node::Sine(variable) => {
                let Some((cosine, sine)) = self.circle(*variable, sheet)? else {
                    return Ok(id);
                };
                Ok(match node {
                    Node::Cosine(_) => cosine,
                    _ => sine,
                })
            }
            Node::Sum(a, b) => sheet.graph.sum(of(a)?, of(b)?),
            Node::Product(a, b) => sheet.graph.product(of(a)?, of(b)?),
            Node::Quotient(a, b) => sheet.graph.quotient(of(a)?, of(b)?),
            Node::Power(a, exponent) => sheet.graph.power(of(a)?, i64::from(*exponent)),
            Node::Root(a) => sheet.graph.root(of(a)?),
            Node::Direction { x, y, .. } => match (of(x)?, of(y)?) {
                (a, b) if (a, b) == (*x, *y) => Ok(id),
                (a, b) => sheet.direction(a, b),
            },
            Node::Function {
                function,
                order,
                argument,
                reference,
            } => {
                let image = of(argument)?;
                for ((replaced, k, place), value) in &self.functions {
                    if (replaced, k) == (function, order) && sheet.is_same(*argument, *place)? {
                        return Ok(*value);
                    }
                }
                sheet.graph.function(*function, *order, image, *reference)
            }
            Node::Guarded { value, needed } => {
                let (value, needed) = (of(value)?, of(needed)?);
                sheet.graph.guarded(value, needed)
            }
            Node::Detour(value) => sheet.graph.by_detour(of(value)?),
        }
    }

    /// The cosine and sine of what replaces a variable.
    fn circle(
        &mut self,
        variable: VariableId,
        sheet: &mut Sheet,
    ) -> Result<Option<(NodeId, NodeId)>, Failure> {
        let Some(image) = self.variables.get(&variable).copied() else {
            return Ok(None);
        };
        if let Some(known) = self.circles.get(&variable) {
            return Ok(Some(*known));
        }
        let circle = sheet.cosine_and_sine(image)?;
        self.circles.insert(variable, circle);
        Ok(Some(circle))
    }
}
