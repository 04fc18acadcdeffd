//! What the body of an emitted function says, in whichever language.

use std::fmt;

use crate::algebra::number::Rational;

use super::names::{Name, quantity};

/// An expression of an emitted text.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A variable.
    Name(String),
    /// A literal, exactly as it is written.
    Number(Rational),
    /// −a
    Negative(Box<Term>),
    /// a + b
    Add(Box<Term>, Box<Term>),
    /// a − b
    Subtract(Box<Term>, Box<Term>),
    /// a·b
    Multiply(Box<Term>, Box<Term>),
    /// a/b
    Divide(Box<Term>, Box<Term>),
    /// √a
    SquareRoot(Box<Term>),
}

/// The body of an emitted function: what is assigned in order, and what is returned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// The inputs, and the variables that they are read into.
    pub inputs: Vec<(String, String)>,
    /// The variables and their values, in order.
    pub assignments: Vec<(String, Term)>,
    /// The outputs, and their values.
    pub outputs: Vec<(String, Term)>,
}

impl Reading {
    /// A field of the inputs is read into a variable, before anything is computed.
    pub(super) fn load(
        &mut self,
        names: &[Name],
        field: &str,
        variable: String,
        line: usize,
    ) -> Result<(), Unreadable> {
        let refuse = |reason: String| Err(Unreadable { line, reason });
        let Some(quantity) = quantity(names, field) else {
            return refuse(format!("`{field}` is no input"));
        };
        if !self.assignments.is_empty() {
            return refuse(format!("`{field}` is read behind the first value"));
        }
        self.inputs.push((quantity.to_string(), variable));
        Ok(())
    }
}

/// What an input is made of where angles are asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// What is asked for under this name.
    Given(String),
    /// The cosine of an expression of angles.
    Cosine(Term),
    /// The sine of one.
    Sine(Term),
}

/// The function that makes inputs from angles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Door {
    /// The angles that are read, as inputs, and those that are fixed, as assignments.
    pub angles: Reading,
    /// The inputs, and what they are made of.
    pub inputs: Vec<(String, Source)>,
}

/// Why a text could not be read: what was found where something else is expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The line, counted from 1; that of the body where it is not known better.
    pub line: usize,
    /// What was found, in words.
    pub reason: String,
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl std::error::Error for Unreadable {}
