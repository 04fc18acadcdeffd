//! What stands in the body of an emitted function: inputs that are read, numbers that are fixed, and
//! what is computed of them.

use super::Error;
use super::documentation::Parts;
use super::literal::Decimal;
use super::named::Named;
use crate::evaluator::{Evaluator, Input};
use crate::optimiser::hoist::still_first;
use crate::optimiser::prune::prune;
use crate::program::{Operation, Program, Rational};
use crate::rounding::all_values;

/// The parts of a body.
pub struct Ingredients<'a> {
    /// What is computed, without what no output needs; what rests on fixed inputs alone stands first.
    pub program: Program,
    /// The inputs that it reads.
    pub read: Vec<&'a str>,
    /// The fixed inputs that it uses, and their numbers.
    pub fixed: Vec<(&'a str, Decimal)>,
}

impl<'a> Ingredients<'a> {
    /// Of an evaluator.
    pub fn of(evaluator: &Evaluator, named: &'a Named) -> Result<Self, Error> {
        let mut program = prune(&evaluator.program);
        let used = used(&program);
        let inputs = named.inputs.names.iter().zip(&evaluator.inputs);
        let (mut read, mut fixed) = (Vec::new(), Vec::new());
        for ((name, input), _) in inputs.zip(used).filter(|(_, used)| *used) {
            match input.fixed() {
                Some(known) => fixed.push((name.as_str(), nearest(&known.value)?)),
                None => read.push(name.as_str()),
            }
        }
        if !fixed.is_empty() {
            let free = evaluator.free_inputs();
            program = still_first(
                &program,
                &free.map(|input| input.quantity.name.clone()).collect(),
            );
            check(evaluator)?;
        }
        Ok(Ingredients {
            program,
            read,
            fixed,
        })
    }
}

/// The double next to a number that is fixed.
pub fn nearest(value: &Rational) -> Result<Decimal, Error> {
    Decimal::nearest(value).ok_or_else(|| Error::Constant(value.to_string()))
}

/// The parts of an evaluator that its documentation names.
pub fn parts<'a>(evaluator: &'a Evaluator, named: &'a Named) -> Result<Parts<'a>, Error> {
    let inputs = named.inputs.names.iter().zip(&evaluator.inputs);
    let (mut free, mut fixed) = (Vec::new(), Vec::new());
    for (name, input) in inputs {
        match input.fixed() {
            Some(known) => fixed.push((
                name.as_str(),
                &input.quantity,
                known,
                nearest(&known.value)?,
            )),
            None => free.push((name.as_str(), input)),
        }
    }
    for angle in evaluator.open_angles() {
        if let Some(known) = &angle.fixed {
            let name = angle.quantity.name.as_str();
            fixed.push((name, &angle.quantity, known, nearest(&known.value)?));
        }
    }
    Ok(Parts {
        inputs: free,
        fixed,
        outputs: &named.outputs.names,
    })
}

/// Refuses what has no value at any point. It would be NaN or infinity in some languages, and a
/// `ZeroDivisionError` in Python.
fn check(evaluator: &Evaluator) -> Result<(), Error> {
    let preparation = evaluator.hoisted().preparation;
    let fixed = evaluator.inputs.iter().filter_map(Input::fixed);
    let values: Result<Vec<f64>, Error> = fixed
        .map(|fixed| Ok(nearest(&fixed.value)?.value))
        .collect();
    let Some(values) = all_values(&preparation, &values?) else {
        return Ok(()); // A constant beyond the doubles is found where it is printed.
    };
    match values.iter().all(|value| value.is_finite()) {
        true => Ok(()),
        false => Err(Error::Fixed(evaluator.name.clone())),
    }
}

/// Of each input of a program, whether it is used.
fn used(program: &Program) -> Vec<bool> {
    let mut used = vec![false; program.operations().len()];
    let operands = program.operations().iter().flat_map(Operation::operands);
    for node in operands.chain(program.outputs().iter().map(|(_, node)| *node)) {
        used[node.index()] = true;
    }
    used.truncate(program.inputs().len());
    used
}
