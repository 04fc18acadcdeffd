//! How expressions are written: for a person, for Python, for LaTeX.

mod latex;
mod plain;

use super::syntax::{BinaryOperator, Comparison, Expression, Name, Node, Relation};
use crate::algebra::number::Rational;

/// A way to write expressions.
///
/// What [`Notation::Unicode`] and [`Notation::Ascii`] write of an expression that was parsed is parsed to
/// the same expression, with two exceptions: a name that was declared `as` another is found again only
/// with the document's aliases, and primes are not ASCII (`C_D′` becomes the name `dC_D`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// `ρ·D·U/(8·m)`, `ẋ²`, `√(1 − x)`, `|M|`
    Unicode,
    /// `rho*D*U/(8*m)`, `dt(x)**2`, `sqrt(1 - x)`, `det(M)`
    Ascii,
    /// `\frac{\rho\,D\,U}{8\,m}`, `\dot{x}^{2}`
    Latex,
}

impl Notation {
    /// Writes an expression.
    pub fn expression(self, expression: &Expression) -> String {
        match self {
            Self::Unicode => plain::UNICODE.expression(expression),
            Self::Ascii => plain::ASCII.expression(expression),
            Self::Latex => latex::expression(expression),
        }
    }

    /// Writes a relation; in Unicode and LaTeX equality is `=`.
    pub fn relation(self, relation: &Relation) -> String {
        let left = self.expression(&relation.left);
        let right = self.expression(&relation.right);
        format!("{left} {} {right}", self.comparison(relation.comparison))
    }

    /// Writes an equation that is meant to hold up to an order only.
    pub fn approximation(self, relation: &Relation) -> String {
        let sign = match (self, relation.comparison) {
            (Self::Unicode, Comparison::Equal) => "≈",
            (Self::Latex, Comparison::Equal) => r"\approx",
            (_, comparison) => self.comparison(comparison),
        };
        let left = self.expression(&relation.left);
        format!("{left} {sign} {}", self.expression(&relation.right))
    }

    /// Writes a number as an integer or as a quotient of two.
    pub fn number(self, number: &Rational) -> String {
        let (numerator, denominator) = (number.numerator().to_string(), number.denominator());
        let (sign, digits) = match numerator.strip_prefix('-') {
            None => ("", numerator.as_str()),
            Some(digits) if self == Self::Unicode => ("−", digits),
            Some(digits) => ("-", digits),
        };
        match self {
            _ if number.is_int() => format!("{sign}{digits}"),
            Self::Latex => format!("{sign}\\frac{{{digits}}}{{{denominator}}}"),
            _ => format!("{sign}{digits}/{denominator}"),
        }
    }

    /// Writes a name.
    pub fn name(self, name: &Name) -> String {
        match self {
            Self::Unicode => name.unicode.clone(),
            Self::Ascii => name.ascii.clone(),
            Self::Latex => latex::name(name),
        }
    }

    fn comparison(self, comparison: Comparison) -> &'static str {
        let (unicode, ascii, latex) = match comparison {
            Comparison::Equal => ("=", "==", "="),
            Comparison::Less => ("<", "<", "<"),
            Comparison::LessOrEqual => ("≤", "<=", r"\le"),
            Comparison::Greater => (">", ">", ">"),
            Comparison::GreaterOrEqual => ("≥", ">=", r"\ge"),
        };
        match self {
            Self::Unicode => unicode,
            Self::Ascii => ascii,
            Self::Latex => latex,
        }
    }
}

/// How tightly the outermost sign of an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    /// `a at rest`
    Place,
    /// `a + b`
    Sum,
    /// `a*b`
    Product,
    /// `-a`
    Sign,
    /// `a^b`
    Power,
    /// `a`, `f(a)`, `[a, b]`
    Operand,
}

impl Strength {
    fn of(expression: &Expression) -> Self {
        match &expression.node {
            Node::At(..) => Self::Place,
            Node::Binary(BinaryOperator::Add | BinaryOperator::Subtract, ..) => Self::Sum,
            Node::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => Self::Product,
            Node::Binary(BinaryOperator::Power, ..) => Self::Power,
            Node::Negative(_) => Self::Sign,
            Node::Number(number) => Self::of_number(number),
            _ => Self::Operand,
        }
    }

    fn of_number(number: &Rational) -> Self {
        match decimal(number) {
            None => Self::Product,
            Some(_) if is_negative(number) => Self::Sign,
            Some(_) => Self::Operand,
        }
    }
}

fn is_negative(number: &Rational) -> bool {
    *number < Rational::ZERO
}

/// Whether the name is differentiated by time and nothing else: `ẋ`, `ẍ`; how often.
fn dotted(expression: &Expression) -> Option<(&Name, u32)> {
    let inner = rate_of(expression)?;
    let (name, dots) = match &inner.node {
        Node::Name(name) => (name, 1),
        _ => match &rate_of(inner)?.node {
            Node::Name(name) => (name, 2),
            _ => return None,
        },
    };
    // A dot stands well above a letter, not above the first letter of a word.
    let letter = name.unicode.split('_').next()?;
    (letter.chars().count() == 1).then_some((name, dots))
}

/// `x` of `dt(x)`.
fn rate_of(expression: &Expression) -> Option<&Expression> {
    match &expression.node {
        Node::Call {
            function,
            order: 0,
            arguments,
        } if function.ascii == "dt" => match arguments.as_slice() {
            [argument] => Some(argument),
            _ => None,
        },
        _ => None,
    }
}

/// The digits of a number whose decimal fraction is finite, without its sign.
fn decimal(number: &Rational) -> Option<String> {
    let numerator = number.numerator().to_string();
    let digits = numerator.trim_start_matches('-');
    if number.is_int() {
        return Some(digits.to_owned());
    }
    // A finite decimal fraction times a power of ten is an integer; the power is at most as large as the
    // denominator has bits.
    let mut places = 0;
    let mut scaled = number.clone();
    let most = number.denominator().to_string().len() * 4;
    while !scaled.is_int() {
        if places == most {
            return None;
        }
        scaled *= Rational::from(10);
        places += 1;
    }
    let scaled = scaled.numerator().to_string();
    let padded = format!(
        "{:0>width$}",
        scaled.trim_start_matches('-'),
        width = places + 1
    );
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Some(format!("{whole}.{fraction}"))
}
