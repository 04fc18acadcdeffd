//! `{"case", "free", "table", "points": […], "unstable": […], "methods": […], "warnings": […]}`.

use serde::Serialize;

use crate::report::stability::{frequency_in_hertz, reasons};
use crate::stability::case::Case;
use crate::stability::coefficient_table::reference::Reference;
use crate::stability::comparison::{
    Agreement, AngleRange, Comparison, FollowedMode, NoBalance, Point, UnstableRange, Value, angle,
};
use crate::stability::input::Remark;
use crate::stability::tolerance::Tolerance;

use super::pairs::{Pairs, coefficients, is_empty, settings};
use super::twist::TwistFound;
use super::write;

#[derive(Serialize)]
struct Compared<'a> {
    case: &'a str,
    /// What was set in place of what the case says.
    #[serde(skip_serializing_if = "is_empty")]
    set: Pairs<f64>,
    /// The lengths that its coefficients stand over, where they are not D.
    #[serde(skip_serializing_if = "Reference::is_usual")]
    reference: Reference,
    free: Vec<&'a str>,
    table: &'a str,
    points: Vec<AtAngle<'a>>,
    /// The angles without a certain mean twist.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    without_balance: Vec<Without>,
    unstable: Vec<Unstable<'a>>,
    undecided: Vec<Angles>,
    methods: Vec<Agreed<'a>>,
    warnings: Vec<Warning<'a>>,
}

#[derive(Serialize)]
struct Without {
    alpha_deg: f64,
    reason: String,
}

#[derive(Serialize)]
struct AtAngle<'a> {
    alpha_deg: f64,
    coefficients: Option<Pairs<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    twist: Option<TwistFound>,
    s3d: ByMethod,
    verdict: &'a str,
    diverges: bool,
    reason: String,
    modes: Vec<OneMode<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    within_errors: Option<WithinErrors<'a>>,
    warnings: Vec<String>,
}

/// What is certain for all coefficients within their errors.
#[derive(Serialize)]
pub(super) struct WithinErrors<'a> {
    verdict: &'a str,
    s3d: Option<[f64; 2]>,
}

#[derive(Serialize)]
struct ByMethod {
    exact: Bounded,
    companion: Option<Bounded>,
    closed: Option<f64>,
    uniform: Option<f64>,
}

#[derive(Serialize)]
struct Bounded {
    value: f64,
    error: f64,
}

#[derive(Serialize)]
struct OneMode<'a> {
    mode: usize,
    s: f64,
    error: f64,
    frequency_hz: f64,
    frequency_error_hz: f64,
    mostly: &'a str,
}

#[derive(Serialize)]
struct Angles {
    from_deg: f64,
    to_deg: f64,
}

#[derive(Serialize)]
struct Unstable<'a> {
    #[serde(flatten)]
    angles: Angles,
    worst_deg: f64,
    s3d: f64,
    error: f64,
    mode: Option<OneMode<'a>>,
}

#[derive(Serialize)]
struct Agreed<'a> {
    method: &'a str,
    answers: usize,
    largest_difference: Option<f64>,
    at_deg: Option<f64>,
    largest_error: Option<f64>,
    differs: Vec<Angles>,
    opposite: Vec<Angles>,
    reasons: Vec<String>,
}

#[derive(Serialize)]
struct Warning<'a> {
    file: &'a str,
    line: Option<usize>,
    what: &'a str,
}

/// A comparison, with all digits and with bounds of the errors.
pub fn comparison(comparison: &Comparison) -> String {
    let case = &comparison.case;
    write(&Compared {
        case: &case.file,
        set: settings(case),
        reference: case.reference,
        free: comparison.free().iter().map(|own| own.name()).collect(),
        table: &comparison.reading,
        points: comparison
            .points
            .iter()
            .enumerate()
            .map(|(place, own)| at_angle(own, tolerance(comparison, place), case))
            .collect(),
        without_balance: comparison.without_balance.iter().map(without).collect(),
        unstable: comparison
            .unstable
            .iter()
            .map(|own| unstable(own, case))
            .collect(),
        undecided: angles(&comparison.undecided),
        methods: comparison.agreements.iter().map(agreed).collect(),
        warnings: comparison.remarks.iter().map(warning).collect(),
    })
}

