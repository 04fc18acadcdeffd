//! The operations of a text are those of the program whose rounding is measured.
//!
//! Two values are the same here if doubles give the same bits for them. Sums and products commute;
//! a change of sign is exact, so that it moves out of products and quotients, and a − b is a + (−b);
//! operations on numbers alone are numbers. Nothing is associative.

use std::collections::BTreeMap;

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::program::Program;

use crate::algebra::number::{Integer, Rational};

use super::double::nearest;
use super::doubt::Reason;
use super::specification::Specification;

/// Compares the program of a body with that of the evaluator, operation by operation.
///
/// Complexity: n log n for n operations.
///
/// # Errors
///
/// [`Reason`], for the first output that is computed in another way, and a number that is beyond the
/// doubles.
pub fn compare(body: &Program, specification: &Specification) -> Result<(), Reason> {
    let mut values = Values::default();
    let wanted = values.outputs_of(&specification.evaluator.program)?;
    let found = values.outputs_of(body)?;
    for (name, _) in &specification.outputs {
        if wanted.get(name.as_str()) != found.get(name.as_str()) {
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
    Input(String),
    Number(Number),
    Sum(Signed, Signed),
    Product(usize, usize),
    Quotient(usize, usize),
    SquareRoot(Signed),
}

/// All values that are known, of whichever program.
#[derive(Default)]
struct Values {
    known: BTreeMap<Key, usize>,
}

impl Values {
    /// The outputs of a program by name; inputs of one name are one value.
    fn outputs_of<'p>(&mut self, program: &'p Program) -> Result<BTreeMap<&'p str, Value>, Reason> {
        let inputs = program.inputs().iter();
        let inputs: Vec<Value> = inputs
            .map(|name| self.known_as(Key::Input(name.clone())))
            .collect();
        let outputs = program.run(self, &inputs)?;
        let names = program.outputs().iter().map(|(name, _)| name.as_str());
        Ok(names.zip(outputs).collect())
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
    fn signed(&mut self, value: &Value) -> Signed {
        let (key, is_negative) = match value {
            Value::Computed(signed) => return *signed,
            Value::Number(number) if number.exact < Rational::ZERO => {
                (Key::Number(number.negative()), true)
            }
            Value::Number(number) => (Key::Number(number.clone()), false),
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

impl Arithmetic for Values {
    type Value = Value;
    type Error = Reason;

    /// The double itself, or the quotient of the doubles nearest to its two parts in lowest terms.
    fn constant(&mut self, exact: &Rational) -> Result<Value, Reason> {
        let rounded = |part: Rational| nearest(&part).ok_or_else(|| beyond(exact));
        let double = match nearest(exact) {
            Some(double) if double == *exact => double,
            _ => {
                let above = rounded(Rational::from(exact.numerator().clone()))?;
                let below = Integer::from(exact.denominator().clone());
                rounded(above / rounded(Rational::from(below))?)?
            }
        };
        Ok(Value::Number(Number {
            exact: exact.clone(),
            double,
        }))
    }

    fn negative(&mut self, a: &Value) -> Result<Value, Reason> {
        Ok(match a {
            // −0 is another double than 0.
            Value::Number(number) if number.exact == Rational::ZERO => {
                Value::Computed(self.signed(a).negative())
            }
            Value::Number(number) => Value::Number(number.negative()),
            Value::Computed(value) => Value::Computed(value.negative()),
        })
    }

    fn sum(&mut self, a: &Value, b: &Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (a, b) {
            return Number::computed(&a.exact + &b.exact, &a.double + &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        Ok(self.known_as(Key::Sum(a.min(b), a.max(b))))
    }

    fn difference(&mut self, a: &Value, b: &Value) -> Result<Value, Reason> {
        let b = self.negative(b)?;
        self.sum(a, &b)
    }

    fn product(&mut self, a: &Value, b: &Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (a, b) {
            return Number::computed(&a.exact * &b.exact, &a.double * &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        let key = Key::Product(a.place.min(b.place), a.place.max(b.place));
        Ok(self.with_sign(a.is_negative != b.is_negative, key))
    }

    fn quotient(&mut self, a: &Value, b: &Value) -> Result<Value, Reason> {
        if let (Value::Number(a), Value::Number(b)) = (a, b) {
            if b.double == Rational::ZERO || b.exact == Rational::ZERO {
                return Err(Reason::Literal("a number is divided by 0".into()));
            }
            return Number::computed(&a.exact / &b.exact, &a.double / &b.double);
        }
        let (a, b) = (self.signed(a), self.signed(b));
        let key = Key::Quotient(a.place, b.place);
        Ok(self.with_sign(a.is_negative != b.is_negative, key))
    }

    fn square_root(&mut self, a: &Value) -> Result<Value, Reason> {
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
            None => Err(beyond(&exact)),
        }
    }
}

fn beyond(exact: &Rational) -> Reason {
    Reason::Literal(format!("{exact} is beyond the doubles"))
}
