//! A body is executed, on whatever values there are: elements of a ring, numbers, operations.

use std::collections::BTreeMap;

use crate::algebra::number::Rational;

use super::constant::Constant;
use super::double::is_double;
use super::doubt::Reason;
use super::reading::names::is_spelling;
use super::reading::{Reading, Term};
use super::specification::Specification;

/// Values that a body can be executed on.
pub trait Domain {
    /// A value.
    type Value: Clone;

    /// An input, by its name in the evaluator.
    fn input(&mut self, name: &str) -> Option<Self::Value>;
    /// A quantity that is fixed, and the literal that stands for it.
    fn constant(&mut self, constant: &Constant, literal: &Rational) -> Self::Value;
    /// A number.
    fn number(&mut self, value: &Rational) -> Self::Value;
    /// −a
    fn negative(&mut self, a: Self::Value) -> Result<Self::Value, Reason>;
    /// a + b
    fn sum(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, Reason>;
    /// a − b
    fn difference(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, Reason>;
    /// a·b
    fn product(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, Reason>;
    /// a/b
    fn quotient(&mut self, a: Self::Value, b: Self::Value) -> Result<Self::Value, Reason>;
    /// √a
    fn square_root(&mut self, a: Self::Value) -> Result<Self::Value, Reason>;
}

/// Executes a body: the values of the outputs, in the order of the evaluator.
///
/// # Errors
///
/// [`Reason`] where an input or output is missing or occurs twice, a name has no value or a second one,
/// a literal is no double, or the values cannot be computed.
pub fn execute<D: Domain>(
    reading: &Reading,
    specification: &Specification,
    domain: &mut D,
) -> Result<Vec<D::Value>, Reason> {
    let mut execution = Execution {
        domain,
        known: BTreeMap::new(),
    };
    let mut read: Vec<&str> = Vec::new();
    for (input, variable) in &reading.inputs {
        let value = execution.domain.input(input);
        let value = value.filter(|_| !read.contains(&input.as_str()));
        let Some(value) = value else {
            let reason = format!("`{input}` is no input, or is read twice");
            return Err(Reason::Interface(reason));
        };
        read.push(input);
        execution.assign(variable, value)?;
    }
    for (variable, term) in &reading.assignments {
        let value = match fixed(variable, specification) {
            Some(constant) => execution.constant(constant, term)?,
            None => execution.value(term)?,
        };
        execution.assign(variable, value)?;
    }
    let mut values: BTreeMap<&str, D::Value> = BTreeMap::new();
    for (output, term) in &reading.outputs {
        let value = execution.value(term)?;
        if values.insert(output, value).is_some() {
            return Err(Reason::Interface(format!(
                "the output `{output}` is given twice"
            )));
        }
    }
    let wanted = specification.outputs.iter().map(|(output, _)| {
        let missing = || Reason::Interface(format!("the output `{output}` is not given"));
        values.remove(output.as_str()).ok_or_else(missing)
    });
    let results = wanted.collect::<Result<_, _>>()?;
    match values.keys().next() {
        Some(surplus) => Err(Reason::Interface(format!("`{surplus}` is no output"))),
        None => Ok(results),
    }
}

/// The constant that a variable is named after.
fn fixed<'s>(variable: &str, specification: &'s Specification) -> Option<&'s Constant> {
    let constants = &specification.constants;
    let is_constant = |name: &str| constants.iter().any(|constant| constant.name == name);
    let is_it = |constant: &&Constant| is_spelling(variable, &constant.name, is_constant);
    constants.iter().find(is_it)
}

struct Execution<'r, 'd, D: Domain> {
    domain: &'d mut D,
    known: BTreeMap<&'r str, D::Value>,
}

impl<'r, D: Domain> Execution<'r, '_, D> {
    fn assign(&mut self, variable: &'r str, value: D::Value) -> Result<(), Reason> {
        match self.known.insert(variable, value) {
            None => Ok(()),
            Some(_) => Err(Reason::Name(format!("`{variable}` is assigned twice"))),
        }
    }

    fn constant(&mut self, constant: &Constant, term: &Term) -> Result<D::Value, Reason> {
        let literal = match term {
            Term::Number(number) => Some(number.clone()),
            Term::Negative(inner) => match inner.as_ref() {
                Term::Number(number) => Some(-number.clone()),
                _ => None,
            },
            _ => None,
        };
        match literal.filter(|literal| constant.may_be(literal)) {
            Some(literal) => Ok(self.domain.constant(constant, &literal)),
            None => Err(Reason::Literal(format!(
                "`{}` is not the number that it is fixed at",
                constant.name
            ))),
        }
    }

    fn value(&mut self, term: &'r Term) -> Result<D::Value, Reason> {
        match term {
            Term::Name(name) => {
                let value = self.known.get(name.as_str()).cloned();
                value.ok_or_else(|| Reason::Name(format!("`{name}` is not assigned before")))
            }
            Term::Number(number) if is_double(number) => Ok(self.domain.number(number)),
            Term::Number(number) => Err(Reason::Literal(format!("{number} is no double"))),
            Term::Negative(a) => {
                let a = self.value(a)?;
                self.domain.negative(a)
            }
            Term::Add(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.domain.sum(a, b)
            }
            Term::Subtract(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.domain.difference(a, b)
            }
            Term::Multiply(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.domain.product(a, b)
            }
            Term::Divide(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.domain.quotient(a, b)
            }
            Term::SquareRoot(a) => {
                let a = self.value(a)?;
                self.domain.square_root(a)
            }
        }
    }
}
