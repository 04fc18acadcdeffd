//! The names that verdicts, expectations and places go by in every view.

use crate::algebra::number::Rational;
use crate::derivation::condition::Condition;
use crate::derivation::condition::Requirement;
use crate::derivation::matching::{Existence, Matched, Row, Singularity};
use crate::language::notation::Notation;
use crate::language::syntax::{BinaryOperator, Expectation, Expression, Label, Node, Sign};
use crate::verdict::claim::{Claim, Coordinate, Verdict};

use super::phrase::Phrase;

/// Beside a claim that its certificate states as a theorem for Coq.
pub const CERTIFIED: &str = "⊢";

/// `(8, printed)` or `[centre of rotation]`, as the document writes it.
pub fn label(label: &Label) -> String {
    label.written()
}

/// One character that stands for a verdict.
pub const fn mark(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds | Verdict::HoldsWhere => "✓",
        Verdict::Approximate => "≈",
        Verdict::Refuted | Verdict::IllFormed => "✗",
        Verdict::Undecided => "?",
        Verdict::Skipped => "–",
    }
}

/// `✓ holds`
pub fn verdict(verdict: Verdict) -> String {
    format!("{} {}", mark(verdict), verdict.text())
}

/// The value that an assignment gives something: `3/5`, `1 + 2*i`.
pub fn assigned(coordinate: &Coordinate, notation: Notation) -> String {
    let real = notation.number(&coordinate.value);
    let Some(imaginary) = &coordinate.imaginary else {
        return real;
    };
    let (minus, times) = match notation {
        Notation::Unicode => ("−", "·"),
        Notation::Ascii => ("-", "*"),
        Notation::Latex => ("-", r"\,"),
    };
    let (sign, size) = match *imaginary < Rational::ZERO {
        true => (minus, -imaginary.clone()),
        false => ("+", imaginary.clone()),
    };
    format!("{real} {sign} {}{times}i", notation.number(&size))
}

/// What the author expects, in the words of a verdict.
pub const fn expectation(expectation: Expectation) -> &'static str {
    match expectation {
        Expectation::Holds => "holds",
        Expectation::Refuted => "refuted",
        Expectation::Approximate => "approximate",
        Expectation::IllFormed => "ill-formed",
    }
}

/// Whether a verdict means that what is asserted is not so.
pub const fn fails(verdict: Verdict) -> bool {
    matches!(verdict, Verdict::Refuted | Verdict::IllFormed)
}

/// Whether a claim has a verdict, and not the one that the author expects.
pub fn is_surprise(claim: &Claim) -> bool {
    claim.verdict != Verdict::Skipped && !claim.as_expected()
}

/// `NOT AS EXPECTED: the document expects “holds”`, of a verdict that the author does not expect.
pub fn surprise(claim: &Claim) -> Option<String> {
    let expected = expectation(claim.expectation);
    is_surprise(claim).then(|| format!("NOT AS EXPECTED: the document expects “{expected}”"))
}

/// What a claim says; an approximation has `≈`.
pub fn statement(claim: &Claim, notation: Notation) -> String {
    match claim.expectation {
        Expectation::Approximate => notation.approximation(&claim.statement),
        _ => notation.relation(&claim.statement),
    }
}

/// `> 0`, `≠ 0`: a declared sign.
pub const fn sign(sign: Sign, notation: Notation) -> &'static str {
    match (sign, notation) {
        (Sign::Positive, _) => "> 0",
        (Sign::NonNegative, Notation::Unicode) => "≥ 0",
        (Sign::NonNegative, Notation::Ascii) => ">= 0",
        (Sign::NonNegative, Notation::Latex) => r"\ge 0",
        (Sign::NonZero, Notation::Unicode) => "≠ 0",
        (Sign::NonZero, Notation::Ascii) => "!= 0",
        (Sign::NonZero, Notation::Latex) => r"\ne 0",
        (Sign::Negative, _) => "< 0",
        (Sign::NonPositive, Notation::Unicode) => "≤ 0",
        (Sign::NonPositive, Notation::Ascii) => "<= 0",
        (Sign::NonPositive, Notation::Latex) => r"\le 0",
    }
}

/// `sin(α_g + θ_0) ≠ 0`
pub fn condition(condition: &Condition, notation: Notation) -> String {
    let expression = notation.expression(&condition.expression);
    let sign = match (condition.requirement, notation) {
        (Requirement::Positive, _) => ">",
        (Requirement::NonZero, Notation::Unicode) => "≠",
        (Requirement::NonZero, Notation::Ascii) => "!=",
        (Requirement::NonZero, Notation::Latex) => r"\ne",
    };
    format!("{expression} {sign} 0")
}

/// `L_g = 0`: where the equations of a matching are singular.
pub fn singularity(singularity: &Singularity, notation: Notation) -> String {
    let equal = if notation == Notation::Ascii {
        "=="
    } else {
        "="
    };
    format!("{} {equal} 0", notation.expression(&singularity.factor))
}

/// What a matching matches: a name that is defined is followed by its definition.
pub fn polynomials(matched: &Matched, notation: Notation) -> (String, String) {
    let write = |expression: &Expression| {
        let written = notation.expression(expression);
        let definition = matched
            .definitions
            .iter()
            .find(|(defined, _)| defined == expression);
        match definition {
            Some((_, definition)) => format!("{written} = {}", notation.expression(definition)),
            None => written,
        }
    };
    (write(&matched.polynomials.0), write(&matched.polynomials.1))
}

/// `λ⁵`, `λ` or `1`: a power of the variable of a matching.
pub fn power(matched: &Matched, power: u32, notation: Notation) -> String {
    let number = |value: u32| Expression::number(value.into());
    let variable = Expression::name(matched.variable.clone());
    notation.expression(&match power {
        0 => number(1),
        1 => variable,
        _ => Expression::binary(BinaryOperator::Power, variable, number(power)),
    })
}

/// What the solution of a matching leaves of a coefficient.
pub fn remainder(matched: &Matched, row: &Row, notation: Notation) -> Phrase {
    match row.order {
        _ if is_zero(&row.residual) => Phrase::of_words("matched exactly"),
        Some(order) => Phrase::of_words(format!("a residual of order {order} in "))
            .list(matched.small.iter().map(|name| notation.name(name)), ", "),
        None => Phrase::of_words("a residual"),
    }
}

/// What becomes of the solution of a matching where its equations are singular.
pub const fn at_singularity(singularity: &Singularity) -> &'static str {
    match singularity.existence {
        Existence::Stays => ", where the solution stays finite",
        Existence::Lost => ", where the solution has no value",
        Existence::Unknown => ", where it is not known whether the solution exists",
    }
}

/// Whether an expression is the number 0.
pub fn is_zero(expression: &Expression) -> bool {
    matches!(&expression.node, Node::Number(number) if *number == Rational::ZERO)
}

/// `1 verdict`, `2 verdicts`
pub fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}
