//! Nodes of a graph as a person reads them.

use crate::language::notation::Notation;
use crate::language::syntax::{BinaryOperator, Expression, Name};

use super::graph::{Graph, Node, NodeId};

/// The most operations that are shown.
const MOST_OPERATIONS: usize = 12;

/// A node in ASCII; nothing where that is long, or has no short form.
pub fn describe(graph: &Graph, id: NodeId) -> Option<String> {
    let mut left = MOST_OPERATIONS;
    let expression = expression(graph, id, &mut left)?;
    Some(Notation::Ascii.expression(&expression))
}

fn expression(graph: &Graph, id: NodeId, left: &mut usize) -> Option<Expression> {
    *left = left.checked_sub(1)?;
    let mut binary = |operator, a: &NodeId, b: &NodeId| {
        let a = expression(graph, *a, left)?;
        let b = expression(graph, *b, left)?;
        Some(Expression::binary(operator, a, b))
    };
    match graph.node(id) {
        Node::Number(number) => Some(Expression::number(number.clone())),
        Node::Variable(id) => {
            let variable = graph.variable(*id);
            let name = Expression::name(Name::new(&variable.name));
            let rate = |inner| Expression::call(Name::new("dt"), 0, vec![inner]);
            Some((0..variable.order).fold(name, |inner, _| rate(inner)))
        }
        Node::Sum(a, b) => binary(BinaryOperator::Add, a, b),
        Node::Product(a, b) => binary(BinaryOperator::Multiply, a, b),
        Node::Quotient(a, b) => binary(BinaryOperator::Divide, a, b),
        _ => None,
    }
}
