//! Mathematics as LaTeX sets it; what follows from the layout needs no brackets.

mod breaking;

use super::{Notation, Strength, decimal, dotted, is_negative};
use crate::algebra::number::Rational;
use crate::language::built_in::{BuiltIn, Declared, Latex};
use crate::language::name::greek::transliterate;
use crate::language::syntax::{BinaryOperator, Expression, Name, Node, Place};
use breaking::brackets;

pub(super) fn expression(expression: &Expression) -> String {
    match &expression.node {
        Node::Number(number) => self::number(number),
        Node::Name(name) => self::name(name),
        Node::Derivative(name, order) => primed(self::name(name), *order),
        Node::Negative(inner) => format!("-{}", unsigned(inner, Strength::Product)),
        Node::Binary(operator, left, right) => binary(*operator, left, right),
        Node::Call {
            function,
            order,
            arguments,
        } => special(expression).unwrap_or_else(|| call(function, *order, arguments)),
        Node::Matrix(rows) => {
            let rows: Vec<_> = rows.iter().map(|row| list(row, " & ")).collect();
            format!(r"\begin{{bmatrix}} {} \end{{bmatrix}}", rows.join(r" \\ "))
        }
        Node::Index(base, indices) => {
            format!("{}_{{{}}}", script_base(base, false), list(indices, ","))
        }
        Node::At(inner, place) => breaking::taken_at(&self::expression(inner), &self::place(place)),
    }
}

/// `ω_n` as `\omega_{n}`; words are set upright below and slanted on the line.
pub(super) fn name(name: &Name) -> String {
    dotted_name(name, 0)
}

fn dotted_name(name: &Name, dots: u32) -> String {
    if let Some((owner, output)) = name.of_output() {
        let owner = owner.ascii.replace('_', r"\_");
        return format!(r"\mathtt{{{owner}}}.{}", self::name(&output));
    }
    let mut segments = name
        .unicode
        .split('_')
        .filter(|segment| !segment.is_empty());
    let base = symbol(segments.next().unwrap_or_default(), "mathit");
    let base = match dots {
        0 => base,
        1 => format!(r"\dot{{{base}}}"),
        _ => format!(r"\ddot{{{base}}}"),
    };
    let below: Vec<_> = segments.map(|segment| symbol(segment, "mathrm")).collect();
    if below.is_empty() {
        base
    } else {
        format!("{base}_{{{}}}", below.join(","))
    }
}

/// A part of a name: a symbol or a word.
fn symbol(segment: &str, alphabet: &str) -> String {
    let is_number = segment.chars().all(|character| character.is_ascii_digit());
    if segment.len() > 1 && segment.is_ascii() && !is_number {
        return format!(r"\{alphabet}{{{segment}}}");
    }
    let letters: Vec<_> = segment.chars().map(letter).collect();
    // Between a command and a letter there must be a space.
    letters.concat().trim_end().to_owned()
}

fn letter(character: char) -> String {
    match (character, transliterate(character)) {
        ('λ', _) => r"\lambda ".to_owned(),
        ('Λ', _) => r"\Lambda ".to_owned(),
        ('ε', _) => r"\varepsilon ".to_owned(),
        ('φ', _) => r"\varphi ".to_owned(),
        ('ο', _) => "o".to_owned(),
        ('Γ' | 'Δ' | 'Θ' | 'Ξ' | 'Π' | 'Σ' | 'Υ' | 'Φ' | 'Ψ' | 'Ω', Some(name)) => {
            format!(r"\{name} ")
        }
        (_, Some(name)) if name.starts_with(|first: char| first.is_ascii_lowercase()) => {
            format!(r"\{name} ")
        }
        // The other capitals look like Latin ones, and LaTeX has no commands for them.
        (_, Some(_)) => format!(r"\mathrm{{{character}}}"),
        (_, None) => character.to_string(),
    }
}

fn binary(operator: BinaryOperator, left: &Expression, right: &Expression) -> String {
    match operator {
        BinaryOperator::Add => {
            format!(
                "{} + {}",
                operand(left, Strength::Sum),
                unsigned(right, Strength::Sum)
            )
        }
        BinaryOperator::Subtract => {
            format!(
                "{} - {}",
                operand(left, Strength::Sum),
                unsigned(right, Strength::Product)
            )
        }
        BinaryOperator::Multiply => {
            let (left, right) = (
                operand(left, Strength::Product),
                unsigned(right, Strength::Product),
            );
            let begins_with_digit = right.starts_with(|first: char| first.is_ascii_digit());
            // A line can be broken at a dot, but not at a space.
            let sign = if begins_with_digit || breaking::is_long(&left) {
                r" \cdot "
            } else {
                r"\,"
            };
            format!("{left}{sign}{right}")
        }
        BinaryOperator::Divide => {
            let factor = unsigned(left, Strength::Product);
            breaking::quotient(&expression(left), &factor, &expression(right))
        }
        BinaryOperator::Power => power(left, &expression(right)),
    }
}

