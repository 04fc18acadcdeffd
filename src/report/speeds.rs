//! The critical wind speeds of a case in words and numbers, said once for every view.

use crate::stability::case::Case;
use crate::stability::comparison::{AngleRange, Value, angle, listed as angles_listed};
use crate::stability::critical_speed::{CriticalSpeed, SpeedRange, Speeds, Stability};

use super::stability::{decimal, rounded, unstable_words};

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
const MOST_DECIMALS: i32 = 9;

/// A critical speed with the decimals that are certain, so many at most.
pub fn critical_speed(own: &CriticalSpeed, most: i32) -> String {
    let (value, error) = (own.speed, own.error);
    rounded(Value { value, error }, most)
}

/// The ends of a range as far as they are certain: critical speeds, and the ends of all that is looked at.
pub fn ends(own: &SpeedRange, speeds: &Speeds, most: i32) -> [String; 2] {
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

/// Whether anything is of this stability, at any angle.
pub fn has(found: &SpeedsFound, stability: Stability) -> bool {
    let mut ranges = found.angles.iter().flat_map(|(_, speeds)| &speeds.ranges);
    ranges.any(|own| own.stability == stability)
}

/// What the section does where it is not stable.
pub fn what_it_does(found: &SpeedsFound) -> &'static str {
    let [gallops, diverges] =
        [Stability::Unstable, Stability::Divergent].map(|own| has(found, own));
    unstable_words(gallops, diverges)
}

/// Where the section gallops: the lowest critical speed, in a sentence.
pub fn conclusion(found: &SpeedsFound) -> String {
    let first = |speeds: &Speeds, kinds: &[Stability]| {
        let mut ranges = speeds.ranges.iter();
        ranges
            .find(|own| kinds.contains(&own.stability))
            .map(|own| {
                if own.is_lowest(found.highest) {
                    0.0
                } else {
                    own.from
                }
            })
    };
    let onsets = found.angles.iter().map(|(place, speeds)| {
        let onset = first(speeds, &[Stability::Unstable, Stability::Divergent]);
        (*place, onset)
    });
    let onsets: Vec<(f64, Option<f64>)> = onsets.collect();
    let unstable = onsets
        .iter()
        .filter_map(|(place, own)| own.map(|own| (own, *place)));
    let (count, all) = (unstable.clone().count(), onsets.len());
    let Some((lowest, place)) = unstable.min_by(|one, other| one.0.total_cmp(&other.0)) else {
        return format!(
            "No wind speed up to {} m/s is unstable for certain, at any angle.",
            found.highest
        );
    };
    let from = if lowest == 0.0 {
        let runs = onsets.chunk_by(|one, other| (one.1 == Some(0.0)) == (other.1 == Some(0.0)));
        let from_0 = runs.filter(|run| run.iter().all(|own| own.1 == Some(0.0)));
        let ranges = from_0.filter_map(|run| {
            let ((from, _), (to, _)) = (*run.first()?, *run.last()?);
            Some(AngleRange { from, to })
        });
        let ranges: Vec<AngleRange> = ranges.collect();
        format!("from the lowest wind speeds on: {}", angles_listed(&ranges))
    } else {
        // What is not decided below may be an onset, too.
        let doubt = |(_, speeds): &(f64, Speeds)| {
            first(speeds, &[Stability::Undecided]).is_some_and(|own| own < lowest)
        };
        let at_most = match found.angles.iter().any(doubt) {
            true => "at most ",
            false => "",
        };
        format!(
            "the lowest critical wind speed is {at_most}{} m/s, at {}°",
            rounded(
                Value {
                    value: lowest,
                    // It is known to 2⁻⁴⁰ of itself, and rounded.
                    error: 1e-11 * lowest,
                },
                4
            ),
            angle(place)
        )
    };
    let does = what_it_does(found);
    format!("The section {does} at {count} of {all} angles; {from}.")
}

/// Neighbouring angles with the same kinds of ranges in the same order, from the first to the last.
pub fn alike(angles: &[(f64, Speeds)]) -> impl Iterator<Item = &[(f64, Speeds)]> {
    let kinds = |speeds: &Speeds| -> Vec<Stability> {
        speeds.ranges.iter().map(|own| own.stability).collect()
    };
    angles.chunk_by(move |(_, one), (_, other)| {
        kinds(one) == kinds(other) && one.is_neutral == other.is_neutral
    })
}

/// What is known at the angles: neighbours that are [`alike`], and the speeds at which something is unstable or not
/// decided there.
pub fn lines(found: &SpeedsFound) -> Vec<(String, String)> {
    let line = |run: &[(f64, Speeds)]| {
        let ((first, _), (last, _)) = (run.first()?, run.last()?);
        let angles = match run.len() {
            1 => format!("{}°", angle(*first)),
            _ => format!("{}° to {}°", angle(*first), angle(*last)),
        };
        Some((angles, at_angles(run, found.highest)))
    };
    alike(&found.angles).filter_map(line).collect()
}

