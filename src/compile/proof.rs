//! The proof that a text computes what was derived: it is executed over the document's ring.

use std::collections::BTreeMap;

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::ring::Ring;

use super::reading::{Reading, Term};
use super::specification::Specification;

/// Why a text is not proven to compute what was derived.
#[derive(Clone, Debug)]
pub enum Doubt {
    /// The text has other inputs or outputs than the evaluator.
    Interface(String),
    /// A name is used before it is assigned, or assigned twice.
    Name(String),
    /// An output differs from what was derived.
    Different(String),
    /// The algebra cannot follow it.
    Algebra(AlgebraError),
}

/// Executes a text in the document's ring, and compares every output with its normal form.
///
/// # Errors
///
/// [`Doubt`] where anything at all is not as it must be.
pub fn prove(
    reading: &Reading,
    specification: &Specification,
    ring: &mut Ring,
) -> Result<(), Doubt> {
    let mut known: BTreeMap<&str, Fraction> = BTreeMap::new();
    let mut inputs: BTreeMap<&str, &Fraction> = BTreeMap::new();
    for (name, element) in &specification.inputs {
        inputs.insert(name, element);
    }
    for (field, variable) in &reading.inputs {
        let Some(element) = inputs.remove(field.as_str()) else {
            return Err(Doubt::Interface(format!(
                "`{field}` is no input, or is read twice"
            )));
        };
        assign(&mut known, variable, element.clone())?;
    }
    for (variable, term) in &reading.assignments {
        let value = value(term, &known, ring)?;
        assign(&mut known, variable, value)?;
    }
    let mut wanted: BTreeMap<&str, &Fraction> = BTreeMap::new();
    for (name, element) in &specification.outputs {
        wanted.insert(name, element);
    }
    for (field, term) in &reading.outputs {
        let Some(derived) = wanted.remove(field.as_str()) else {
            return Err(Doubt::Interface(format!(
                "`{field}` is no output, or is given twice"
            )));
        };
        let computed = value(term, &known, ring)?;
        let difference = ring
            .difference(&computed, derived)
            .map_err(Doubt::Algebra)?;
        if !difference.is_zero() {
            return Err(Doubt::Different(field.clone()));
        }
    }
    match wanted.keys().next() {
        Some(missing) => Err(Doubt::Interface(format!(
            "the output `{missing}` is not given"
        ))),
        None => Ok(()),
    }
}

fn assign<'a>(
    known: &mut BTreeMap<&'a str, Fraction>,
    variable: &'a str,
    value: Fraction,
) -> Result<(), Doubt> {
    match known.insert(variable, value) {
        None => Ok(()),
        Some(_) => Err(Doubt::Name(format!("`{variable}` is assigned twice"))),
    }
}

fn value(
    term: &Term,
    known: &BTreeMap<&str, Fraction>,
    ring: &mut Ring,
) -> Result<Fraction, Doubt> {
    let result = match term {
        Term::Name(name) => {
            let value = known.get(name.as_str()).cloned();
            return value.ok_or_else(|| Doubt::Name(format!("`{name}` is not assigned before")));
        }
        Term::Number(number) => Ok(Fraction::from(Rational::clone(number))),
        Term::Negative(inner) => {
            let inner = value(inner, known, ring)?;
            Ok(ring.negative(&inner))
        }
        Term::Add(a, b) => {
            let (a, b) = (value(a, known, ring)?, value(b, known, ring)?);
            ring.sum(&a, &b)
        }
        Term::Subtract(a, b) => {
            let (a, b) = (value(a, known, ring)?, value(b, known, ring)?);
            ring.difference(&a, &b)
        }
        Term::Multiply(a, b) => {
            let (a, b) = (value(a, known, ring)?, value(b, known, ring)?);
            ring.product(&a, &b)
        }
        Term::Divide(a, b) => {
            let (a, b) = (value(a, known, ring)?, value(b, known, ring)?);
            ring.quotient(&a, &b)
        }
        Term::SquareRoot(square) => {
            let square = value(square, known, ring)?;
            ring.square_root(&square)
        }
    };
    result.map_err(Doubt::Algebra)
}
