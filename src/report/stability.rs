//! A comparison of methods in words and numbers, said once for every view.

use std::f64::consts::TAU;

use crate::stability::case::Case;
use crate::stability::comparison::{
    Agreement, Comparison, FollowedMode, Point, Reason, Value, angle, listed,
};
use crate::stability::mean_twist::{BOUND, Twist};
use crate::stability::tolerance::{Certainty, Tolerance};
use crate::stability::verdict::Verdict;

/// The most decimals of a damping coefficient; the sines of another machine may change later ones.
const MOST_DECIMALS: i32 = 9;

/// Numbers from this on are written with a power of ten.
const LARGE: f64 = 1e6;

/// A number with the decimals that are certain, nine at most; empty where not a digit is.
pub fn certain(value: Value) -> String {
    match is_unknown(value) {
        true => String::new(),
        false => decimal(value.value, decimals(value.error, MOST_DECIMALS)),
    }
}

/// Whether an error leaves no digit of a number certain, not even that it is 0 in whole numbers.
pub fn is_unknown(value: Value) -> bool {
    let decimals = decimals(value.error, MOST_DECIMALS);
    decimals < 0 && order(value.value).saturating_add(decimals) < 0
}

/// A number for a table: with the decimals that are certain, so many at most, or as many digits of a large one;
/// `unknown` where not a digit is.
pub fn rounded(value: Value, most: i32) -> String {
    if is_unknown(value) {
        return "unknown".to_string();
    }
    let places = if value.value.abs() >= LARGE {
        order(value.value)
    } else {
        0
    };
    let text = decimal(value.value, decimals(value.error, most - places));
    // What is small is not 0 if that is certain.
    let is_zero = text.chars().all(|own| "0.".contains(own));
    match is_zero && value.value.abs() > value.error {
        true => format!("{:.0e}", value.value),
        false => text,
    }
}

/// A number as it is given, with a power of ten where its zeros would be many.
pub fn given(value: f64) -> String {
    match value == 0.0 || (1e-4..LARGE).contains(&value.abs()) {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// A bound for a number as [`certain`] prints it: its error and half a unit of the last decimal, as a power
/// of ten.
pub fn bound(value: Value) -> String {
    bound_with(value.error, decimals(value.error, MOST_DECIMALS))
}

/// A bound for a number that is printed with so many decimals.
pub fn bound_with(error: f64, decimals: i32) -> String {
    power(error + 0.5 * 10_f64.powi(-decimals))
}

/// How many decimals an error leaves certain, so many at most; fewer than 0 where whole numbers are not.
pub fn decimals(error: f64, most: i32) -> i32 {
    let decimals = -(2.0 * error).log10();
    decimals.floor().clamp(-308.0, f64::from(most)) as i32
}

/// A number with so many decimals, and no sign before zero; a large one, or one of fewer decimals than none,
/// with a power of ten.
pub fn decimal(value: f64, decimals: i32) -> String {
    if value.abs() >= LARGE || decimals < 0 {
        let digits = order(value).saturating_add(decimals);
        return match usize::try_from(digits) {
            Ok(digits) => format!("{value:.digits$e}"),
            Err(_) => "0".to_string(),
        };
    }
    let decimals = decimals.unsigned_abs() as usize;
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|own| "-0.".contains(own));
    match text.strip_prefix('-') {
        Some(positive) if is_zero => positive.to_string(),
        _ => text,
    }
}

/// A number with so many digits, however small it is.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let last = digits.saturating_sub(1);
    if (1e-4..LARGE).contains(&value.abs()) {
        let decimals = (last as i32).saturating_sub(order(value)).clamp(0, 16);
        return decimal(value, decimals);
    }
    format!("{value:.last$e}")
}

