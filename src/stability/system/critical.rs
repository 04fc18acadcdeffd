//! All values of one parameter at which the stability of a system changes.

use std::collections::BTreeMap;

use rayon::prelude::*;
use sextic_codegen::evaluator::Circular;

use crate::algebra::interval::Intervals;
use crate::algebra::number::{Integer, Rational};

use super::System;
use super::arithmetic::{above, ball, nearest};
use super::block::blocks;
use super::entries::{Entries, Matrices, check};
use super::error::SystemError;
use super::jet::{Jet, Jets};
use super::motion::{Motion, motion};
use super::parameter::{Parameters, chosen, is_double, names};
use super::real::Real;

/// What is certain of a system at all values of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// All eigenvalues have negative real parts.
    Stable,
    /// None has a positive real part, and those of some coordinates without damping are imaginary, exactly.
    Neutral,
    /// An eigenvalue has a positive real part.
    Unstable,
    /// A real eigenvalue is above 0, whether another motion grows beside it or not.
    Divergent,
    /// None of these is shown.
    Undecided,
}

impl Stability {
    /// `stable`, `neutral`, `unstable`, `divergent` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Stability::Stable => "stable",
            Stability::Neutral => "neutral",
            Stability::Unstable => "unstable",
            Stability::Divergent => "divergent",
            Stability::Undecided => "undecided",
        }
    }
}

/// Values of a parameter, all of one stability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRange {
    /// The least value.
    pub from: f64,
    /// The largest value.
    pub to: f64,
    /// What is certain at every value between.
    pub stability: Stability,
}

/// A value at which stability changes: it differs for certain on both sides of what is left open, which is less than
/// 2⁻³⁰ of the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalValue {
    /// The value.
    pub value: f64,
    /// The change is no farther away.
    pub error: f64,
    /// What the system is above it.
    pub becomes: Stability,
}

/// The values of a parameter from a first to a last one.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranges {
    /// Ranges in order.
    pub ranges: Vec<ParameterRange>,
    /// The values at which stability changes for certain, in order, each between two ranges.
    pub critical: Vec<CriticalValue>,
}

/// A part of the range is halved at most so often: to 6e-14 of it.
const DEEPEST: usize = 44;

/// What is open between parts on which stability differs encloses a critical value, if it is below this power of 1/2
/// of the range.
const NARROW: usize = 30;

/// The most parts that are looked at.
const MOST_PARTS: usize = 12_000;

impl System {
    /// The ranges of a parameter on which the system is stable, neutral, unstable or divergent for certain, from `from` to
    /// `to`, and the values between at which that changes. It may be an angle, too; the others have the given `values`.
    ///
    /// On a part of the range the matrices are known to second order, by running the program in such numbers, and the
    /// eigenvalues lie in discs that move with the parameter and whose radii are of second order. A part on which the
    /// discs decide nothing is halved, down to 2⁻⁴⁴ of the range. Coordinates that do not couple are taken apart, and
    /// those without any damping by λ², so that what is neutral is known to be.
    ///
    /// Bounded: at most 12,000 parts, each with one run of the program and some n³ operations; what these leave open is
    /// undecided. The same on any number of cores.
    ///
    /// # Errors
    ///
    /// As [`System::at`] for missing, unknown and impossible parameters, and a range without a width.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use sextic::algebra::number::Rational;
    /// use sextic::stability::system::System;
    /// use sextic::stability::system::critical::Stability;
    /// use sextic_codegen::evaluator::Evaluator;
    /// use sextic_codegen::program::Program;
    ///
    /// // q̈ + c q̇ + k q = 0
    /// let mut program = Program::new(["c".to_string(), "k".to_string()]);
    /// let [c, k] = ["c", "k"].map(|name| program.input(name).unwrap());
    /// let one = program.constant(Rational::ONE);
    /// for (name, node) in [("M", one), ("C", c), ("K", k)] {
    ///     program.output(name, node);
    /// }
    /// let system = System {
    ///     evaluator: Evaluator::plain("oscillator", program),
    ///     coordinates: vec!["q".to_string()],
    ///     damping: vec![String::new()],
    ///     stiffness: vec![String::new()],
    /// };
    /// let values = BTreeMap::from([("k".to_string(), Rational::from(9))]);
    /// let found = system.critical(&values, "c", &Rational::from(-2), &Rational::from(1))?;
    /// let kinds: Vec<Stability> = found.ranges.iter().map(|own| own.stability).collect();
    /// assert_eq!(kinds, [Stability::Unstable, Stability::Stable]);
    /// let critical = &found.critical[0];
    /// assert!(critical.value.abs() <= critical.error && critical.error < 1e-8);
    /// # Ok::<(), sextic::stability::system::error::SystemError>(())
    /// ```
    pub fn critical(
        &self,
        values: &BTreeMap<String, Rational>,
        over: &str,
        from: &Rational,
        to: &Rational,
    ) -> Result<Ranges, SystemError> {
        check(self)?;
        check_range(self, over, from, to)?;
        let mut values = values.clone();
        values.insert(over.to_string(), from.clone());
        let parameters = Parameters::new(&self.evaluator, &values)?;
        let search = Search {
            system: self,
            inputs: prepared(&parameters, over),
            from,
            width: to - from,
        };
        Ok(search.ranges(&search.parts()))
    }
}

