//! What stands in the body of an emitted function: inputs that are read, numbers that are fixed, and
//! what is computed of them.

use super::Error;
use super::documentation::Parts;
use super::literal::Decimal;
use super::named::Named;
use crate::evaluator::Evaluator;
use crate::optimiser::hoist::still_first;
use crate::optimiser::prune::prune;
use crate::program::{Node, Operation, Program, Rational};

/// The parts of a body.
pub struct Ingredients<'a> {
    /// What is computed, without what no output needs; what rests on fixed inputs alone stands first.
    pub program: Program,
    /// The inputs that it reads: their fields, and the variables that these are read into.
    pub read: Vec<(&'a str, &'a str)>,
    /// The fixed inputs that it uses, as variables, and their numbers.
    pub fixed: Vec<(&'a str, Decimal)>,
}

impl<'a> Ingredients<'a> {
    /// Of an evaluator.
    pub fn of(evaluator: &Evaluator, named: &'a Named) -> Result<Self, Error> {
        let mut program = prune(&evaluator.program);
        let used = used(&program);
        let names = named.inputs.iter().zip(&named.variables);
        let inputs = names.zip(&evaluator.inputs);
        let (mut read, mut fixed) = (Vec::new(), Vec::new());
        for (((field, variable), input), _) in inputs.zip(used).filter(|(_, used)| *used) {
            match input.fixed() {
                Some(known) => fixed.push((variable.as_str(), nearest(&known.value)?)),
                None => read.push((field.as_str(), variable.as_str())),
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

/// The double next to a number that is fixed; not a subnormal one, which has lost digits.
pub fn nearest(value: &Rational) -> Result<Decimal, Error> {
    let found = Decimal::nearest(value);
    let whole = found.filter(|found| found.value == 0.0 || found.value.is_normal());
    whole.ok_or_else(|| Error::Constant(value.to_string()))
}

/// The parts of an evaluator that its documentation names.
pub fn parts<'a>(evaluator: &'a Evaluator, named: &'a Named) -> Result<Parts<'a>, Error> {
    let names = named.inputs.iter().zip(&named.variables);
    let (mut free, mut fixed) = (Vec::new(), Vec::new());
    for ((name, variable), input) in names.zip(&evaluator.inputs) {
        match input.fixed() {
            Some(known) => fixed.push((
                variable.as_str(),
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
        function: &named.function,
        inputs: free,
        fixed,
        outputs: &named.outputs,
    })
}

/// Refuses what has no value at any point. It would be NaN or infinity in some languages, and a
/// `ZeroDivisionError` in Python.
fn check(evaluator: &Evaluator) -> Result<(), Error> {
    let mut values: Vec<Option<f64>> = Vec::new();
    for input in &evaluator.inputs {
        let fixed = input.fixed().map(|fixed| nearest(&fixed.value));
        values.push(fixed.transpose()?.map(|decimal| decimal.value));
    }
    let program = &evaluator.program;
    for operation in &program.operations()[program.inputs().len()..] {
        let value = known(operation, &values);
        let is_divided_by_zero = match operation {
            Operation::Divide(_, below) => values[below.index()] == Some(0.0),
            _ => false,
        };
        if is_divided_by_zero || value.is_some_and(|value| !value.is_finite()) {
            return Err(Error::Fixed(evaluator.name.clone()));
        }
        values.push(value);
    }
    Ok(())
}

/// The value of an operation in doubles, as far as it is the same at all points: 0 times whatever is 0.
fn known(operation: &Operation, values: &[Option<f64>]) -> Option<f64> {
    let of = |node: &Node| values[node.index()];
    match operation {
        Operation::Input(_) => None,
        // One beyond the doubles is found where it is printed.
        Operation::Constant(value) => Decimal::nearest(value).map(|decimal| decimal.value),
        Operation::Add(a, b) => Some(of(a)? + of(b)?),
        Operation::Subtract(a, b) => Some(of(a)? - of(b)?),
        Operation::Multiply(a, b) if of(a) == Some(0.0) || of(b) == Some(0.0) => Some(0.0),
        Operation::Multiply(a, b) => Some(of(a)? * of(b)?),
        Operation::Divide(a, b) => Some(of(a)? / of(b)?),
        Operation::Negative(a) => Some(-of(a)?),
        Operation::SquareRoot(a) => Some(of(a)?.sqrt()),
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
