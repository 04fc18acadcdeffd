//! The error at a point, whichever way it was found: by pairs of doubles or with rationals.

use proptest::prelude::*;
use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::arithmetic::rationals::evaluate_closely;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::program::{Node, Operation, Program, Rational};
use sextic_codegen::rounding::{Domain, Interval, Unmeasured, measure, units};

use crate::laws::drawn;
use crate::samples::{self, rational};

/// Programs in which all digits of pairs of doubles cancel.
fn cancelling() -> Vec<Program> {
    use Operation::{Add, Divide, Multiply, Subtract};
    type Build = fn(&mut Program, Node, Node, Node, Node) -> Node;
    // (x/y)·y − x is 0.
    let builds: [Build; 12] = [
        |_, _, _, _, zero| zero,
        |p, x, _, _, zero| p.push(Multiply(zero, x)),
        |p, _, _, z, zero| p.push(Divide(zero, z)),
        |p, x, _, _, zero| p.push(Divide(x, zero)),
        |p, x, _, _, zero| {
            let tiny = p.constant(Rational::from(2).pow(-108));
            let tiny = p.push(Multiply(tiny, x));
            let sum = p.push(Add(zero, tiny));
            let large = p.constant(Rational::from(2).pow(200));
            p.push(Multiply(sum, large))
        },
        |p, x, y, z, _| {
            let (left, right) = (p.push(Multiply(x, y)), p.push(Multiply(y, z)));
            let (left, right) = (p.push(Multiply(left, z)), p.push(Multiply(x, right)));
            let zero = p.push(Subtract(left, right));
            let third = p.constant(rational(1, 3));
            let large = p.push(Multiply(zero, third));
            p.push(Add(large, zero))
        },
        // A little below 1, where the distance between doubles is half of that above.
        |p, x, _, _, zero| {
            let tiny = p.constant(Rational::from(1) - Rational::from(2).pow(-150));
            let one = p.push(Divide(x, x));
            let sum = p.push(Add(zero, one));
            p.push(Multiply(sum, tiny))
        },
        // Pairs that are exact, and a sum that is not.
        |p, x, y, z, _| {
            let mut pair = |above, below, power| {
                let tiny = p.constant(Rational::from(2).pow(power));
                let tiny = p.push(Multiply(below, tiny));
                p.push(Add(above, tiny))
            };
            let (left, right) = (pair(x, y, -60), pair(z, x, -70));
            let sum = p.push(Add(left, right));
            let rest = p.push(Subtract(sum, left));
            let zero = p.push(Subtract(rest, right));
            let large = p.constant(Rational::from(2).pow(200));
            p.push(Multiply(zero, large))
        },
        // Half of the digits are left.
        |p, x, _, _, zero| {
            let tiny = p.constant(Rational::from(2).pow(-52));
            let tiny = p.push(Multiply(tiny, x));
            p.push(Add(zero, tiny))
        },
        |p, x, y, z, _| {
            let (left, right) = (p.push(Divide(x, y)), p.push(Divide(z, x)));
            let sum = p.push(Add(left, right));
            let rest = p.push(Subtract(sum, left));
            let zero = p.push(Subtract(rest, right));
            let large = p.constant(Rational::from(2).pow(200));
            p.push(Multiply(zero, large))
        },
        |p, x, _, _, _| {
            let root = p.push(Operation::SquareRoot(x));
            let square = p.push(Multiply(root, root));
            p.push(Subtract(square, x))
        },
        |p, x, _, _, zero| {
            let square = p.push(Multiply(zero, zero));
            let root = p.push(Operation::SquareRoot(square));
            p.push(Multiply(root, x))
        },
    ];
    let program = |build: &Build| {
        let mut program = Program::new(["x", "y", "z"].map(str::to_owned));
        let [x, y, z] = samples::inputs(&program)[..] else {
            panic!("three inputs");
        };
        let quotient = program.push(Divide(x, y));
        let again = program.push(Multiply(quotient, y));
        let zero = program.push(Subtract(again, x));
        let value = build(&mut program, x, y, z, zero);
        program.output("o", value);
        program
    };
    builds.iter().map(program).collect()
}

/// Whether the error at one point is the distance of the double from the rational.
fn is_measured(program: &Program, point: &[f64]) -> Result<(), TestCaseError> {
    let evaluator = Evaluator::plain("f", program.clone());
    let exact = point
        .iter()
        .map(|value| Rational::try_from(*value).unwrap());
    let exact: Vec<Rational> = exact.collect();
    let interval = |value: &Rational| Interval {
        from: value.clone(),
        to: value.clone(),
    };
    let names = ["x", "y", "z"].map(str::to_owned);
    let domain = Domain {
        intervals: names.into_iter().zip(exact.iter().map(interval)).collect(),
        text: String::new(),
    };
    let found = evaluate(program, point).unwrap();
    let exact = evaluate_closely(program, &exact, 500);
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
        // Roots that cancel are known to no number of bits.
        (Err(Unmeasured::NoPoint), _) => {}
        (measured, errors) => prop_assert!(false, "{measured:?} {errors:?}"),
    }
    Ok(())
}

proptest! {
    /// Whichever way it was found.
    #[test]
    fn an_error_is_the_distance_from_the_exact_value(
        program in drawn(),
        point in prop::collection::vec(number(), 3),
    ) {
        is_measured(&program, &point)?;
    }

    #[test]
    fn what_cancels_is_left_to_rationals(point in prop::collection::vec(0.1..9.0_f64, 3)) {
        for program in cancelling() {
            is_measured(&program, &point)?;
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
