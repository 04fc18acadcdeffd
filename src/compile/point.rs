//! A point of the relations modulo a prime: what differs there differs, and most texts that are wrong
//! are refused by it before any algebra.
//!
//! Nothing is proven by a point. Where something has no value there (a division by 0, a root that is not
//! known) it decides nothing.

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::program::Program;
use sextic_codegen::random;

use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::modular::{
    PRIME, inverse, negative, power, reduce, residue, square_root, times,
};
use crate::algebra::number::{Integer, Rational};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::symbol::Symbol;

use super::doubt::Reason;
use super::specification::Specification;

/// How many points are tried until all radicands are squares.
const MOST_TRIES: u64 = 64;

/// A point, with what an evaluator takes and gives there.
#[derive(Clone, Debug)]
pub struct Point {
    inputs: Vec<Option<u64>>,
    outputs: Vec<Option<u64>>,
    /// The roots of the ring, by their radicands.
    roots: BTreeMap<u64, u64>,
}

impl Point {
    /// A point for an evaluator, the same one every time.
    ///
    /// Complexity: linear in the number of terms of the outputs.
    pub fn of(specification: &Specification, ring: &Ring) -> Self {
        let inputs = specification.elements().map(|(_, element)| element);
        let outputs = specification.outputs.iter().map(|(_, element)| element);
        let symbols = needed(inputs.chain(outputs), ring);
        let mut coordinates = Coordinates::default();
        for seed in 0..MOST_TRIES {
            coordinates = Coordinates::draw(&symbols, ring, seed);
            if coordinates.values.values().all(Option::is_some) {
                break;
            }
        }
        let inputs = specification.elements();
        let outputs = specification.outputs.iter();
        Point {
            inputs: inputs
                .map(|(_, element)| coordinates.fraction(element))
                .collect(),
            outputs: outputs
                .map(|(_, element)| coordinates.fraction(element))
                .collect(),
            roots: coordinates.roots,
        }
    }

    /// Refuses the program of a body that gives something else here than what was derived; whether all of
    /// its outputs have a value here, otherwise.
    ///
    /// # Errors
    ///
    /// [`Reason::Different`], for the first output that differs.
    pub fn refute(&self, body: &Program, specification: &Specification) -> Result<bool, Reason> {
        let mut residues = Residues { roots: &self.roots };
        let Ok(found) = body.run(&mut residues, &self.inputs);
        let mut is_decided = true;
        let names = specification.outputs.iter().map(|(name, _)| name);
        for (name, values) in names.zip(self.outputs.iter().zip(&found)) {
            match values {
                (Some(wanted), Some(found)) if wanted != found => {
                    return Err(Reason::Different(name.clone()));
                }
                (Some(_), Some(_)) => {}
                _ => is_decided = false,
            }
        }
        Ok(is_decided)
    }
}

/// The symbols of some elements, with those under their roots.
fn needed<'a>(elements: impl Iterator<Item = &'a Fraction>, ring: &Ring) -> BTreeSet<Symbol> {
    let mut found = BTreeSet::new();
    let mut open: Vec<Symbol> = elements
        .flat_map(|element| [element.numerator(), element.denominator()])
        .flat_map(Polynomial::symbols)
        .collect();
    while let Some(symbol) = open.pop() {
        if found.insert(symbol)
            && let Generator::Root { radicand } = ring.generator(symbol)
        {
            open.extend(radicand.symbols());
        }
    }
    found
}

/// The values of symbols; none where a symbol has no value here.
#[derive(Clone, Debug, Default)]
struct Coordinates {
    values: BTreeMap<Symbol, Option<u64>>,
    roots: BTreeMap<u64, u64>,
}

