//! One division instead of several.

use std::collections::BTreeMap;

use super::prune::prune;
use crate::program::{Node, Operation, Program, Rational, is_power_of_two};

/// How many values are multiplied to be divided by together, at most: the product of four is in the range
/// of doubles as long as each is within 10^±77.
const FACTORS: usize = 4;

/// Divides once by all divisors that do not wait for each other: a/x and b/(y·z) become a·(y·z)·q and
/// b·x·q with q = 1/(x·y·z), and a/d and b/d become a·q and b·q with q = 1/d.
///
/// A division takes as long as eight to sixteen products in lanes. Powers of two stay out of the common
/// divisor, because products with them are exact. Where one divisor is 0 none of the quotients has a value.
///
/// Complexity: n log n for n operations.
#[must_use]
pub fn reciprocals(program: &Program) -> Program {
    // What no output needs must not be divided by.
    let program = prune(program);
    let depths = depths(&program);
    let mut rebuilt = Program::new(program.inputs().iter().cloned());
    let mut images: BTreeMap<Node, Node> = BTreeMap::new();
    let mut inverses: BTreeMap<Node, Node> = BTreeMap::new();
    for depth in 0..=depths.iter().copied().max().unwrap_or(0) {
        let is_here = |node: Node| depths[node.index()] == depth;
        for (node, operation) in program.nodes().filter(|(node, _)| is_here(*node)) {
            let image = match operation {
                // The inputs are the first values of both programs.
                Operation::Input(_) => node,
                Operation::Divide(above, below) if inverses.contains_key(below) => {
                    rebuilt.push(Operation::Multiply(images[above], inverses[below]))
                }
                _ => rebuilt.push(operation.map(|operand| images[&operand])),
            };
            images.insert(node, image);
        }
        for group in groups(&program, is_here) {
            group.invert(&mut rebuilt, &images, &mut inverses);
        }
    }
    for (name, node) in program.outputs() {
        rebuilt.output(name.clone(), images[node]);
    }
    rebuilt
}

/// Of each value, how many divisions are done one after the other to compute it.
fn depths(program: &Program) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        let of = |node: &Node| depths[node.index()];
        depths.push(match operation {
            Operation::Divide(above, below) => of(above).max(of(below) + 1),
            _ => operation
                .operands()
                .map(|node| of(&node))
                .max()
                .unwrap_or(0),
        });
    }
    depths
}

/// A divisor: a power of two times the product of some values.
struct Divisor {
    node: Node,
    uses: usize,
    power_of_two: Rational,
    /// In order; empty if there are too many.
    factors: Vec<Node>,
}

/// Divisors that are divided by together, and the least product that all of them divide.
struct Group {
    divisors: Vec<Divisor>,
    multiple: Vec<Node>,
}

/// The divisors of some values, in groups whose products are not too long.
fn groups(program: &Program, is_here: impl Fn(Node) -> bool) -> Vec<Group> {
    let mut uses: BTreeMap<Node, usize> = BTreeMap::new();
    for operation in program.operations() {
        match operation {
            Operation::Divide(_, divisor) if is_here(*divisor) => {
                *uses.entry(*divisor).or_default() += 1;
            }
            _ => {}
        }
    }
    let mut groups: Vec<Group> = Vec::new();
    for (node, uses) in uses {
        let divisor = Divisor::of(program, node, uses);
        let joined = groups.iter_mut().find_map(|group| {
            let multiple = common_multiple(&group.multiple, &divisor.factors)?;
            Some((group, multiple))
        });
        match joined {
            Some((group, multiple)) => {
                group.divisors.push(divisor);
                group.multiple = multiple;
            }
            None => groups.push(Group {
                multiple: divisor.factors.clone(),
                divisors: vec![divisor],
            }),
        }
    }
    groups
}

impl Divisor {
    /// Takes a product apart.
    fn of(program: &Program, node: Node, uses: usize) -> Self {
        let mut divisor = Divisor {
            node,
            uses,
            power_of_two: Rational::ONE,
            factors: Vec::new(),
        };
        let mut products = vec![node];
        while let Some(node) = products.pop() {
            match program.operation(node) {
                Operation::Multiply(a, b) => products.extend([*a, *b]),
                Operation::Constant(value) if is_power_of_two(value) => {
                    divisor.power_of_two *= value;
                }
                _ => divisor.factors.push(node),
            }
            // A power can have more factors than there are operations.
            if divisor.factors.len() + products.len() > 2 * FACTORS {
                divisor.factors.clear();
                break;
            }
        }
        divisor.factors.sort();
        divisor
    }
}

impl Group {
    /// Appends the inverses of all divisors; a single division stays one.
    fn invert(
        self,
        program: &mut Program,
        images: &BTreeMap<Node, Node>,
        inverses: &mut BTreeMap<Node, Node>,
    ) {
        let uses: usize = self.divisors.iter().map(|divisor| divisor.uses).sum();
        if uses < 2 {
            return;
        }
        let one = program.constant(Rational::ONE);
        if let [divisor] = &self.divisors[..] {
            let inverse = program.push(Operation::Divide(one, images[&divisor.node]));
            inverses.insert(divisor.node, inverse);
            return;
        }
        let product = |program: &mut Program, factors: &[Node]| {
            let factors = factors.iter().map(|factor| images[factor]);
            factors.reduce(|left, right| program.push(Operation::Multiply(left, right)))
        };
        let Some(below) = product(program, &self.multiple) else {
            return;
        };
        let common = program.push(Operation::Divide(one, below));
        for divisor in &self.divisors {
            let mut inverse = common;
            let rest = without(&self.multiple, &divisor.factors);
            if let Some(rest) = product(program, &rest) {
                inverse = program.push(Operation::Multiply(inverse, rest));
            }
            if divisor.power_of_two != Rational::ONE {
                let scale = program.constant(Rational::ONE / divisor.power_of_two.clone());
                inverse = program.push(Operation::Multiply(inverse, scale));
            }
            inverses.insert(divisor.node, inverse);
        }
    }
}

/// The least product of factors in order that both products divide; none if one of them is not known or
/// the result is too long.
fn common_multiple(left: &[Node], right: &[Node]) -> Option<Vec<Node>> {
    let mut multiple = left.to_vec();
    multiple.extend(without(right, left));
    multiple.sort();
    let is_known = !left.is_empty() && !right.is_empty();
    (is_known && multiple.len() <= FACTORS).then_some(multiple)
}

/// The factors of a product that another one does not have.
fn without(factors: &[Node], others: &[Node]) -> Vec<Node> {
    let mut rest = factors.to_vec();
    for other in others {
        if let Some(place) = rest.iter().position(|factor| factor == other) {
            rest.remove(place);
        }
    }
    rest
}
