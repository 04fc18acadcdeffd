//! The parameters of a system: what must be given, and the inputs of its program that follow.

use std::collections::{BTreeMap, BTreeSet};

use sextic_codegen::evaluator::{Circular, Evaluator, Function, Origin};

use crate::algebra::number::Rational;

use super::error::SystemError;

/// The names of what must be given: inputs in the order of the program, then angles whose sines and cosines are inputs.
pub(super) fn names(evaluator: &Evaluator) -> Vec<String> {
    let given = evaluator
        .inputs
        .iter()
        .filter_map(|input| match input.origin {
            Origin::Given => Some(&input.quantity.name),
            Origin::Circular(_) | Origin::Fixed(_) => None,
        });
    let circular = evaluator.inputs.iter().filter_map(|input| input.circular());
    let angles = circular.flat_map(|own| own.angle.iter().map(|(_, name)| name));
    let is_open = |name: &&String| fixed_angle(evaluator, name).is_none();
    let mut known = BTreeSet::new();
    let all = given.chain(angles.filter(is_open));
    all.filter(|name| known.insert(*name)).cloned().collect()
}

fn fixed_angle<'a>(evaluator: &'a Evaluator, name: &str) -> Option<&'a Rational> {
    let fixed = evaluator.angle(name)?.fixed.as_ref();
    fixed.map(|fixed| &fixed.value)
}

/// The parameters of an evaluator, each with its number.
#[derive(Clone, Debug)]
pub(super) struct Parameters<'a> {
    evaluator: &'a Evaluator,
    values: BTreeMap<String, Rational>,
}

impl<'a> Parameters<'a> {
    /// Checks that there is a number for each parameter, and for nothing else.
    pub fn new(
        evaluator: &'a Evaluator,
        values: &BTreeMap<String, Rational>,
    ) -> Result<Self, SystemError> {
        let known = names(evaluator);
        let is_unknown = |name: &&String| !known.contains(name);
        let unknown: Vec<String> = values.keys().filter(is_unknown).cloned().collect();
        if !unknown.is_empty() {
            return Err(SystemError::Unknown {
                names: unknown,
                known,
            });
        }
        let is_missing = |name: &String| !values.contains_key(name);
        let missing: Vec<String> = known.into_iter().filter(is_missing).collect();
        if !missing.is_empty() {
            return Err(SystemError::Missing { names: missing });
        }
        if let Some((name, _)) = values.iter().find(|(_, own)| !is_double(own)) {
            return Err(SystemError::TooLarge { name: name.clone() });
        }
        Ok(Parameters {
            evaluator,
            values: values.clone(),
        })
    }

    /// The inputs of the program in order: `number` of what is given, `circular` of an angle.
    pub fn inputs<T>(
        &self,
        mut number: impl FnMut(&str, &Rational) -> T,
        mut circular: impl FnMut(&Circular, &Rational) -> T,
    ) -> Vec<T> {
        let input = self.evaluator.inputs.iter();
        input
            .map(|input| match &input.origin {
                Origin::Fixed(fixed) => number("", &fixed.value),
                Origin::Circular(own) => circular(own, &self.angle(own)),
                Origin::Given => {
                    let name = &input.quantity.name;
                    number(name, self.values.get(name).unwrap_or(&Rational::ZERO))
                }
            })
            .collect()
    }

    /// The sum of angles whose sine or cosine is an input.
    fn angle(&self, circular: &Circular) -> Rational {
        let part = |(count, name): &(i32, String)| {
            let own = fixed_angle(self.evaluator, name).or_else(|| self.values.get(name));
            Rational::from(*count) * own.unwrap_or(&Rational::ZERO)
        };
        circular
            .angle
            .iter()
            .map(part)
            .fold(Rational::ZERO, |sum, own| sum + own)
    }
}

/// Which of a cosine and a sine an input is.
pub(super) fn chosen<T>(function: Function, [cosine, sine]: [T; 2]) -> T {
    match function {
        Function::Cosine => cosine,
        Function::Sine => sine,
    }
}

/// Whether a number has a double near it.
pub(super) fn is_double(number: &Rational) -> bool {
    let nearest = number.to_f64().value();
    nearest.is_finite() && (number.is_zero() || nearest.is_normal())
}
