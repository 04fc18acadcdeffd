//! `{"method", "eigenvalues": [{"re", "im", "error"}…], "s3d", "s3d_error", "verdict", "diverges", "reason",
//! "warnings": […]}`, and with shapes `"shape": {"x": {"re", "im"}, "y", "r_theta"}`, or the coordinates of a system, in each of the eigenvalues.

use serde::Serialize;

use crate::report::modes::{ModeFound, ModesFound, Moving, Shape};

use super::pairs::{Pairs, coefficients};
use super::stability::{WithinErrors, within_errors};
use super::twist::TwistFound;
use super::write;

#[derive(Serialize)]
struct Found<'a> {
    method: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    twist: Option<TwistFound>,
    eigenvalues: Vec<Eigenvalue>,
    s3d: Option<f64>,
    s3d_error: Option<f64>,
    verdict: &'a str,
    diverges: bool,
    reason: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    coefficients: Option<Pairs<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    within_errors: Option<WithinErrors<'a>>,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct Eigenvalue {
    re: f64,
    im: f64,
    error: Option<f64>,
    /// Only where shapes are asked for; `null` for a mode that has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<Option<Pairs<Entry>>>,
}

#[derive(Serialize)]
struct Entry {
    re: f64,
    im: f64,
}

/// One of each pair of conjugates, in 1/s.
///
/// `error` is a bound of the distance from the eigenvalue of the section whose quantities are the doubles
/// nearest to what was given: what rounding may cost, and for a closed form also what it leaves out; `null`
/// where there is no bound. `verdict` is of the numbers as they were given.
pub fn modes(found: &ModesFound) -> String {
    let reading = found.reading.as_ref();
    write(&Found {
        method: found.method,
        twist: found.twist.as_ref().map(TwistFound::from),
        eigenvalues: found.modes.iter().map(eigenvalue).collect(),
        s3d: found.damping_coefficient.map(|own| own.value),
        s3d_error: found.damping_coefficient.and_then(|own| own.error),
        verdict: found.verdict.name(),
        diverges: found.diverges,
        reason: found.verdict.to_string(),
        coefficients: reading
            .and_then(|own| own.coefficients.as_ref())
            .map(coefficients),
        within_errors: reading.and_then(|own| own.within_errors).map(within_errors),
        warnings: &found.warnings,
    })
}

fn eigenvalue(mode: &ModeFound) -> Eigenvalue {
    let entries = |shape: &Shape| {
        let entries = shape.as_ref()?.iter();
        Some(Pairs(entries.map(entry).collect()))
    };
    Eigenvalue {
        re: mode.value.re,
        im: mode.value.im,
        error: mode.error,
        shape: mode.shape.as_ref().map(entries),
    }
}

fn entry(moving: &Moving) -> (String, Entry) {
    let (re, im) = (moving.entry.re, moving.entry.im);
    (moving.name.clone(), Entry { re, im })
}
