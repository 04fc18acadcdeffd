//! A table of expressions and their canonical forms, read and written as documents are.

use sextic::algebra::arithmetic::Arithmetic;
use sextic::algebra::budget::Budget;
use sextic::algebra::generator::Generator;
use sextic::algebra::sign::Signs;
use sextic::derivation::elaboration::Elaborator;
use sextic::derivation::presentation::Presenter;
use sextic::derivation::scope::{Meaning, SymbolKind};
use sextic::language::expression_parser::parse_expression;
use sextic::language::notation::Notation;
use sextic::language::syntax::{Name, Spanned};
use sextic::language::unit::Unit;

fn elaborator() -> Elaborator {
    let mut elaborator = Elaborator::new(Budget::new(1_000_000));
    let constant = |name: &str| Generator::Constant { name: name.into() };
    let angle = |name: &str| Generator::Angle { name: name.into() };
    let coordinate = |name: &str, angular| Generator::Coordinate {
        name: name.into(),
        order: 0,
        angular,
    };
    for (name, generator, kind, signs) in [
        ("a", constant("a"), SymbolKind::Parameter, Signs::ANY),
        ("b", constant("b"), SymbolKind::Parameter, Signs::ANY),
        ("p", constant("p"), SymbolKind::Parameter, Signs::POSITIVE),
        ("q", constant("q"), SymbolKind::Parameter, Signs::POSITIVE),
        ("α", angle("alpha"), SymbolKind::Angle, Signs::ANY),
        ("β", angle("beta"), SymbolKind::Angle, Signs::ANY),
        (
            "x",
            coordinate("x", false),
            SymbolKind::Coordinate,
            Signs::ANY,
        ),
        (
            "θ",
            coordinate("theta", true),
            SymbolKind::AngularCoordinate,
            Signs::ANY,
        ),
        (
            "i",
            Generator::ImaginaryUnit,
            SymbolKind::Imaginary,
            Signs::ANY,
        ),
    ] {
        let symbol = elaborator.ring.symbol(generator).unwrap();
        elaborator
            .ring
            .assumptions_mut()
            .assume_symbol(symbol, signs);
        let name = Spanned {
            value: Name::new(name),
            span: 0..0,
        };
        let meaning = Meaning::Symbol {
            symbol,
            unit: Unit::default(),
            kind,
        };
        elaborator.scope.declare(&name, meaning, None).unwrap();
    }
    elaborator
}

#[test]
fn normal_forms() {
    let table = include_str!("../../data/ring/normal_forms.txt");
    let rows = table
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    let mut wrong = Vec::new();
    for row in rows {
        let (text, expected) = row.split_once(" = ").expect("expression = form");
        let mut elaborator = elaborator();
        let mut canonical = |text: &str| {
            let expression =
                parse_expression(text).unwrap_or_else(|error| panic!("{text}: {error:?}"));
            let value = elaborator.scalar(&expression);
            let value = value
                .unwrap_or_else(|error| panic!("{text}: {error:?}"))
                .value;
            elaborator.ring.canonical(&value).unwrap()
        };
        // The form first: it has the smaller angles.
        let known = canonical(expected);
        let element = canonical(text);
        let presenter = Presenter {
            ring: &elaborator.ring,
            scope: &elaborator.scope,
        };
        let shown = Notation::Unicode.expression(&presenter.element(&element).unwrap());
        let read = Notation::Unicode.expression(&parse_expression(expected).unwrap());
        let equal = elaborator
            .ring
            .difference(&element, &known)
            .is_ok_and(|zero| zero.is_zero());
        if !equal || element != known || shown != read {
            wrong.push(format!("{text} is {shown}, not {read}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
