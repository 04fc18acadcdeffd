//! How far a closed form is from the eigenvalues of its system, over the domain of a document.

use std::collections::BTreeMap;

use num_complex::Complex;
use rayon::prelude::*;
use sextic_codegen::arithmetic::doubles::evaluate_at;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::literal::Decimal;
use sextic_codegen::random::mixed;
use sextic_codegen::rounding::Interval;

use crate::algebra::number::{Integer, Rational};

use super::roots::roots;
use super::system::System;
use super::system::error::SystemError;
use super::system::instance::Instance;
use super::verdict::Verdict;

/// Which numbers of a system the outputs of a closed form stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approximated {
    /// The real parts of its eigenvalues, one of each pair of conjugates.
    RealParts,
    /// The eigenvalues with positive imaginary parts: as many real parts, and then the imaginary parts.
    Eigenvalues,
}

/// A closed form and the system that it is close to.
#[derive(Clone, Copy, Debug)]
pub struct ClosedForm<'a> {
    /// What it computes.
    pub evaluator: &'a Evaluator,
    /// What that stands for.
    pub approximated: Approximated,
    /// Whether the outputs are the coefficients of a monic polynomial whose roots do: the real parts from the power
    /// n − 1 down to 0, and then as many imaginary parts.
    pub by_roots: bool,
    /// The system.
    pub system: &'a System,
    /// Where quantities are drawn from, by name; an angle without an interval is drawn from all around the circle.
    pub domain: &'a BTreeMap<String, Interval>,
}

/// How far a closed form is from the eigenvalues.
#[derive(Clone, Debug, PartialEq)]
pub struct Closeness {
    /// How many points were drawn.
    pub points: usize,
    /// The errors at the points that count, in ascending order: of all numbers, the largest distance from the exact
    /// one, over the largest exact one.
    pub errors: Vec<f64>,
    /// At how many points the system does not oscillate in all its modes, so that nothing is compared.
    pub overdamped: usize,
    /// At how many points the closed form or the system has no number.
    pub without_value: usize,
    /// At how many points stability is certain, and the largest real part of the form is on a side of 0.
    pub decided: usize,
    /// At how many of these it is on the wrong side.
    pub wrong_signs: usize,
    /// The point with the largest error.
    pub worst: Option<Point>,
    /// The first point with a wrong sign.
    pub first_wrong: Option<Point>,
}

/// Quantities by name.
pub type Point = BTreeMap<String, Rational>;

/// What is found at one point.
struct Found {
    error: Option<f64>,
    is_overdamped: bool,
    /// Whether the sign is wrong, where that is certain.
    is_wrong: Option<bool>,
}

/// Points are drawn on a grid of so many steps an interval, so that they have few digits.
const STEPS: u64 = 1000;

/// Angles lie between this number of thousandths of a radian and its negative: a circle but for a little.
const HALF_TURN: u32 = 3141;