fn check_range(
    system: &System,
    over: &str,
    from: &Rational,
    to: &Rational,
) -> Result<(), SystemError> {
    let known = names(&system.evaluator);
    if !known.iter().any(|name| name == over) {
        return Err(SystemError::Unknown {
            names: vec![over.to_string()],
            known,
        });
    }
    let wrong = |reason| {
        Err(SystemError::Range {
            name: over.to_string(),
            reason,
        })
    };
    match (is_double(from) && is_double(to), from < to) {
        (false, _) => wrong("has an end beyond the doubles: check its unit"),
        (_, false) => wrong("has no width: give a last value above the first"),
        _ => Ok(()),
    }
}

/// Where an input of the program comes from while one parameter moves.
enum Prepared {
    /// It stays.
    Still(Real),
    /// It is the parameter.
    Moving,
    /// It is the cosine or sine of an angle at the first value of the parameter, and a multiple of what is beyond.
    Turning(Circular, Rational, i32),
}

fn prepared(parameters: &Parameters<'_>, over: &str) -> Vec<Prepared> {
    let intervals = Intervals::new(128);
    let number = |name: &str, value: &Rational| match name == over {
        true => Prepared::Moving,
        false => Prepared::Still(nearest(value)),
    };
    let circular = |own: &Circular, angle: &Rational| {
        let parts = own.angle.iter().filter(|(_, name)| name == over);
        match parts.map(|(count, _)| *count).sum() {
            0 => Prepared::Still(ball(
                &chosen(own.function, intervals.cosine_and_sine(angle)),
                &intervals,
            )),
            count => Prepared::Turning(own.clone(), angle.clone(), count),
        }
    };
    parameters.inputs(number, circular)
}

/// A part of the range: from place/2^depth to one more.
#[derive(Clone, Debug)]
struct Part {
    place: Integer,
    depth: usize,
    found: Stability,
}

impl Part {
    fn ends(&self) -> [Rational; 2] {
        let unit = Rational::from(Integer::ONE << self.depth);
        [self.place.clone(), &self.place + Integer::ONE].map(|own| Rational::from(own) / &unit)
    }

    fn halves(&self) -> [Part; 2] {
        let place = &self.place << 1;
        [place.clone(), place + Integer::ONE].map(|place| Part {
            place,
            depth: self.depth + 1,
            found: Stability::Undecided,
        })
    }
}

struct Search<'a> {
    system: &'a System,
    inputs: Vec<Prepared>,
    from: &'a Rational,
    width: Rational,
}

