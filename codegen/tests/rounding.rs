//! The measure of rounding errors, measured.

use proptest::prelude::*;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::program::{Operation, Program, Rational};
use sextic_codegen::rounding::{
    Domain, Interval, Unmeasured, evaluate, evaluate_closely, evaluate_exactly, measure, units,
};

use crate::laws::drawn;
use crate::samples::{self, rational};

/// An evaluator of a program, and 1 to 2 for each of its inputs.
fn from_1_to_2(program: &Program) -> (Evaluator, Domain) {
    let evaluator = Evaluator::plain("f", program.clone());
    let domain = domain(&evaluator, 1, 2);
    (evaluator, domain)
}

fn domain(evaluator: &Evaluator, from: i64, to: i64) -> Domain {
    let interval = Interval {
        from: rational(from, 1),
        to: rational(to, 1),
    };
    let names = evaluator
        .inputs
        .iter()
        .map(|input| input.quantity.name.clone());
    Domain {
        intervals: names.map(|name| (name, interval.clone())).collect(),
        text: format!("{from} to {to}"),
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
    let (evaluator, domain) = from_1_to_2(&program);
    let rounding = measure(&evaluator, &domain, 2000, 1).unwrap();
    // Numbers of one binade have an exact difference.
    assert_eq!(rounding.largest[1], 0.0);
    for place in [0, 2, 3, 4] {
        let largest = rounding.largest[place];
        assert!((0.45..0.500_001).contains(&largest), "{place}: {largest}");
    }
    assert_eq!(rounding, measure(&evaluator, &domain, 2000, 1).unwrap());
    assert_ne!(rounding, measure(&evaluator, &domain, 2000, 2).unwrap());
}

#[test]
fn several_operations_are_further_off_and_cancellation_is_seen() {
    let evaluator = samples::determinant();
    let rounding = measure(&evaluator, &domain(&evaluator, 1, 2), 500, 1).unwrap();
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
    let evaluator = samples::determinant();
    let failed = |domain: &Domain| measure(&evaluator, domain, 10, 1).unwrap_err();
    assert_eq!(failed(&domain(&evaluator, 1, 0)), Unmeasured::Domain);
    assert_eq!(failed(&domain(&evaluator, 0, 0)), Unmeasured::NoPoint);
    let mut huge = domain(&evaluator, 0, 1);
    let interval = huge.intervals.get_mut("m_22").unwrap();
    interval.to = Rational::from(10).pow(400);
    assert_eq!(failed(&huge), Unmeasured::Domain);
    huge.intervals.remove("m_22");
    assert_eq!(failed(&huge), Unmeasured::Domain);
    let points = measure(&evaluator, &domain(&evaluator, 1, 2), 0, 1);
    assert_eq!(points.unwrap_err(), Unmeasured::NoPoint);
}

#[test]
fn circular_inputs_are_points_of_the_circle_and_constants_are_doubles() {
    let evaluator = samples::rod();
    // Outputs that are 0 up to rounding if cosine and sine belong to one angle.
    let mut program = Program::new(evaluator.program.inputs().iter().cloned());
    let input = |name: &str| program.input(name).unwrap();
    let (cosine, sine) = (
        input("cos_alpha_g_plus_theta_0"),
        input("sin_alpha_g_plus_theta_0"),
    );
    let (r, ratio) = (input("r"), input("k"));
    let square = program.push(Operation::Multiply(cosine, cosine));
    let other = program.push(Operation::Multiply(sine, sine));
    let length = program.push(Operation::Add(square, other));
    for (name, node) in [("length", length), ("r", r), ("ratio", ratio)] {
        program.output(name, node);
    }
    let mut circle = Evaluator::plain("circle", program);
    circle.inputs.clone_from(&evaluator.inputs);
    circle.angles.clone_from(&evaluator.angles);
    let rounding = measure(&circle, &domain(&circle, 1, 2), 1000, 1).unwrap();
    // The sum is 1 up to some units; it is rounded once or twice more.
    assert!(rounding.largest[0] <= 2.0, "{rounding:?}");
    assert_eq!(rounding.largest[1..], [0.0, 0.0]);
    // Only what is given needs an interval.
    let mut lengths = domain(&evaluator, 1, 2);
    lengths.intervals.retain(|name, _| name == "L");
    assert!(measure(&evaluator, &lengths, 100, 1).is_ok());
}

#[test]
fn the_percentile_leaves_out_one_point_of_a_hundred() {
    // x − 1 is exact, but for the rounding of a third.
    let mut program = Program::new(["x".to_owned()]);
    let third = program.constant(rational(1, 3));
    let value = program.push(Operation::Subtract(program.input("x").unwrap(), third));
    program.output("y", value);
    let evaluator = Evaluator::plain("f", program);
    let rounding = measure(&evaluator, &domain(&evaluator, 0, 1), 20_000, 3).unwrap();
    assert!(rounding.largest[0] > 1000.0, "{rounding:?}");
    assert!(rounding.percentile_99[0] < 100.0, "{rounding:?}");
}

proptest! {
    /// The error at one point is the distance of the double from the rational, whichever way it was found.
    #[test]
    fn an_error_is_the_distance_from_the_exact_value(
        program in drawn(),
        point in prop::collection::vec(number(), 3),
    ) {
        let evaluator = Evaluator::plain("f", program.clone());
        let exact: Vec<Rational> = point
            .iter()
            .map(|value| Rational::try_from(*value).unwrap())
            .collect();
        let names = ["x", "y", "z"].map(str::to_owned);
        let interval = |value: &Rational| Interval { from: value.clone(), to: value.clone() };
        let domain = Domain {
            intervals: names.into_iter().zip(exact.iter().map(interval)).collect(),
            text: String::new(),
        };
        let found = evaluate(&program, &point).unwrap();
        let exact = evaluate_closely(&program, &exact, 500);
        let pairs = found.iter().zip(exact);
        let errors: Option<Vec<f64>> = pairs
            .map(|(found, exact)| Some(units(*found, &exact?)))
            .collect();
        match (measure(&evaluator, &domain, 1, 1), errors) {
            (Ok(rounding), Some(errors)) => {
                for (measured, error) in rounding.largest.iter().zip(errors) {
                    let close = (measured - error).abs() <= 2e-6 * error.max(1.0);
                    prop_assert!(close || *measured == error, "{measured} is not {error}");
                }
            }
            (Err(Unmeasured::NoPoint), None) => {}
            // Roots that cancel are known to no number of bits.
            (Err(Unmeasured::NoPoint), Some(_)) => {}
            (measured, errors) => prop_assert!(false, "{measured:?} {errors:?}"),
        }
    }
}

/// Doubles of all sizes, and those next to simple numbers, which cancel.
fn number() -> impl Strategy<Value = f64> {
    let simple = (-9..10_i32, -2..3_i32);
    prop_oneof![
        3 => -4.0..4.0_f64,
        3 => simple.prop_map(|(number, off)| f64::from(number) * (1.0 + f64::from(off) * f64::EPSILON)),
        1 => (-4.0..4.0_f64, -300..300_i32).prop_map(|(number, power)| number * 10.0_f64.powi(power)),
    ]
}