impl ClosedForm<'_> {
    /// Compares the form with the eigenvalues at so many points of the domain: the same in every run.
    ///
    /// Complexity: a run of both programs, and the eigenvalues with their verdict, at each point.
    ///
    /// # Errors
    ///
    /// [`SystemError::Missing`] for quantities without an interval, and those of the system itself.
    pub fn closeness(&self, points: usize) -> Result<Closeness, SystemError> {
        let names = self.names();
        let missing = names.iter().filter(|name| self.interval(name).is_none());
        let missing: Vec<String> = missing.cloned().collect();
        if !missing.is_empty() {
            return Err(SystemError::Missing { names: missing });
        }
        let numbered = (0..points as u64).into_par_iter();
        let found = numbered.map(|number| {
            let point = self.point(&names, number);
            let found = self.compare(&point);
            (point, found)
        });
        Ok(summary(found.collect()))
    }

    /// What both programs need, each once.
    pub fn names(&self) -> Vec<String> {
        let mut names = self.system.names();
        let own = self.evaluator.inputs.iter();
        let given = own.filter(|input| input.circular().is_none() && input.fixed().is_none());
        let angles = self
            .evaluator
            .open_angles()
            .map(|angle| &angle.quantity.name);
        for name in given.map(|input| &input.quantity.name).chain(angles) {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        names
    }

    fn interval(&self, name: &str) -> Option<Interval> {
        if let Some(interval) = self.domain.get(name) {
            return Some(interval.clone());
        }
        let is_angle = self
            .evaluator
            .angle(name)
            .or(self.system.evaluator.angle(name));
        let half = Rational::from(HALF_TURN) / Rational::from(1000_u32);
        is_angle.map(|_| Interval {
            from: -half.clone(),
            to: half,
        })
    }

    fn point(&self, names: &[String], number: u64) -> Point {
        let place = |(column, name): (usize, &String)| {
            let Interval { from, to } = self.interval(name)?;
            let step = mixed(number * names.len() as u64 + column as u64 + 1) % (STEPS + 1);
            let share = Rational::from(Integer::from(step)) / Rational::from(Integer::from(STEPS));
            Some((name.clone(), &from + (to - &from) * share))
        };
        names.iter().enumerate().filter_map(place).collect()
    }

    fn compare(&self, point: &Point) -> Option<Found> {
        let of_system = self.system.names();
        let own = point.iter().filter(|(name, _)| of_system.contains(name));
        let own: Point = own
            .map(|(name, value)| (name.clone(), value.clone()))
            .collect();
        let instance = self.system.at(&own).ok()?;
        let doubles = point.iter();
        let doubles =
            doubles.map(|(name, value)| Some((name.clone(), Decimal::nearest(value)?.value)));
        let outputs = evaluate_at(self.evaluator, &doubles.collect::<Option<_>>()?)?;
        if !outputs.iter().all(|output| output.is_finite()) {
            return None;
        }
        self.beside(&outputs, &instance)
    }

    fn beside(&self, outputs: &[f64], instance: &Instance<'_>) -> Option<Found> {
        let spectrum = instance.spectrum().ok()?;
        let pairs = spectrum.eigenvalues.iter().filter(|own| own.value.im > 0.0);
        let mut exact: Vec<Complex<f64>> = pairs.map(|own| own.value).collect();
        let count = self.system.coordinates.len();
        let mut form = self.numbers(outputs)?;
        if self.approximated == Approximated::RealParts {
            let numbers = form.iter_mut().chain(&mut exact);
            numbers.for_each(|own| own.im = 0.0);
        }
        let largest = form
            .iter()
            .map(|own| own.re)
            .fold(f64::NEG_INFINITY, f64::max);
        let is_overdamped = exact.len() != count;
        Some(Found {
            error: (!is_overdamped).then(|| distance(&mut form, &mut exact)),
            is_overdamped,
            is_wrong: is_wrong(largest, instance.verdict()),
        })
    }

    /// What outputs stand for; `None` where a polynomial has no roots that are found.
    fn numbers(&self, outputs: &[f64]) -> Option<Vec<Complex<f64>>> {
        if !self.by_roots && self.approximated == Approximated::RealParts {
            return Some(outputs.iter().map(|own| Complex::from(*own)).collect());
        }
        let (real, imaginary) = outputs.split_at(outputs.len() / 2);
        let pairs = real.iter().zip(imaginary);
        let numbers: Vec<_> = pairs.map(|(re, im)| Complex::new(*re, *im)).collect();
        match self.by_roots {
            true => roots(&numbers),
            false => Some(numbers),
        }
    }
}

/// Whether the sign of the largest real part is certainly wrong; `None` where nothing is certain.
fn is_wrong(largest: f64, verdict: Verdict) -> Option<bool> {
    match verdict {
        Verdict::Stable(_) => Some(largest > 0.0),
        Verdict::Unstable(_) => Some(largest < 0.0),
        Verdict::Undecided(_) => None,
    }
}

/// The largest distance of two sets of numbers, each in order, over the largest exact one.
fn distance(form: &mut [Complex<f64>], exact: &mut [Complex<f64>]) -> f64 {
    let order = |a: &Complex<f64>, b: &Complex<f64>| (a.im, a.re).partial_cmp(&(b.im, b.re));
    for numbers in [&mut *form, &mut *exact] {
        numbers.sort_by(|a, b| order(a, b).unwrap_or(std::cmp::Ordering::Equal));
    }
    let largest = exact.iter().map(|own| own.norm()).fold(0.0, f64::max);
    let pairs = form.iter().zip(exact.iter());
    pairs
        .map(|(one, other)| (one - other).norm())
        .fold(0.0, f64::max)
        / largest
}

fn summary(found: Vec<(Point, Option<Found>)>) -> Closeness {
    let mut closeness = Closeness {
        points: found.len(),
        errors: Vec::new(),
        overdamped: 0,
        without_value: 0,
        decided: 0,
        wrong_signs: 0,
        worst: None,
        first_wrong: None,
    };
    let mut largest = f64::NEG_INFINITY;
    for (point, found) in found {
        let Some(found) = found else {
            closeness.without_value += 1;
            continue;
        };
        closeness.overdamped += usize::from(found.is_overdamped);
        closeness.decided += usize::from(found.is_wrong.is_some());
        if found.is_wrong == Some(true) {
            closeness.wrong_signs += 1;
            closeness.first_wrong.get_or_insert_with(|| point.clone());
        }
        let Some(error) = found.error.filter(|error| !error.is_nan()) else {
            continue;
        };
        closeness.errors.push(error);
        if error > largest {
            largest = error;
            closeness.worst = Some(point);
        }
    }
    closeness.errors.sort_by(f64::total_cmp);
    closeness
}

impl Closeness {
    /// What the error is below at such a share of the points, from 0 to 1; `None` where nothing was compared.
    pub fn quantile(&self, share: f64) -> Option<f64> {
        let last = self.errors.len().checked_sub(1)?;
        self.errors
            .get((share * last as f64).ceil() as usize)
            .copied()
    }
}
