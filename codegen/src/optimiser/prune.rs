//! Values that no output needs.

use crate::program::{Node, Operation, Program};

/// Leaves out what no output needs; the inputs stay.
#[must_use]
pub fn prune(program: &Program) -> Program {
    let mut needed = vec![false; program.operations().len()];
    for (_, node) in program.outputs() {
        needed[node.index()] = true;
    }
    for (node, operation) in program.nodes().collect::<Vec<_>>().into_iter().rev() {
        if needed[node.index()] {
            for operand in operation.operands() {
                needed[operand.index()] = true;
            }
        }
    }
    let mut kept = Program::new(program.inputs().iter().cloned());
    let mut images: Vec<Option<Node>> = Vec::with_capacity(needed.len());
    for (node, operation) in program.nodes() {
        images.push(match operation {
            Operation::Input(place) => kept.input(&program.inputs()[*place as usize]),
            _ if !needed[node.index()] => None,
            _ => {
                let moved = operation.map(|operand| images[operand.index()].unwrap_or(operand));
                Some(kept.push(moved))
            }
        });
    }
    for (name, node) in program.outputs() {
        if let Some(image) = images[node.index()] {
            kept.output(name.clone(), image);
        }
    }
    kept
}
