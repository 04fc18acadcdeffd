//! `{"system", "over", "ranges": [{"from", "to", "verdict"}], "critical": [{"value", "error", "becomes"}]}`

use serde::Serialize;

use crate::report::ranges::RangesFound;

use super::write;

#[derive(Serialize)]
struct Found<'a> {
    system: &'a str,
    over: &'a str,
    ranges: Vec<Range<'a>>,
    critical: Vec<Critical<'a>>,
}

#[derive(Serialize)]
struct Range<'a> {
    from: f64,
    to: f64,
    verdict: &'a str,
}

#[derive(Serialize)]
struct Critical<'a> {
    value: f64,
    error: f64,
    becomes: &'a str,
}

/// The ranges, certain from end to end, and the critical values between them, in SI units and radians.
pub fn ranges(found: &RangesFound) -> String {
    let own = &found.ranges;
    let range = own.ranges.iter().map(|own| Range {
        from: own.from,
        to: own.to,
        verdict: own.stability.name(),
    });
    let critical = own.critical.iter().map(|own| Critical {
        value: own.value,
        error: own.error,
        becomes: own.becomes.name(),
    });
    write(&Found {
        system: &found.system,
        over: &found.over,
        ranges: range.collect(),
        critical: critical.collect(),
    })
}
