//! Programs run over the rationals.

use std::convert::Infallible;

use dashu_base::{BitTest, Sign, SquareRootRem};
use dashu_int::UBig;
use dashu_ratio::Relaxed;

use crate::program::{Program, Rational};

use super::Arithmetic;

/// Exact numbers; none where a divisor is 0 or a root has no value, so that one output may have a value
/// where another has none.
#[derive(Clone, Copy, Debug)]
pub struct Rationals {
    /// What becomes of a root that is not rational.
    pub roots: Roots,
}

/// What becomes of a root that is not rational.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Roots {
    /// It has no value.
    Exact,
    /// It is taken to this many bits from below; only one that is not real has no value.
    Bits(usize),
}

/// A fraction that need not be in lowest terms: a greatest common divisor costs more than a product.
type Value = Option<Relaxed>;

/// Fractions are reduced only when they get longer than this.
const LONG: usize = 4096;

impl Arithmetic for Rationals {
    type Value = Value;
    type Error = Infallible;

    fn constant(&mut self, value: &Rational) -> Result<Value, Infallible> {
        Ok(Some(value.clone().relax()))
    }

    fn negative(&mut self, a: &Value) -> Result<Value, Infallible> {
        Ok(a.as_ref().map(|a| -a.clone()))
    }

    fn sum(&mut self, a: &Value, b: &Value) -> Result<Value, Infallible> {
        Ok(both(a, b).map(|(a, b)| shortened(a + b)))
    }

    fn difference(&mut self, a: &Value, b: &Value) -> Result<Value, Infallible> {
        Ok(both(a, b).map(|(a, b)| shortened(a - b)))
    }

    fn product(&mut self, a: &Value, b: &Value) -> Result<Value, Infallible> {
        Ok(both(a, b).map(|(a, b)| shortened(a * b)))
    }

    fn quotient(&mut self, a: &Value, b: &Value) -> Result<Value, Infallible> {
        let divisible = both(a, b).filter(|(_, b)| !b.is_zero());
        Ok(divisible.map(|(a, b)| shortened(a / b)))
    }

    fn square_root(&mut self, a: &Value) -> Result<Value, Infallible> {
        let root = a.as_ref().and_then(|a| root(a, self.roots));
        Ok(root.map(shortened))
    }
}

fn both<'v>(a: &'v Value, b: &'v Value) -> Option<(&'v Relaxed, &'v Relaxed)> {
    a.as_ref().zip(b.as_ref())
}

fn shortened(value: Relaxed) -> Relaxed {
    match value.denominator().bit_len() > LONG {
        true => value.canonicalize().relax(),
        false => value,
    }
}

/// √(p/q) = √(pq)/q, from below.
fn root(value: &Relaxed, roots: Roots) -> Value {
    // An exact root is found in lowest terms, where both parts are squares.
    let value = value.clone().canonicalize();
    let (sign, above) = value.numerator().clone().into_parts();
    if sign == Sign::Negative && !value.is_zero() {
        return None;
    }
    let below = value.denominator().clone();
    let product = above * &below;
    let shift = match roots {
        Roots::Exact => 0,
        Roots::Bits(bits) => bits.saturating_sub(product.bit_len() / 2),
    };
    let (root, rest) = (product << (2 * shift)).sqrt_rem();
    let is_wanted = rest == UBig::ZERO || roots != Roots::Exact;
    is_wanted.then(|| Relaxed::from_parts(root.into(), below << shift))
}

/// The outputs over the rationals; none where a divisor is 0 or a root is not rational.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate_exactly(program: &Program, inputs: &[Rational]) -> Vec<Option<Rational>> {
    outputs(program, inputs, Roots::Exact)
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
    outputs(program, inputs, Roots::Bits(bits))
}

fn outputs(program: &Program, inputs: &[Rational], roots: Roots) -> Vec<Option<Rational>> {
    let inputs = inputs.iter().map(|input| Some(input.clone().relax()));
    let inputs: Vec<Value> = inputs.collect();
    let Ok(outputs) = program.run(&mut Rationals { roots }, &inputs);
    let outputs = outputs.into_iter();
    outputs
        .map(|output| output.map(Relaxed::canonicalize))
        .collect()
}
