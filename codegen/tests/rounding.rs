//! The measure of rounding errors, measured.

use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::arithmetic::rationals::{evaluate_closely, evaluate_exactly};
use sextic_codegen::evaluator::{Angle, Circular, Evaluator, Fixed, Function, Origin, Quantity};
use sextic_codegen::program::{Operation, Program, Rational};
use sextic_codegen::rounding::{Domain, Interval, Unmeasured, measure, units};

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
fn points_without_a_value_do_not_count() {
    // √(a − b)/(a − b) has a value where a > b: at half of the points.
    let mut program = Program::new(["a".to_owned(), "b".to_owned()]);
    let (a, b) = (program.input("a").unwrap(), program.input("b").unwrap());
    let difference = program.push(Operation::Subtract(a, b));
    let root = program.push(Operation::SquareRoot(difference));
    let quotient = program.push(Operation::Divide(root, difference));
    program.output("x", quotient);
    let evaluator = Evaluator::plain("half", program);
    let found = measure(&evaluator, &domain(&evaluator, 0, 1), 1000, 1).unwrap();
    assert!((400..600).contains(&found.points), "{}", found.points);
}

#[test]
fn one_point_of_a_hundred_is_beyond_the_percentile() {
    let mut program = Program::new(["a".to_owned(), "b".to_owned()]);
    let (a, b) = (program.input("a").unwrap(), program.input("b").unwrap());
    let product = program.push(Operation::Multiply(a, b));
    program.output("x", product);
    let evaluator = Evaluator::plain("product", program);
    let found = measure(&evaluator, &domain(&evaluator, 1, 2), 20_000, 1).unwrap();
    // Evenly spread over half a unit: 99 of 100 are within 0.495 units.
    let (most, largest) = (found.percentile_99[0], found.largest[0]);
    assert!(
        (0.49..0.5).contains(&most) && largest <= 0.5,
        "{most} {largest}"
    );
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

#[test]
fn fixed_angles_are_drawn_where_they_are() {
    for (alpha, beta) in [("3/10", "1/10"), ("-40", "7/2"), ("0", "0"), ("1000", "-1")] {
        let mut program = Program::new(["c".to_owned(), "s".to_owned()]);
        let number = |text: &str| text.parse::<Rational>().unwrap();
        let angle = 3.0 * number(alpha).to_f64().value() - number(beta).to_f64().value();
        // √(10⁻²⁰ − (c − cos(3·α − β))²) is real only next to it.
        for (name, value) in [("c", angle.cos()), ("s", angle.sin())] {
            let value = program.constant(Rational::try_from(value).unwrap());
            let offset = program.push(Operation::Subtract(program.input(name).unwrap(), value));
            let square = program.push(Operation::Multiply(offset, offset));
            let near = program.constant(Rational::from(10).pow(-20));
            let rest = program.push(Operation::Subtract(near, square));
            let root = program.push(Operation::SquareRoot(rest));
            program.output(format!("near_{name}"), root);
        }
        let mut evaluator = Evaluator::plain("f", program);
        let fixed = |name: &str, value: &str| Angle {
            quantity: Quantity::plain(name),
            fixed: Some(Fixed {
                value: number(value),
                text: String::new(),
            }),
        };
        evaluator.angles = vec![fixed("alpha", alpha), fixed("beta", beta)];
        for (input, function) in evaluator
            .inputs
            .iter_mut()
            .zip([Function::Cosine, Function::Sine])
        {
            let angle = vec![(3, "alpha".to_owned()), (-1, "beta".to_owned())];
            input.origin = Origin::Circular(Circular { function, angle });
        }
        let rounding = measure(&evaluator, &domain(&evaluator, 0, 1), 2, 1);
        assert!(rounding.is_ok(), "{alpha} {beta}: {rounding:?}");
    }
}
