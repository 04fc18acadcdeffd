//! No pass changes what a program computes, whatever the program.

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;
use sextic_codegen::arithmetic::rationals::evaluate_exactly;
use sextic_codegen::cost::Cost;
use sextic_codegen::horner::horner;
use sextic_codegen::optimiser::fold::fold;
use sextic_codegen::optimiser::hoist::{hoist, still_first};
use sextic_codegen::optimiser::optimise;
use sextic_codegen::optimiser::prune::prune;
use sextic_codegen::optimiser::reciprocal::reciprocals;
use sextic_codegen::optimiser::share::share;
use sextic_codegen::optimiser::specialise::specialise;
use sextic_codegen::program::{Node, Operation, Program, Rational};

use Operation::{Add, Divide, Multiply, Negative, SquareRoot, Subtract};

use crate::samples::rational;

/// A program of three inputs from numbers: each step takes earlier values.
pub fn drawn() -> impl Strategy<Value = Program> {
    let step = (
        0..8_u8,
        any::<prop::sample::Index>(),
        any::<prop::sample::Index>(),
        -3..4_i64,
    );
    prop::collection::vec(step, 1..25).prop_map(|steps| {
        let mut program = Program::new(["x", "y", "z"].map(str::to_owned));
        for (kind, first, second, number) in steps {
            let nodes: Vec<Node> = program.nodes().map(|(node, _)| node).collect();
            let (a, b) = (
                nodes[first.index(nodes.len())],
                nodes[second.index(nodes.len())],
            );
            program.push(match kind {
                0 | 1 => Add(a, b),
                2 => Subtract(a, b),
                3 => Multiply(a, b),
                4 => Divide(a, b),
                5 => Negative(a),
                6 => SquareRoot(a),
                _ => Operation::Constant(rational(number, 2)),
            });
        }
        let last: Vec<Node> = program.nodes().map(|(node, _)| node).collect();
        for (place, node) in last.iter().rev().take(3).enumerate() {
            program.output(format!("o_{place}"), *node);
        }
        program
    })
}

fn point() -> impl Strategy<Value = Vec<Rational>> {
    let number = (-9..10_i64, 1..6_i64).prop_map(|(above, below)| rational(above, below));
    prop::collection::vec(number, 3)
}

/// Where a program has a value, the other one has the same: where all outputs have one.
fn agrees(before: &[Option<Rational>], after: &[Option<Rational>]) -> bool {
    before.iter().any(Option::is_none) || before == after
}

/// A pass that joins no divisions keeps the value of each output, whether others have one or not.
fn agrees_each(before: &[Option<Rational>], after: &[Option<Rational>]) -> bool {
    before.len() == after.len()
        && before
            .iter()
            .zip(after)
            .all(|(before, after)| before.is_none() || before == after)
}

proptest! {
    #[test]
    fn no_pass_changes_a_value(program in drawn(), point in point()) {
        let before = evaluate_exactly(&program, &point);
        let alone: [fn(&Program) -> Program; 3] = [fold, share, prune];
        for (place, pass) in alone.into_iter().enumerate() {
            let after = evaluate_exactly(&pass(&program), &point);
            prop_assert!(agrees_each(&before, &after), "pass {place}: {before:?} {after:?}");
        }
        for pass in [reciprocals, optimise] {
            let after = evaluate_exactly(&pass(&program), &point);
            prop_assert!(agrees(&before, &after), "{before:?} {after:?}");
        }
    }

    #[test]
    fn optimising_never_costs_more(program in drawn()) {
        let (before, after) = (Cost::of(&prune(&program)), Cost::of(&optimise(&program)));
        prop_assert!(after.divisions <= before.divisions);
        prop_assert_eq!(optimise(&optimise(&program)), optimise(&program));
    }

    #[test]
    fn fixing_inputs_is_evaluation_in_part(program in drawn(), point in point()) {
        let fixed = BTreeMap::from([("y".to_owned(), point[1].clone())]);
        let special = specialise(&program, &fixed);
        prop_assert_eq!(special.inputs(), ["x", "z"]);
        let rest = [point[0].clone(), point[2].clone()];
        let after = evaluate_exactly(&special, &rest);
        prop_assert!(agrees(&evaluate_exactly(&program, &point), &after));
    }

    #[test]
    fn the_two_parts_of_a_sweep_are_the_whole(program in drawn(), point in point()) {
        let swept = BTreeSet::from(["y".to_owned()]);
        let parts = hoist(&program, &swept);
        let still = [point[0].clone(), point[2].clone()];
        let prepared = evaluate_exactly(&parts.preparation, &still);
        let before = evaluate_exactly(&program, &point);
        // A prepared value may be missing where only an unused output needs it.
        if let Some(prepared) = prepared.into_iter().collect::<Option<Vec<Rational>>>() {
            let inputs: Vec<Rational> = std::iter::once(point[1].clone()).chain(prepared).collect();
            prop_assert!(agrees(&before, &evaluate_exactly(&parts.sweep, &inputs)));
        }
    }

    #[test]
    fn what_stays_can_stand_first(program in drawn(), point in point()) {
        let swept = BTreeSet::from(["y".to_owned()]);
        let sorted = still_first(&program, &swept);
        prop_assert_eq!(evaluate_exactly(&sorted, &point), evaluate_exactly(&program, &point));
        let mut moves: Vec<bool> = Vec::new();
        for (node, operation) in sorted.nodes() {
            moves.push(match operation {
                Operation::Input(_) => sorted.input("y") == Some(node),
                _ => operation.operands().any(|operand| moves[operand.index()]),
            });
        }
        prop_assert!(moves[sorted.inputs().len()..].is_sorted());
    }

    #[test]
    fn horner_gives_the_sum_of_its_terms(
        terms in prop::collection::vec((-4..5_i64, [0..4_u32, 0..4_u32, 0..4_u32]), 0..8),
        point in point(),
    ) {
        let mut program = Program::new(["x", "y", "z"].map(str::to_owned));
        let inputs = crate::samples::inputs(&program);
        let listed: Vec<_> = terms
            .iter()
            .map(|(coefficient, exponents)| {
                let powers = inputs.iter().copied().zip(*exponents);
                let powers = powers.filter(|(_, exponent)| *exponent > 0).collect();
                (rational(*coefficient, 1), powers)
            })
            .collect();
        let value = horner(&mut program, &listed);
        program.output("p", value);
        let mut sum = Rational::ZERO;
        for (coefficient, exponents) in &terms {
            let mut term = rational(*coefficient, 1);
            for (value, exponent) in point.iter().zip(exponents) {
                term *= value.clone().pow(*exponent as isize);
            }
            sum += term;
        }
        prop_assert_eq!(evaluate_exactly(&program, &point), vec![Some(sum)]);
    }
}
