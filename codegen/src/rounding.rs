//! How far an emitted text is from exact, measured.
//!
//! A program is run in doubles, with the same operations in the same order as the emitted strict text,
//! and over the rationals, at points drawn from a box.

use std::fmt;

use dashu_base::{Abs, BitTest, Sign, SquareRootRem};
use dashu_int::UBig;
use dashu_ratio::Relaxed;

use crate::evaluator::Rounding;
use crate::language::literal::Literal;
use crate::program::{Node, Operation, Program, Rational};

/// Where one input is drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Interval {
    /// The least value.
    pub from: f64,
    /// The greatest value.
    pub to: f64,
}

/// Where the inputs are drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// One interval an input, in the order of the program.
    pub intervals: Vec<Interval>,
    /// The domain in words.
    pub text: String,
}

/// Why there is no measure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unmeasured {
    /// There is not one interval, with finite ends in order, for each input.
    Domain,
    /// A constant is beyond the doubles.
    Constant,
    /// No point of the domain gave a value that is known exactly or closely enough.
    NoPoint,
}

impl fmt::Display for Unmeasured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Unmeasured::Domain => "each input needs an interval with finite ends in order",
            Unmeasured::Constant => "a constant is beyond the range of a double",
            Unmeasured::NoPoint => "no point of the domain has an exact value",
        })
    }
}

impl std::error::Error for Unmeasured {}

/// The outputs in doubles, bit for bit as the strict text gives them.
///
/// None if a constant is beyond the doubles.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate(program: &Program, inputs: &[f64]) -> Option<Vec<f64>> {
    Doubles::new(program).map(|doubles| doubles.run(inputs))
}

/// The outputs over the rationals; none where a divisor is 0 or a root is not rational.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate_exactly(program: &Program, inputs: &[Rational]) -> Vec<Option<Rational>> {
    values(program, inputs, &Precision::Exact)
}

/// The outputs over the rationals, with roots that are not rational taken to this many bits from below;
/// none where a divisor is 0 or a root is not real.
///
/// # Panics
///
/// If there are fewer values than inputs.
pub fn evaluate_closely(
    program: &Program,
    inputs: &[Rational],
    bits: usize,
) -> Vec<Option<Rational>> {
    values(program, inputs, &Precision::Bits(bits))
}

/// A program whose constants are doubles.
struct Doubles<'a> {
    program: &'a Program,
    constants: Vec<f64>,
}

impl<'a> Doubles<'a> {
    fn new(program: &'a Program) -> Option<Self> {
        let constant = |operation: &Operation| match operation {
            Operation::Constant(value) => Literal::of(value).map(|literal| literal.value()),
            _ => Some(0.0),
        };
        let constants: Option<Vec<f64>> = program.operations().iter().map(constant).collect();
        constants.map(|constants| Doubles { program, constants })
    }

    fn run(&self, inputs: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.constants.len());
        for (node, operation) in self.program.nodes() {
            let value = match operation {
                Operation::Input(place) => inputs[*place as usize],
                Operation::Constant(_) => self.constants[node.index()],
                Operation::Add(a, b) => values[a.index()] + values[b.index()],
                Operation::Subtract(a, b) => values[a.index()] - values[b.index()],
                Operation::Multiply(a, b) => values[a.index()] * values[b.index()],
                Operation::Divide(a, b) => values[a.index()] / values[b.index()],
                Operation::Negative(a) => -values[a.index()],
                Operation::SquareRoot(a) => values[a.index()].sqrt(),
            };
            values.push(value);
        }
        let outputs = self.program.outputs().iter();
        outputs.map(|(_, node)| values[node.index()]).collect()
    }
}

/// What becomes of a root that is not rational.
enum Precision {
    /// It has no value.
    Exact,
    /// It is taken to this many bits.
    Bits(usize),
}

/// Fractions are reduced only when they get longer than this: a greatest common divisor costs more than
/// a product.
const LONG: usize = 4096;

fn values(program: &Program, inputs: &[Rational], precision: &Precision) -> Vec<Option<Rational>> {
    let mut values: Vec<Option<Relaxed>> = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        let known = |node: &Node| values[node.index()].as_ref();
        let value = match operation {
            Operation::Input(place) => Some(inputs[*place as usize].clone().relax()),
            Operation::Constant(value) => Some(value.clone().relax()),
            Operation::Add(a, b) => known(a).zip(known(b)).map(|(a, b)| a + b),
            Operation::Subtract(a, b) => known(a).zip(known(b)).map(|(a, b)| a - b),
            Operation::Multiply(a, b) => known(a).zip(known(b)).map(|(a, b)| a * b),
            Operation::Divide(a, b) => match known(a).zip(known(b)) {
                Some((a, b)) if !b.is_zero() => Some(a / b),
                _ => None,
            },
            Operation::Negative(a) => known(a).map(|a| -a.clone()),
            Operation::SquareRoot(a) => known(a).and_then(|a| root(a, precision)),
        };
        values.push(
            value.map(|value| match value.denominator().bit_len() > LONG {
                true => value.canonicalize().relax(),
                false => value,
            }),
        );
    }
    let output = |(_, node): &(String, Node)| {
        let value = values[node.index()].clone();
        value.map(Relaxed::canonicalize)
    };
    program.outputs().iter().map(output).collect()
}

