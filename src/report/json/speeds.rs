//! `{"case", "to", "points": [{"alpha_deg", "ranges": […], "critical": […], "neutral"}]}`.

use serde::Serialize;

use crate::report::speeds::SpeedsFound;
use crate::stability::coefficient_table::reference::Reference;
use crate::stability::comparison::angle;
use crate::stability::critical_speed::Speeds;

use super::pairs::{Pairs, is_empty, settings};
use super::write;

#[derive(Serialize)]
struct Found<'a> {
    case: &'a str,
    /// What was set in place of what the case says.
    #[serde(skip_serializing_if = "is_empty")]
    set: Pairs<f64>,
    /// The lengths that its coefficients stand over, where they are not D.
    #[serde(skip_serializing_if = "Reference::is_usual")]
    reference: Reference,
    to: f64,
    points: Vec<AtAngle<'a>>,
}

#[derive(Serialize)]
struct AtAngle<'a> {
    alpha_deg: f64,
    ranges: Vec<Range<'a>>,
    critical: Vec<Critical<'a>>,
    neutral: bool,
}

#[derive(Serialize)]
struct Range<'a> {
    from: f64,
    to: f64,
    verdict: &'a str,
}

#[derive(Serialize)]
struct Critical<'a> {
    speed: f64,
    error: f64,
    becomes: &'a str,
}

/// The ranges, certain from end to end, and the critical speeds between them, in m/s.
pub fn speeds(found: &SpeedsFound) -> String {
    write(&Found {
        case: &found.case.file,
        set: settings(&found.case),
        reference: found.case.reference,
        to: found.highest,
        points: found.angles.iter().map(at_angle).collect(),
    })
}

fn at_angle((place, speeds): &(f64, Speeds)) -> AtAngle<'_> {
    let ranges = speeds.ranges.iter().map(|own| Range {
        from: own.from,
        to: own.to,
        verdict: own.stability.name(),
    });
    let critical = speeds.critical.iter().map(|own| Critical {
        speed: own.speed,
        error: own.error,
        becomes: own.becomes.name(),
    });
    AtAngle {
        alpha_deg: angle(*place),
        ranges: ranges.collect(),
        critical: critical.collect(),
        neutral: speeds.is_neutral,
    }
}
