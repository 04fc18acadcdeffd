//! The two notations that the parser reads.

use super::{Notation, Strength, decimal, dotted, is_negative};
use crate::algebra::number::Rational;
use crate::language::name::DottedName;
use crate::language::syntax::{BinaryOperator, Expression, Name, Node, Place, Replacement};

/// For a person.
pub(super) const UNICODE: Plain = Plain {
    notation: Notation::Unicode,
    minus: "−",
    times: "·",
    power: "^",
};
/// For Python.
pub(super) const ASCII: Plain = Plain {
    notation: Notation::Ascii,
    minus: "-",
    times: "*",
    power: "**",
};

/// The signs of a notation.
pub(super) struct Plain {
    notation: Notation,
    minus: &'static str,
    times: &'static str,
    power: &'static str,
}

impl Plain {
    pub(super) fn expression(&self, expression: &Expression) -> String {
        match &expression.node {
            Node::Number(number) => self.number(number),
            Node::Name(name) => self.notation.name(name),
            Node::Derivative(name, order) => self.primed(name, *order),
            Node::Negative(operand) => {
                format!("{}{}", self.minus, self.operand(operand, Strength::Power))
            }
            Node::Binary(operator, left, right) => self.binary(*operator, left, right),
            Node::Call {
                function,
                order,
                arguments,
            } => self.special(expression).unwrap_or_else(|| {
                format!(
                    "{}({})",
                    self.primed(function, *order),
                    self.list(arguments)
                )
            }),
            Node::Matrix(rows) => {
                let rows: Vec<_> = rows.iter().map(|row| self.list(row)).collect();
                format!("[{}]", rows.join("; "))
            }
            Node::Index(base, indices) => {
                format!(
                    "{}[{}]",
                    self.operand(base, Strength::Operand),
                    self.list(indices)
                )
            }
            Node::At(inner, place) => {
                format!("{} at {}", self.expression(inner), self.place(place))
            }
        }
    }

    fn binary(&self, operator: BinaryOperator, left: &Expression, right: &Expression) -> String {
        let (sign, weakest_left, weakest_right) = match operator {
            BinaryOperator::Add => (" + ", Strength::Sum, Strength::Product),
            BinaryOperator::Subtract if self.notation == Notation::Ascii => {
                (" - ", Strength::Sum, Strength::Product)
            }
            BinaryOperator::Subtract => (" − ", Strength::Sum, Strength::Product),
            BinaryOperator::Multiply => (self.times, Strength::Product, Strength::Power),
            BinaryOperator::Divide => ("/", Strength::Product, Strength::Power),
            BinaryOperator::Power => return self.power(left, right),
        };
        let left = self.operand(left, weakest_left);
        // `a + -b*c` is grammatical, but nobody writes it.
        let right = if begins_with_sign(right) {
            format!("({})", self.expression(right))
        } else {
            self.operand(right, weakest_right)
        };
        format!("{left}{sign}{right}")
    }

    fn power(&self, base: &Expression, exponent: &Expression) -> String {
        let base = self.operand(base, Strength::Operand);
        if let Some(raised) = self.superscript(exponent) {
            return base + &raised;
        }
        format!(
            "{base}{}{}",
            self.power,
            self.operand(exponent, Strength::Power)
        )
    }

    /// `⁻²`, for an integer in Unicode.
    fn superscript(&self, exponent: &Expression) -> Option<String> {
        let (number, is_negated) = match &exponent.node {
            Node::Number(number) => (number, is_negative(number)),
            Node::Negative(inner) => match &inner.node {
                Node::Number(number) if !is_negative(number) => (number, true),
                _ => return None,
            },
            _ => return None,
        };
        if self.notation == Notation::Ascii || !number.is_int() {
            return None;
        }
        let sign = if is_negated { "⁻" } else { "" };
        Some(
            sign.chars()
                .chain(decimal(number)?.chars().map(raised))
                .collect(),
        )
    }

    /// What Unicode has a sign for: `ẋ`, `√(x)`, `|M|`.
    fn special(&self, call: &Expression) -> Option<String> {
        if self.notation == Notation::Ascii {
            return None;
        }
        if let Some((name, dots)) = dotted(call) {
            return Some(DottedName::write(&name.unicode, dots));
        }
        let Node::Call {
            function,
            order: 0,
            arguments,
        } = &call.node
        else {
            return None;
        };
        match (function.ascii.as_str(), arguments.as_slice()) {
            ("sqrt", [argument]) => Some(format!("√({})", self.expression(argument))),
            ("det", [argument]) => Some(format!("|{}|", self.expression(argument))),
            _ => None,
        }
    }

    /// `C_D″` or `d2C_D`.
    fn primed(&self, name: &Name, order: u32) -> String {
        let count = usize::try_from(order).unwrap_or(usize::MAX);
        match (self.notation, order) {
            (_, 0) => self.notation.name(name),
            (Notation::Ascii, 1) => format!("d{}", name.ascii),
            (Notation::Ascii, _) => format!("d{order}{}", name.ascii),
            _ => format!(
                "{}{}{}",
                name.unicode,
                "″".repeat(count / 2),
                "′".repeat(count % 2)
            ),
        }
    }

    fn number(&self, number: &Rational) -> String {
        match decimal(number) {
            Some(digits) if is_negative(number) => format!("{}{digits}", self.minus),
            Some(digits) => digits,
            None => self.notation.number(number),
        }
    }

    fn list(&self, expressions: &[Expression]) -> String {
        let written: Vec<_> = expressions
            .iter()
            .map(|expression| self.expression(expression))
            .collect();
        written.join(", ")
    }

    fn place(&self, place: &Place) -> String {
        match place {
            Place::Named(name) => self.notation.name(&name.value),
            Place::Replacements(replacements) => {
                let written: Vec<_> = replacements
                    .iter()
                    .map(|one| self.replacement(one))
                    .collect();
                format!("({})", written.join(", "))
            }
        }
    }

    fn replacement(&self, replacement: &Replacement) -> String {
        format!(
            "{} = {}",
            self.expression(&replacement.target),
            self.expression(&replacement.value)
        )
    }

    /// An operand, in brackets if it binds more loosely than it must.
    fn operand(&self, expression: &Expression, weakest: Strength) -> String {
        if Strength::of(expression) < weakest {
            format!("({})", self.expression(expression))
        } else {
            self.expression(expression)
        }
    }
}

/// Whether the first thing that is written of an expression is a minus sign.
fn begins_with_sign(expression: &Expression) -> bool {
    match &expression.node {
        Node::Negative(_) => true,
        Node::Number(number) => is_negative(number),
        Node::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, left, _) => {
            begins_with_sign(left)
        }
        _ => false,
    }
}

fn raised(digit: char) -> char {
    match digit {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    }
}
