//! Several divisions by one value.

use std::collections::BTreeMap;

use crate::program::{Node, Operation, Program, Rational};

/// Divides once by what is divided by more than once: a/d and b/d become a·(1/d) and b·(1/d).
#[must_use]
pub fn reciprocals(program: &Program) -> Program {
    let mut divisions: BTreeMap<Node, usize> = BTreeMap::new();
    for operation in program.operations() {
        if let Operation::Divide(_, divisor) = operation {
            *divisions.entry(*divisor).or_default() += 1;
        }
    }
    // By the divisor in the new program.
    let mut inverses: BTreeMap<Node, Node> = BTreeMap::new();
    program.rebuild(|rebuilt, node, operation| {
        let Operation::Divide(above, below) = operation else {
            return rebuilt.push(operation);
        };
        let Operation::Divide(_, divisor) = program.operation(node) else {
            return rebuilt.push(operation);
        };
        if divisions[divisor] < 2 {
            return rebuilt.push(operation);
        }
        let inverse = *inverses.entry(below).or_insert_with(|| {
            let one = rebuilt.constant(Rational::ONE);
            rebuilt.push(Operation::Divide(one, below))
        });
        rebuilt.push(Operation::Multiply(above, inverse))
    })
}
