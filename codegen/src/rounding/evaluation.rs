//! A program run in doubles, and over the rationals.

use std::collections::BTreeMap;

use dashu_base::{BitTest, Sign, SquareRootRem};
use dashu_int::UBig;
use dashu_ratio::Relaxed;

use crate::evaluator::{Circular, Evaluator, Function, Input, Origin};
use crate::language::literal::{Decimal, Literal};
use crate::program::{Node, Operation, Program, Rational};

/// The outputs in doubles, bit for bit as the strict text gives them.
///
/// None if a constant is beyond the doubles.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate(program: &Program, inputs: &[f64]) -> Option<Vec<f64>> {
    let doubles = Doubles::new(program)?;
    Some(doubles.outputs(&doubles.values(inputs)))
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

/// The outputs over the rationals; none where a divisor is 0 or a root is not rational.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate_exactly(program: &Program, inputs: &[Rational]) -> Vec<Option<Rational>> {
    exact_values(program, inputs, &Precision::Exact)
}

/// The outputs over the rationals, with roots that are not rational taken to this many bits from below;
/// none where a divisor is 0 or a root is not real.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate_closely(
    program: &Program,
    inputs: &[Rational],
    bits: usize,
) -> Vec<Option<Rational>> {
    exact_values(program, inputs, &Precision::Bits(bits))
}

/// A program whose constants are doubles.
pub(super) struct Doubles<'a> {
    program: &'a Program,
    constants: Vec<f64>,
}

impl<'a> Doubles<'a> {
    /// None if a constant is beyond the doubles.
    pub(super) fn new(program: &'a Program) -> Option<Self> {
        let constant = |operation: &Operation| match operation {
            Operation::Constant(value) => Literal::of(value).map(|literal| literal.value()),
            _ => Some(0.0),
        };
        let constants: Option<Vec<f64>> = program.operations().iter().map(constant).collect();
        constants.map(|constants| Doubles { program, constants })
    }

    /// Every value, in the order of the operations.
    pub(super) fn values(&self, inputs: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.constants.len());
        for (node, operation) in self.program.nodes() {
            let value = match operation {
                Operation::Input(place) => inputs[*place as usize],
                Operation::Constant(_) => self.constants[node.index()],
                Operation::Add(a, b) => values[a.index()] + values[b.index()],
                Operation::Subtract(a, b) => values[a.index()] - values[b.index()],
                Operation::Multiply(a, b) => values[a.index()] * values[b.index()],
                Operation::Divide(a, b) => values[a.index()] / values[b.index()],
                Operation::Negative(a) => -values[a.index()],
                Operation::SquareRoot(a) => values[a.index()].sqrt(),
            };
            values.push(value);
        }
        values
    }

    /// The outputs among all values.
    pub(super) fn outputs(&self, values: &[f64]) -> Vec<f64> {
        let outputs = self.program.outputs().iter();
        outputs.map(|(_, node)| values[node.index()]).collect()
    }
}

/// What becomes of a root that is not rational.
enum Precision {
    /// It has no value.
    Exact,
    /// It is taken to this many bits.
    Bits(usize),
}

/// Fractions are reduced only when they get longer than this: a greatest common divisor costs more than
/// a product.
const LONG: usize = 4096;

fn exact_values(
    program: &Program,
    inputs: &[Rational],
    precision: &Precision,
) -> Vec<Option<Rational>> {
    let mut values: Vec<Option<Relaxed>> = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        let known = |node: &Node| values[node.index()].as_ref();
        let value = match operation {
            Operation::Input(place) => Some(inputs[*place as usize].clone().relax()),
            Operation::Constant(value) => Some(value.clone().relax()),
            Operation::Add(a, b) => known(a).zip(known(b)).map(|(a, b)| a + b),
            Operation::Subtract(a, b) => known(a).zip(known(b)).map(|(a, b)| a - b),
            Operation::Multiply(a, b) => known(a).zip(known(b)).map(|(a, b)| a * b),
            Operation::Divide(a, b) => match known(a).zip(known(b)) {
                Some((a, b)) if !b.is_zero() => Some(a / b),
                _ => None,
            },
            Operation::Negative(a) => known(a).map(|a| -a.clone()),
            Operation::SquareRoot(a) => known(a).and_then(|a| root(a, precision)),
        };
        values.push(
            value.map(|value| match value.denominator().bit_len() > LONG {
                true => value.canonicalize().relax(),
                false => value,
            }),
        );
    }
    let output = |(_, node): &(String, Node)| {
        let value = values[node.index()].clone();
        value.map(Relaxed::canonicalize)
    };
    program.outputs().iter().map(output).collect()
}

/// √(p/q) = √(pq)/q, from below.
fn root(value: &Relaxed, precision: &Precision) -> Option<Relaxed> {
    // An exact root is found in lowest terms, where both parts are squares.
    let value = value.clone().canonicalize();
    let (sign, above) = value.numerator().clone().into_parts();
    if sign == Sign::Negative && !value.is_zero() {
        return None;
    }
    let below = value.denominator().clone();
    let product = above * &below;
    let shift = match precision {
        Precision::Exact => 0,
        Precision::Bits(bits) => bits.saturating_sub(product.bit_len() / 2),
    };
    let (root, rest) = (product << (2 * shift)).sqrt_rem();
    let exact = rest == UBig::ZERO;
    let close = matches!(precision, Precision::Bits(_));
    (exact || close).then(|| Relaxed::from_parts(root.into(), below << shift))
}
