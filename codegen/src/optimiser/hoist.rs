//! What does not depend on the inputs that are swept.

use std::collections::{BTreeMap, BTreeSet};

use crate::program::{Node, Operation, Program};

/// A program in two parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hoisted {
    /// What is computed once, from the inputs that stay.
    pub preparation: Program,
    /// What is computed at each point, from the swept inputs, the inputs that stay and the outputs of
    /// the preparation.
    pub sweep: Program,
}

/// Splits a program by the inputs that are swept: every value that does not depend on them and is used
/// by one that does becomes an output of the preparation, called `h_1`, `h_2`, ….
#[must_use]
pub fn hoist(program: &Program, swept: &BTreeSet<String>) -> Hoisted {
    let moves = moving(program, swept);
    let stays = |node: Node| !moves[node.index()];
    let mut wanted: BTreeSet<Node> = BTreeSet::new();
    for (node, operation) in program.nodes() {
        if moves[node.index()] {
            wanted.extend(operation.operands().filter(|operand| stays(*operand)));
        }
    }
    wanted.extend(
        program
            .outputs()
            .iter()
            .map(|(_, node)| *node)
            .filter(|node| stays(*node)),
    );
    let hoisted: Vec<Node> = wanted
        .into_iter()
        .filter(|node| !matches!(program.operation(*node), Operation::Constant(_)))
        .collect();

    let still = program
        .inputs()
        .iter()
        .filter(|name| !swept.contains(*name));
    let mut preparation = Program::new(still.cloned());
    let mut images: Vec<Option<Node>> = Vec::new();
    for (node, operation) in program.nodes() {
        images.push(match operation {
            _ if moves[node.index()] => None,
            Operation::Input(place) => preparation.input(&program.inputs()[*place as usize]),
            _ => Some(
                preparation
                    .push(operation.map(|operand| images[operand.index()].unwrap_or(operand))),
            ),
        });
    }
    let names: Vec<String> = (1..=hoisted.len())
        .map(|number| format!("h_{number}"))
        .collect();
    for (name, node) in names.iter().zip(&hoisted) {
        if let Some(image) = images[node.index()] {
            preparation.output(name.clone(), image);
        }
    }

    let moving_inputs = program.inputs().iter().filter(|name| swept.contains(*name));
    let mut sweep = Program::new(moving_inputs.cloned().chain(names.iter().cloned()));
    let mut images: Vec<Option<Node>> = Vec::new();
    for (node, operation) in program.nodes() {
        let place = hoisted.iter().position(|known| *known == node);
        images.push(match (operation, place) {
            (_, Some(place)) => sweep.input(&names[place]),
            (Operation::Input(place), None) => sweep.input(&program.inputs()[*place as usize]),
            (Operation::Constant(value), None) => Some(sweep.constant(value.clone())),
            _ if stays(node) => None,
            _ => Some(
                sweep.push(operation.map(|operand| images[operand.index()].unwrap_or(operand))),
            ),
        });
    }
    for (name, node) in program.outputs() {
        if let Some(image) = images[node.index()] {
            sweep.output(name.clone(), image);
        }
    }
    Hoisted {
        preparation: super::prune::prune(&preparation),
        sweep: super::prune::prune(&sweep),
    }
}

/// The same program, with what does not depend on the swept inputs before what does.
#[must_use]
pub fn still_first(program: &Program, swept: &BTreeSet<String>) -> Program {
    let moves = moving(program, swept);
    let mut sorted = Program::new(program.inputs().iter().cloned());
    let mut images: BTreeMap<Node, Node> = BTreeMap::new();
    for late in [false, true] {
        for (node, operation) in program.nodes() {
            if let Operation::Input(_) = operation {
                // The inputs are the first values of both programs.
                images.insert(node, node);
            } else if moves[node.index()] == late {
                let moved = operation.map(|operand| images[&operand]);
                images.insert(node, sorted.push(moved));
            }
        }
    }
    for (name, node) in program.outputs() {
        sorted.output(name.clone(), images[node]);
    }
    sorted
}

/// Of each value, whether it depends on a swept input.
fn moving(program: &Program, swept: &BTreeSet<String>) -> Vec<bool> {
    let mut moves: Vec<bool> = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        moves.push(match operation {
            Operation::Input(place) => swept.contains(&program.inputs()[*place as usize]),
            _ => operation.operands().any(|operand| moves[operand.index()]),
        });
    }
    moves
}
