//! How far an emitted text is from exact, measured.
//!
//! A program is run in doubles, with the same operations in the same order as the emitted strict text,
//! and in exact arithmetic, at points drawn from a domain.

mod domain;
mod unit;

use std::fmt;
use std::ops::Range;

use crate::arithmetic::Prepared;
use crate::arithmetic::doubles::Doubles;
use crate::arithmetic::pairs::{Close, Pairs};
use crate::arithmetic::rationals::evaluate_closely;
use crate::evaluator::{Evaluator, Rounding};
use crate::optimiser::prune::prune;
use crate::program::{Node, Operation, Program, Rational};
use domain::Sampler;
pub use domain::{Domain, Interval};
pub use unit::units;

/// Why there is no measure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unmeasured {
    /// A given input has no interval with ends in order that are doubles.
    Domain,
    /// A constant is beyond the doubles.
    Constant,
    /// No point of the domain gave a value that is known exactly or closely enough.
    NoPoint,
}

impl fmt::Display for Unmeasured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Unmeasured::Domain => {
                "each input that is given needs an interval with ends in order and in the range of a \
                 double"
            }
            Unmeasured::Constant => "a constant is beyond the range of a double",
            Unmeasured::NoPoint => "no point of the domain has an exact value",
        })
    }
}

impl std::error::Error for Unmeasured {}

/// Runs an evaluator at points of a domain and reports the errors of each output, in units in the last
/// place of the exact value.
///
/// The same seed gives the same points and figures, on every machine and with any number of threads. A
/// point does not count where an output has no exact value, because a divisor is 0 or a radicand negative.
///
/// At most points, sums of two doubles with rigorous bounds give the error to a millionth of a unit: some
/// nanoseconds an operation. Where they do not, rationals give it: some microseconds an operation. Roots
/// are then taken to 300 bits, and once more to 400: a point where that makes a difference of more than a
/// millionth of a unit does not count either.
///
/// # Errors
///
/// If the intervals do not fit the inputs, a constant is beyond the doubles, or no point counts.
pub fn measure(
    evaluator: &Evaluator,
    domain: &Domain,
    points: usize,
    seed: u64,
) -> Result<Rounding, Unmeasured> {
    let program = &evaluator.program;
    let measurement = Measurement {
        sampler: Sampler::new(evaluator, domain).ok_or(Unmeasured::Domain)?,
        doubles: program
            .prepare(&mut Doubles)
            .map_err(|_| Unmeasured::Constant)?,
        pairs: program.prepare(&mut Pairs).ok(),
        alone: alone(program),
        seed,
    };
    // Without inputs all points are one.
    let points = match evaluator.is_constant() {
        true => points.min(1),
        false => points,
    };
    let mut errors = measurement.on_threads(points, evaluator.outputs.len());
    let (mut largest, mut percentile_99) = (Vec::new(), Vec::new());
    let points = errors.iter().map(Vec::len).min().unwrap_or(0);
    for errors in &mut errors {
        errors.sort_by(f64::total_cmp);
        let most = (99 * errors.len()).div_ceil(100).checked_sub(1);
        let most = most.ok_or(Unmeasured::NoPoint)?;
        percentile_99.push(errors[most]);
        largest.push(errors[errors.len() - 1]);
    }
    Ok(Rounding {
        points,
        domain: domain.text.clone(),
        largest,
        percentile_99,
    })
}

/// All that a thread needs.
struct Measurement<'a> {
    sampler: Sampler,
    doubles: Prepared<'a, f64>,
    /// None if a constant is out of their range.
    pairs: Option<Prepared<'a, Close>>,
    /// The program of each output, for the points where pairs do not tell.
    alone: Vec<Program>,
    seed: u64,
}

impl Measurement<'_> {
    /// Of each output, its errors at the points that count for it.
    fn on_threads(&self, points: usize, outputs: usize) -> Vec<Vec<f64>> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = points.div_ceil(threads).max(1);
        let mut errors = vec![Vec::new(); outputs];
        std::thread::scope(|scope| {
            let starts = (0..points).step_by(share);
            let parts = starts.map(|start| {
                let part = start..points.min(start + share);
                scope.spawn(move || self.errors(part, outputs))
            });
            for part in parts.collect::<Vec<_>>() {
                let found = part.join();
                let found = found.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
                for (all, part) in errors.iter_mut().zip(found) {
                    all.extend(part);
                }
            }
        });
        errors
    }

    fn errors(&self, points: Range<usize>, outputs: usize) -> Vec<Vec<f64>> {
        let mut errors = vec![Vec::new(); outputs];
        for number in points {
            let point = self.sampler.point(self.seed, number as u64);
            let found = self.doubles.run(&mut Doubles, &point);
            let found = found.expect("only a constant is beyond the doubles");
            let close = self.close(&point);
            for (place, found) in found.into_iter().enumerate() {
                let close = close.as_ref().and_then(|close| close[place].units(found));
                let error = close.or_else(|| exact_units(&self.alone[place], &point, found));
                errors[place].extend(error);
            }
        }
        errors
    }

    /// The outputs in pairs, where these tell all of them.
    fn close(&self, point: &[f64]) -> Option<Vec<Close>> {
        let inputs: Option<Vec<Close>> = point.iter().map(|value| Close::exact(*value)).collect();
        self.pairs.as_ref()?.run(&mut Pairs, &inputs?).ok()
    }
}

/// The program of each output, without what only others need.
fn alone(program: &Program) -> Vec<Program> {
    let alone = |(name, node): &(String, Node)| {
        let mut alone = Program::new(program.inputs().iter().cloned());
        for operation in &program.operations()[program.inputs().len()..] {
            alone.push(operation.clone());
        }
        alone.output(name.clone(), *node);
        prune(&alone)
    };
    program.outputs().iter().map(alone).collect()
}

/// The error of the only output of a program, measured with rationals.
fn exact_units(program: &Program, point: &[f64], found: f64) -> Option<f64> {
    let inputs = point.iter().map(|value| Rational::try_from(*value).ok());
    let inputs: Vec<Rational> = inputs.collect::<Option<_>>()?;
    let output = |bits| evaluate_closely(program, &inputs, bits).pop().flatten();
    let first = output(300)?;
    let is_root = |operation: &Operation| matches!(operation, Operation::SquareRoot(_));
    if program.operations().iter().any(is_root) {
        let second = output(400)?;
        return (unit::difference(&first, &second) <= 1e-6).then(|| units(found, &second));
    }
    Some(units(found, &first))
}
