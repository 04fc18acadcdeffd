//! The function that takes angles makes the inputs that the document means.

use std::collections::BTreeMap;

use crate::algebra::angle::Angle;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::number::Rational;
use crate::algebra::ring::Ring;
use crate::language::syntax::Name;

use super::constant::Constant;
use super::doubt::Reason;
use super::reading::names::is_spelling;
use super::reading::{Door, Source, Term};
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
    let known = angles(door, specification)?;
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
            (Source::Cosine(term), Some(Generator::Cosine { angle }))
            | (Source::Sine(term), Some(Generator::Sine { angle })) => {
                Some(sum(term, &known)?) == sum_of(angle, ring)
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

/// The variables of the function: angles, those that are fixed among them.
fn angles<'d>(
    door: &'d Door,
    specification: &Specification,
) -> Result<BTreeMap<&'d str, Sum>, Reason> {
    let mut known: BTreeMap<&str, Sum> = BTreeMap::new();
    let mut assign = |variable: &'d str, angle: &str| {
        let sum = Sum::from([(angle.to_string(), Rational::ONE)]);
        match known.insert(variable, sum) {
            None => Ok(()),
            Some(_) => Err(Reason::Name(format!("`{variable}` is assigned twice"))),
        }
    };
    for (angle, variable) in &door.angles.inputs {
        assign(variable, angle)?;
    }
    let all = &specification.evaluator.angles;
    let is_angle = |name: &str| all.iter().any(|angle| angle.quantity.name == name);
    for (variable, term) in &door.angles.assignments {
        let named = all
            .iter()
            .find(|angle| is_spelling(variable, &angle.quantity.name, is_angle));
        let fixed = named.and_then(|angle| Some((&angle.quantity.name, angle.fixed.as_ref()?)));
        let literal = number(term);
        let (Some((name, fixed)), Some(literal)) = (fixed, literal) else {
            return Err(Reason::Name(format!("`{variable}` is no fixed angle")));
        };
        let constant = Constant {
            name: name.clone(),
            element: Fraction::constant(fixed.value.clone()),
            lower: fixed.value.clone(),
            upper: fixed.value.clone(),
        };
        if !constant.may_be(&literal) {
            let reason = format!("`{name}` is not the number that it is fixed at");
            return Err(Reason::Literal(reason));
        }
        assign(variable, name)?;
    }
    Ok(known)
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

/// A number, if a term is one.
fn number(term: &Term) -> Option<Rational> {
    match term {
        Term::Number(number) => Some(number.clone()),
        Term::Negative(inner) => number(inner).map(|number| -number),
        _ => None,
    }
}

/// The sum of angles that a term is, if doubles give it too: whole factors, and no angle that is added and
/// taken away again. A large multiple that cancels takes all digits with it.
fn sum(term: &Term, known: &BTreeMap<&str, Sum>) -> Result<Sum, Reason> {
    let scaled = |factor: Rational, term: &Term| -> Result<Sum, Reason> {
        let mut scaled = sum(term, known)?;
        scaled
            .values_mut()
            .for_each(|count| *count *= factor.clone());
        Ok(scaled)
    };
    let together = |mut left: Sum, right: Sum| {
        for (angle, count) in right {
            let known = left.entry(angle).or_default();
            if known.clone() * count.clone() < Rational::ZERO {
                return Err(Reason::Interface("an angle that cancels".into()));
            }
            *known += count;
        }
        Ok(left)
    };
    match term {
        Term::Name(name) => {
            let angle = known.get(name.as_str()).cloned();
            angle.ok_or_else(|| Reason::Name(format!("`{name}` is not assigned before")))
        }
        Term::Negative(a) => scaled(-Rational::ONE, a),
        Term::Add(a, b) => together(sum(a, known)?, sum(b, known)?),
        Term::Subtract(a, b) => together(sum(a, known)?, scaled(-Rational::ONE, b)?),
        Term::Multiply(a, b) => match (number(a), number(b)) {
            (Some(factor), None) if factor.is_int() => scaled(factor, b),
            (None, Some(factor)) if factor.is_int() => scaled(factor, a),
            _ => Err(Reason::Interface("a product that is no angle".into())),
        },
        Term::Number(_) | Term::Divide(..) | Term::SquareRoot(_) => Err(Reason::Interface(
            "an expression that is no sum of angles".into(),
        )),
    }
}
