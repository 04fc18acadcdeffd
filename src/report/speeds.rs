//! The critical wind speeds of a case in words and numbers, said once for every view.

use crate::stability::case::Case;
use crate::stability::comparison::angle;
use crate::stability::critical_speed::{CriticalSpeed, SpeedRange, Speeds, Stability};

use super::stability::{decimal, decimals};

/// The wind speeds of a case at its angles.
#[derive(Clone, Debug)]
pub struct SpeedsFound {
    /// The case.
    pub case: Case,
    /// Speeds up to this were looked at, in m/s.
    pub highest: f64,
    /// The angles in degrees, with what is known there.
    pub angles: Vec<(f64, Speeds)>,
}

/// The most decimals of a speed.
const MOST_DECIMALS: usize = 9;

/// A critical speed with the decimals that are certain, so many at most.
pub fn critical_speed(own: &CriticalSpeed, most: usize) -> String {
    decimal(own.speed, decimals(own.error, most))
}

/// The ends of a range as far as they are certain: critical speeds, and the ends of all that is looked at.
pub fn ends(own: &SpeedRange, speeds: &Speeds, most: usize) -> [String; 2] {
    let critical = &speeds.critical;
    let end = |speed: f64| {
        let beside = critical
            .iter()
            .find(|own| (own.speed - speed).abs() <= 2.0 * own.error);
        beside.map_or_else(
            || decimal(speed, MOST_DECIMALS.min(most)),
            |own| critical_speed(own, most),
        )
    };
    [end(own.from), end(own.to)]
}

/// Where the section gallops: the lowest critical speed, in a sentence.
pub fn conclusion(found: &SpeedsFound) -> String {
    let is_any = |stability| {
        let mut ranges = found.angles.iter().flat_map(|(_, speeds)| &speeds.ranges);
        ranges.any(|own: &SpeedRange| own.stability == stability)
    };
    let does = match (is_any(Stability::Unstable), is_any(Stability::Divergent)) {
        (true, true) => "gallops or diverges",
        (false, true) => "diverges",
        _ => "gallops",
    };
    let is_unstable =
        |own: &&SpeedRange| matches!(own.stability, Stability::Unstable | Stability::Divergent);
    let onset = |(place, speeds): &(f64, Speeds)| {
        let first = speeds.ranges.iter().find(is_unstable);
        first.map(|own| (own.from, *place))
    };
    let onsets: Vec<(f64, f64)> = found.angles.iter().filter_map(onset).collect();
    let lowest = onsets.iter().min_by(|one, other| one.0.total_cmp(&other.0));
    let (count, all) = (onsets.len(), found.angles.len());
    match lowest {
        None => format!(
            "No wind speed up to {} m/s is unstable for certain, at any angle.",
            found.highest
        ),
        Some((speed, place)) if *speed == 0.0 => format!(
            "The section {does} at {count} of {all} angles; from the lowest wind speeds on at {}°.",
            angle(*place)
        ),
        Some((speed, place)) => format!(
            "The section {does} at {count} of {all} angles; the lowest critical wind speed is {} m/s, at {}°.",
            decimal(*speed, 4),
            angle(*place)
        ),
    }
}

/// The ranges of one stability in words: `from 4.2 to 17.9 m/s`.
pub fn listed(speeds: &Speeds, stability: Stability, highest: f64) -> String {
    let ranges = speeds
        .ranges
        .iter()
        .filter(|own| own.stability == stability);
    let words = ranges.map(|own| {
        let [from, to] = ends(own, speeds, 4);
        match (own.from == 0.0, own.to == highest) {
            (true, true) => "at every speed".to_string(),
            (true, false) => format!("up to {to} m/s"),
            (false, true) => format!("from {from} m/s on"),
            (false, false) => format!("from {from} to {to} m/s"),
        }
    });
    words.collect::<Vec<String>>().join(", ")
}
