//! Polynomials in values of a program, by Horner's rule in several variables.

use std::collections::BTreeMap;

use crate::program::{Node, Operation, Program, Rational};

/// A term: its coefficient, and the values that are multiplied, with their exponents.
pub type Term = (Rational, BTreeMap<Node, u32>);

/// Appends the value of a sum of terms.
///
/// The value that occurs in most terms is taken out of them, c₁x + c₂x² + c₃ = x(c₁ + c₂x) + c₃, and
/// both parts are treated likewise (the greedy rule of Ceberio and Kreinovich, 2004).
pub fn horner(program: &mut Program, terms: &[Term]) -> Node {
    let terms: Vec<&Term> = terms
        .iter()
        .filter(|(coefficient, _)| *coefficient != Rational::ZERO)
        .collect();
    let owned: Vec<Term> = terms.into_iter().cloned().collect();
    sum(program, owned)
}

fn sum(program: &mut Program, terms: Vec<Term>) -> Node {
    let mut counts: BTreeMap<Node, usize> = BTreeMap::new();
    for node in terms.iter().flat_map(|(_, powers)| powers.keys()) {
        *counts.entry(*node).or_default() += 1;
    }
    let most = counts
        .iter()
        .map(|(node, count)| (*count, std::cmp::Reverse(*node)))
        .max();
    match most {
        Some((count, std::cmp::Reverse(variable))) if count > 1 => {
            let (with, without): (Vec<Term>, Vec<Term>) = terms
                .into_iter()
                .partition(|(_, powers)| powers.contains_key(&variable));
            let divided = with
                .into_iter()
                .map(|(coefficient, powers)| (coefficient, lowered(powers, variable)));
            let inner = sum(program, divided.collect());
            let product = program.push(Operation::Multiply(variable, inner));
            if without.is_empty() {
                return product;
            }
            let rest = sum(program, without);
            program.push(Operation::Add(product, rest))
        }
        _ => {
            let mut total: Option<Node> = None;
            for (coefficient, powers) in terms {
                let term = product(program, coefficient, powers);
                total = Some(match total {
                    Some(total) => program.push(Operation::Add(total, term)),
                    None => term,
                });
            }
            total.unwrap_or_else(|| program.constant(Rational::ZERO))
        }
    }
}

fn lowered(mut powers: BTreeMap<Node, u32>, variable: Node) -> BTreeMap<Node, u32> {
    if let Some(exponent) = powers.get_mut(&variable) {
        *exponent -= 1;
        if *exponent == 0 {
            powers.remove(&variable);
        }
    }
    powers
}

/// Appends c·xᵃyᵇ….
fn product(program: &mut Program, coefficient: Rational, powers: BTreeMap<Node, u32>) -> Node {
    let mut total: Option<Node> = None;
    for (node, exponent) in powers {
        let factor = power(program, node, exponent);
        total = Some(match total {
            Some(total) => program.push(Operation::Multiply(total, factor)),
            None => factor,
        });
    }
    let Some(total) = total else {
        return program.constant(coefficient);
    };
    if coefficient == Rational::ONE {
        return total;
    }
    if coefficient == -Rational::ONE {
        return program.push(Operation::Negative(total));
    }
    let coefficient = program.constant(coefficient);
    program.push(Operation::Multiply(coefficient, total))
}

/// Appends xⁿ by repeated squaring; equal squares are shared later.
pub fn power(program: &mut Program, base: Node, exponent: u32) -> Node {
    match exponent {
        0 => program.constant(Rational::ONE),
        1 => base,
        _ => {
            let half = power(program, base, exponent / 2);
            let square = program.push(Operation::Multiply(half, half));
            match exponent % 2 {
                0 => square,
                _ => program.push(Operation::Multiply(square, base)),
            }
        }
    }
}
