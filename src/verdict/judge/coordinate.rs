//! What an assignment gives a value, as the document writes it.

use crate::derivation::scope::Scope;
use crate::language::expression_parser::parse_expression;
use crate::language::syntax::{Expression, Name, Node};

/// The expression that a point lists a value for: `m`, `cos(alpha_0)`, `dt(x)`, `dC_D`, `C_D(0)`.
pub fn coordinate(ascii: &str, scope: &Scope) -> Expression {
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
    let declared = |ascii: &str| scope.spelled(ascii).map(|entry| entry.name.clone());
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
    use crate::derivation::scope::Meaning;
    use crate::language::notation::Notation;
    use crate::language::syntax::Spanned;

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
                expression: std::sync::Arc::new(Expression::number(Rational::ZERO)),
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
