//! Why an expression is no element of the ring, for the reader of the document.

use crate::algebra::error::AlgebraError;
use crate::derivation::quantity::{QuantityError, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Name, Span};
use crate::language::unit::Unit;

/// What the algebra could not do, at a place of the document.
pub fn algebra(error: AlgebraError, span: &Span) -> Diagnostic {
    let (kind, message, label, help) = match &error {
        AlgebraError::DivisionByZero => (
            DiagnosticKind::DivisionByZero,
            "division by an expression that is identically 0".to_string(),
            "a divisor here is 0",
            "change the expression or the replacement, or cancel what vanishes before it does",
        ),
        AlgebraError::Exhausted(limit) => (
            DiagnosticKind::Budget,
            format!("this is too large to compute: {limit}"),
            "given up here",
            "claim less at once, or let a `parameter` stand for a part: definitions are expanded",
        ),
        AlgebraError::TooManySymbols => (
            DiagnosticKind::Budget,
            "the document has more symbols than the ring can hold".to_string(),
            "no symbol left",
            "split the document",
        ),
        AlgebraError::FractionalAngle => (
            DiagnosticKind::Unsupported,
            "the sine of this angle is no polynomial in the sines used before".to_string(),
            "a fraction of earlier angles",
            "mention the sine or cosine of the smaller angle earlier in the document",
        ),
        AlgebraError::NotAnAngle => (
            DiagnosticKind::Unsupported,
            "sines are taken of sums of angles with whole coefficients".to_string(),
            "not such an angle",
            "declare what stands here with `angle` or as a coordinate in rad",
        ),
        AlgebraError::UnknownSign => (
            DiagnosticKind::Unsupported,
            "the sign below this root, or of the root, cannot be told".to_string(),
            "a root of what may be negative, or of a square whose base may be",
            "state a sign with `parameter … > 0` or `assume … > 0`; for √−1 declare `imaginary i`",
        ),
        AlgebraError::NotReal => (
            DiagnosticKind::Unsupported,
            "this is a complex number, and only real ones have a meaning here".to_string(),
            "not real",
            "roots, angles, functions and inequalities take real numbers: use the real part, or two real \
             parameters for a complex one",
        ),
        AlgebraError::NegativeRadicand => (
            DiagnosticKind::Unsupported,
            "what stands under this root is negative".to_string(),
            "roots are real here",
            "declare `imaginary i` and write `i*sqrt(…)` with the opposite under the root",
        ),
    };
    Diagnostic::new(kind, span.clone(), message)
        .with_label(label)
        .with_help(help)
}

/// What the algebra could not do where it expands in small quantities.
pub fn expansion(error: AlgebraError, small: &[String], span: &Span) -> Diagnostic {
    unexpandable(algebra(error, span), small, span)
}

/// A division by 0 where small quantities vanish is one that leaves no expansion in them.
pub fn unexpandable(error: Diagnostic, small: &[String], span: &Span) -> Diagnostic {
    if error.kind != DiagnosticKind::DivisionByZero {
        return error;
    }
    let (place, first) = (small.join(" = "), small.first());
    let first = first.map_or("x", String::as_str);
    let middle = if first == "a" { "c" } else { "a" };
    let message = format!("this has no expansion where {place} = 0");
    let help = format!(
        "expand about a value other than 0: `(…) at ({first} = {middle} + {first})`, with `parameter {middle} : … > 0`"
    );
    Diagnostic::new(error.kind, span.clone(), message)
        .with_label("it, or a derivative of it, has no value there")
        .with_help(help)
}

/// What the arithmetic of quantities could not do, at a place of the document.
pub fn quantity(error: QuantityError, span: &Span) -> Diagnostic {
    match error {
        QuantityError::Algebra(error) => algebra(error, span),
        QuantityError::Units(a, b) => units(&a, &b, span),
    }
}

/// Quantities of different units were added or compared.
pub fn units(a: &Unit, b: &Unit, span: &Span) -> Diagnostic {
    let message = format!("the units {a} and {b} do not fit together");
    Diagnostic::new(DiagnosticKind::Unit, span.clone(), message)
        .with_label(format!("{a} and {b}"))
        .with_help("only quantities of one unit can be added or compared")
}

/// What the arithmetic of quantities could not do with two expressions.
pub fn sides(
    error: QuantityError,
    left: &Expression,
    right: &Expression,
    span: &Span,
) -> Diagnostic {
    match error {
        QuantityError::Units(a, b) => units(&a, &b, span)
            .with_label("added or compared here")
            .with_secondary(left.span.clone(), a.to_string())
            .with_secondary(right.span.clone(), b.to_string()),
        error => quantity(error, span),
    }
}

/// Matrices do not fit together.
pub fn shape(span: &Span, message: String) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Shape, span.clone(), message)
}

/// Two matrices do not fit together.
pub fn mismatch(
    verb: &str,
    a: &Value,
    b: &Value,
    left: &Expression,
    right: &Expression,
    span: &Span,
) -> Diagnostic {
    let size = |value: &Value| format!("{}×{}", value.rows(), value.columns());
    shape(
        span,
        format!("a {} and a {} matrix cannot be {verb}", size(a), size(b)),
    )
    .with_label("the shapes do not fit")
    .with_help(
        "sums need equal shapes; a product needs as many columns on the left as rows on the right",
    )
    .with_secondary(left.span.clone(), size(a))
    .with_secondary(right.span.clone(), size(b))
}

/// A wrong number of arguments; `usage` is what to write.
pub fn argument_count(
    function: &Name,
    wanted: usize,
    given: usize,
    usage: &str,
    span: &Span,
) -> Diagnostic {
    let message = format!("`{function}` takes {wanted} arguments, not {given}");
    let message = if wanted == 1 {
        message.replace("arguments", "argument")
    } else {
        message
    };
    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
        .with_label(format!("{given} given"))
        .with_help(usage)
}

/// Requires that nothing is named twice.
pub fn different(things: &[(String, Span)]) -> Result<(), Diagnostic> {
    for (place, (thing, span)) in things.iter().enumerate() {
        if let Some((_, earlier)) = things[..place].iter().find(|(known, _)| known == thing) {
            let message = format!("`{thing}` is named twice");
            return Err(
                Diagnostic::new(DiagnosticKind::Duplicate, span.clone(), message)
                    .with_label("the same again")
                    .with_secondary(earlier.clone(), "the first one")
                    .with_help("name it once"),
            );
        }
    }
    Ok(())
}