fn power(base: &Expression, exponent: &str) -> String {
    if let Node::Call {
        function,
        order: 0,
        arguments,
    } = &base.node
    {
        let is_plain = exponent.chars().all(|character| character.is_ascii_digit());
        let declared = Declared::of(&function.ascii);
        let call = declared.and_then(|own| own.call(arguments));
        if is_plain && matches!(call, Some(BuiltIn::Circular(..))) {
            return format!(
                r"\{}^{{{exponent}}}{}",
                function.ascii,
                brackets(&list(arguments, ", "))
            );
        }
    }
    format!("{}^{{{exponent}}}", script_base(base, true))
}

/// What can bear an exponent, or an index: (v)₂ is an entry of v, and not what is called v_2.
fn script_base(base: &Expression, may_have_index: bool) -> String {
    let written = expression(base);
    let is_single = match &base.node {
        Node::Name(_) | Node::Index(..) => may_have_index,
        Node::Matrix(_) => true,
        Node::Number(_) => Strength::of(base) == Strength::Operand,
        Node::Call { .. } if dotted(base).is_some() => may_have_index,
        Node::Call { .. } => written.starts_with(r"\sqrt"),
        _ => false,
    };
    if is_single {
        written
    } else {
        brackets(&written)
    }
}

/// What is not written as a call.
fn special(call: &Expression) -> Option<String> {
    if let Some((name, dots)) = dotted(call) {
        return Some(dotted_name(name, dots));
    }
    let Node::Call {
        function,
        order: 0,
        arguments,
    } = &call.node
    else {
        return None;
    };
    let latex = Declared::of(&function.ascii)?.latex;
    Some(match (latex, arguments.as_slice()) {
        (Latex::Root, [square]) => breaking::root(&expression(square)),
        (Latex::Exponent(above), [matrix]) => power(matrix, above),
        (Latex::Rate, [quantity]) => format!(
            r"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}}{}",
            brackets(&expression(quantity))
        ),
        (Latex::Partial, [quantity, variable]) => {
            let variable = expression(variable);
            match &quantity.node {
                Node::Name(quantity) => {
                    format!(
                        r"\frac{{\partial {}}}{{\partial {variable}}}",
                        name(quantity)
                    )
                }
                _ => format!(
                    r"\frac{{\partial}}{{\partial {variable}}}{}",
                    brackets(&expression(quantity))
                ),
            }
        }
        _ => return None,
    })
}

fn call(function: &Name, order: u32, arguments: &[Expression]) -> String {
    let ascii = function.ascii.as_str();
    let is_word = ascii.len() > 1 && function.unicode == ascii && !ascii.contains('_');
    let is_command = Declared::of(ascii).is_some_and(|own| own.latex == Latex::Command);
    let written = if is_command {
        format!(r"\{ascii}")
    } else if is_word {
        format!(r"\mathrm{{{ascii}}}")
    } else {
        name(function)
    };
    primed(written, order) + &brackets(&list(arguments, ", "))
}

fn primed(written: String, order: u32) -> String {
    written + &"'".repeat(usize::try_from(order).unwrap_or(usize::MAX))
}

fn place(place: &Place) -> String {
    match place {
        Place::Named(place) => symbol_of_place(&place.value),
        Place::Replacements(replacements) => {
            let written = replacements.iter().map(|replacement| {
                format!(
                    "{} = {}",
                    expression(&replacement.target),
                    expression(&replacement.value)
                )
            });
            written.collect::<Vec<_>>().join(r",\; ")
        }
    }
}

/// The name of a substitution is a word, not a quantity.
fn symbol_of_place(place: &Name) -> String {
    if place.unicode.is_ascii() {
        format!(r"\mathrm{{{}}}", place.ascii.replace('_', r"\_"))
    } else {
        name(place)
    }
}

fn number(number: &Rational) -> String {
    match decimal(number) {
        Some(digits) if is_negative(number) => format!("-{digits}"),
        Some(digits) => digits,
        None => Notation::Latex.number(number),
    }
}

fn list(expressions: &[Expression], separator: &str) -> String {
    expressions
        .iter()
        .map(expression)
        .collect::<Vec<_>>()
        .join(separator)
}

/// An operand, in brackets if it binds more loosely than it must.
fn operand(inner: &Expression, weakest: Strength) -> String {
    let written = expression(inner);
    if is_looser(inner, weakest) {
        brackets(&written)
    } else {
        written
    }
}

/// An operand behind another sign: in brackets also if it begins with a minus.
fn unsigned(inner: &Expression, weakest: Strength) -> String {
    let written = expression(inner);
    if written.starts_with('-') || is_looser(inner, weakest) {
        brackets(&written)
    } else {
        written
    }
}

/// Whether an operand needs brackets; what is taken at a place is closed in itself by the bar behind it.
fn is_looser(inner: &Expression, weakest: Strength) -> bool {
    let strength = Strength::of(inner);
    strength != Strength::Place && strength < weakest
}
