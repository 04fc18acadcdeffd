//! Programs run in doubles.

use crate::language::literal::Literal;
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
