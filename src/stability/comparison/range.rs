//! Angles in a row that have something in common.

use std::fmt;

use super::following::FollowedMode;
use super::point::Point;
use super::value::Value;
use crate::stability::verdict::Verdict;

/// From one angle of a sweep to another, both included, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleRange {
    /// The first angle.
    pub from: f64,
    /// The last angle.
    pub to: f64,
}

impl fmt::Display for AngleRange {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (from, to) = (angle(self.from), angle(self.to));
        if from == to {
            write!(formatter, "at {from}°")
        } else {
            write!(formatter, "{from}° to {to}°")
        }
    }
}

/// An angle of a sweep, without the rounding of its steps.
pub fn angle(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9
}

/// Ranges in words, the first five of them: `at 10°, 20° to 25°`.
pub fn listed(ranges: &[AngleRange]) -> String {
    let shown: Vec<String> = ranges.iter().take(5).map(ToString::to_string).collect();
    let rest = match ranges.len() {
        0..=5 => String::new(),
        more => format!(" and {} more", more - 5),
    };
    shown.join(", ") + &rest
}

/// Where a section is unstable.
#[derive(Clone, Debug, PartialEq)]
pub struct UnstableRange {
    /// The angles of the sweep.
    pub angles: AngleRange,
    /// The angle with the least damping, in degrees.
    pub worst: f64,
    /// S there.
    pub damping: Value,
    /// Whether it diverges there; else it gallops.
    pub diverges: bool,
    /// The mode with the least damping there.
    pub mode: Option<FollowedMode>,
}

/// The points for which something holds, in runs without a gap.
fn runs(points: &[Point], holds: impl Fn(&Point) -> bool) -> Vec<&[Point]> {
    let groups = points.chunk_by(|one, next| holds(one) == holds(next) && follows(one, next));
    groups.filter(|group| group.iter().all(&holds)).collect()
}

/// Whether the sweep goes from one point to the next: no angle without a section is between them.
fn follows(one: &Point, next: &Point) -> bool {
    one.place + 1 == next.place
}

/// The ranges of the points for which something holds.
pub(super) fn ranges(points: &[Point], holds: impl Fn(&Point) -> bool) -> Vec<AngleRange> {
    runs(points, holds).into_iter().filter_map(range).collect()
}

/// The ranges of angles with their places in a sweep.
pub(super) fn joined(angles: &[(usize, f64)]) -> Vec<AngleRange> {
    let runs = angles.chunk_by(|one, next| one.0 + 1 == next.0);
    let range = |run: &[(usize, f64)]| AngleRange {
        from: run[0].1,
        to: run[run.len() - 1].1,
    };
    runs.map(range).collect()
}

fn range(run: &[Point]) -> Option<AngleRange> {
    Some(AngleRange {
        from: run.first()?.angle,
        to: run.last()?.angle,
    })
}

/// Where the section is unstable for certain.
pub(super) fn unstable(points: &[Point]) -> Vec<UnstableRange> {
    let is_unstable = |point: &Point| matches!(point.verdict, Verdict::Unstable(_));
    let of = |run: &[Point]| {
        let damping = |point: &&Point| point.exact.value;
        let worst = run
            .iter()
            .min_by(|one, other| damping(one).total_cmp(&damping(other)))?;
        Some(UnstableRange {
            angles: range(run)?,
            worst: worst.angle,
            damping: worst.exact,
            diverges: worst.diverges,
            mode: worst.critical().copied(),
        })
    };
    runs(points, is_unstable)
        .into_iter()
        .filter_map(of)
        .collect()
}

/// Where neither is shown.
pub(super) fn undecided(points: &[Point]) -> Vec<AngleRange> {
    ranges(points, |point| {
        matches!(point.verdict, Verdict::Undecided(_))
    })
}