fn without(own: &NoBalance) -> Without {
    Without {
        alpha_deg: angle(own.angle),
        reason: own.reason.to_string(),
    }
}

fn tolerance(comparison: &Comparison, place: usize) -> Option<Tolerance> {
    let within = comparison.within.as_ref();
    let within = within.filter(|own| own.has_errors())?;
    within.tolerances.get(place).copied()
}

fn at_angle<'a>(point: &'a Point, tolerance: Option<Tolerance>, case: &Case) -> AtAngle<'a> {
    AtAngle {
        alpha_deg: angle(point.angle),
        coefficients: point.coefficients.as_ref().map(coefficients),
        twist: point.twist.as_ref().map(TwistFound::from),
        s3d: ByMethod {
            exact: bounded(point.exact),
            companion: point.companion.map(bounded),
            closed: point.closed.value,
            uniform: point.uniform.value,
        },
        verdict: point.verdict.name(),
        diverges: point.diverges,
        reason: point.verdict.to_string(),
        modes: point.modes.iter().map(|own| one_mode(own, case)).collect(),
        within_errors: tolerance.map(within_errors),
        warnings: warnings(point),
    }
}

pub(super) fn within_errors<'a>(own: Tolerance) -> WithinErrors<'a> {
    WithinErrors {
        verdict: own.certainty.name(),
        s3d: own.damping,
    }
}

/// What speaks against the closed form, then against the uniform form, each once.
fn warnings(point: &Point) -> Vec<String> {
    let closed = &point.closed.limitations;
    let uniform = point.uniform.limitations.iter();
    let others = uniform.filter(|own| !closed.contains(own));
    closed
        .iter()
        .chain(others)
        .map(ToString::to_string)
        .collect()
}

fn bounded(value: Value) -> Bounded {
    Bounded {
        value: value.value,
        error: value.error,
    }
}

fn one_mode<'a>(mode: &'a FollowedMode, case: &Case) -> OneMode<'a> {
    let frequency = frequency_in_hertz(mode, case);
    OneMode {
        mode: mode.label,
        s: mode.damping.value,
        error: mode.damping.error,
        frequency_hz: frequency.value,
        frequency_error_hz: frequency.error,
        mostly: mode.mostly.name(),
    }
}

fn angles(ranges: &[AngleRange]) -> Vec<Angles> {
    ranges.iter().map(|own| one_range(*own)).collect()
}

fn one_range(range: AngleRange) -> Angles {
    Angles {
        from_deg: angle(range.from),
        to_deg: angle(range.to),
    }
}

fn unstable<'a>(own: &'a UnstableRange, case: &Case) -> Unstable<'a> {
    Unstable {
        angles: one_range(own.angles),
        worst_deg: angle(own.worst),
        s3d: own.damping.value,
        error: own.damping.error,
        mode: own.mode.as_ref().map(|own| one_mode(own, case)),
    }
}

fn agreed(own: &Agreement) -> Agreed<'_> {
    Agreed {
        method: own.method.name(),
        answers: own.answers,
        largest_difference: own.largest_difference.map(|(difference, _)| difference),
        at_deg: own.largest_difference.map(|(_, place)| angle(place)),
        largest_error: own.largest_error,
        differs: angles(&own.differs),
        opposite: angles(&own.opposite),
        reasons: reasons(own),
    }
}

fn warning(remark: &Remark) -> Warning<'_> {
    Warning {
        file: &remark.place.file,
        line: remark.place.line,
        what: &remark.what,
    }
}
