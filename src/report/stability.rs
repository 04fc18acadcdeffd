//! A comparison of methods in words and numbers, said once for every view.

use crate::stability::case::Case;
use crate::stability::comparison::{
    Agreement, Comparison, FollowedMode, Point, Reason, Value, angle, listed,
};
use crate::stability::verdict::Verdict;

/// The most decimals of a damping coefficient; the sines of another machine may change later ones.
const MOST_DECIMALS: usize = 9;

/// A number with the decimals that are certain, nine at most.
pub fn certain(value: Value) -> String {
    decimal(value.value, decimals(value.error, MOST_DECIMALS))
}

/// A bound for a number as [`certain`] prints it: its error and half a unit of the last decimal, as a power
/// of ten.
pub fn bound(value: Value) -> String {
    bound_with(value.error, decimals(value.error, MOST_DECIMALS))
}

/// A bound for a number that is printed with so many decimals.
pub fn bound_with(error: f64, decimals: usize) -> String {
    power(error + 0.5 * 10_f64.powi(-(decimals as i32)))
}

/// How many decimals an error leaves certain.
pub fn decimals(error: f64, most: usize) -> usize {
    let decimals = -(2.0 * error).log10();
    decimals.floor().clamp(0.0, most as f64) as usize
}

/// A number with so many decimals, and no sign before zero.
pub fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|own| "-0.".contains(own));
    match text.strip_prefix('-') {
        Some(positive) if is_zero => positive.to_string(),
        _ => text,
    }
}

/// What a case is, in one line.
pub fn title(comparison: &Comparison) -> String {
    let case = &comparison.case;
    let names: Vec<&str> = comparison.free().iter().map(|own| own.name()).collect();
    let free = match names.split_last() {
        Some((last, [])) => format!("{last} is free"),
        Some((last, others)) => format!("{} and {last} are free", others.join(", ")),
        None => String::new(),
    };
    let angles = match (comparison.points.first(), comparison.points.last()) {
        (Some(first), Some(last)) if comparison.points.len() > 1 => format!(
            "{} angles from {}° to {}°",
            comparison.points.len(),
            angle(first.angle),
            angle(last.angle)
        ),
        (Some(only), _) => format!("at {}°", angle(only.angle)),
        _ => String::new(),
    };
    format!(
        "{}: {angles}; {free}; U = {} m/s{}",
        case.file,
        case.parameters.wind_speed,
        with_stiffness(case)
    )
}

/// What a title says of aerodynamic stiffness, if there is any.
pub fn with_stiffness(case: &Case) -> &'static str {
    match case.parameters.aerodynamic_stiffness {
        true => "; with aerodynamic stiffness",
        false => "",
    }
}

/// What a section does where it is unstable: whether a motion grows without oscillating anywhere.
fn what_it_does(comparison: &Comparison) -> &'static str {
    let is_growing = |own: &FollowedMode| own.damping.value < -own.damping.error;
    let mut modes = comparison.points.iter().flat_map(|point| &point.modes);
    match modes.any(|own| own.frequency == 0.0 && is_growing(own)) {
        true => "gallops or diverges",
        false => "gallops",
    }
}

/// The frequency of a mode that grows; one that does not oscillate diverges.
pub fn frequency(mode: &FollowedMode) -> String {
    match mode.frequency {
        0.0 => "diverges".to_string(),
        frequency => format!("{frequency:.4} Hz"),
    }
}

/// Where the section gallops, in a sentence: what is not decided is not called stable.
pub fn conclusion(comparison: &Comparison) -> String {
    let name = comparison.coefficient_name();
    let points = comparison.points.iter();
    let least = points.min_by(|one, other| one.exact.value.total_cmp(&other.exact.value));
    let least = least.map_or(String::new(), |point| {
        let (value, place) = (decimal(point.exact.value, 4), angle(point.angle));
        format!("the least {name} is {value}, at {place}°")
    });
    let undecided = match comparison.undecided.as_slice() {
        [] => String::new(),
        ranges => {
            let verdicts = comparison.points.iter().map(|point| point.verdict);
            let mut reasons: Vec<String> = Vec::new();
            for verdict in verdicts.filter(|own| matches!(own, Verdict::Undecided(_))) {
                let reason = verdict.to_string();
                if !reasons.contains(&reason) {
                    reasons.push(reason);
                }
            }
            let reasons = reasons.join("; or ");
            format!("; not decided ({}), because {reasons}", listed(ranges))
        }
    };
    let does = what_it_does(comparison);
    match (comparison.unstable.len(), comparison.undecided.len()) {
        (0, 0) => format!("No angle of the sweep is unstable: {least}."),
        (0, _) => format!("No angle of the sweep is unstable for certain: {least}{undecided}."),
        (1, _) => format!("The section {does} in one range of angles: {least}{undecided}."),
        (count, _) => {
            format!("The section {does} in {count} ranges of angles: {least}{undecided}.")
        }
    }
}

/// A mode: `2, mostly y`.
pub fn mode(mode: &FollowedMode) -> String {
    format!("{}, mostly {}", mode.label, mode.mostly.name())
}

/// What the state matrix is worth: the largest bound of its error.
pub fn largest_error(points: &[Point]) -> f64 {
    points
        .iter()
        .map(|point| point.exact.error)
        .fold(0.0, f64::max)
}

/// A bound as the next power of ten, which the rounding of another machine hardly changes.
pub fn power(bound: f64) -> String {
    match bound > 0.0 {
        true => format!("1e{}", bound.log10().ceil()),
        false => "0".to_string(),
    }
}

/// How a method agrees with the state matrix, in one sentence.
pub fn agreement(own: &Agreement, angles: usize) -> String {
    let Some((difference, place)) = own.largest_difference else {
        return "does not apply".to_string();
    };
    let mut text = if own.differs.is_empty() {
        match own.largest_error {
            Some(error) => format!("agrees within the errors of both, at most {}", power(error)),
            None => format!("agrees, within {difference:.0e}"),
        }
    } else {
        let differs = listed(&own.differs);
        format!(
            "differs by up to {difference:.2} (at {}°): {differs}",
            angle(place)
        )
    };
    if !own.opposite.is_empty() {
        text += &format!(
            "; calls stable what is not, or the reverse: {}",
            listed(&own.opposite)
        );
    }
    if own.answers < angles {
        text += &format!("; no answer at {} angles", angles - own.answers);
    }
    text
}

/// Why: a sentence a reason.
pub fn reasons(own: &Agreement) -> Vec<String> {
    own.reasons.iter().map(Reason::to_string).collect()
}
