//! One division instead of several.

use std::collections::BTreeMap;

use super::prune::prune;
use crate::program::{Node, Operation, Program, Rational, is_power_of_two};

/// How many values are multiplied to be divided by together, at most: the product of four is in the range
/// of doubles as long as each is within 10^±77.
const FACTORS: usize = 4;

/// Divides once by all divisors that are known closely: a/x and b/(y·z) become a·(y·z)·q and b·x·q with
/// q = 1/(x·y·z), and a/d and b/d become a·q and b·q with q = 1/d.
///
/// A division takes as long as eight to sixteen products in lanes. Divisors are known closely if they are
/// products of what is given, and of sums of two given values; cancellation in others would spoil quotients
/// that have nothing to do with them. Powers of two stay out of the common divisor, because products with
/// them are exact. Where one divisor is 0 none of the quotients has a value.
///
/// Complexity: n log n for n operations.
#[must_use]
pub fn reciprocals(program: &Program) -> Program {
    // What no output needs must not be divided by.
    let program = prune(program);
    let groups = groups(&program);
    let mut inverses: BTreeMap<Node, Node> = BTreeMap::new();
    program.rebuild(|rebuilt, node, operation| {
        let (Operation::Divide(above, below), Operation::Divide(_, divisor)) =
            (&operation, program.operation(node))
        else {
            return rebuilt.push(operation);
        };
        let Some(group) = groups.iter().find(|group| group.has(*divisor)) else {
            return rebuilt.push(operation);
        };
        if !inverses.contains_key(divisor) {
            group.invert(*below, &program, rebuilt, &mut inverses);
        }
        rebuilt.push(Operation::Multiply(*above, inverses[divisor]))
    })
}

/// A divisor: a power of two times the product of some values.
struct Divisor {
    node: Node,
    uses: usize,
    power_of_two: Rational,
    /// In order; empty if there are too many, or one that is not to be joined.
    factors: Vec<Node>,
}

/// Divisors that are divided by together, and the least product that all of them divide.
struct Group {
    divisors: Vec<Divisor>,
    multiple: Vec<Node>,
}

/// What is divided by more than once, in groups whose products are not too long.
fn groups(program: &Program) -> Vec<Group> {
    let mut uses: BTreeMap<Node, usize> = BTreeMap::new();
    for operation in program.operations() {
        if let Operation::Divide(_, divisor) = operation {
            *uses.entry(*divisor).or_default() += 1;
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
    let is_worth_it = |group: &Group| {
        let uses: usize = group.divisors.iter().map(|divisor| divisor.uses).sum();
        uses > 1
    };
    groups.retain(is_worth_it);
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
            let is_long = divisor.factors.len() + products.len() > 2 * FACTORS;
            let mut factors = divisor.factors.iter();
            if is_long || !factors.all(|factor| is_close(program, *factor)) {
                divisor.factors.clear();
                break;
            }
        }
        divisor.factors.sort();
        divisor
    }
}

/// Whether a value is given, or the sum or difference of two that are: rounded once, so that it is close
/// to exact however small it is.
fn is_close(program: &Program, node: Node) -> bool {
    let is_given = |node: Node| {
        let operation = program.operation(node);
        matches!(operation, Operation::Input(_) | Operation::Constant(_))
    };
    match program.operation(node) {
        Operation::Add(a, b) | Operation::Subtract(a, b) => is_given(*a) && is_given(*b),
        _ => is_given(node),
    }
}

/// A value of one program in another one with the same inputs, which come first in both.
fn copied(node: Node, program: &Program, rebuilt: &mut Program) -> Node {
    match program.operation(node) {
        Operation::Input(_) => node,
        operation => {
            let moved = operation.map(|operand| copied(operand, program, rebuilt));
            rebuilt.push(moved)
        }
    }
}

impl Group {
    fn has(&self, divisor: Node) -> bool {
        self.divisors.iter().any(|known| known.node == divisor)
    }

    /// Appends the inverses of all divisors, of which `below` is the image of the first that is needed.
    fn invert(
        &self,
        below: Node,
        program: &Program,
        rebuilt: &mut Program,
        inverses: &mut BTreeMap<Node, Node>,
    ) {
        let one = rebuilt.constant(Rational::ONE);
        if let [divisor] = &self.divisors[..] {
            let inverse = rebuilt.push(Operation::Divide(one, below));
            inverses.insert(divisor.node, inverse);
            return;
        }
        let factors = self.multiple.iter();
        let images: BTreeMap<Node, Node> = factors
            .map(|factor| (*factor, copied(*factor, program, rebuilt)))
            .collect();
        let product = |rebuilt: &mut Program, factors: &[Node]| {
            let factors = factors.iter().map(|factor| images[factor]);
            factors.reduce(|left, right| rebuilt.push(Operation::Multiply(left, right)))
        };
        let below = product(rebuilt, &self.multiple).unwrap_or(one);
        let common = rebuilt.push(Operation::Divide(one, below));
        for divisor in &self.divisors {
            let mut inverse = common;
            let rest = without(&self.multiple, &divisor.factors);
            if let Some(rest) = product(rebuilt, &rest) {
                inverse = rebuilt.push(Operation::Multiply(inverse, rest));
            }
            if divisor.power_of_two != Rational::ONE {
                let scale = rebuilt.constant(Rational::ONE / divisor.power_of_two.clone());
                inverse = rebuilt.push(Operation::Multiply(inverse, scale));
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
