//! Random equations: true ones hold, false ones are refuted by a point at which they fail.

use std::collections::BTreeMap;

use proptest::prelude::*;
use sextic::algebra::number::Rational;
use sextic::language::expression_parser::parse_expression;
use sextic::language::notation::Notation;
use sextic::language::syntax::{BinaryOperator, Expression, Node};
use sextic::verdict::claim::{Coordinate, Verdict};

use super::{audit_text, block};

const PREAMBLE: &str = "parameter p, q : 1 > 0\nparameter x, y : 1\nangle α, β\n";

/// A small expression without divisions that could be by 0: below a line stand positive terms.
fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("p".to_string()),
        Just("q".to_string()),
        Just("x".to_string()),
        Just("y".to_string()),
        Just("sin(α)".to_string()),
        Just("cos(α)".to_string()),
        Just("sin(β)".to_string()),
        Just("cos(β)".to_string()),
        (1..5).prop_map(|n: i32| n.to_string()),
    ];
    leaf.prop_recursive(3, 12, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} + {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} - {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("{a}*{b}")),
            inner.clone().prop_map(|a| format!("({a})^2")),
            inner.clone().prop_map(|a| format!("({a})/(p + q)")),
            inner.prop_map(|a| format!("({a})/(1 + x^2)")),
        ]
    })
}

/// Another way to write the same.
fn rewritten(e: &str, rule: usize) -> String {
    match rule {
        0 => format!("({e})*(sin(α)^2 + cos(α)^2)"),
        1 => format!("({e}) + sin(α + β) - sin(α)*cos(β) - cos(α)*sin(β)"),
        2 => format!("({e}) + 2*sin(α)^2 + cos(2*α) - 1"),
        3 => format!("(({e})*(p + q) + ({e})*x)/(p + q + x)"),
        4 => format!("({e}) + sqrt(p)*sqrt(p) - p"),
        5 => format!("({e})*sqrt(p^2*q)/(p*sqrt(q))"),
        6 => format!("det([{e}, x; 0, 1])"),
        7 => format!("d(x*({}), x) - x*d({}, x)", fixed(e), fixed(e)),
        8 => format!("(t*({})) at (t = 1)", fixed(e)),
        9 => format!("coefficient(({})*(t + 1)^2, t, 2)", fixed(e)),
        10 => format!("truncate(({})/(1 - t), t, 0)", fixed(e)),
        11 => format!("trace(inverse([2, 1; 1, 1])*[2*({e}), {e}; {e}, {e}])/2"),
        _ => format!("({e}) + tan(α)*cot(α) - 1"),
    }
}

fn fixed(e: &str) -> String {
    e.to_string()
}

/// An evaluation of its own, with none of the engine's.
fn value(expression: &Expression, point: &BTreeMap<String, Rational>) -> Option<Rational> {
    let of = |inner: &Expression| value(inner, point);
    Some(match &expression.node {
        Node::Number(number) => number.clone(),
        Node::Name(name) => point.get(&name.ascii)?.clone(),
        Node::Negative(inner) => -of(inner)?,
        Node::Binary(operator, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            match operator {
                BinaryOperator::Add => a + b,
                BinaryOperator::Subtract => a - b,
                BinaryOperator::Multiply => a * b,
                BinaryOperator::Divide if b.is_zero() => return None,
                BinaryOperator::Divide => a / b,
                BinaryOperator::Power => {
                    let exponent = u32::try_from(b.numerator().clone()).ok()?;
                    (0..exponent).fold(Rational::ONE, |power, _| power * &a)
                }
            }
        }
        Node::Call {
            function,
            arguments,
            ..
        } => {
            let [
                Expression {
                    node: Node::Name(angle),
                    ..
                },
            ] = &arguments[..]
            else {
                return None;
            };
            point
                .get(&format!("{}({})", function.ascii, angle.ascii))?
                .clone()
        }
        _ => return None,
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn an_expression_equals_itself_in_other_words(e in expression(), rule in 0..13_usize) {
        let claim = format!("{PREAMBLE}parameter t : 1\nclaim (1): {e} == {}", rewritten(&e, rule));
        let audit = audit_text(&block(&claim)).map_err(TestCaseError::fail)?;
        let verdict = audit.claims[0].verdict;
        prop_assert!(matches!(verdict, Verdict::Holds | Verdict::HoldsWhere), "{claim}: {verdict:?}");
    }

    #[test]
    fn what_is_added_is_found(e in expression(), more in expression()) {
        let (left, right) = (e.clone(), format!("{e} + ({more})"));
        let audit = audit_text(&block(&format!("{PREAMBLE}refute (1): {left} == {right}")))
            .map_err(TestCaseError::fail)?;
        let claim = &audit.claims[0];
        let Some(witness) = &claim.witness else {
            // What was added is 0, as x − x is.
            let zero = audit_text(&block(&format!("{PREAMBLE}claim (1): {more} == 0")));
            let zero = zero.map_err(TestCaseError::fail)?.claims[0].verdict;
            prop_assert!(matches!(zero, Verdict::Holds | Verdict::HoldsWhere), "{right}: {zero:?}");
            return Ok(());
        };
        prop_assert_eq!(claim.verdict, Verdict::Refuted);
        // What an expression does not contain is not listed and may have any value.
        let named = |one: &Coordinate| (Notation::Ascii.expression(&one.name), one.value.clone());
        let mut point: BTreeMap<String, Rational> = witness.point.iter().map(named).collect();
        for name in ["p", "q", "x", "y"] {
            point.entry(name.into()).or_insert(Rational::from(7));
        }
        for angle in ["alpha", "beta"] {
            point.entry(format!("cos({angle})")).or_insert(Rational::from_parts(3.into(), 5_u8.into()));
            point.entry(format!("sin({angle})")).or_insert(Rational::from_parts(4.into(), 5_u8.into()));
            let (c, s) = (&point[&format!("cos({angle})")], &point[&format!("sin({angle})")]);
            prop_assert_eq!(c * c + s * s, Rational::ONE);
        }
        for (side, shown) in [(&left, &witness.left), (&right, &witness.right)] {
            let expression = parse_expression(side).map_err(|e| TestCaseError::fail(format!("{e:?}")))?;
            let found = value(&expression, &point).map(|value| value.to_string());
            prop_assert_eq!(found.as_deref(), Some(shown.as_str()), "{} at {:?}", side, point);
        }
        prop_assert_ne!(&witness.left, &witness.right);
    }
}
