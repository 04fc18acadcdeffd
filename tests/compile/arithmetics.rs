//! One program has one value, whatever it is run in.

use std::collections::BTreeMap;
use std::convert::Infallible;

use proptest::prelude::*;
use sextic::algebra::budget::Budget;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::{Integer, Rational};
use sextic::algebra::ring::Ring;
use sextic::algebra::sign::Signs;
use sextic::compile::doubt::Reason;
use sextic::compile::operations::compare;
use sextic::compile::point::{Point, Residues};
use sextic::compile::proof::{Elements, prove};
use sextic::compile::specification::Specification;
use sextic::derivation::elaboration::Elaborator;
use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::arithmetic::doubles::{Beyond, Doubles};
use sextic_codegen::arithmetic::pairs::{Close, Pairs};
use sextic_codegen::arithmetic::rationals::{evaluate_closely, evaluate_exactly};
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::optimiser::prune::prune;
use sextic_codegen::program::{Node, Operation, Program};
use sextic_evaluators::arithmetic::Arithmetic as _;
use sextic_evaluators::bounded::Bounded;

fn quotient(above: i64, below: i64) -> Rational {
    Rational::from(above) / Rational::from(below)
}

/// A program of x, y and z whose last three values are its outputs.
fn drawn(length: usize) -> impl Strategy<Value = Program> {
    let index = any::<prop::sample::Index>;
    let step = (0..10_u8, index(), index(), (-9..10_i64, 1..4_i64));
    prop::collection::vec(step, 1..length).prop_map(|steps| {
        let mut program = Program::new(["x", "y", "z"].map(str::to_owned));
        for (kind, first, second, (above, below)) in steps {
            let nodes = nodes(&program);
            let (a, b) = (*first.get(&nodes), *second.get(&nodes));
            let operation = match kind {
                0 | 1 => Operation::Add(a, b),
                2 => Operation::Subtract(a, b),
                3 | 4 => Operation::Multiply(a, b),
                5 => Operation::Divide(a, b),
                6 => Operation::Negative(a),
                7 => Operation::SquareRoot(a),
                8 => nothing(&mut program, a, b),
                _ => Operation::Constant(quotient(above, below)),
            };
            program.push(operation);
        }
        for (place, node) in nodes(&program).iter().rev().take(3).enumerate() {
            program.output(format!("o_{place}"), *node);
        }
        program
    })
}

/// a/b·b − a, which is 0 up to rounding.
fn nothing(program: &mut Program, a: Node, b: Node) -> Operation {
    let quotient = program.push(Operation::Divide(a, b));
    let product = program.push(Operation::Multiply(quotient, b));
    Operation::Subtract(product, a)
}

fn nodes(program: &Program) -> Vec<Node> {
    program.nodes().map(|(node, _)| node).collect()
}

/// Numbers that are doubles, and often squares.
fn point() -> impl Strategy<Value = Vec<Rational>> {
    let number = (-40..41_i64, 0..5_u32).prop_map(|(n, power)| quotient(n, 1 << power));
    let square = (0..20_i64, 0..3_u32).prop_map(|(n, power)| quotient(n * n, 1 << (2 * power)));
    prop::collection::vec(prop_oneof![number, square], 3)
}

/// The doubles with bounds of the emitted crate.
struct Bounds;

impl Arithmetic for Bounds {
    type Value = Bounded;
    type Error = Infallible;

    fn constant(&mut self, value: &Rational) -> Result<Bounded, Infallible> {
        let above = Rational::from(value.numerator().clone());
        let below = Rational::from(Integer::from(value.denominator().clone()));
        let [above, below] = [above, below].map(|part| Bounded::exact(part.to_f64().value()));
        Ok(above / below)
    }

    fn negative(&mut self, a: &Bounded) -> Result<Bounded, Infallible> {
        Ok(-*a)
    }

