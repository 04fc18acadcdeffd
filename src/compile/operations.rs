//! The operations of a text are those of the program whose rounding is measured.
//!
//! Two values are the same here if doubles give the same bits for them. Sums and products commute;
//! a change of sign is exact, so that it moves out of products and quotients, and a − b is a + (−b);
//! operations on numbers alone are numbers. Nothing is associative.

use std::collections::BTreeMap;

use sextic_codegen::program::{Operation, Program};

use crate::algebra::number::{Integer, Rational};

use super::constant::Constant;
use super::double::nearest;
use super::doubt::Reason;
use super::execution::{Domain, execute};
use super::reading::Reading;
use super::specification::Specification;

/// Compares a body with the program of the evaluator, operation by operation.
///
/// Complexity: n log n for n operations.
///
/// # Errors
///
/// [`Reason`], for the first output that is computed in another way, and whatever keeps the body from
/// being executed.
pub fn compare(reading: &Reading, specification: &Specification) -> Result<(), Reason> {
    let program = &specification.evaluator.program;
    let mut values = Values {
        program,
        known: BTreeMap::new(),
    };
    let wanted = values.of_program()?;
    let found = execute(reading, specification, &mut values)?;
    let names = specification.outputs.iter().map(|(name, _)| name);
    for (name, found) in names.zip(&found) {
        if wanted.get(name.as_str()) != Some(found) {
            return Err(Reason::Operations(name.clone()));
        }
    }
    Ok(())
}

/// A value up to its sign, by its number among those that are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Signed {
    is_negative: bool,
    place: usize,
}

/// A number: as it is meant, and the double that is computed for it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Number {
    exact: Rational,
    double: Rational,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Value {
    Number(Number),
    Computed(Signed),
}

/// What is known by its number; the operands of sums and products in order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Input(usize),
    Number(Number),
    Sum(Signed, Signed),
    Product(usize, usize),
    Quotient(usize, usize),
    SquareRoot(Signed),
}

struct Values<'p> {
    program: &'p Program,
    known: BTreeMap<Key, usize>,
}

impl<'p> Values<'p> {
    /// The outputs of the program by name.
    fn of_program(&mut self) -> Result<BTreeMap<&'p str, Value>, Reason> {
        let program = self.program;
        let mut values: Vec<Value> = Vec::with_capacity(program.operations().len());
        for operation in program.operations() {
            let operand = |node: &sextic_codegen::program::Node| values[node.index()].clone();
            let value = match operation {
                Operation::Input(place) => self.known_as(Key::Input(*place as usize)),
                Operation::Constant(value) => Value::Number(constant(value)?),
                Operation::Add(a, b) => self.sum(operand(a), operand(b))?,
                Operation::Subtract(a, b) => self.difference(operand(a), operand(b))?,
                Operation::Multiply(a, b) => self.product(operand(a), operand(b))?,
                Operation::Divide(a, b) => self.quotient(operand(a), operand(b))?,
                Operation::Negative(a) => self.negative(operand(a))?,
                Operation::SquareRoot(a) => self.square_root(operand(a))?,
            };
            values.push(value);
        }
        let outputs = program.outputs().iter();
        Ok(outputs
            .map(|(name, node)| (name.as_str(), values[node.index()].clone()))
            .collect())
    }

    fn known_as(&mut self, key: Key) -> Value {
        let place = self.known.len();
        let place = *self.known.entry(key).or_insert(place);
        Value::Computed(Signed {
            is_negative: false,
            place,
        })
    }

    /// A value by its number; the sign of a number is kept apart as that of any value.
    fn signed(&mut self, value: Value) -> Signed {
        let (key, is_negative) = match value {
            Value::Computed(signed) => return signed,
            Value::Number(number) if number.exact < Rational::ZERO => {
                (Key::Number(number.negative()), true)
            }
            Value::Number(number) => (Key::Number(number), false),
        };
        let place = self.known.len();
        let place = *self.known.entry(key).or_insert(place);
        Signed { is_negative, place }
    }

    fn with_sign(&mut self, is_negative: bool, key: Key) -> Value {
        match self.known_as(key) {
            Value::Computed(value) => Value::Computed(Signed {
                is_negative,
                ..value
            }),
            number => number,
        }
    }
}