impl Coordinates {
    /// A relation gives the square of a symbol by symbols before it.
    fn draw(symbols: &BTreeSet<Symbol>, ring: &Ring, seed: u64) -> Self {
        let mut coordinates = Coordinates::default();
        for symbol in symbols {
            let value = match ring.generator(*symbol) {
                Generator::Constant { .. }
                | Generator::Angle { .. }
                | Generator::Coordinate { .. }
                | Generator::FunctionValue { .. } => Some(mixed(seed, symbol.index())),
                Generator::Cosine { .. } | Generator::Sine { .. } => circle(*symbol, ring, seed),
                Generator::Root { radicand } => {
                    let square = coordinates.polynomial(radicand);
                    let root = square.and_then(square_root);
                    coordinates.roots.extend(square.zip(root));
                    root
                }
                // The prime is 3 modulo 4, so that −1 has no root.
                Generator::ImaginaryUnit | Generator::Direction { .. } => None,
            };
            coordinates.values.insert(*symbol, value);
        }
        coordinates
    }

    fn polynomial(&self, polynomial: &Polynomial) -> Option<u64> {
        let mut sum = 0;
        for (monomial, coefficient) in polynomial.terms() {
            let mut term = residue(coefficient);
            for (symbol, exponent) in monomial.factors() {
                let value = self.values.get(&symbol).copied().flatten()?;
                term = times(term, power(value, exponent));
            }
            sum = reduce(sum + term);
        }
        Some(sum)
    }

    fn fraction(&self, fraction: &Fraction) -> Option<u64> {
        let below = self.polynomial(fraction.denominator())?;
        Some(times(
            self.polynomial(fraction.numerator())?,
            inverse(below)?,
        ))
    }
}

/// The coordinate (1 − t²)/(1 + t²) or 2t/(1 + t²) of a point of the circle.
fn circle(symbol: Symbol, ring: &Ring, seed: u64) -> Option<u64> {
    let of =
        |basis: &crate::algebra::ring::BasisAngle| basis.cosine == symbol || basis.sine == symbol;
    let basis = ring.basis().iter().find(|basis| of(basis))?;
    let t = mixed(seed, basis.cosine.index());
    let square = times(t, t);
    let above = match basis.cosine == symbol {
        true => reduce(1 + negative(square)),
        false => reduce(t + t),
    };
    Some(times(above, inverse(reduce(1 + square))?))
}

/// An arbitrary but fixed number for each place, by the mixing function of SplitMix64.
fn mixed(seed: u64, place: usize) -> u64 {
    let number = (seed << 32).wrapping_add(place as u64 + 1);
    random::mixed(number) % (PRIME - 1) + 1
}

/// Numbers modulo [`PRIME`]; none where nothing is known.
#[derive(Clone, Copy, Debug)]
pub struct Residues<'r> {
    /// The roots that are known, by their radicands: of two of them the one that a ring means.
    pub roots: &'r BTreeMap<u64, u64>,
}

impl Arithmetic for Residues<'_> {
    type Value = Option<u64>;
    type Error = Infallible;

    fn constant(&mut self, value: &Rational) -> Result<Option<u64>, Infallible> {
        let below = inverse(residue(&Integer::from(value.denominator().clone())));
        Ok(below.map(|below| times(residue(value.numerator()), below)))
    }

    fn negative(&mut self, a: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.map(negative))
    }

    fn sum(&mut self, a: &Option<u64>, b: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.zip(*b).map(|(a, b)| reduce(a + b)))
    }

    fn difference(&mut self, a: &Option<u64>, b: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.zip(*b).map(|(a, b)| reduce(a + negative(b))))
    }

    fn product(&mut self, a: &Option<u64>, b: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.zip(*b).map(|(a, b)| times(a, b)))
    }

    fn quotient(&mut self, a: &Option<u64>, b: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.zip(b.and_then(inverse)).map(|(a, b)| times(a, b)))
    }

    fn square_root(&mut self, a: &Option<u64>) -> Result<Option<u64>, Infallible> {
        Ok(a.and_then(|a| self.roots.get(&a).copied()))
    }
}