/// √(p/q) = √(pq)/q, from below.
fn root(value: &Relaxed, precision: &Precision) -> Option<Relaxed> {
    // An exact root is found in lowest terms, where both parts are squares.
    let value = value.clone().canonicalize();
    let (sign, above) = value.numerator().clone().into_parts();
    if sign == Sign::Negative && !value.is_zero() {
        return None;
    }
    let below = value.denominator().clone();
    let product = above * &below;
    let shift = match precision {
        Precision::Exact => 0,
        Precision::Bits(bits) => bits.saturating_sub(product.bit_len() / 2),
    };
    let (root, rest) = (product << (2 * shift)).sqrt_rem();
    let exact = rest == UBig::ZERO;
    let close = matches!(precision, Precision::Bits(_));
    (exact || close).then(|| Relaxed::from_parts(root.into(), below << shift))
}

/// Runs a program at points of a domain and reports the largest error of each output, in units in the
/// last place of the exact value.
///
/// The same seed gives the same points. Where an output has no exact value the point does not count for
/// it. Roots are taken to 300 bits, and once more to 400: a point where that makes a difference of more
/// than a millionth of a unit does not count either. The cost is that of exact arithmetic: some
/// microseconds an operation and point.
///
/// # Errors
///
/// If the intervals do not fit the inputs, a constant is beyond the doubles, or no point counts.
pub fn measure(
    program: &Program,
    domain: &Domain,
    points: usize,
    seed: u64,
) -> Result<Rounding, Unmeasured> {
    let fits = |interval: &Interval| {
        interval.from.is_finite() && interval.to.is_finite() && interval.from <= interval.to
    };
    let count = program.inputs().len();
    if domain.intervals.len() != count || !domain.intervals.iter().all(fits) {
        return Err(Unmeasured::Domain);
    }
    let doubles = Doubles::new(program).ok_or(Unmeasured::Constant)?;
    let roots = program
        .operations()
        .iter()
        .any(|operation| matches!(operation, Operation::SquareRoot(_)));
    let mut random = Random(seed);
    let mut largest: Vec<Option<f64>> = vec![None; program.outputs().len()];
    for _ in 0..points {
        let point: Vec<f64> = domain
            .intervals
            .iter()
            .map(|interval| random.within(interval))
            .collect();
        let exact: Option<Vec<Rational>> = point
            .iter()
            .map(|value| Rational::try_from(*value).ok())
            .collect();
        let Some(exact) = exact else { continue };
        let found = doubles.run(&point);
        let first = values(program, &exact, &Precision::Bits(300));
        let second = match roots {
            true => values(program, &exact, &Precision::Bits(400)),
            false => first.clone(),
        };
        for (place, found) in found.into_iter().enumerate() {
            let (Some(first), Some(second)) = (&first[place], &second[place]) else {
                continue;
            };
            if roots && difference(first, second) > 1e-6 {
                continue;
            }
            let error = units(found, second);
            let known = largest[place].unwrap_or(0.0);
            largest[place] = Some(known.max(error));
        }
    }
    let largest: Option<Vec<f64>> = largest.into_iter().collect();
    Ok(Rounding {
        points,
        domain: domain.text.clone(),
        largest: largest.ok_or(Unmeasured::NoPoint)?,
    })
}

/// The distance of a double from an exact value, in units in the last place of that value; infinite if
/// the double is.
pub fn units(found: f64, exact: &Rational) -> f64 {
    match Rational::try_from(found) {
        Ok(found) => difference(&found, exact),
        Err(_) => f64::INFINITY,
    }
}

fn difference(found: &Rational, exact: &Rational) -> f64 {
    if found == exact {
        return 0.0;
    }
    let unit = unit_in_the_last_place(exact);
    ((found - exact).abs() / unit).to_f64().value()
}

/// The distance between the doubles around a value: 2^(e − 52) for 2^e ≤ |value| < 2^(e + 1), at least
/// that of the subnormal ones.
fn unit_in_the_last_place(value: &Rational) -> Rational {
    let magnitude = value.clone().abs();
    let two = Rational::from(2);
    let power = |exponent: isize| two.pow(exponent);
    if magnitude.is_zero() {
        return power(-1074);
    }
    let above = magnitude.numerator().bit_len() as isize;
    let below = magnitude.denominator().bit_len() as isize;
    let mut exponent = above - below;
    if power(exponent) > magnitude {
        exponent -= 1;
    }
    power(exponent.max(-1022) - 52)
}

/// SplitMix64: the same points on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    fn within(&mut self, interval: &Interval) -> f64 {
        let fraction = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        let value = interval.from * (1.0 - fraction) + interval.to * fraction;
        value.clamp(interval.from, interval.to)
    }
}
