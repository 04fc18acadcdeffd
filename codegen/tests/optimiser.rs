//! What each pass does.

use std::collections::BTreeSet;

use sextic_codegen::arithmetic::rationals::evaluate_exactly;
use sextic_codegen::cost::Cost;
use sextic_codegen::horner::{horner, power};
use sextic_codegen::optimiser::fold::fold;
use sextic_codegen::optimiser::hoist::hoist;
use sextic_codegen::optimiser::optimise;
use sextic_codegen::optimiser::prune::prune;
use sextic_codegen::optimiser::share::share;
use sextic_codegen::program::{Node, Operation, Program};

use Operation::{Add, Divide, Multiply, Negative, SquareRoot, Subtract};

use crate::samples::rational;

pub fn program(build: impl Fn(&mut Program, Node, Node) -> Node) -> Program {
    let mut program = Program::new(["x".to_owned(), "y".to_owned()]);
    let (x, y) = (program.input("x").unwrap(), program.input("y").unwrap());
    let value = build(&mut program, x, y);
    program.output("z", value);
    program
}

/// The operations that no input and no constant is, in order.
pub fn signs(program: &Program) -> String {
    let sign = |operation: &Operation| match operation {
        Operation::Input(_) | Operation::Constant(_) => "",
        Add(..) => "+",
        Subtract(..) => "-",
        Multiply(..) => "*",
        Divide(..) => "/",
        Negative(_) => "~",
        SquareRoot(_) => "√",
    };
    prune(program).operations().iter().map(sign).collect()
}

#[test]
fn folding_leaves_out_what_changes_nothing() {
    type Build = fn(&mut Program, Node, Node) -> Node;
    let table: [(&str, Build, &str); 14] = [
        (
            "x + 0",
            |p, x, _| {
                let c = p.constant(rational(0, 1));
                p.push(Add(x, c))
            },
            "",
        ),
        (
            "x - 0",
            |p, x, _| {
                let c = p.constant(rational(0, 1));
                p.push(Subtract(x, c))
            },
            "",
        ),
        (
            "0 - x",
            |p, x, _| {
                let c = p.constant(rational(0, 1));
                p.push(Subtract(c, x))
            },
            "~",
        ),
        (
            "x·1",
            |p, x, _| {
                let c = p.constant(rational(1, 1));
                p.push(Multiply(x, c))
            },
            "",
        ),
        (
            "x·(-1)",
            |p, x, _| {
                let c = p.constant(rational(-1, 1));
                p.push(Multiply(x, c))
            },
            "~",
        ),
        (
            "0·x",
            |p, x, _| {
                let c = p.constant(rational(0, 1));
                p.push(Multiply(c, x))
            },
            "",
        ),
        (
            "x/1",
            |p, x, _| {
                let c = p.constant(rational(1, 1));
                p.push(Divide(x, c))
            },
            "",
        ),
        (
            "x/4",
            |p, x, _| {
                let c = p.constant(rational(4, 1));
                p.push(Divide(x, c))
            },
            "*",
        ),
        (
            "x/3",
            |p, x, _| {
                let c = p.constant(rational(3, 1));
                p.push(Divide(x, c))
            },
            "/",
        ),
        (
            "0/x",
            |p, x, _| {
                let c = p.constant(rational(0, 1));
                p.push(Divide(c, x))
            },
            "",
        ),
        (
            "-(-x)",
            |p, x, _| {
                let n = p.push(Negative(x));
                p.push(Negative(n))
            },
            "",
        ),
        (
            "x + (-y)",
            |p, x, y| {
                let n = p.push(Negative(y));
                p.push(Add(x, n))
            },
            "-",
        ),
        ("x - x", |p, x, _| p.push(Subtract(x, x)), ""),
        (
            "√1",
            |p, _, _| {
                let c = p.constant(rational(1, 1));
                p.push(SquareRoot(c))
            },
            "",
        ),
    ];
    for (name, build, expected) in table {
        assert_eq!(signs(&fold(&program(build))), expected, "{name}");
    }
}

#[test]
fn a_division_by_zero_is_not_folded_away() {
    let quotient = program(|p, x, _| {
        let zero = p.constant(rational(0, 1));
        p.push(Divide(x, zero))
    });
    assert_eq!(signs(&optimise(&quotient)), "/");
}

#[test]
fn sharing_computes_once_whatever_the_order() {
    let twice = program(|p, x, y| {
        let (a, b) = (p.push(Multiply(x, y)), p.push(Multiply(y, x)));
        p.push(Add(a, b))
    });
    assert_eq!(signs(&share(&twice)), "*+");
    // A difference has an order.
    let differs = program(|p, x, y| {
        let (a, b) = (p.push(Subtract(x, y)), p.push(Subtract(y, x)));
        p.push(Multiply(a, b))
    });
    assert_eq!(signs(&share(&differs)), "--*");
}

#[test]
fn pruning_keeps_the_inputs() {
    let mut unused = program(|p, x, y| p.push(Add(x, y)));
    let (x, y) = (unused.input("x").unwrap(), unused.input("y").unwrap());
    unused.push(Divide(x, y));
    let pruned = prune(&unused);
    assert_eq!(
        (pruned.inputs(), pruned.operations().len()),
        (unused.inputs(), 3)
    );
}

#[test]
fn hoisting_prepares_what_stays() {
    let swept = program(|p, x, y| {
        let square = p.push(Multiply(x, x));
        let cube = p.push(Multiply(square, x));
        p.push(Add(cube, y))
    });
    let hoisted = hoist(&swept, &BTreeSet::from(["y".to_owned()]));
    assert_eq!(
        (signs(&hoisted.preparation), signs(&hoisted.sweep)),
        ("**".into(), "+".into())
    );
    assert_eq!(hoisted.sweep.inputs(), ["y", "h_1"]);
}

#[test]
fn horner_and_powers_need_few_operations() {
    let mut polynomial = Program::new(["x".to_owned()]);
    let x = polynomial.input("x").unwrap();
    let terms: Vec<_> = (0..=6)
        .map(|exponent| {
            let powers = (exponent > 0).then_some((x, exponent));
            (
                rational(i64::from(exponent) + 2, 1),
                powers.into_iter().collect(),
            )
        })
        .collect();
    let value = horner(&mut polynomial, &terms);
    polynomial.output("p", value);
    let cost = Cost::of(&optimise(&polynomial));
    assert_eq!((cost.additions, cost.multiplications), (6, 6));

    let mut high = Program::new(["x".to_owned()]);
    let x = high.input("x").unwrap();
    let value = power(&mut high, x, 12);
    high.output("p", value);
    assert_eq!(Cost::of(&high).multiplications, 4);
    assert_eq!(
        evaluate_exactly(&high, &[rational(2, 3)]),
        [Some(rational(4096, 531_441))]
    );
}