impl Search<'_> {
    /// The parts in order, each with what is certain of it: all of one depth before those of the next, so that what is
    /// left at the end is spread over the range.
    fn parts(&self) -> Vec<Part> {
        let whole = Part {
            place: Integer::ZERO,
            depth: 0,
            found: Stability::Undecided,
        };
        let (mut open, mut done, mut count) = (vec![whole], Vec::new(), 0);
        while !open.is_empty() {
            count += open.len();
            let looked: Vec<Part> = open
                .into_par_iter()
                .map(|own| self.looked_at(own))
                .collect();
            open = Vec::new();
            for part in looked {
                match part.found == Stability::Undecided && part.depth < DEEPEST {
                    true => open.push(part),
                    false => done.push(part),
                }
            }
            if count + 2 * open.len() > MOST_PARTS {
                done.append(&mut open);
            }
            open = open.iter().flat_map(Part::halves).collect();
        }
        done.sort_by_cached_key(|own| own.ends()[0].clone());
        done
    }

    fn looked_at(&self, part: Part) -> Part {
        let found = self.stability(&part).unwrap_or(Stability::Undecided);
        Part { found, ..part }
    }

    /// The value at a share of the range.
    fn value(&self, share: &Rational) -> Rational {
        self.from + &self.width * share
    }

    /// What is certain on a part.
    fn stability(&self, part: &Part) -> Option<Stability> {
        let [low, high] = part.ends().map(|own| self.value(&own));
        let exact = (&low + &high) / Rational::from(2);
        let middle = exact.to_f64().value();
        // About a double, so that the middle is exact; the step reaches both ends.
        let double = Rational::try_from(middle).ok()?;
        let h = above(&(&high - &double)).max(above(&(&double - &low)));
        let matrices = self.matrices(&double, middle, h)?;
        let motions = blocks(&structure(&matrices))
            .into_iter()
            .map(|block| motion(&matrices.block(&block), h));
        Some(together(&motions.collect::<Vec<_>>()))
    }

    /// The matrices near a value.
    fn matrices(&self, exact: &Rational, middle: f64, h: f64) -> Option<Matrices<Jet>> {
        let intervals = Intervals::new(96);
        let beyond = exact - self.from;
        let input = |own: &Prepared| match own {
            Prepared::Still(value) => Jet::constant(*value),
            Prepared::Moving => Jet::parameter(Real::exact(middle)),
            Prepared::Turning(circular, angle, count) => {
                let angle = angle + &beyond * Rational::from(*count);
                let pair = intervals
                    .cosine_and_sine(&angle)
                    .map(|own| ball(&own, &intervals));
                chosen(circular.function, Jet::circular(*count, pair))
            }
        };
        let inputs: Vec<Jet> = self.inputs.iter().map(input).collect();
        let outputs = self
            .system
            .evaluator
            .program
            .run(&mut Jets::new(h), &inputs)
            .ok()?;
        let entries = Entries::new(self.system, &outputs)?;
        let sum = |a: &Jet, b: &Jet| Ok::<Jet, std::convert::Infallible>(a.sum(b));
        let Ok(matrices) = entries.sums(&Jet::default(), sum);
        Some(matrices)
    }

    /// Ranges and critical values by what is known of the parts.
    fn ranges(&self, parts: &[Part]) -> Ranges {
        let mut found = Ranges {
            ranges: Vec::new(),
            critical: Vec::new(),
        };
        let mut stretches: Vec<(Rational, Rational, Stability)> = Vec::new();
        for part in parts {
            let [from, to] = part.ends();
            match stretches.last_mut() {
                Some(last) if last.2 == part.found => last.1 = to,
                _ => stretches.push((from, to, part.found)),
            }
        }
        for (place, own) in stretches.iter().enumerate() {
            let beside = |other: Option<usize>| {
                other
                    .and_then(|other| stretches.get(other))
                    .map(|own| own.2)
            };
            match (beside(place.checked_sub(1)), beside(Some(place + 1))) {
                (Some(below), Some(becomes))
                    if own.2 == Stability::Undecided && below != becomes && is_narrow(own) =>
                {
                    found.critical.push(self.critical_value(own, becomes));
                }
                _ => found.ranges.push(self.range(own)),
            }
        }
        found
    }

    fn range(&self, (from, to, stability): &(Rational, Rational, Stability)) -> ParameterRange {
        let [low, high] = [from, to].map(|own| self.value(own));
        let (mut from, mut to) = (low.to_f64().value(), high.to_f64().value());
        // What is said of a range is said of the doubles at its ends.
        if Rational::try_from(from).is_ok_and(|own| own < low) {
            from = from.next_up();
        }
        if Rational::try_from(to).is_ok_and(|own| own > high) {
            to = to.next_down();
        }
        ParameterRange {
            from,
            to,
            stability: *stability,
        }
    }

    fn critical_value(
        &self,
        (from, to, _): &(Rational, Rational, Stability),
        becomes: Stability,
    ) -> CriticalValue {
        let [low, high] = [from, to].map(|own| self.value(own));
        let value = ((&low + &high) / Rational::from(2)).to_f64().value();
        let exact = Rational::try_from(value).unwrap_or_default();
        CriticalValue {
            value,
            error: above(&(&high - &exact)).max(above(&(exact - low))),
            becomes,
        }
    }
}

fn is_narrow((from, to, _): &(Rational, Rational, Stability)) -> bool {
    (to - from) * Rational::from(1_u64 << NARROW) <= Rational::ONE
}

/// Which entries are 0 at all values of a part.
fn structure(matrices: &Matrices<Jet>) -> Matrices<Real> {
    matrices.map(|_, own| if own.is_zero() { Real::ZERO } else { Real::ONE })
}

/// What is certain of blocks together.
fn together(motions: &[Motion]) -> Stability {
    match motions.iter().max() {
        Some(Motion::Divergent) => Stability::Divergent,
        Some(Motion::Growing) => Stability::Unstable,
        Some(Motion::Neutral) => Stability::Neutral,
        Some(Motion::Damped) => Stability::Stable,
        Some(Motion::Unknown) | None => Stability::Undecided,
    }
}
