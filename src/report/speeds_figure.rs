//! The critical wind speeds of a case as a figure: wind speed against the angle.

use crate::stability::comparison::angle;
use crate::stability::critical_speed::{SpeedRange, Speeds, Stability};

use super::figure::{Curve, Figure, Fill, Patch, Stroke};
use super::speeds::{SpeedsFound, alike, has, what_it_does};
use super::stability::{given, options};
use super::stability_figure::{angle_axis, set, titled};

/// Where the section gallops, shaded, and where it diverges, darker, with the critical speeds around it; what
/// is not decided is hatched.
pub fn figure(found: &SpeedsFound) -> Figure {
    let regions: Vec<Region> = regions(found);
    let patch = |(stability, label, fill): (Stability, &str, Fill)| Patch {
        label: label.into(),
        fill,
        pieces: regions
            .iter()
            .filter(|own| own.stability == stability)
            .map(Region::outline)
            .collect(),
    };
    let critical = regions.iter().filter(|own| own.ends_critically);
    let mut curves = vec![Curve {
        label: "critical wind speed".into(),
        stroke: Stroke::Solid,
        pieces: critical.map(|own| own.above.clone()).collect(),
    }];
    let wind_speed = found.case.parameters.wind_speed;
    let [from, to] = ends(found);
    if 0.0 < wind_speed && wind_speed <= found.highest {
        curves.push(Curve {
            label: format!("U = {} m/s of the case", given(wind_speed)),
            stroke: Stroke::Dashed,
            pieces: vec![vec![(from, wind_speed), (to, wind_speed)]],
        });
    }
    let mut patches: Vec<Patch> = PATCHES.map(patch).into();
    patches.retain(|own| !own.pieces.is_empty());
    Figure {
        title: titled(
            "Critical wind speeds against the angle of attack",
            &found.case,
        ),
        subtitle: set(
            &found.case,
            &format!(
                "all of them up to {} m/s, in exact arithmetic{}",
                found.highest,
                options(&found.case)
            ),
        ),
        x_label: angle_axis(&found.case),
        is_angle: true,
        y_label: "wind speed U (m/s)".into(),
        corners: Some([(from, 0.0), (to, found.highest)]),
        patches,
        curves: curves
            .into_iter()
            .filter(|curve| !curve.pieces.is_empty())
            .collect(),
        ..Figure::default()
    }
}

/// The angles at the ends of the axis: one angle alone is as wide as a degree on both sides.
fn ends(found: &SpeedsFound) -> [f64; 2] {
    let ends = [found.angles.first(), found.angles.last()];
    let [from, to] = ends.map(|end| end.map_or(0.0, |(angle, _)| *angle));
    let margin = if from == to { 1.0 } else { 0.0 };
    [from - margin, to + margin]
}

/// How what is not stable is drawn.
const PATCHES: [(Stability, &str, Fill); 3] = [
    (Stability::Unstable, "gallops", Fill::Shaded),
    (Stability::Divergent, "diverges", Fill::Dark),
    (Stability::Undecided, "not decided", Fill::Hatched),
];

/// Speeds of one stability at neighbouring angles.
struct Region {
    stability: Stability,
    /// The lowest speed at each angle.
    below: Vec<(f64, f64)>,
    /// The highest speed at each angle.
    above: Vec<(f64, f64)>,
    /// Whether stability changes at the highest speeds for certain.
    ends_critically: bool,
}

impl Region {
    fn outline(&self) -> Vec<(f64, f64)> {
        let back = self.above.iter().rev();
        self.below.iter().chain(back).copied().collect()
    }
}

/// The regions of all stabilities; those of neighbouring angles that differ meet half way.
fn regions(found: &SpeedsFound) -> Vec<Region> {
    let mut regions = Vec::new();
    let mut before: Option<f64> = None;
    let mut rest = found.angles.as_slice();
    let [leftmost, rightmost] = ends(found);
    for run in alike(&found.angles) {
        rest = &rest[run.len()..];
        let (Some((first, speeds)), Some((last, _))) = (run.first(), run.last()) else {
            continue;
        };
        let middle = |one: f64, other: f64| (one + other) / 2.0;
        let from = before.map_or(leftmost, |before| middle(before, *first));
        let to = rest
            .first()
            .map_or(rightmost, |(next, _)| middle(*last, *next));
        before = Some(*last);
        for (place, own) in speeds.ranges.iter().enumerate() {
            let next = speeds.ranges.get(place + 1);
            let along = |speed: &dyn Fn(&SpeedRange) -> f64| -> Vec<(f64, f64)> {
                let at = |(angle, speeds): &(f64, Speeds)| {
                    Some((*angle, speed(speeds.ranges.get(place)?)))
                };
                let mut points: Vec<(f64, f64)> = run.iter().filter_map(at).collect();
                if let (Some(first), Some(last)) = (points.first(), points.last()) {
                    let ends = [(from, first.1), (to, last.1)];
                    points.insert(0, ends[0]);
                    points.push(ends[1]);
                }
                points
            };
            let is_decided = |own: &SpeedRange| own.stability != Stability::Undecided;
            regions.push(Region {
                stability: own.stability,
                below: along(&|own| own.from),
                above: along(&|own| own.to),
                ends_critically: is_decided(own) && next.is_some_and(is_decided),
            });
        }
    }
    regions
}

/// The figure in a sentence.
pub fn caption(found: &SpeedsFound) -> String {
    let angles = match (found.angles.first(), found.angles.last()) {
        (Some((first, _)), Some((last, _))) if first < last => {
            format!("from {}° to {}°", angle(*first), angle(*last))
        }
        (Some((only, _)), _) => format!("at {}°", angle(*only)),
        _ => String::new(),
    };
    let but = match has(found, Stability::Undecided) {
        true => " but for what is hatched",
        false => "",
    };
    format!(
        "The wind speeds at which the section {}, {angles}, in exact arithmetic: none up to {} m/s is missed{but}",
        what_it_does(found),
        found.highest
    )
}
