//! Emitted text, read back by parsers that share no code with the printers.

pub mod rust;

use crate::algebra::number::Rational;

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
    /// The fields of the inputs, and the variables that they are read into.
    pub inputs: Vec<(String, String)>,
    /// The variables and their values, in order.
    pub assignments: Vec<(String, Term)>,
    /// The fields of the outputs, and their values.
    pub outputs: Vec<(String, Term)>,
}

/// Why a text could not be read: what was found where something else is expected.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// What was found, in words.
    pub reason: String,
}

impl Unreadable {
    fn new(reason: impl Into<String>) -> Self {
        Unreadable {
            reason: reason.into(),
        }
    }
}

/// The exact value of a decimal literal such as `8.0`, `0.125` or `1e3`.
fn decimal(text: &str) -> Option<Rational> {
    let text = text.replace('_', "");
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text.as_str(), 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let value = Rational::from(digits.parse::<crate::algebra::number::Integer>().ok()?);
    let places = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    if places.unsigned_abs() > 400 {
        return None;
    }
    let scale =
        (0..places.unsigned_abs()).fold(Rational::ONE, |scale, _| scale * Rational::from(10));
    Some(if places < 0 {
        value / scale
    } else {
        value * scale
    })
}
