//! Identities of nodes, by arithmetic modulo large numbers.
//!
//! Every variable is a random number; so are the measure of an angle beside a random point of the circle,
//! a root beside what stands under it, and the value of a function at each argument. No equation ties these
//! to each other but those that are followed here, so that what vanishes does so everywhere.
//! The numbers depend on the text of the document: nobody can write a document that knows them.

use crate::algebra::modular::is_prime;

use super::graph::{FunctionId, Graph, Node, NodeId};

/// A residue a + b·i.
type Residue = (u64, u64);

/// Values of nodes modulo one number.
#[derive(Clone, Debug)]
pub struct Formal {
    modulus: u64,
    seed: [u64; 2],
    known: Vec<Option<Option<Residue>>>,
}

/// What an independent value belongs to.
#[derive(Clone, Copy)]
enum Owner {
    Variable(u64),
    Circle(u64),
    Root,
    Direction,
    Function(FunctionId, u32),
}

impl Formal {
    /// Values that depend on a seed: the modulus too, which is a prime, so that what is not 0 has an inverse.
    pub fn new(seed: [u64; 2]) -> Self {
        let mut modulus = mix(seed[0] ^ mix(seed[1])) >> 2 | 1 << 61 | 1;
        while !is_prime(modulus) {
            modulus += 2;
        }
        Formal {
            modulus,
            seed,
            known: Vec::new(),
        }
    }

    /// Forgets the values of the nodes from a place on.
    pub fn forget(&mut self, size: usize) {
        self.known.truncate(size);
    }

    /// Whether a node is 0; nothing where it has no value here.
    pub fn vanishes(&mut self, graph: &Graph, id: NodeId) -> Option<bool> {
        self.known.resize(graph.size().max(self.known.len()), None);
        for part in graph.unknown(id, |part| self.known[Graph::place(part)].is_some()) {
            self.known[Graph::place(part)] = Some(self.compute(graph.node(part)));
        }
        Some(self.of(id)? == (0, 0))
    }

    fn of(&self, id: NodeId) -> Option<Residue> {
        self.known[Graph::place(id)].flatten()
    }

    fn compute(&self, node: &Node) -> Option<Residue> {
        match node {
            Node::Number(number) => {
                let modulus = self.modulus as i64;
                let above = (number.numerator() % modulus).rem_euclid(modulus) as u64;
                let below = number.denominator() % self.modulus;
                Some((self.times(above, self.inverse(below)?), 0))
            }
            Node::ImaginaryUnit => Some((0, 1)),
            Node::Variable(id) => Some((self.independent(Owner::Variable(id.number()), &[]), 0)),
            Node::Cosine(id) => self.circle(id.number()).map(|(cosine, _)| (cosine, 0)),
            Node::Sine(id) => self.circle(id.number()).map(|(_, sine)| (sine, 0)),
            Node::Sum(a, b) => {
                let ((a, b), (c, d)) = (self.of(*a)?, self.of(*b)?);
                Some((self.plus(a, c), self.plus(b, d)))
            }
            Node::Product(a, b) => Some(self.product(self.of(*a)?, self.of(*b)?)),
            Node::Quotient(a, b) => {
                let (c, d) = self.of(*b)?;
                let square = self.plus(self.times(c, c), self.times(d, d));
                let inverse = self.inverse(square)?;
                let conjugate = (self.times(c, inverse), self.times(self.minus(d), inverse));
                Some(self.product(self.of(*a)?, conjugate))
            }
            Node::Power(a, exponent) => Some(self.power(self.of(*a)?, *exponent)),
            Node::Root(a) => Some((self.independent(Owner::Root, &[self.of(*a)?]), 0)),
            Node::Direction { x, y, .. } => {
                let vector = [self.of(*x)?, self.of(*y)?];
                Some((self.independent(Owner::Direction, &vector), 0))
            }
            Node::Function {
                function,
                order,
                argument,
                ..
            } => {
                let owner = Owner::Function(*function, *order);
                Some((self.independent(owner, &[self.of(*argument)?]), 0))
            }
            Node::Guarded { value, needed } => {
                self.of(*needed)?;
                self.of(*value)
            }
            Node::Detour(value) => self.of(*value),
        }
    }

    /// A random number that depends on what it belongs to and on where that is taken.
    fn independent(&self, owner: Owner, place: &[Residue]) -> u64 {
        let words = match owner {
            Owner::Variable(id) => [1, id, 0],
            Owner::Circle(id) => [2, id, 0],
            Owner::Root => [3, 0, 0],
            Owner::Direction => [4, 0, 0],
            Owner::Function(id, order) => [5, id.number(), u64::from(order)],
        };
        let place = place.iter().flat_map(|(a, b)| [*a, *b]);
        let words = words.into_iter().chain(place);
        let [a, b] = words.fold(self.seed, |[a, b], word| {
            let a = mix(a ^ word);
            [a, mix(b ^ a)]
        });
        let state = u128::from(a) << 64 | u128::from(b);
        (state % u128::from(self.modulus)) as u64
    }

    /// A point of the circle.
    fn circle(&self, id: u64) -> Option<Residue> {
        let t = self.independent(Owner::Circle(id), &[]);
        let square = self.times(t, t);
        let inverse = self.inverse(self.plus(1, square))?;
        let cosine = self.times(self.plus(1, self.minus(square)), inverse);
        Some((cosine, self.times(self.plus(t, t), inverse)))
    }

    fn product(&self, (a, b): Residue, (c, d): Residue) -> Residue {
        let real = self.plus(self.times(a, c), self.minus(self.times(b, d)));
        (real, self.plus(self.times(a, d), self.times(b, c)))
    }

    fn power(&self, base: Residue, exponent: u32) -> Residue {
        let (mut result, mut square, mut rest) = ((1, 0), base, exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(result, square);
            }
            square = self.product(square, square);
            rest /= 2;
        }
        result
    }

    fn plus(&self, a: u64, b: u64) -> u64 {
        (a + b) % self.modulus
    }

    fn minus(&self, a: u64) -> u64 {
        (self.modulus - a) % self.modulus
    }

    fn times(&self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.modulus)) as u64
    }

    /// 1/a by Euclid; nothing where a and the modulus have a divisor in common.
    fn inverse(&self, a: u64) -> Option<u64> {
        let modulus = i128::from(self.modulus);
        let (mut r, mut next) = (modulus, i128::from(a));
        let (mut s, mut other) = (0_i128, 1_i128);
        while next != 0 {
            let quotient = r / next;
            (r, next) = (next, r - quotient * next);
            (s, other) = (other, s - quotient * other);
        }
        (r == 1).then(|| s.rem_euclid(modulus) as u64)
    }
}

/// Spreads the bits of a number (the finaliser of SplitMix64).
pub fn mix(state: u64) -> u64 {
    let state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    state ^ (state >> 31)
}