impl Domain for Values<'_> {
    type Value = Value;

    fn input(&mut self, name: &str) -> Option<Value> {
        let node = self.program.input(name)?;
        Some(self.known_as(Key::Input(node.index())))
    }

    /// What is fixed in the text alone is an input of the program.
    fn constant(&mut self, constant: &Constant, literal: &Rational) -> Value {
        let input = self.input(&constant.name);
        input.unwrap_or_else(|| self.number(literal))
    }

    fn number(&mut self, value: &Rational) -> Value {
        // A literal beyond the doubles is refused before it comes here.
        let double = nearest(value).unwrap_or(Rational::ZERO);
        Value::Number(Number {
            exact: value.clone(),
            double,
        })
    }

    fn negative(&mut self, a: Value) -> Result<Value, Reason> {
        Ok(match a {
            // −0 is another double than 0.
            Value::Number(number) if number.exact == Rational::ZERO => {
                Value::Computed(self.signed(Value::Number(number)).negative())
            }
            Value::Number(number) => Value::Number(number.negative()),
            Value::Computed(value) => Value::Computed(value.negative()),
        })
    }

    fn sum(&mut self, a: Value, b: Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (&a, &b) {
            return Number::computed(&a.exact + &b.exact, &a.double + &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        Ok(self.known_as(Key::Sum(a.min(b), a.max(b))))
    }

    fn difference(&mut self, a: Value, b: Value) -> Result<Value, Reason> {
        let b = self.negative(b)?;
        self.sum(a, b)
    }

    fn product(&mut self, a: Value, b: Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (&a, &b) {
            return Number::computed(&a.exact * &b.exact, &a.double * &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        let key = Key::Product(a.place.min(b.place), a.place.max(b.place));
        Ok(self.with_sign(a.is_negative != b.is_negative, key))
    }

    fn quotient(&mut self, a: Value, b: Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (&a, &b) {
            if b.double == Rational::ZERO || b.exact == Rational::ZERO {
                return Err(Reason::Literal("a number is divided by 0".into()));
            }
            return Number::computed(&a.exact / &b.exact, &a.double / &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        let key = Key::Quotient(a.place, b.place);
        Ok(self.with_sign(a.is_negative != b.is_negative, key))
    }

    fn square_root(&mut self, a: Value) -> Result<Value, Reason> {
        let a = self.signed(a);
        Ok(self.known_as(Key::SquareRoot(a)))
    }
}

impl Signed {
    fn negative(self) -> Self {
        Signed {
            is_negative: !self.is_negative,
            ..self
        }
    }
}

impl Number {
    fn negative(&self) -> Self {
        Number {
            exact: -self.exact.clone(),
            double: -self.double.clone(),
        }
    }

    /// The result of an operation on numbers, before it is rounded.
    fn computed(exact: Rational, double: Rational) -> Result<Value, Reason> {
        match nearest(&double) {
            Some(double) => Ok(Value::Number(Number { exact, double })),
            None => Err(Reason::Literal(format!("{exact} is beyond the doubles"))),
        }
    }
}

/// A constant of the program: the double itself, or the quotient of the doubles nearest to its two parts
/// in lowest terms.
fn constant(exact: &Rational) -> Result<Number, Reason> {
    let rounded = |part: Rational| {
        nearest(&part).ok_or_else(|| Reason::Literal(format!("{exact} is beyond the doubles")))
    };
    let double = match nearest(exact) {
        Some(double) if double == *exact => double,
        _ => {
            let above = rounded(Rational::from(exact.numerator().clone()))?;
            let below = rounded(Rational::from(Integer::from(exact.denominator().clone())))?;
            rounded(above / below)?
        }
    };
    Ok(Number {
        exact: exact.clone(),
        double,
    })
}
