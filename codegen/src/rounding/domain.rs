//! Where points are drawn from.

use std::collections::BTreeMap;

use crate::evaluator::{Angle, Evaluator, Function, Origin};
use crate::language::literal::Decimal;
use crate::program::Rational;
use crate::random::scrambled;

/// Where one input is drawn from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The least value.
    pub from: Rational,
    /// The greatest value.
    pub to: Rational,
}

/// Where the inputs are drawn from: each given one from an interval, the sines and cosines from all
/// around the circle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain {
    /// The intervals by the names of the inputs; those of other names are not looked at.
    pub intervals: BTreeMap<String, Interval>,
    /// The domain in words.
    pub text: String,
}

/// A point of the unit circle: cosine and sine of an angle.
type Direction = (f64, f64);

/// What one input is at each point.
enum Source {
    Fixed(f64),
    Between(f64, f64),
    /// The function of so many times the angles of these places.
    Circular(Function, Vec<(i32, usize)>),
}

/// Draws points of a domain for the inputs of an evaluator.
pub(super) struct Sampler {
    sources: Vec<Source>,
    /// The directions of the angles that are fixed.
    angles: Vec<Option<Direction>>,
}

impl Sampler {
    /// None if a given input has no interval of doubles in order, or a fixed number is no double.
    pub(super) fn new(evaluator: &Evaluator, domain: &Domain) -> Option<Self> {
        let double = |value: &Rational| Some(Decimal::nearest(value)?.value);
        let place = |name: &String| {
            let mut angles = evaluator.angles.iter();
            angles.position(|angle| angle.quantity.name == *name)
        };
        let source = |(name, origin): (&String, &Origin)| match origin {
            Origin::Fixed(fixed) => Some(Source::Fixed(double(&fixed.value)?)),
            Origin::Given => {
                let interval = domain.intervals.get(name)?;
                let ends = (double(&interval.from)?, double(&interval.to)?);
                (interval.from <= interval.to).then_some(Source::Between(ends.0, ends.1))
            }
            Origin::Circular(circular) => {
                let parts = circular.angle.iter();
                let parts: Option<_> = parts.map(|(n, name)| Some((*n, place(name)?))).collect();
                Some(Source::Circular(circular.function, parts?))
            }
        };
        let inputs = evaluator.inputs.iter();
        let inputs = inputs.map(|input| (&input.quantity.name, &input.origin));
        let direction = |angle: &Angle| match &angle.fixed {
            Some(fixed) => Some(Some(direction(double(&fixed.value)?))),
            None => Some(None),
        };
        Some(Sampler {
            sources: inputs.map(source).collect::<Option<_>>()?,
            angles: evaluator
                .angles
                .iter()
                .map(direction)
                .collect::<Option<_>>()?,
        })
    }

    /// The point of this number: the same for the same seed, whatever was drawn before.
    pub(super) fn point(&self, seed: u64, number: u64) -> Vec<f64> {
        let mut random = Random(scrambled(seed) ^ scrambled(!number));
        let angles: Vec<Direction> = self
            .angles
            .iter()
            .map(|fixed| fixed.unwrap_or_else(|| random.direction()))
            .collect();
        let value = |source: &Source| match source {
            Source::Fixed(value) => *value,
            Source::Between(from, to) => random.within(*from, *to),
            Source::Circular(function, parts) => {
                let sum = parts.iter().fold((1.0, 0.0), |sum, (count, place)| {
                    turned(sum, multiple(angles[*place], *count))
                });
                match function {
                    Function::Cosine => sum.0,
                    Function::Sine => sum.1,
                }
            }
        };
        self.sources.iter().map(value).collect()
    }
}

/// The direction of the sum of two angles.
fn turned(a: Direction, b: Direction) -> Direction {
    (a.0 * b.0 - a.1 * b.1, a.1 * b.0 + a.0 * b.1)
}

/// The direction of a multiple of an angle.
fn multiple(angle: Direction, count: i32) -> Direction {
    let (mut product, mut power) = ((1.0, 0.0), angle);
    let mut rest = count.unsigned_abs();
    while rest > 0 {
        if rest % 2 == 1 {
            product = turned(product, power);
        }
        power = turned(power, power);
        rest /= 2;
    }
    match count < 0 {
        true => (product.0, -product.1),
        false => product,
    }
}

/// The direction of an angle. Libraries differ in the last bits of a sine; this one does not.
fn direction(angle: f64) -> Direction {
    // Halved until the series converges fast, then doubled as often.
    let (mut part, mut halvings) = (angle, 0);
    while part.abs() > 0.5 {
        part *= 0.5;
        halvings += 1;
    }
    let (mut cosine, mut sine, mut term) = (1.0, 0.0, 1.0);
    for order in 1..20_u8 {
        term *= part / f64::from(order);
        match order % 4 {
            0 => cosine += term,
            1 => sine += term,
            2 => cosine -= term,
            _ => sine -= term,
        }
    }
    let doubled = |direction, _| unit(turned(direction, direction));
    (0..halvings).fold((cosine, sine), doubled)
}

/// The direction of a vector that is not 0.
fn unit(vector: Direction) -> Direction {
    let length = (vector.0 * vector.0 + vector.1 * vector.1).sqrt();
    (vector.0 / length, vector.1 / length)
}

/// SplitMix64: the same points on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        scrambled(self.0)
    }

    /// Of [0, 1).
    fn fraction(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, from: f64, to: f64) -> f64 {
        let fraction = self.fraction();
        (from * (1.0 - fraction) + to * fraction).clamp(from, to)
    }

    /// From a disc, so that no angle is more likely than another.
    fn direction(&mut self) -> Direction {
        loop {
            let (x, y) = (2.0 * self.fraction() - 1.0, 2.0 * self.fraction() - 1.0);
            let square = x * x + y * y;
            if square <= 1.0 && square > 1e-6 {
                return unit((x, y));
            }
        }
    }
}
