//! Literals are the numbers that they stand for.

use proptest::prelude::*;
use sextic_codegen::language::literal::{Decimal, Literal};
use sextic_codegen::program::Rational;

use crate::samples::rational;

fn decimals(value: &Rational) -> (Vec<String>, Vec<String>) {
    let literal = Literal::of(value).unwrap();
    let texts = |terms: Vec<sextic_codegen::language::literal::Decimal>| {
        terms.into_iter().map(|term| term.text).collect()
    };
    (texts(literal.above), texts(literal.below))
}

/// The exact value of a decimal number.
fn read(text: &str) -> Rational {
    let (whole, fraction) = text.split_once('.').unwrap();
    let digits: Rational = format!("{whole}{fraction}").parse().unwrap();
    digits / Rational::from(10).pow(fraction.len() as isize)
}

#[test]
fn table() {
    for (value, above, below) in [
        (rational(0, 1), "0.0", ""),
        (rational(2, 1), "2.0", ""),
        (rational(-7, 1), "-7.0", ""),
        (rational(1, 2), "0.5", ""),
        (rational(-3, 8), "-0.375", ""),
        (rational(1, 3), "1.0", "3.0"),
        (rational(-22, 7), "-22.0", "7.0"),
        (rational(1, 10), "1.0", "10.0"),
        (rational(1, 1 << 40), "1.0", "1099511627776.0"),
        (rational((1 << 53) + 1, 1), "9007199254740992.0 1.0", ""),
    ] {
        let (found, under) = decimals(&value);
        assert_eq!(
            (found.join(" ").as_str(), under.join(" ").as_str()),
            (above, below)
        );
    }
    let smallest = Rational::try_from(f64::from_bits(1)).unwrap();
    assert_eq!(Literal::of(&smallest).unwrap().value(), f64::from_bits(1));
    assert_eq!(Literal::of(&Rational::from(2).pow(1024)), None);
    assert_eq!(
        Literal::of(&(Rational::ONE / Rational::from(3).pow(700))),
        None
    );
}

#[test]
fn the_nearest_double_is_short() {
    for (value, text) in [
        ("89/5000", Some("0.0178")),
        ("-1/3", Some("-0.3333333333333333")),
        ("0", Some("0.0")),
        ("1/10000000", Some("1.0e-7")),
        ("3", Some("3.0")),
    ] {
        let found = Decimal::nearest(&value.parse().unwrap());
        assert_eq!(found.map(|decimal| decimal.text).as_deref(), text);
    }
    let ten = Rational::from(10);
    assert_eq!(Decimal::nearest(&ten.pow(400)), None);
    assert_eq!(Decimal::nearest(&-ten.pow(400)), None);
    assert_eq!(Decimal::nearest(&ten.pow(-400)), None);
    assert!(Decimal::nearest(&ten.pow(-320)).is_some());
}

proptest! {
    #[test]
    fn the_nearest_double_is_what_a_compiler_takes(digits: i64, places in -320..280_isize) {
        let value = Rational::from(digits) * Rational::from(10).pow(places);
        let expected: f64 = format!("{digits}e{places}").parse().unwrap();
        match Decimal::nearest(&value) {
            Some(decimal) => {
                prop_assert_eq!(decimal.value, expected);
                prop_assert_eq!(decimal.text.parse::<f64>().unwrap(), expected);
            }
            None => prop_assert!(expected == 0.0 || expected.is_infinite()),
        }
    }

    #[test]
    fn a_reader_and_a_compiler_take_a_literal_for_the_same(above: i128, below in 1..i128::MAX) {
        let value = Rational::from(above) / Rational::from(below);
        let literal = Literal::of(&value).unwrap();
        let sum = |terms: &[sextic_codegen::language::literal::Decimal]| {
            let mut sum = Rational::ZERO;
            for term in terms {
                prop_assert_eq!(term.text.parse::<f64>().unwrap(), term.value);
                prop_assert_eq!(&read(&term.text), &Rational::try_from(term.value).unwrap());
                sum += read(&term.text);
            }
            Ok(sum)
        };
        let (above, below) = (sum(&literal.above)?, sum(&literal.below)?);
        let below = if literal.below.is_empty() { Rational::ONE } else { below };
        prop_assert_eq!(above / below, value);
    }

    #[test]
    fn every_double_is_a_literal(value in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL) {
        let literal = Literal::of(&Rational::try_from(value).unwrap()).unwrap();
        prop_assert_eq!(literal.value(), value);
    }
}
