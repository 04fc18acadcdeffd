//! Points at which the sides of an assertion differ.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use crate::derivation::assertion::{Finding, Outcome};
use crate::derivation::condition::Requirement;
use crate::derivation::evaluation::evaluator::{Evaluator, Failure};
use crate::derivation::expression_parser::parse_expression;
use crate::derivation::scope::Scope;
use crate::derivation::syntax::{Expression, Name, Node, Order};
use crate::derivation::verdict::{Condition, Witness};

use super::points::Points;
use super::sides::{compare, first_difference, sides, small_names};

/// How many points are looked at for a counterexample.
const MOST_POINTS: usize = 160;

/// How many more once one with irrational sides is found.
const MOST_POINTS_AFTER: usize = 64;

/// Why no point shows that the sides of an assertion differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fruitless {
    /// No point satisfies the assumptions.
    NoPoint,
    /// A side has no value at any of the points; the reason at the last of them.
    NoValue(Failure),
    /// The sides have values, but no order.
    NoOrder,
    /// The sides differ where the conditions of the assertion are not met only.
    NoConditions,
    /// They stand in the relation at every point, or nothing was looked for.
    Agreed,
}

/// What became of an assertion at a point.
enum Tried {
    /// The sides differ there.
    Differs(Box<Witness>, Rationality),
    /// They do not, or it does not count.
    Nothing(Fruitless),
}

/// Whether both sides are rational numbers.
type Rationality = bool;

/// The first point at which the sides of what may be refuted differ, one with rational sides if there
/// is one not much later.
pub fn witness<'a>(points: &mut Points<'a>, finding: &'a Finding) -> Result<Witness, Fruitless> {
    if !matches!(finding.outcome, Outcome::Different(_) | Outcome::Open) {
        return Err(Fruitless::Agreed);
    }
    let scope = points.scope;
    let (mut irrational, mut fruitless) = (None, Fruitless::NoPoint);
    let mut most = MOST_POINTS;
    for count in 0..MOST_POINTS {
        let evaluator = points.at(count).filter(|_| count < most);
        let Some(evaluator) = evaluator else { break };
        match at_point(evaluator, finding, scope) {
            Tried::Differs(witness, true) => return Ok(*witness),
            Tried::Differs(witness, false) if irrational.is_none() => {
                irrational = Some(*witness);
                most = count + MOST_POINTS_AFTER;
            }
            Tried::Differs(..) => {}
            Tried::Nothing(why) => fruitless = telling(fruitless, why),
        }
    }
    irrational.ok_or(fruitless)
}

/// Which of two reasons tells more: one point that has a value outweighs those that have none.
fn telling(before: Fruitless, now: Fruitless) -> Fruitless {
    let weight = |why: &Fruitless| match why {
        Fruitless::NoPoint => 0,
        Fruitless::NoValue(_) => 1,
        Fruitless::NoConditions => 2,
        Fruitless::NoOrder => 3,
        Fruitless::Agreed => 4,
    };
    match weight(&now) >= weight(&before) {
        true => now,
        false => before,
    }
}

/// Compares the sides of an assertion at a point that meets its conditions.
fn at_point<'a>(evaluator: &mut Evaluator<'a>, finding: &'a Finding, scope: &Scope) -> Tried {
    let assertion = &finding.assertion;
    let degree = match &finding.outcome {
        Outcome::Different(degree) => *degree,
        _ => None,
    };
    let order = assertion.order.as_ref().filter(|_| degree.is_some());
    let sides = match sides(evaluator, assertion, order) {
        Ok(sides) => sides,
        Err(reason) => return Tried::Nothing(Fruitless::NoValue(reason)),
    };
    let side = sides.into_iter().nth(degree.unwrap_or(0) as usize);
    let Some((left, right)) = side else {
        return Tried::Nothing(Fruitless::Agreed);
    };
    let extension = &evaluator.point().extension;
    match compare(&left, &right, assertion.relation.comparison, extension) {
        Some(false) => {}
        Some(true) => return Tried::Nothing(Fruitless::Agreed),
        None => return Tried::Nothing(Fruitless::NoOrder),
    }
    let drawn = evaluator.point().drawn().clone();
    if !meets(evaluator, &finding.conditions, order) {
        return Tried::Nothing(Fruitless::NoConditions);
    }
    let (row, column) = first_difference(&left, &right).unwrap_or((0, 0));
    let (a, b) = (&left[row][column], &right[row][column]);
    let extension = &evaluator.point().extension;
    let shown = drawn
        .into_iter()
        .filter(|(name, _)| is_shown(name, &finding.names));
    let witness = Witness {
        point: shown
            .map(|(name, value)| (coordinate(&name, scope), value))
            .collect(),
        degree,
        entry: (left.len() > 1 || left[0].len() > 1).then_some((row + 1, column + 1)),
        left: a.display(extension),
        right: b.display(extension),
    };
    let rational = a.as_rational().is_some() && b.as_rational().is_some();
    Tried::Differs(Box::new(witness), rational)
}