/// The power of ten of the first digit of a number.
fn order(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

/// What a case is, in one line.
pub fn title(comparison: &Comparison) -> String {
    format!("{}: {}", comparison.case.title(), sweep(comparison))
}

/// The angles of a case, what is free, and the wind.
pub fn sweep(comparison: &Comparison) -> String {
    let case = &comparison.case;
    let names: Vec<&str> = comparison.free().iter().map(|own| own.name()).collect();
    let free = match names.split_last() {
        Some((last, [])) => format!("{last} is free"),
        Some((last, others)) => format!("{} and {last} are free", others.join(", ")),
        None => String::new(),
    };
    let angles = match comparison.at_all_angles().as_slice() {
        [(first, _), .., (last, _)] => format!(
            "{} angles from {}° to {}°",
            comparison.angle_count(),
            angle(*first),
            angle(*last)
        ),
        [(only, _)] => format!("at {}°", angle(*only)),
        [] => String::new(),
    };
    format!(
        "{angles}; {free}; U = {} m/s{}",
        given(case.parameters.wind_speed),
        options(case)
    )
}

/// What a title says of what a case asks for: aerodynamic stiffness, the mean twist, and other reference lengths than D.
pub fn options(case: &Case) -> String {
    let stiffness = match case.parameters.aerodynamic_stiffness {
        true => "; with aerodynamic stiffness",
        false => "",
    };
    let twist = match (case.mean_twist, case.is_twisted()) {
        (true, true) => "; with mean twist",
        (true, false) => "; with mean twist, which is 0 as theta is held",
        _ => "",
    };
    format!("{stiffness}{twist}{}", case.over_lengths())
}

/// Between which mean twists the section lies at its angles, and how certain they are; `None` where none is asked for.
pub fn twists(comparison: &Comparison) -> Option<String> {
    let points = comparison.points.iter();
    let twists = points.filter_map(|point| Some((point.angle, point.twist?)));
    let twists: Vec<(f64, Twist)> = twists.collect();
    let by_angle =
        |one: &&(f64, Twist), other: &&(f64, Twist)| one.1.angle.total_cmp(&other.1.angle);
    let (least, most) = (
        twists.iter().min_by(by_angle)?,
        twists.iter().max_by(by_angle)?,
    );
    let shown = |(place, own): &(f64, Twist)| format!("{} (at {}°)", degrees(own), angle(*place));
    let stiffness = twists
        .iter()
        .map(|(_, own)| own.stiffness)
        .fold(f64::INFINITY, f64::min);
    let between = match twists.len() {
        1 => degrees(&least.1),
        _ => format!("from {} to {}", shown(least), shown(most)),
    };
    Some(format!(
        "{between}; each is certain within {}°; the stiffness of the turn is at least {:.1} % of that of its springs",
        power(BOUND.to_degrees()),
        (stiffness * 1000.0).floor() / 10.0
    ))
}

/// A twist, as far as anyone reads it.
pub fn degrees(twist: &Twist) -> String {
    format!("{}°", decimal(twist.angle.to_degrees(), 4))
}

/// What an unstable section does. It diverges where the determinant of the stiffness is below 0, and gallops
/// everywhere else, with or without an oscillation.
pub fn unstable_words(gallops: bool, diverges: bool) -> &'static str {
    match (gallops, diverges) {
        (true, true) => "gallops or diverges",
        (false, true) => "diverges",
        _ => "gallops",
    }
}

/// What a section does at the angles at which it is unstable.
fn what_it_does(comparison: &Comparison) -> &'static str {
    let points = comparison.points.iter();
    let unstable = points.filter(|own| matches!(own.verdict, Verdict::Unstable(_)));
    let [gallops, diverges] =
        [false, true].map(|kind| unstable.clone().any(|own| own.diverges == kind));
    unstable_words(gallops, diverges)
}

