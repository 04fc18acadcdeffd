//! The entries of a system at numbers: exact ones, and enclosures with as many digits as they need.

use sextic_codegen::evaluator::Circular;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Budget;
use crate::algebra::interval::{Interval, Intervals};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::stability::verdict::LONGEST_POLYNOMIAL;

use super::System;
use super::arithmetic::{Enclosures, NoValue, Sums, ball};
use super::entries::{Entries, Matrices};
use super::error::SystemError;
use super::parameter::{Parameters, chosen};
use super::real::Real;

/// The digits with which matrices are enclosed: more where fewer leave an entry open.
pub(super) const DIGITS: [usize; 3] = [256, 1024, 4096];

/// An entry is known well enough if its bound is below this share of it, or it is 0.
const CLOSE: f64 = 1e-12;

/// The entries with as many digits as they need.
pub(super) fn close_entries(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
) -> Result<(Entries<Real>, Matrices<Real>), SystemError> {
    let mut found = Err(NoValue::NotExact);
    for bits in DIGITS {
        found = enclosed_entries(system, parameters, exact, &Intervals::new(bits));
        if is_close(&found) {
            break;
        }
    }
    found.map_err(cause)
}

/// Why a program has no value, for a reader.
pub(super) fn cause(reason: NoValue) -> SystemError {
    match reason {
        NoValue::Root => SystemError::Root,
        NoValue::Division | NoValue::NotExact => SystemError::Division,
    }
}

/// The entries in exact numbers; `None` where they have none, or too long ones.
pub(super) fn exact_entries(
    system: &System,
    parameters: &Parameters<'_>,
) -> Result<Option<Entries<Sum>>, SystemError> {
    let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
    let circular = |own: &Circular, angle: &Rational| {
        chosen(own.function, [Sum::cosine(angle), Sum::sine(angle)])
    };
    let inputs = parameters.inputs(|_, own| Sum::from(own.clone()), circular);
    match system.evaluator.program.run(&mut Sums(&sums), &inputs) {
        Ok(outputs) => Ok(Entries::new(system, &outputs)),
        Err(NoValue::NotExact) => Ok(None),
        Err(reason) => Err(cause(reason)),
    }
}

pub(super) fn totals(entries: &Entries<Sum>) -> Option<Matrices<Sum>> {
    let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
    entries.sums(&Sum::default(), |a, b| sums.sum(a, b)).ok()
}

/// The entries with so many digits.
pub(super) fn intervals_of(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
    intervals: &Intervals,
) -> Result<Entries<Interval>, NoValue> {
    if let Some(exact) = exact {
        return Ok(exact.map(|own| intervals.enclosure(own)));
    }
    let circular =
        |own: &Circular, angle: &Rational| chosen(own.function, intervals.cosine_and_sine(angle));
    let inputs = parameters.inputs(|_, own| intervals.rational(own), circular);
    let outputs = system
        .evaluator
        .program
        .run(&mut Enclosures(intervals), &inputs)?;
    Entries::new(system, &outputs).ok_or(NoValue::NotExact)
}

/// The entries and the sums of parts, in doubles with bounds.
fn enclosed_entries(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
    intervals: &Intervals,
) -> Result<(Entries<Real>, Matrices<Real>), NoValue> {
    let entries = intervals_of(system, parameters, exact, intervals)?;
    let Ok(matrices) = entries.sums(&intervals.zero(), |a, b| intervals.sum(a, b));
    let round = |own: &Interval| ball(own, intervals);
    Ok((entries.map(round), matrices.map(|_, own| round(own))))
}

/// Whether more digits would say no more.
fn is_close(found: &Result<(Entries<Real>, Matrices<Real>), NoValue>) -> bool {
    let Ok((_, matrices)) = found else {
        return false;
    };
    let is_close = |own: &Real| own.radius <= CLOSE * own.centre.abs();
    matrices.powers.iter().flatten().all(is_close)
}