/// Whether no condition of an assertion fails at a point; of an approximation, where the small
/// quantities vanish.
fn meets<'a>(
    evaluator: &mut Evaluator<'a>,
    conditions: &'a [Condition],
    order: Option<&Order>,
) -> bool {
    conditions.iter().all(|condition| {
        let value = match order {
            None => evaluator.evaluate(&condition.expression).ok(),
            Some(order) => {
                let parts = evaluator.parts(&condition.expression, &small_names(order), 0);
                parts.ok().and_then(|parts| parts.into_iter().next())
            }
        };
        let value = value.and_then(|value| value.first()?.first().cloned());
        let extension = &evaluator.point().extension;
        value.is_some_and(|value| match condition.requirement {
            Requirement::NonZero => !value.is_zero(),
            Requirement::Positive => {
                let order = extension.order(&value);
                order == Some(Ordering::Greater)
            }
        })
    })
}

/// Whether a point shows a value: its own name is wanted, or it is a value of a function that is.
fn is_shown(value: &str, names: &BTreeSet<String>) -> bool {
    let function = value
        .split_once('(')
        .map(|(function, _)| format!("{function}("));
    names.contains(value) || function.is_some_and(|function| names.contains(&function))
}

/// The expression that a point lists a value for: `m`, `cos(alpha_0)`, `dt(x)`, `dC_D`, `C_D(0)`.
fn coordinate(ascii: &str, scope: &Scope) -> Expression {
    if let Some((function, inner)) = ascii
        .strip_suffix(')')
        .and_then(|call| call.split_once('('))
    {
        return match function {
            "cos" | "sin" | "dt" => {
                Expression::call(Name::new(function), 0, vec![coordinate(inner, scope)])
            }
            _ => {
                let argument = parse_expression(inner);
                let argument = argument.unwrap_or_else(|_| Expression::name(Name::new(inner)));
                let (function, order) = derivative(function, scope);
                Expression::call(function, order, vec![argument])
            }
        };
    }
    match derivative(ascii, scope) {
        (name, 0) => Expression::name(name),
        (name, order) => Expression::made(Node::Derivative(name, order)),
    }
}

/// `dC_D` and `d2C_D` are derivatives of `C_D` unless the document declares something that is called
/// so.
fn derivative(ascii: &str, scope: &Scope) -> (Name, u32) {
    let declared = |ascii: &str| scope.get(&Name::new(ascii)).map(|entry| entry.name.clone());
    if let Some(name) = declared(ascii) {
        return (name, 0);
    }
    let primed = ascii.strip_prefix('d').and_then(|primed| {
        let name = primed.trim_start_matches(|digit: char| digit.is_ascii_digit());
        let order = match primed.strip_suffix(name)? {
            "" => 1,
            digits => digits.parse().ok()?,
        };
        Some((declared(name)?, order))
    });
    primed.unwrap_or((Name::new(ascii), 0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::number::Rational;
    use crate::derivation::notation::Notation;
    use crate::derivation::scope::Meaning;
    use crate::derivation::syntax::Spanned;

    #[test]
    fn coordinates_are_shown_as_the_document_writes_them() {
        let mut scope = Scope::default();
        for value in [
            Name::with_ascii("S_xθ", "S_xt"),
            Name::new("C_D"),
            Name::new("d_1"),
        ] {
            let name = Spanned { value, span: 0..0 };
            let meaning = Meaning::Template {
                arguments: Vec::new(),
                expression: Expression::number(Rational::ZERO),
            };
            scope.declare(&name, meaning, None).unwrap();
        }
        for (ascii, expected) in [
            ("m", "m"),
            ("S_xt", "S_xθ"),
            ("cos(alpha_0)", "cos(α_0)"),
            ("dt(x)", "ẋ"),
            ("dt(dt(theta_d))", "θ̈_d"),
            ("dC_D", "C_D′"),
            ("d2C_D", "C_D″"),
            ("dC_D(2*alpha_0 + theta_0)", "C_D′(2·α_0 + θ_0)"),
            ("d_1", "d_1"),
            ("d", "d"),
        ] {
            let shown = Notation::Unicode.expression(&coordinate(ascii, &scope));
            assert_eq!(shown, expected);
        }
    }
}
