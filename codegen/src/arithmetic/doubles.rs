//! Programs run in doubles.

use std::collections::BTreeMap;

use crate::evaluator::{Circular, Evaluator, Function, Input, Origin};
use crate::language::literal::{Decimal, Literal};
use crate::program::{Program, Rational};

use super::Arithmetic;

/// Doubles, rounded at each operation as the strict text rounds them.
#[derive(Clone, Copy, Debug)]
pub struct Doubles;

/// A constant is beyond the doubles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Beyond;

impl Arithmetic for Doubles {
    type Value = f64;
    type Error = Beyond;

    fn constant(&mut self, value: &Rational) -> Result<f64, Beyond> {
        let literal = Literal::of(value).ok_or(Beyond)?;
        Ok(literal.value())
    }

    fn negative(&mut self, a: &f64) -> Result<f64, Beyond> {
        Ok(-a)
    }

    fn sum(&mut self, a: &f64, b: &f64) -> Result<f64, Beyond> {
        Ok(a + b)
    }

    fn difference(&mut self, a: &f64, b: &f64) -> Result<f64, Beyond> {
        Ok(a - b)
    }

    fn product(&mut self, a: &f64, b: &f64) -> Result<f64, Beyond> {
        Ok(a * b)
    }

    fn quotient(&mut self, a: &f64, b: &f64) -> Result<f64, Beyond> {
        Ok(a / b)
    }

    fn square_root(&mut self, a: &f64) -> Result<f64, Beyond> {
        Ok(a.sqrt())
    }
}

/// The outputs in doubles, bit for bit as the strict text gives them.
///
/// None if a constant is beyond the doubles.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate(program: &Program, inputs: &[f64]) -> Option<Vec<f64>> {
    program.run(&mut Doubles, inputs).ok()
}

/// The outputs of an evaluator in doubles, for its quantities by name: inputs, and angles in radians rather
/// than their sines and cosines. Those that are fixed are not asked for.
///
/// None if a quantity is missing, or a number is beyond the doubles.
pub fn evaluate_at(evaluator: &Evaluator, values: &BTreeMap<String, f64>) -> Option<Vec<f64>> {
    let inputs = evaluator.inputs.iter().map(|input| input_at(input, values));
    evaluate(&evaluator.program, &inputs.collect::<Option<Vec<f64>>>()?)
}

fn input_at(input: &Input, values: &BTreeMap<String, f64>) -> Option<f64> {
    match &input.origin {
        Origin::Given => values.get(&input.quantity.name).copied(),
        Origin::Circular(Circular { function, angle }) => {
            let mut sum = 0.0;
            for (count, name) in angle {
                sum += f64::from(*count) * values.get(name)?;
            }
            Some(match function {
                Function::Cosine => sum.cos(),
                Function::Sine => sum.sin(),
            })
        }
        Origin::Fixed(fixed) => Decimal::nearest(&fixed.value).map(|number| number.value),
    }
}