    fn sum(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Infallible> {
        Ok(*a + *b)
    }

    fn difference(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Infallible> {
        Ok(*a - *b)
    }

    fn product(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Infallible> {
        Ok(*a * *b)
    }

    fn quotient(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Infallible> {
        Ok(*a / *b)
    }

    fn square_root(&mut self, a: &Bounded) -> Result<Bounded, Infallible> {
        Ok(a.square_root())
    }
}

/// The values of the outputs in elements of a ring without symbols; none where there is no such element.
fn in_a_ring(program: &Program, point: &[Rational]) -> Option<Vec<Fraction>> {
    let mut ring = Ring::new(Budget::new(100_000));
    let point: Vec<Fraction> = point.iter().cloned().map(Fraction::constant).collect();
    program.run(&mut Elements(&mut ring), &point).ok()
}

/// The values modulo the prime, where the roots of the squares of n/8 are known.
fn in_residues(program: &Program, point: &[Rational]) -> Vec<Option<u64>> {
    let none = BTreeMap::new();
    let residue = |value: &Rational| {
        let Ok(residue) = Residues { roots: &none }.constant(value);
        residue
    };
    let root = |n: i64| Some((residue(&quotient(n * n, 64))?, residue(&quotient(n, 8))?));
    let roots = (0..400).filter_map(root).collect();
    let point: Vec<Option<u64>> = point.iter().map(residue).collect();
    let Ok(outputs) = program.run(&mut Residues { roots: &roots }, &point);
    outputs
}

fn is_between(value: &Rational, [lower, upper]: &[Rational; 2]) -> bool {
    lower <= value && value <= upper
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn exact_arithmetics_agree(program in drawn(20), point in point()) {
        // What no output needs has no say in whether there are elements.
        let program = prune(&program);
        let wanted = evaluate_exactly(&program, &point);
        let residues = in_residues(&program, &point);
        for (wanted, found) in wanted.iter().zip(residues) {
            let Some(wanted) = wanted else { continue };
            let Ok(wanted) = Residues { roots: &BTreeMap::new() }.constant(wanted);
            prop_assert!(found.is_none() || found == wanted);
        }
        let elements = in_a_ring(&program, &point);
        prop_assert!(elements.is_some() || wanted.contains(&None));
        for (wanted, found) in wanted.iter().zip(elements.into_iter().flatten()) {
            let (Some(wanted), Some(found)) = (wanted, found.as_constant()) else { continue };
            prop_assert_eq!(wanted, &found);
        }
    }

    #[test]
    fn bounds_hold_the_exact_value(program in drawn(20), point in point()) {
        let wanted = evaluate_closely(&program, &point, 600);
        let doubles: Vec<f64> = point.iter().map(|value| value.to_f64().value()).collect();
        let plain: Result<Vec<f64>, Beyond> = program.run(&mut Doubles, &doubles);
        let bounds: Vec<Bounded> = doubles.iter().copied().map(Bounded::exact).collect();
        let Ok(bounded) = program.run(&mut Bounds, &bounds);
        let pairs: Option<Vec<Close>> = doubles.iter().copied().map(Close::exact).collect();
        let pairs = program.run(&mut Pairs, &pairs.unwrap());
        for (place, wanted) in wanted.iter().enumerate() {
            let (value, error) = (bounded[place].value, bounded[place].error);
            let plain = plain.as_ref().unwrap()[place];
            prop_assert!(plain.to_bits() == value.to_bits() || plain.is_nan() && value.is_nan());
            let Some(wanted) = wanted else {
                prop_assert!(!error.is_finite() && pairs.is_err());
                continue;
            };
            if let (Ok(value), Ok(error)) = (Rational::try_from(value), Rational::try_from(error)) {
                let bounds = [&value - &error, value + error];
                prop_assert!(is_between(wanted, &bounds), "{wanted} {bounds:?}");
            }
            if let Ok(pairs) = &pairs {
                let bounds = pairs[place].bounds().unwrap();
                prop_assert!(is_between(wanted, &bounds), "{wanted} {bounds:?}");
            }
        }
    }

    /// What a program is over a ring is what it is at a point of the ring; another program is neither.
    #[test]
    fn elements_have_the_values_of_the_program(program in drawn(10)) {
        let mut elaborator = Elaborator::new(Budget::new(100_000));
        let ring = &mut elaborator.ring;
        let inputs = ["x", "y", "z"].map(|name| {
            let symbol = ring.symbol(Generator::Constant { name: name.to_owned() }).unwrap();
            ring.assumptions_mut().assume_symbol(symbol, Signs::POSITIVE);
            (name.to_owned(), ring.element(symbol))
        });
        let elements = inputs.clone().map(|(_, element)| element);
        let Ok(outputs) = program.run(&mut Elements(ring), &elements) else {
            return Ok(());
        };
        let names = program.outputs().iter().map(|(name, _)| name.clone());
        let outputs: Vec<(String, Fraction)> = names.zip(outputs).collect();
        let evaluator = Evaluator::plain("e", program.clone());
        let specification = Specification::new(evaluator, inputs.to_vec(), outputs, elaborator);
        let mut ring = specification.elaborator.ring.clone();
        let point = Point::of(&specification, &ring);
        let is_decided = point.refute(&program, &specification);
        prop_assert!(is_decided.is_ok(), "{:?}", is_decided);
        prop_assert_eq!(prove(&program, &specification, &mut ring), Ok(()));
        // Its numbers may be beyond the doubles, or 0 in doubles alone.
        let compared = compare(&program, &specification);
        prop_assert!(matches!(compared, Ok(()) | Err(Reason::Literal(_))), "{compared:?}");

        let mut other = Program::new(program.inputs().iter().cloned());
        for operation in &program.operations()[3..] {
            other.push(operation.clone());
        }
        let one = other.constant(Rational::ONE);
        for (name, node) in program.outputs() {
            let another = other.push(Operation::Add(*node, one));
            other.output(name.clone(), another);
        }
        let refuted = point.refute(&other, &specification);
        prop_assert!(refuted.is_err() || is_decided == Ok(false));
        prop_assert!(prove(&other, &specification, &mut ring).is_err());
        prop_assert!(compare(&other, &specification).is_err());
    }
}
