//! Partial evaluation.

use std::collections::BTreeMap;

use crate::program::{Node, Operation, Program, Rational};

/// The program with some inputs fixed; they are no inputs any more.
#[must_use]
pub fn specialise(program: &Program, fixed: &BTreeMap<String, Rational>) -> Program {
    let free = program
        .inputs()
        .iter()
        .filter(|name| !fixed.contains_key(*name));
    let mut special = Program::new(free.cloned());
    let mut images: Vec<Node> = Vec::with_capacity(program.operations().len());
    for (_, operation) in program.nodes() {
        let image = match operation {
            Operation::Input(place) => {
                let name = &program.inputs()[*place as usize];
                match (special.input(name), fixed.get(name)) {
                    (Some(input), _) => input,
                    (None, value) => special.constant(value.cloned().unwrap_or_default()),
                }
            }
            _ => {
                let moved = operation.map(|operand| images[operand.index()]);
                special.push(moved)
            }
        };
        images.push(image);
    }
    for (name, node) in program.outputs() {
        special.output(name.clone(), images[node.index()]);
    }
    super::optimise(&special)
}
