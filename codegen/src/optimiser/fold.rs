//! Operations on constants, and with 0 and 1.

use crate::program::{Node, Operation, Program, Rational, is_power_of_two};

/// Carries out what is known, and leaves out what changes nothing: x + 0, x·1, x/1, x·0, 0/x, −(−x),
/// x + (−y), and the signs of constants in products.
///
/// 0/x and x·0 become 0, which is right wherever x has a value.
#[must_use]
pub fn fold(program: &Program) -> Program {
    program.rebuild(|program, _, operation| folded(program, operation))
}

fn folded(program: &mut Program, operation: Operation) -> Node {
    use Operation::{Add, Divide, Multiply, Negative, SquareRoot, Subtract};
    let known = |node: Node| match program.operation(node) {
        Operation::Constant(value) => Some(value.clone()),
        _ => None,
    };
    let negated = |node: Node| match program.operation(node) {
        Negative(inner) => Some(*inner),
        _ => None,
    };
    let is = |value: &Option<Rational>, number: i64| *value == Some(Rational::from(number));
    match operation {
        Add(a, b) => match (known(a), known(b)) {
            (Some(x), Some(y)) => program.constant(x + y),
            (x, _) if is(&x, 0) => b,
            (_, y) if is(&y, 0) => a,
            _ => match (negated(a), negated(b)) {
                (_, Some(y)) => program.push(Subtract(a, y)),
                (Some(x), None) => program.push(Subtract(b, x)),
                (None, None) => program.push(operation),
            },
        },
        Subtract(a, b) if a == b => program.constant(Rational::ZERO),
        Subtract(a, b) => match (known(a), known(b)) {
            (Some(x), Some(y)) => program.constant(x - y),
            (x, _) if is(&x, 0) => folded(program, Negative(b)),
            (_, y) if is(&y, 0) => a,
            _ => match negated(b) {
                Some(y) => folded(program, Add(a, y)),
                None => program.push(operation),
            },
        },
        Multiply(a, b) => match (known(a), known(b)) {
            (Some(x), Some(y)) => program.constant(x * y),
            (x, y) if is(&x, 0) || is(&y, 0) => program.constant(Rational::ZERO),
            (x, _) if is(&x, 1) => b,
            (_, y) if is(&y, 1) => a,
            (x, _) if is(&x, -1) => folded(program, Negative(b)),
            (_, y) if is(&y, -1) => folded(program, Negative(a)),
            _ => match (negated(a), negated(b)) {
                (Some(x), Some(y)) => folded(program, Multiply(x, y)),
                (Some(x), None) => {
                    let product = folded(program, Multiply(x, b));
                    folded(program, Negative(product))
                }
                (None, Some(y)) => {
                    let product = folded(program, Multiply(a, y));
                    folded(program, Negative(product))
                }
                (None, None) => program.push(operation),
            },
        },
        Divide(a, b) => match (known(a), known(b)) {
            (Some(x), Some(y)) if y != Rational::ZERO => program.constant(x / y),
            (x, _) if is(&x, 0) => program.constant(Rational::ZERO),
            (_, y) if is(&y, 1) => a,
            (_, y) if is(&y, -1) => folded(program, Negative(a)),
            // Division by a power of two is exact as a product.
            (_, Some(y)) if y != Rational::ZERO && is_power_of_two(&y) => {
                let inverse = program.constant(Rational::ONE / y);
                folded(program, Multiply(a, inverse))
            }
            _ => match (negated(a), negated(b)) {
                (Some(x), Some(y)) => folded(program, Divide(x, y)),
                (Some(x), None) => {
                    let quotient = folded(program, Divide(x, b));
                    folded(program, Negative(quotient))
                }
                (None, Some(y)) => {
                    let quotient = folded(program, Divide(a, y));
                    folded(program, Negative(quotient))
                }
                (None, None) => program.push(operation),
            },
        },
        Negative(a) => match (known(a), program.operation(a).clone()) {
            (Some(x), _) => program.constant(-x),
            (None, Negative(inner)) => inner,
            (None, Subtract(x, y)) => program.push(Subtract(y, x)),
            _ => program.push(operation),
        },
        SquareRoot(a) => match known(a) {
            Some(x) if x == Rational::ZERO || x == Rational::ONE => a,
            _ => program.push(operation),
        },
        Operation::Input(_) | Operation::Constant(_) => program.push(operation),
    }
}