/// What is so at angles that are alike.
fn at_angles(run: &[(f64, Speeds)], highest: f64) -> String {
    let Some((_, speeds)) = run.first() else {
        return String::new();
    };
    let parts = [
        (Stability::Unstable, "gallops"),
        (Stability::Divergent, "diverges"),
        (Stability::Undecided, "not decided"),
    ];
    let mut words: Vec<String> = parts
        .into_iter()
        .filter(|(stability, _)| speeds.ranges.iter().any(|own| own.stability == *stability))
        .map(|(stability, word)| format!("{word} {}", listed(run, stability, highest)))
        .collect();
    if words.is_empty() {
        words.push(format!("stable at {}", every_speed(highest)));
    }
    if speeds.is_neutral {
        words.push("a real part is 0 at every speed, exactly".into());
    }
    words.join("; ")
}

/// All speeds that were looked at.
fn every_speed(highest: f64) -> String {
    format!("every speed up to {highest} m/s")
}

/// The ranges of one stability in words, at angles that are [`alike`]: `from 4.2 to 17.9 m/s`, or with the
/// lowest and the highest of each end `from 4.2–4.5 to 16.8–17.9 m/s`.
pub fn listed(angles: &[(f64, Speeds)], stability: Stability, highest: f64) -> String {
    let Some((_, first)) = angles.first() else {
        return String::new();
    };
    let places = first.ranges.iter().enumerate();
    let places = places.filter(|(_, own)| own.stability == stability);
    let words = places.map(|(place, own)| {
        let end = |which: usize| {
            let end = |(_, speeds): &(f64, Speeds)| {
                let own = speeds.ranges.get(place)?;
                let speed = [own.from, own.to][which];
                Some((speed, ends(own, speeds, 4)[which].clone()))
            };
            let mut all: Vec<(f64, String)> = angles.iter().filter_map(end).collect();
            all.sort_by(|one, other| one.0.total_cmp(&other.0));
            match (all.first(), all.last()) {
                (Some((_, low)), Some((_, high))) if low != high => format!("{low}–{high}"),
                (Some((_, only)), _) => only.clone(),
                _ => String::new(),
            }
        };
        match (own.is_lowest(highest), own.to == highest) {
            (true, true) => format!("at {}", every_speed(highest)),
            (true, false) => format!("up to {} m/s", end(1)),
            (false, true) => format!("from {} m/s on", end(0)),
            (false, false) => format!("from {} to {} m/s", end(0), end(1)),
        }
    });
    words.collect::<Vec<String>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn speeds(ranges: &[(f64, f64, Stability)]) -> Speeds {
        let range = |&(from, to, stability)| SpeedRange {
            from,
            to,
            stability,
        };
        Speeds {
            ranges: ranges.iter().map(range).collect(),
            critical: Vec::new(),
            is_neutral: false,
        }
    }

    fn concluded(angles: Vec<(f64, Speeds)>) -> String {
        let case = include_str!("../../derivations/cases/tuned.toml");
        conclusion(&SpeedsFound {
            case: Case::read("tuned.toml", case).expect("a case"),
            highest: 40.0,
            angles,
        })
    }

    #[test]
    fn an_onset_is_called_certain_only_where_nothing_below_is_open() {
        use Stability::{Stable, Undecided, Unstable};
        let clear = speeds(&[(0.0, 7.0, Stable), (7.0, 40.0, Unstable)]);
        let open = speeds(&[
            (0.0, 5.0, Stable),
            (5.0, 6.0, Undecided),
            (6.0, 40.0, Stable),
        ]);
        let low = speeds(&[(0.0, 40.0, Unstable)]);
        assert_eq!(
            concluded(vec![(0.0, clear.clone()), (1.0, clear.clone())]),
            "The section gallops at 2 of 2 angles; the lowest critical wind speed is 7.0000 m/s, at 0°."
        );
        assert_eq!(
            concluded(vec![(0.0, clear.clone()), (1.0, open.clone())]),
            "The section gallops at 1 of 2 angles; the lowest critical wind speed is at most 7.0000 m/s, at 0°."
        );
        let angles = vec![
            (0.0, low.clone()),
            (1.0, low.clone()),
            (2.0, clear),
            (3.0, low),
        ];
        assert_eq!(
            concluded(angles),
            "The section gallops at 4 of 4 angles; from the lowest wind speeds on: 0° to 1°, at 3°."
        );
        assert_eq!(
            concluded(vec![(0.0, open)]),
            "No wind speed up to 40 m/s is unstable for certain, at any angle."
        );
    }
}
