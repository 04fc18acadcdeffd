//! What a column holds, and in which unit, by its usual names.

use std::f64::consts::PI;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// The angle of attack.
    Angle,
    Lift,
    Drag,
    Moment,
    /// A derivative by the angle: `dCL`, `dCD` or `dCM`.
    Slope(&'static str),
    /// How far a coefficient may be from what is measured: `CL_error`, `CD_error` or `CM_error`.
    Error(&'static str),
}

/// The unit of angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    Degrees,
    Radians,
}

impl Unit {
    /// An angle in degrees: exact where it is in degrees.
    pub fn degrees(self, angle: f64) -> f64 {
        match self {
            Unit::Degrees => angle,
            Unit::Radians => angle * 180.0 / PI,
        }
    }

    /// The unit that a text names.
    pub fn of(text: &str) -> Option<Self> {
        match letters(text).as_str() {
            "deg" | "degree" | "degrees" | "°" => Some(Unit::Degrees),
            "rad" | "radian" | "radians" => Some(Unit::Radians),
            _ => None,
        }
    }

    /// The unit in which a text divides: `1/deg`, `per radian`.
    pub fn per(text: &str) -> Option<Self> {
        let own = letters(text);
        let own = own.trim_end_matches(POWERS);
        let rest = own.strip_prefix('1').or(own.strip_prefix("per"));
        Unit::of(rest.unwrap_or(own))
    }

    /// The unit that stands as a word among others.
    pub fn within(text: &str) -> Option<Self> {
        let is_sign = |own: char| !own.is_alphanumeric() && own != '°';
        text.split(is_sign).find_map(Unit::of)
    }

    /// A slope per radian.
    pub fn slope(self, slope: f64) -> f64 {
        match self {
            Unit::Degrees => slope.to_degrees(),
            Unit::Radians => slope,
        }
    }
}

/// The usual names, without blanks, signs and units.
const NAMES: [(Meaning, &[&str]); 10] = [
    (
        Meaning::Angle,
        &[
            "alpha",
            "α",
            "alf",
            "aoa",
            "angle",
            "angleofattack",
            "attackangle",
            "incidence",
        ],
    ),
    (Meaning::Lift, &["cl", "lift", "clift", "liftcoefficient"]),
    (Meaning::Drag, &["cd", "drag", "cdrag", "dragcoefficient"]),
    (
        Meaning::Moment,
        &["cm", "moment", "cmoment", "momentcoefficient"],
    ),
    (Meaning::Slope("dCL"), &["dcl", "dcldalpha", "dcldα"]),
    (Meaning::Slope("dCD"), &["dcd", "dcddalpha", "dcddα"]),
    (Meaning::Slope("dCM"), &["dcm", "dcmdalpha", "dcmdα"]),
    (
        Meaning::Error("CL_error"),
        &[
            "clerror",
            "clerr",
            "errorcl",
            "errcl",
            "δcl",
            "cluncertainty",
        ],
    ),
    (
        Meaning::Error("CD_error"),
        &[
            "cderror",
            "cderr",
            "errorcd",
            "errcd",
            "δcd",
            "cduncertainty",
        ],
    ),
    (
        Meaning::Error("CM_error"),
        &[
            "cmerror",
            "cmerr",
            "errorcm",
            "errcm",
            "δcm",
            "cmuncertainty",
        ],
    ),
];

/// How units of angles end a name.
const UNITS: [&str; 7] = ["degrees", "degree", "deg", "°", "radians", "radian", "rad"];

/// What a name of a column means, and the unit that it says.
pub(super) fn meaning(name: &str) -> Option<(Meaning, Option<Unit>)> {
    let own = letters(name);
    if let Some(meaning) = known(&own) {
        return Some((meaning, None));
    }
    let is_slope = |own: &Meaning| matches!(own, Meaning::Slope(_));
    let found = |unit: &str| {
        let of = |own: &str| Some((known(own.strip_suffix(unit)?)?, Unit::of(unit)));
        let per = |own: &str| known(numerator(own.strip_suffix(unit)?)).filter(is_slope);
        let angle = of(&own).filter(|(own, _)| *own == Meaning::Angle);
        angle.or_else(|| Some((per(own.trim_end_matches(POWERS))?, Unit::of(unit))))
    };
    UNITS.iter().find_map(|unit| found(unit))
}

/// The meaning of a usual name in small letters.
fn known(text: &str) -> Option<Meaning> {
    let is_known = |(_, names): &&(Meaning, &[&str])| names.contains(&text);
    NAMES.iter().find(is_known).map(|(meaning, _)| *meaning)
}

/// The signs of `deg^-1` that are letters.
const POWERS: [char; 2] = ['1', '¹'];

/// What stands before `1/` or `per`.
fn numerator(text: &str) -> &str {
    let rest = text.strip_suffix('1').or(text.strip_suffix("per"));
    rest.unwrap_or(text)
}

/// A name in small letters, without blanks and signs.
fn letters(name: &str) -> String {
    let is_part = |own: &char| own.is_alphanumeric() || *own == '°';
    name.to_lowercase().chars().filter(is_part).collect()
}

/// Whether cells are units: words such as deg, or brackets and dashes.
pub(super) fn are_units(cells: &[String]) -> bool {
    let is_unit = |cell: &String| {
        let is_bracketed = cell.starts_with(['(', '[']) && cell.ends_with([')', ']']);
        is_bracketed || Unit::per(cell).is_some() || letters(cell).is_empty()
    };
    cells.iter().all(is_unit) && cells.iter().any(|cell| !cell.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_names_are_understood() {
        use Unit::{Degrees, Radians};
        for (name, expected) in [
            ("alpha_deg", (Meaning::Angle, Some(Degrees))),
            ("AoA", (Meaning::Angle, None)),
            ("alpha [deg]", (Meaning::Angle, Some(Degrees))),
            ("α (°)", (Meaning::Angle, Some(Degrees))),
            ("Angle of attack / rad", (Meaning::Angle, Some(Radians))),
            ("alpha_rad", (Meaning::Angle, Some(Radians))),
            ("Cl", (Meaning::Lift, None)),
            ("C_L [-]", (Meaning::Lift, None)),
            ("Drag coefficient", (Meaning::Drag, None)),
            ("cm", (Meaning::Moment, None)),
            ("dCL/dalpha", (Meaning::Slope("dCL"), None)),
            ("dCL/dalpha [1/deg]", (Meaning::Slope("dCL"), Some(Degrees))),
            ("dCM per degree", (Meaning::Slope("dCM"), Some(Degrees))),
            ("dCD (rad^-1)", (Meaning::Slope("dCD"), Some(Radians))),
        ] {
            assert_eq!(meaning(name), Some(expected), "{name}");
        }
        for name in ["", "Re", "C_N", "CLrad", "degrees", "Cpmin", "alpha_deg1"] {
            assert_eq!(meaning(name), None, "{name}");
        }
    }

    #[test]
    fn units_are_told_from_numbers_and_names() {
        let cells = |text: &str| text.split(',').map(String::from).collect::<Vec<_>>();
        assert!(are_units(&cells("(deg),(-),(-),(-)")));
        assert!(are_units(&cells("°,-,-,-")));
        assert!(are_units(&cells("deg,,,")));
        assert!(are_units(&cells("deg,-,1/deg")));
        for other in ["1,2,3", "deg,1,-,-", "a,b,c", ",,"] {
            assert!(!are_units(&cells(other)), "{other}");
        }
    }
}
