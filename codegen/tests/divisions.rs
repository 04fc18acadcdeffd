//! How often a program divides.

use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::arithmetic::rationals::evaluate_exactly;
use sextic_codegen::cost::Cost;
use sextic_codegen::horner::power;
use sextic_codegen::optimiser::optimise;
use sextic_codegen::optimiser::reciprocal::reciprocals;
use sextic_codegen::program::{Node, Operation, Program};

use Operation::{Add, Divide, Multiply, Subtract};

use crate::optimiser::{program, signs};
use crate::samples::rational;

/// The quotients x/d of some divisors of x and y, as outputs; optimised.
fn quotients(divisors: impl Fn(&mut Program, Node, Node) -> Vec<Node>) -> Program {
    let mut program = Program::new(["x".to_owned(), "y".to_owned()]);
    let (x, y) = (program.input("x").unwrap(), program.input("y").unwrap());
    for (place, divisor) in divisors(&mut program, x, y).into_iter().enumerate() {
        let quotient = program.push(Divide(x, divisor));
        program.output(format!("q_{place}"), quotient);
    }
    let optimised = optimise(&program);
    let point = [rational(7, 3), rational(-5, 2)];
    let wanted = evaluate_exactly(&program, &point);
    assert_eq!(evaluate_exactly(&optimised, &point), wanted);
    optimised
}

#[test]
fn one_division_by_one_divisor() {
    let twice = program(|p, x, y| {
        let square = p.push(Multiply(x, x));
        let (a, b) = (p.push(Divide(x, y)), p.push(Divide(square, y)));
        p.push(Add(a, b))
    });
    assert_eq!(signs(&reciprocals(&twice)), "*/**+");
    let once = program(|p, x, y| p.push(Divide(x, y)));
    assert_eq!(reciprocals(&once), once);
}

#[test]
fn one_division_by_several_divisors() {
    // q = 1/(y·z) with z = x + y; x·(q·z) and x·(q·y).
    let two = quotients(|p, x, y| vec![y, p.push(Add(x, y))]);
    assert_eq!(signs(&two), "+*/****");
}

#[test]
fn a_common_multiple_is_enough() {
    let nested = quotients(|p, x, y| {
        let product = p.push(Multiply(x, y));
        vec![x, product, y] // x/y is x·q·x, and q·x is x/(x·y)
    });
    let cost = Cost::of(&nested);
    assert_eq!((cost.divisions, cost.multiplications), (1, 5));
}

#[test]
fn powers_of_two_stay_out_of_a_common_divisor() {
    // y, −4y and y/2 are one divisor.
    let scaled = quotients(|p, _, y| {
        let (four, half) = (p.constant(rational(-4, 1)), p.constant(rational(1, 2)));
        vec![y, p.push(Multiply(four, y)), p.push(Multiply(y, half))]
    });
    let cost = Cost::of(&scaled);
    assert_eq!((cost.divisions, cost.multiplications), (1, 5));
}

#[test]
fn what_waits_for_a_division_is_divided_by_later() {
    let chain = quotients(|p, x, y| {
        let first = p.push(Divide(x, y));
        let second = p.push(Add(first, x));
        vec![second, p.push(Multiply(second, y)), y]
    });
    assert_eq!(Cost::of(&chain).divisions, 3);
}

#[test]
fn a_common_divisor_has_four_factors_at_most() {
    let sums = |count: i64| {
        quotients(move |p, x, y| {
            let sum = |number: i64| {
                let number = p.constant(rational(number, 1));
                p.push(Add(if number.index() % 2 == 0 { x } else { y }, number))
            };
            (3..3 + count).map(sum).collect()
        })
    };
    let divisions = [1, 2, 4, 5, 8, 9].map(|count| Cost::of(&sums(count)).divisions);
    assert_eq!(divisions, [1, 1, 1, 2, 2, 3]);
}

#[test]
fn what_may_cancel_stays_alone() {
    // x·x − y·y loses its digits where x is close to y, and must not spoil x/y.
    let apart = quotients(|p, x, y| {
        let (a, b) = (p.push(Multiply(x, x)), p.push(Multiply(y, y)));
        vec![p.push(Subtract(a, b)), y]
    });
    assert_eq!(Cost::of(&apart).divisions, 2);
    let alone = quotients(|_, _, y| vec![y]);
    let second = |program: &Program| {
        let found = evaluate(program, &[1.000_000_01, 1.0]).unwrap();
        found[found.len() - 1].to_bits()
    };
    assert_eq!(second(&apart), second(&alone));
    // A difference of what is given is close to exact, however small.
    let joined = quotients(|p, x, y| vec![p.push(Subtract(x, y)), y]);
    assert_eq!(Cost::of(&joined).divisions, 1);
}

#[test]
fn a_power_is_not_taken_apart() {
    let powers = program(|p, x, y| {
        let (a, b) = (power(p, x, 1 << 30), power(p, y, 5));
        let (a, b) = (p.push(Divide(x, a)), p.push(Divide(x, b)));
        p.push(Add(a, b))
    });
    assert_eq!(Cost::of(&reciprocals(&powers)).divisions, 2);
}

#[test]
fn what_no_output_needs_is_not_divided_by() {
    let mut unused = program(|p, x, y| p.push(Divide(x, y)));
    let (x, y) = (unused.input("x").unwrap(), unused.input("y").unwrap());
    unused.push(Divide(y, x));
    let zero = [rational(0, 1), rational(1, 1)];
    assert_eq!(
        evaluate_exactly(&reciprocals(&unused), &zero),
        [Some(rational(0, 1))]
    );
}
