//! Common subexpressions.

use std::collections::BTreeMap;

use crate::program::{Node, Operation, Program};

/// Computes every value once: equal operations on equal values are one, whatever the order of the
/// operands of a sum or product.
#[must_use]
pub fn share(program: &Program) -> Program {
    let mut known: BTreeMap<Operation, Node> = BTreeMap::new();
    program.rebuild(|program, _, operation| {
        let operation = match operation {
            Operation::Add(a, b) if b < a => Operation::Add(b, a),
            Operation::Multiply(a, b) if b < a => Operation::Multiply(b, a),
            other => other,
        };
        *known
            .entry(operation)
            .or_insert_with_key(|operation| program.push(operation.clone()))
    })
}
