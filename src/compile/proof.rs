//! The proof that a text computes what was derived: it is executed over the document's ring.

use std::fmt;

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::language::{File, Language};
use sextic_codegen::program::Program;

use crate::algebra::arithmetic::{Arithmetic as _, Division as _};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::ring::Ring;

use super::door;
use super::doubt::{Doubt, Reason};
use super::operations;
use super::point::Point;
use super::reading::read;
use super::resolution::resolve;
use super::specification::Specification;

/// What was proven of emitted files. Only [`prove_files`] gives one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof {
    language: Language,
    bodies: usize,
    outputs: usize,
    constants: usize,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |count: usize, one: &str, more: &str| match count {
            1 => format!("the {one}"),
            _ => format!("the {count} {more}"),
        };
        write!(
            f,
            "Read back from this {}, {} of {} equal the derived expressions in exact algebra{}, by \
             exactly the operations that are counted.",
            self.language.title(),
            count(self.outputs, "output", "outputs"),
            count(self.bodies, "body", "bodies"),
            match self.constants {
                0 => "",
                _ => ", where each fixed input is the double nearest to its value",
            },
        )
    }
}

/// Proves that the emitted files of an evaluator compute what was derived.
///
/// The files are read back as a whole. Every body must take the operations of the program, up to the
/// order in sums and products, and each of its outputs must be equal to its normal form in the ring.
/// What all evaluators share (numbers with bounds, lanes, the root of a crate) is not read.
///
/// Complexity: that of the normal forms; reading is linear in the length of the files.
///
/// # Errors
///
/// [`Doubt`] where anything at all is not as it must be.
pub fn prove_files(
    files: &[File],
    specification: &Specification,
    language: Language,
) -> Result<Proof, Doubt> {
    let readings = read(files, &specification.evaluator, language);
    let readings = readings.map_err(|(place, unreadable)| Doubt {
        place,
        reason: Reason::Unreadable(unreadable),
    })?;
    let mut ring = specification.elaborator.ring.clone();
    ring.budget().refill();
    let point = Point::of(specification, &ring);
    if let Some((place, door)) = &readings.door {
        door::check(door, specification, &ring).map_err(|reason| Doubt {
            place: place.clone(),
            reason,
        })?;
    }
    for (place, reading) in &readings.bodies {
        let mut check = || {
            let body = resolve(reading, specification)?;
            operations::compare(&body, specification)?;
            point.refute(&body, specification)?;
            prove(&body, specification, &mut ring)
        };
        check().map_err(|reason| Doubt {
            place: place.clone(),
            reason,
        })?;
    }
    Ok(Proof {
        language,
        bodies: readings.bodies.len(),
        outputs: specification.outputs.len(),
        constants: specification.constants.len(),
    })
}

/// Runs the program of a body in the document's ring, and compares every output with its normal form.
///
/// # Errors
///
/// [`Reason`] where an output differs, or the algebra cannot follow it.
pub fn prove(body: &Program, specification: &Specification, ring: &mut Ring) -> Result<(), Reason> {
    let elements = specification.elements();
    let inputs: Vec<Fraction> = elements.map(|(_, element)| element.clone()).collect();
    let found = body.run(&mut Elements(ring), &inputs)?;
    for ((name, derived), found) in specification.outputs.iter().zip(found) {
        if !ring.difference(&found, derived)?.is_zero() {
            return Err(Reason::Different(name.clone()));
        }
    }
    Ok(())
}

/// The elements of a ring.
#[derive(Debug)]
pub struct Elements<'r>(pub &'r mut Ring);

impl Arithmetic for Elements<'_> {
    type Value = Fraction;
    type Error = AlgebraError;

    fn constant(&mut self, value: &Rational) -> Result<Fraction, AlgebraError> {
        Ok(Fraction::constant(value.clone()))
    }

    fn negative(&mut self, a: &Fraction) -> Result<Fraction, AlgebraError> {
        Ok(self.0.negative(a))
    }

    fn sum(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.0.sum(a, b)
    }

    fn difference(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.0.difference(a, b)
    }

    fn product(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.0.product(a, b)
    }

    fn quotient(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.0.quotient(a, b)
    }

    fn square_root(&mut self, a: &Fraction) -> Result<Fraction, AlgebraError> {
        self.0.square_root(a)
    }
}
