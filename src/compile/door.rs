//! The function that takes angles makes the inputs that the document means.

use std::collections::BTreeMap;

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::evaluator::Angle as EmittedAngle;

use crate::algebra::angle::Angle;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::number::Rational;
use crate::algebra::ring::Ring;
use crate::language::syntax::Name;

use super::constant::Constant;
use super::doubt::Reason;
use super::reading::{Door, Source};
use super::resolution::Resolution;
use super::specification::Specification;

/// How often each angle occurs in a sum, by name.
type Sum = BTreeMap<String, Rational>;

/// Checks that every input is what is asked for under its name, or the sine or cosine of the sum of angles
/// that it is in the ring.
///
/// A sum is compared as a sum: that of two angles may be rounded before its cosine is taken.
///
/// # Errors
///
/// [`Reason`], for the first input that is made of something else.
pub fn check(door: &Door, specification: &Specification, ring: &Ring) -> Result<(), Reason> {
    let found = sums(door, specification)?;
    let mut wanted: BTreeMap<&str, &Fraction> = BTreeMap::new();
    for (name, element) in &specification.inputs {
        wanted.insert(name, element);
    }
    for (input, source) in &door.inputs {
        let Some(element) = wanted.remove(input.as_str()) else {
            let reason = format!("`{input}` is no input, or is made twice");
            return Err(Reason::Interface(reason));
        };
        let symbol = ring.as_symbol(element);
        let is_same = match (source, symbol.map(|symbol| ring.generator(symbol))) {
            (Source::Cosine(_), Some(Generator::Cosine { angle }))
            | (Source::Sine(_), Some(Generator::Sine { angle })) => {
                found.get(input) == sum_of(angle, ring).map(Part::Sum).as_ref()
            }
            (_, Some(Generator::Cosine { .. } | Generator::Sine { .. })) => false,
            (Source::Given(asked), _) => asked == input,
            (Source::Cosine(_) | Source::Sine(_), _) => false,
        };
        if !is_same {
            return Err(Reason::Different(input.clone()));
        }
    }
    match wanted.keys().next() {
        Some(missing) => Err(Reason::Interface(format!(
            "the input `{missing}` is not made"
        ))),
        None => Ok(()),
    }
}

/// The sums of angles whose sines and cosines are taken, by the inputs that these become.
fn sums(door: &Door, specification: &Specification) -> Result<BTreeMap<String, Part>, Reason> {
    let angles = &specification.evaluator.angles;
    let open = angles.iter().filter(|angle| angle.fixed.is_none());
    let open = open.map(|angle| angle.quantity.name.as_str());
    let fixed: Vec<Constant> = angles.iter().filter_map(constant).collect();
    let mut resolution = Resolution::of(&door.angles, open, &fixed)?;
    for (input, source) in &door.inputs {
        if let Source::Cosine(term) | Source::Sine(term) = source {
            resolution.output(input, term)?;
        }
    }
    let program = resolution.program;
    let angles = program.inputs().iter();
    let angles: Vec<Part> = angles
        .map(|angle| Part::Sum(Sum::from([(angle.clone(), Rational::ONE)])))
        .collect();
    let sums = program.run(&mut Sums, &angles)?;
    let inputs = program.outputs().iter().map(|(input, _)| input.clone());
    Ok(inputs.zip(sums).collect())
}

/// An angle that is fixed.
fn constant(angle: &EmittedAngle) -> Option<Constant> {
    let value = &angle.fixed.as_ref()?.value;
    Some(Constant {
        name: angle.quantity.name.clone(),
        element: Fraction::constant(value.clone()),
        lower: value.clone(),
        upper: value.clone(),
    })
}

/// The sum that an angle of the ring is; none if it is not one of declared angles.
fn sum_of(angle: &Angle, ring: &Ring) -> Option<Sum> {
    let mut sum = Sum::new();
    for (symbol, count) in angle.coefficients() {
        let Generator::Angle { name } = ring.generator(symbol) else {
            return None;
        };
        sum.insert(Name::new(name).ascii, Rational::from(count.clone()));
    }
    Some(sum)
}

/// A number, or a sum of angles.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    Number(Rational),
    Sum(Sum),
}

/// Sums of angles, as far as doubles give them too: whole factors, and no angle that is added and taken
/// away again. A large multiple that cancels takes all digits with it.
struct Sums;

impl Arithmetic for Sums {
    type Value = Part;
    type Error = Reason;

    fn constant(&mut self, value: &Rational) -> Result<Part, Reason> {
        Ok(Part::Number(value.clone()))
    }

    fn negative(&mut self, a: &Part) -> Result<Part, Reason> {
        Ok(match a {
            Part::Number(number) => Part::Number(-number.clone()),
            Part::Sum(sum) => Part::Sum(scaled(&-Rational::ONE, sum)),
        })
    }

    fn sum(&mut self, a: &Part, b: &Part) -> Result<Part, Reason> {
        match (a, b) {
            (Part::Sum(a), Part::Sum(b)) => together(a, b).map(Part::Sum),
            _ => Err(no_sum()),
        }
    }

    fn difference(&mut self, a: &Part, b: &Part) -> Result<Part, Reason> {
        let b = self.negative(b)?;
        self.sum(a, &b)
    }

    fn product(&mut self, a: &Part, b: &Part) -> Result<Part, Reason> {
        match (a, b) {
            (Part::Number(factor), Part::Sum(sum)) | (Part::Sum(sum), Part::Number(factor))
                if factor.is_int() =>
            {
                Ok(Part::Sum(scaled(factor, sum)))
            }
            _ => Err(Reason::Interface("a product that is no angle".into())),
        }
    }

    fn quotient(&mut self, _: &Part, _: &Part) -> Result<Part, Reason> {
        Err(no_sum())
    }

    fn square_root(&mut self, _: &Part) -> Result<Part, Reason> {
        Err(no_sum())
    }
}

fn scaled(factor: &Rational, sum: &Sum) -> Sum {
    let angles = sum.iter();
    angles
        .map(|(angle, count)| (angle.clone(), count * factor))
        .collect()
}

fn together(a: &Sum, b: &Sum) -> Result<Sum, Reason> {
    let mut sum = a.clone();
    for (angle, count) in b {
        let known = sum.entry(angle.clone()).or_default();
        if &*known * count < Rational::ZERO {
            return Err(Reason::Interface("an angle that cancels".into()));
        }
        *known += count;
    }
    Ok(sum)
}

fn no_sum() -> Reason {
    Reason::Interface("an expression that is no sum of angles".into())
}
