//! The measure of rounding errors, measured.

use sextic_codegen::program::{Operation, Program, Rational};
use sextic_codegen::rounding::{
    Domain, Interval, Unmeasured, evaluate, evaluate_closely, evaluate_exactly, measure, units,
};

use crate::samples::{self, rational};

fn unit_cube(program: &Program) -> Domain {
    Domain {
        intervals: program
            .inputs()
            .iter()
            .map(|_| Interval { from: 1.0, to: 2.0 })
            .collect(),
        text: "1 to 2".into(),
    }
}

#[test]
fn units_in_the_last_place() {
    for (found, exact, expected) in [
        (1.0, rational(1, 1), 0.0),
        (1.0 + f64::EPSILON, rational(1, 1), 1.0),
        (
            -2.0,
            rational(-2, 1) - Rational::try_from(f64::EPSILON).unwrap(),
            0.5,
        ),
        (f64::from_bits(1), rational(0, 1), 1.0),
        (f64::INFINITY, rational(0, 1), f64::INFINITY),
        (f64::NAN, rational(1, 1), f64::INFINITY),
    ] {
        assert_eq!(units(found, &exact), expected, "{found} {exact}");
    }
}

#[test]
fn one_operation_is_rounded_to_half_a_unit() {
    use Operation::{Add, Divide, Multiply, SquareRoot, Subtract};
    let mut program = Program::new(["a".to_owned(), "b".to_owned()]);
    let (a, b) = (program.input("a").unwrap(), program.input("b").unwrap());
    for operation in [
        Add(a, b),
        Subtract(a, b),
        Multiply(a, b),
        Divide(a, b),
        SquareRoot(a),
    ] {
        let value = program.push(operation);
        program.output("x", value);
    }
    let rounding = measure(&program, &unit_cube(&program), 2000, 1).unwrap();
    // Numbers of one binade have an exact difference.
    assert_eq!(rounding.largest[1], 0.0);
    for place in [0, 2, 3, 4] {
        let largest = rounding.largest[place];
        assert!((0.45..=0.5).contains(&largest), "{place}: {largest}");
    }
    assert_eq!(
        rounding,
        measure(&program, &unit_cube(&program), 2000, 1).unwrap()
    );
    assert_ne!(
        rounding,
        measure(&program, &unit_cube(&program), 2000, 2).unwrap()
    );
}

#[test]
fn several_operations_are_further_off_and_cancellation_is_seen() {
    let program = samples::determinant().program;
    let rounding = measure(&program, &unit_cube(&program), 500, 1).unwrap();
    assert!(
        rounding.largest[0] > 2.0 && rounding.largest[1] < 2.0,
        "{rounding:?}"
    );
}

#[test]
fn roots_that_are_rational_are_exact() {
    let mut program = Program::new(["a".to_owned()]);
    let root = program.push(Operation::SquareRoot(program.input("a").unwrap()));
    program.output("x", root);
    let exactly = |above, below| evaluate_exactly(&program, &[rational(above, below)])[0].clone();
    assert_eq!(exactly(9, 4), Some(rational(3, 2)));
    assert_eq!(exactly(0, 1), Some(rational(0, 1)));
    assert_eq!(exactly(2, 1), None);
    assert_eq!(exactly(-1, 1), None);
    let closely = evaluate_closely(&program, &[rational(2, 1)], 200)[0]
        .clone()
        .unwrap();
    let rest = rational(2, 1) - closely.clone() * closely;
    assert!(rest > Rational::ZERO && rest < Rational::from(2).pow(-190));
    assert_eq!(evaluate(&program, &[2.0]), Some(vec![2.0_f64.sqrt()]));
}

#[test]
fn what_cannot_be_measured_is_an_error() {
    let program = samples::determinant().program;
    let domain = |from, to| Domain {
        intervals: vec![Interval { from, to }; 9],
        text: String::new(),
    };
    let failed = |domain: Domain| measure(&program, &domain, 10, 1).unwrap_err();
    assert_eq!(failed(domain(1.0, 0.0)), Unmeasured::Domain);
    assert_eq!(failed(domain(0.0, f64::INFINITY)), Unmeasured::Domain);
    assert_eq!(failed(domain(0.0, 0.0)), Unmeasured::NoPoint);
    let short = Domain {
        intervals: Vec::new(),
        text: String::new(),
    };
    assert_eq!(failed(short), Unmeasured::Domain);
}
