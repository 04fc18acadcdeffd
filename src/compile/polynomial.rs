//! Polynomials in one variable whose coefficients are values of a program.

use std::collections::BTreeMap;

use sextic_codegen::program::{Node, Operation, Program};

/// The coefficients by power; those that are not there are 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial {
    coefficients: BTreeMap<u32, Node>,
}

impl Polynomial {
    /// c·xⁿ
    pub fn monomial(power: u32, coefficient: Node) -> Self {
        Polynomial {
            coefficients: BTreeMap::from([(power, coefficient)]),
        }
    }

    /// Whether it is known to be 0.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The coefficient of a power, if it is not known to be 0.
    pub fn coefficient(&self, power: u32) -> Option<Node> {
        self.coefficients.get(&power).copied()
    }

    /// The powers and their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (u32, Node)> {
        self.coefficients
            .iter()
            .map(|(power, node)| (*power, *node))
    }

    /// The value of a polynomial without the variable; nothing for one with it.
    pub fn constant(&self) -> Option<Option<Node>> {
        let free = self.coefficients.keys().all(|power| *power == 0);
        free.then(|| self.coefficient(0))
    }

    /// The degree.
    pub fn degree(&self) -> u32 {
        self.coefficients.keys().last().copied().unwrap_or(0)
    }

    /// p + q
    pub fn sum(&self, other: &Self, program: &mut Program) -> Self {
        self.merge(other, program, Operation::Add, |_, b| b)
    }

    /// p − q
    pub fn difference(&self, other: &Self, program: &mut Program) -> Self {
        self.merge(other, program, Operation::Subtract, |program, b| {
            program.push(Operation::Negative(b))
        })
    }

    /// −p
    pub fn negative(&self, program: &mut Program) -> Self {
        self.map(|node| program.push(Operation::Negative(node)))
    }

    /// p·q
    pub fn product(&self, other: &Self, program: &mut Program) -> Self {
        let mut product = Polynomial::default();
        for (i, a) in &self.coefficients {
            for (j, b) in &other.coefficients {
                let term = program.push(Operation::Multiply(*a, *b));
                let sum = match product.coefficients.get(&(i + j)) {
                    Some(sum) => program.push(Operation::Add(*sum, term)),
                    None => term,
                };
                product.coefficients.insert(i + j, sum);
            }
        }
        product
    }

    /// p/d for a value d.
    pub fn quotient(&self, divisor: Node, program: &mut Program) -> Self {
        self.map(|node| program.push(Operation::Divide(node, divisor)))
    }

    fn map(&self, mut image: impl FnMut(Node) -> Node) -> Self {
        let images = self.coefficients.iter();
        Polynomial {
            coefficients: images.map(|(power, node)| (*power, image(*node))).collect(),
        }
    }

    fn merge(
        &self,
        other: &Self,
        program: &mut Program,
        both: fn(Node, Node) -> Operation,
        alone: fn(&mut Program, Node) -> Node,
    ) -> Self {
        let mut merged = self.clone();
        for (power, b) in &other.coefficients {
            let node = match self.coefficients.get(power) {
                Some(a) => program.push(both(*a, *b)),
                None => alone(program, *b),
            };
            merged.coefficients.insert(*power, node);
        }
        merged
    }
}
