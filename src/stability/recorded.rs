//! Emitted functions as the programs that they are: run on operations, they say which they are made of.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use sextic_codegen::arithmetic::Arithmetic as Numbers;
use sextic_codegen::optimiser::prune::prune;
use sextic_codegen::program::{Node, Operation, Program, Rational};
use sextic_evaluators::arithmetic::Arithmetic;

thread_local! {
    /// What is being recorded: an emitted function takes numbers that are copied, and nothing besides.
    static PROGRAM: RefCell<Program> = RefCell::new(Program::new([]));
}

/// A value of the program that is being recorded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recorded(Node);

impl Recorded {
    fn of(operation: Operation) -> Self {
        PROGRAM.with_borrow_mut(|program| Recorded(program.push(operation)))
    }
}

/// The results of emitted functions in any arithmetic: exact where they are exact. What no result needs is not
/// computed.
///
/// Doubles that stand in the text are taken as the numbers that they are.
///
/// # Errors
///
/// Those of the arithmetic.
pub(super) fn run<A: Numbers>(
    arithmetic: &mut A,
    inputs: &[A::Value],
    functions: impl FnOnce(&[Recorded]) -> Vec<Recorded>,
) -> Result<Vec<A::Value>, A::Error> {
    prune(&record(inputs.len(), functions)).run(arithmetic, inputs)
}

/// The program of functions of so many inputs.
fn record(inputs: usize, functions: impl FnOnce(&[Recorded]) -> Vec<Recorded>) -> Program {
    let program = Program::new((0..inputs).map(|place| place.to_string()));
    let nodes: Vec<Recorded> = program.nodes().map(|(node, _)| Recorded(node)).collect();
    let before = PROGRAM.replace(program);
    let outputs = functions(&nodes);
    let mut program = PROGRAM.replace(before);
    for (place, output) in outputs.into_iter().enumerate() {
        program.output(place.to_string(), output.0);
    }
    program
}

impl Arithmetic for Recorded {
    fn constant(value: f64) -> Self {
        let exact = Rational::try_from(value).expect("emitted constants are finite");
        Recorded::of(Operation::Constant(exact))
    }

    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    fn square_root(self) -> Self {
        Recorded::of(Operation::SquareRoot(self.0))
    }
}

impl Neg for Recorded {
    type Output = Self;

    fn neg(self) -> Self {
        Recorded::of(Operation::Negative(self.0))
    }
}

macro_rules! operations {
    ($($name:ident $method:ident $operation:ident),*) => {$(
        impl $name for Recorded {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Recorded::of(Operation::$operation(self.0, other.0))
            }
        }

        impl $name<f64> for Recorded {
            type Output = Self;

            fn $method(self, other: f64) -> Self {
                $name::$method(self, Self::constant(other))
            }
        }
    )*};
}

operations!(Add add Add, Sub sub Subtract, Mul mul Multiply, Div div Divide);

#[cfg(test)]
mod tests {
    use super::*;
    use sextic_codegen::arithmetic::rationals::{Rationals, Roots};

    #[test]
    fn every_operation_is_recorded() {
        let function = |inputs: &[Recorded]| {
            let [a, b] = [inputs[0], inputs[1]];
            let root = (a * a).square_root();
            vec![
                (a + b) * 2.0 - a / b,
                -a + 0.5,
                a.multiply_add(b, b - 1.0) / 4.0,
                root - b,
            ]
        };
        let program = record(2, function);
        let number = |above: i32, below: i32| Rational::from(above) / Rational::from(below);
        let inputs = [number(3, 1), number(7, 1)].map(|own| Some(own.relax()));
        let mut exact = Rationals {
            roots: Roots::Exact,
        };
        let Ok(values) = program.run(&mut exact, &inputs);
        let values: Vec<_> = values
            .into_iter()
            .map(|own| own.map(|own| own.canonicalize()))
            .collect();
        let expected = [number(137, 7), number(-5, 2), number(27, 4), number(-4, 1)];
        assert_eq!(values, expected.map(Some));
    }
}
