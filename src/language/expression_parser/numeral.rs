//! Numbers as they are written: exactly.

use crate::algebra::number::{Integer, Rational};

use super::Tree;
use crate::language::cursor::Parsed;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Node, Span};

/// How many digits a number may have.
const MAXIMUM_DIGITS: usize = 1000;

/// The exact value of `0.25`.
pub(super) fn number(text: &str, span: &Span) -> Parsed<Rational> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    if whole.len() + fraction.len() > MAXIMUM_DIGITS {
        let message = format!("a number may have at most {MAXIMUM_DIGITS} digits");
        // The number itself would fill the screen.
        let start = span.start..span.start;
        return Err(Diagnostic::new(DiagnosticKind::Budget, start, message)
            .with_label("this one has more")
            .with_help("write a quotient, a power of 10, or a parameter"));
    }
    let digits = integer(&format!("{whole}{fraction}"), span)?;
    let power_of_ten = integer(&format!("1{}", "0".repeat(fraction.len())), span)?;
    Ok(Rational::from(digits) / Rational::from(power_of_ten))
}

fn integer(digits: &str, span: &Span) -> Parsed<Integer> {
    digits
        .parse()
        .map_err(|_| Diagnostic::syntax(span.clone(), "this is not a number"))
}

/// The exponent that `⁻¹²` stands for.
pub(super) fn superscript(text: &str, span: Span) -> Parsed<Tree> {
    let digits: String = text.chars().filter_map(lowered).collect();
    let value = number(&digits, &span)?;
    let exponent = Tree::leaf(Node::Number(value), span.clone());
    if !text.starts_with('⁻') {
        return Ok(exponent);
    }
    let node = Node::Negative(Box::new(exponent.expression));
    Ok(Tree {
        expression: Expression { node, span },
        height: 2,
    })
}

fn lowered(superscript: char) -> Option<char> {
    Some(match superscript {
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁰' | '⁴'..='⁹' => char::from_digit(u32::from(superscript) - u32::from('⁰'), 10)?,
        _ => return None,
    })
}