/// Where the section gallops, in a sentence: what is not decided is not called stable.
pub fn conclusion(comparison: &Comparison) -> String {
    let name = comparison.coefficient_name();
    let points = comparison.points.iter();
    let least = points.min_by(|one, other| one.exact.value.total_cmp(&other.exact.value));
    let least = least.map_or(String::new(), |point| {
        let (value, place) = (rounded(point.exact, 4), angle(point.angle));
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
    let without = match comparison.without_balance.len() {
        0 => String::new(),
        count => format!(
            "; no verdict at {count} of {} angles, which have no certain mean twist",
            comparison.angle_count()
        ),
    };
    let undecided = undecided + &without;
    let does = what_it_does(comparison);
    match (comparison.unstable.len(), comparison.undecided.len()) {
        (0, 0) if without.is_empty() => format!("No angle of the sweep is unstable: {least}."),
        (0, _) => format!("No angle of the sweep is unstable for certain: {least}{undecided}."),
        (1, _) => format!("The section {does} in one range of angles: {least}{undecided}."),
        (count, _) => {
            format!("The section {does} in {count} ranges of angles: {least}{undecided}.")
        }
    }
}

/// What is certain within the errors of the coefficients: what, and at which angles; nothing where no errors are given.
pub fn within_errors(comparison: &Comparison) -> Vec<(&'static str, String)> {
    let within = comparison.within.as_ref();
    let Some(within) = within.filter(|own| own.has_errors()) else {
        return Vec::new();
    };
    let kinds = [
        (Certainty::Stable, "stable for all"),
        (Certainty::Unstable, "unstable for all"),
        (Certainty::Depends, "depends on them"),
        (Certainty::Open, "not decided"),
    ];
    let line = |name: &'static str, holds: &dyn Fn(&Tolerance) -> bool| {
        let ranges = within.ranges(&comparison.points, holds);
        let ranges: Vec<String> = ranges.iter().map(ToString::to_string).collect();
        (!ranges.is_empty()).then(|| (name, ranges.join(", ")))
    };
    let certain = |(certainty, name)| line(name, &|own| own.certainty == certainty);
    let unbounded = line("no bounds of S", &|own| own.damping.is_none());
    let certain = kinds.into_iter().filter_map(certain);
    certain.chain(unbounded).collect()
}

/// What [`within_errors`] is worth.
pub const WITHIN: &str = "for all coefficients and slopes, each within what the errors of the rows make of it, with \
                          proof; it depends where two such were found, one stable and one not; S has no bounds where \
                          the errors are too large to tell the modes apart";

/// How all verdicts are known.
pub const PROOF: &str = "each verdict is proven, by bounds of the errors or in exact arithmetic";

/// The frequency of a mode that grows, as far as it is certain: one that does not oscillate diverges, or has none.
pub fn frequency(mode: &FollowedMode, diverges: bool, case: &Case) -> String {
    match (mode.frequency == 0.0, diverges) {
        (true, true) => "diverges".to_string(),
        (true, false) => "none".to_string(),
        _ => format!("{} Hz", rounded(frequency_in_hertz(mode, case), 4)),
    }
}

/// The frequency of a mode of a case in Hz, with a bound of its error.
pub fn frequency_in_hertz(mode: &FollowedMode, case: &Case) -> Value {
    // S is proportional to λ, and so are the bounds of both.
    let per_rate = case.parameters.damping_coefficient(1.0);
    let error = per_rate.map_or(f64::INFINITY, |own| mode.damping.error / own.abs());
    Value {
        value: mode.frequency,
        error: error / TAU,
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
        // No sign before zero.
        true => format!("1e{}", bound.log10().ceil() + 0.0),
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
        let error = 0.0;
        let value = difference;
        format!(
            "differs by up to {} (at {}°): {differs}",
            rounded(Value { value, error }, 2),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_say_something() {
        let value = |value, error| Value { value, error };
        for (number, most, text) in [
            (value(-0.12345, 1e-12), 4, "-0.1235"),
            (value(-0.12345, 1e-3), 4, "-0.12"),
            (value(-0.00001, 1e-12), 4, "-1e-5"),
            (value(-0.00001, 1e-4), 4, "0.000"),
            (value(0.0, 1e-12), 4, "0.0000"),
            (value(123.4, 20.0), 4, "1e2"),
            (value(12.0, 600.0), 4, "unknown"),
            (value(-437_581_289.579_6, 1e-3), 4, "-4.3758e8"),
            (value(5e300, 1e285), 4, "5.0000e300"),
            (value(5e300, 1e302), 4, "unknown"),
            (value(0.0, f64::INFINITY), 4, "unknown"),
        ] {
            assert_eq!(rounded(number, most), text);
        }
        assert_eq!(
            [given(9.0), given(1e-9), given(0.0), given(3e8)],
            ["9", "1e-9", "0", "3e8"]
        );
        assert_eq!(certain(value(1.5e7, 1e-9)), "1.500000000000000e7");
        assert_eq!(certain(value(-16.8, 112.0)), "");
        assert_eq!(certain(value(-1234.0, 112.0)), "-1e3");
        assert_eq!([power(0.7), power(2.0), power(0.0)], ["1e0", "1e1", "0"]);
        for (number, text) in [
            (0.019_312_345, "0.0193123"),
            (-6.001_234_5, "-6.00123"),
            (1e-9, "1.00000e-9"),
            (-2.5e12, "-2.50000e12"),
            (0.0, "0"),
        ] {
            assert_eq!(significant(number, 6), text);
        }
    }
}
