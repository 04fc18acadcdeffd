//! Units of measurement, as products of powers of the SI base units.

use std::collections::BTreeMap;
use std::fmt;

use crate::algebra::number::{Integer, Rational};

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::expression_parser::parse_expression;
use super::syntax::{BinaryOperator, Expression, Name, Node, Spanned};

/// Π uᵢ^qᵢ of base units uᵢ with rational exponents qᵢ ≠ 0; rad counts as 1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    exponents: BTreeMap<&'static str, Rational>,
}

/// The base units, and those made of them: name, and exponents of kg, m, s, A, K.
const UNITS: [(&str, [i8; 5]); 17] = [
    ("kg", [1, 0, 0, 0, 0]),
    ("m", [0, 1, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0]),
    ("A", [0, 0, 0, 1, 0]),
    ("K", [0, 0, 0, 0, 1]),
    ("rad", [0, 0, 0, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0]),
    ("N", [1, 1, -2, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0]),
    ("J", [1, 2, -2, 0, 0]),
    ("W", [1, 2, -3, 0, 0]),
    ("C", [0, 0, 1, 1, 0]),
    ("V", [1, 2, -3, -1, 0]),
    ("F", [-1, -2, 4, 2, 0]),
    ("ohm", [1, 2, -3, -2, 0]),
    ("H", [1, 2, -2, -2, 0]),
    ("T", [1, 0, -2, -1, 0]),
];

impl Unit {
    /// 1: a pure number.
    pub fn one() -> Self {
        Unit::default()
    }

    /// s: a second.
    pub fn second() -> Self {
        Unit {
            exponents: BTreeMap::from([("s", Rational::ONE)]),
        }
    }

    fn named(name: &str) -> Option<Self> {
        let (_, exponents) = UNITS.iter().find(|(known, _)| *known == name)?;
        let bases = UNITS.iter().map(|(base, _)| *base);
        let powers = bases.zip(exponents).filter(|(_, exponent)| **exponent != 0);
        Some(Unit {
            exponents: powers.map(|(base, e)| (base, Rational::from(*e))).collect(),
        })
    }

    /// The exponents of kg, m, s, A and K, if they are whole.
    pub fn exponents(&self) -> Option<[i64; 5]> {
        let mut exponents = [0; 5];
        for ((base, _), exponent) in UNITS.iter().zip(&mut exponents) {
            let own = self.exponents.get(base).cloned().unwrap_or_default();
            *exponent = i64::try_from(own.numerator())
                .ok()
                .filter(|_| own.is_int())?;
        }
        Some(exponents)
    }

    /// The unit of a product.
    pub fn product(&self, other: &Self) -> Self {
        let mut exponents = self.exponents.clone();
        for (base, exponent) in &other.exponents {
            *exponents.entry(base).or_default() += exponent;
        }
        exponents.retain(|_, exponent| !exponent.is_zero());
        Unit { exponents }
    }

    /// The unit of a power.
    pub fn power(&self, exponent: &Rational) -> Self {
        let mut exponents = self.exponents.clone();
        exponents.values_mut().for_each(|known| *known *= exponent);
        exponents.retain(|_, exponent| !exponent.is_zero());
        Unit { exponents }
    }

    /// The unit of a reciprocal.
    pub fn inverse(&self) -> Self {
        self.power(&-Rational::ONE)
    }

    /// The unit that a document writes, such as `kg/m` or `N*s/m^2`.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] at the text where it is no product of powers of known units.
    pub fn parse(text: &Spanned<String>) -> Result<Self, Diagnostic> {
        let wrong = |what: String| {
            let known: Vec<&str> = UNITS.iter().map(|(name, _)| *name).collect();
            Diagnostic::new(DiagnosticKind::Unit, text.span.clone(), what)
                .with_label("not a unit")
                .with_help(format!(
                    "write a product of powers of {}, or 1",
                    known.join(", ")
                ))
        };
        let expression = parse_expression(&text.value)
            .map_err(|_| wrong(format!("`{}` is not a unit", text.value)))?;
        Unit::of_expression(&expression).map_err(wrong)
    }

    fn of_expression(expression: &Expression) -> Result<Self, String> {
        match &expression.node {
            Node::Number(number) if *number == Rational::ONE => Ok(Unit::one()),
            Node::Name(name) => Unit::named(&name.ascii).ok_or_else(|| unknown(name)),
            Node::Binary(BinaryOperator::Multiply, left, right) => {
                Ok(Unit::of_expression(left)?.product(&Unit::of_expression(right)?))
            }
            Node::Binary(BinaryOperator::Divide, left, right) => {
                Ok(Unit::of_expression(left)?.product(&Unit::of_expression(right)?.inverse()))
            }
            Node::Binary(BinaryOperator::Power, base, exponent) => {
                let exponent = match &exponent.node {
                    Node::Number(exponent) => exponent.clone(),
                    Node::Negative(inner) => match &inner.node {
                        Node::Number(exponent) => -exponent.clone(),
                        _ => return Err("the exponent of a unit is a number".into()),
                    },
                    _ => return Err("the exponent of a unit is a number".into()),
                };
                Ok(Unit::of_expression(base)?.power(&exponent))
            }
            _ => Err("a unit is a product of powers of units".into()),
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = |above: bool| -> Vec<String> {
            let powers = self
                .exponents
                .iter()
                .filter(|(_, e)| (**e > Rational::ZERO) == above);
            powers
                .map(|(base, exponent)| {
                    let size = if above { exponent.clone() } else { -exponent };
                    match i64::try_from(size.numerator()) {
                        Ok(1) if size.is_int() => (*base).to_string(),
                        Ok(n) if size.is_int() => format!("{base}{}", superscript(n)),
                        _ => format!("{base}^({size})"),
                    }
                })
                .collect()
        };
        let (above, below) = (side(true), side(false));
        let above = if above.is_empty() {
            "1".to_string()
        } else {
            above.join("·")
        };
        match below.len() {
            0 => formatter.write_str(&above),
            1 => write!(formatter, "{above}/{}", below[0]),
            _ => write!(formatter, "{above}/({})", below.join("·")),
        }
    }
}

/// Why a name is no unit; `kPa` has a prefix.
fn unknown(name: &Name) -> String {
    let written = &name.unicode;
    let mut letters = written.chars();
    let is_prefix = letters
        .next()
        .is_some_and(|first| "GMkhdcmμµn".contains(first));
    let unit = letters.as_str();
    if is_prefix && Unit::named(unit).is_some() {
        return format!(
            "`{written}` is not the name of a unit: prefixes are not known; write `{unit}`, and numbers in it"
        );
    }
    format!("`{written}` is not the name of a unit")
}

fn superscript(number: i64) -> String {
    let digits = number.to_string();
    digits
        .chars()
        .map(|digit| {
            "⁰¹²³⁴⁵⁶⁷⁸⁹"
                .chars()
                .nth(digit as usize - '0' as usize)
                .unwrap_or(digit)
        })
        .collect()
}

/// The integer a rational is, if it is one that fits.
pub fn small_integer(number: &Rational) -> Option<i64> {
    number
        .is_int()
        .then(|| i64::try_from(Integer::clone(number.numerator())).ok())
        .flatten()
}
