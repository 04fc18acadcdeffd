//! Exact constants as decimal literals.
//!
//! A reader takes a literal for the decimal number that it is, a compiler for the nearest double; every
//! literal printed here is both.

use dashu_base::BitTest;
use dashu_int::IBig;

use crate::program::Rational;

/// Longer expansions are written as quotients.
const LONGEST: usize = 24;

/// A decimal number that is a double.
#[derive(Clone, Debug, PartialEq)]
pub struct Decimal {
    /// Its digits, with a point, and a sign if it is negative.
    pub text: String,
    /// The same number.
    pub value: f64,
}

impl Decimal {
    /// The number with the other sign.
    #[must_use]
    pub fn negated(&self) -> Self {
        let text = match self.text.strip_prefix('-') {
            Some(text) => text.to_owned(),
            None => format!("-{}", self.text),
        };
        Decimal {
            text,
            value: -self.value,
        }
    }

    /// Whether it is below 0.
    pub fn is_negative(&self) -> bool {
        self.value < 0.0
    }

    /// The shortest decimal that a compiler takes for the double next to a number; none if that is
    /// infinite, or 0 for another number.
    pub fn nearest(value: &Rational) -> Option<Self> {
        let double = value.to_f64().value();
        let known = double.is_finite() && (double != 0.0 || value.is_zero());
        known.then(|| Decimal {
            text: pointed(double),
            value: double,
        })
    }

    fn of(value: &Rational) -> Option<Self> {
        let double = value.to_f64().value();
        let exact = double.is_finite() && Rational::try_from(double).ok()? == *value;
        exact.then(|| Decimal {
            text: expansion(value),
            value: double,
        })
    }
}

/// The shortest digits of a double, with a point: `1.0e-5`.
fn pointed(double: f64) -> String {
    let text = format!("{double:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => text,
    }
}

/// A constant: a sum of decimals over a sum of decimals, both exact. Nearly all are a single decimal.
#[derive(Clone, Debug, PartialEq)]
pub struct Literal {
    /// The sum above the line.
    pub above: Vec<Decimal>,
    /// The sum below the line; empty for 1.
    pub below: Vec<Decimal>,
}

impl Literal {
    /// How a constant is written: 2.0, 0.125, 1.0 / 3.0; none if it is beyond the doubles.
    pub fn of(value: &Rational) -> Option<Self> {
        let single = Decimal::of(value).map(|decimal| Literal {
            above: vec![decimal],
            below: Vec::new(),
        });
        match single {
            Some(literal) if literal.above[0].text.len() <= LONGEST => Some(literal),
            single => quotient(value).or(single),
        }
    }

    /// The decimal, if it is only one.
    pub fn single(&self) -> Option<&Decimal> {
        match (self.above.as_slice(), self.below.as_slice()) {
            ([decimal], []) => Some(decimal),
            _ => None,
        }
    }

    /// What the emitted text gives in doubles.
    pub fn value(&self) -> f64 {
        let sum = |terms: &[Decimal]| terms.iter().map(|term| term.value).reduce(|a, b| a + b);
        sum(&self.above).unwrap_or(0.0) / sum(&self.below).unwrap_or(1.0)
    }
}

fn quotient(value: &Rational) -> Option<Literal> {
    let below = IBig::from(value.denominator().clone());
    Some(Literal {
        above: pieces(value.numerator().clone())?,
        below: match below == IBig::ONE {
            true => Vec::new(),
            false => pieces(below)?,
        },
    })
}

/// A whole number as a sum of doubles, the largest first.
fn pieces(mut rest: IBig) -> Option<Vec<Decimal>> {
    let mut pieces = Vec::new();
    loop {
        let nearest = rest.to_f64().value();
        if !nearest.is_finite() {
            return None;
        }
        let piece = IBig::try_from(nearest).ok()?;
        rest -= &piece;
        pieces.push(Decimal::of(&Rational::from(piece))?);
        if rest == IBig::ZERO {
            return Some(pieces);
        }
    }
}

/// All digits of a number whose denominator is a power of two.
fn expansion(value: &Rational) -> String {
    let places = value.denominator().bit_len() - 1;
    let scaled = value.numerator() * IBig::from(5).pow(places);
    let (sign, digits) = match scaled.to_string() {
        text if text.starts_with('-') => ("-", text[1..].to_owned()),
        text => ("", text),
    };
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let fraction = if fraction.is_empty() { "0" } else { fraction };
    format!("{sign}{whole}.{fraction}")
}
