//! What the columns of a table mean, by their usual names.

use std::f64::consts::PI;

use crate::stability::input::{InputError, Place, meant_among, quoted};

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

/// The columns as they are best written, for messages.
const COLUMNS: [&str; 10] = [
    "alpha_deg",
    "CL",
    "CD",
    "CM",
    "dCL",
    "dCD",
    "dCM",
    "CD_error",
    "CL_error",
    "CM_error",
];

/// What must be there.
const NEEDED: [(Meaning, &str); 4] = [
    (Meaning::Angle, COLUMNS[0]),
    (Meaning::Lift, COLUMNS[1]),
    (Meaning::Drag, COLUMNS[2]),
    (Meaning::Moment, COLUMNS[3]),
];

/// How the first row names the columns.
const HELP: &str = "the first row names the columns alpha_deg, CL, CD, CM, separated by commas";

/// What a name of a column means, and the unit that it says.
fn meaning(name: &str) -> Option<(Meaning, Option<Unit>)> {
    let own = letters(name);
    let known = |text: &str| {
        let is_known = |(_, names): &&(Meaning, &[&str])| names.contains(&text);
        NAMES.iter().find(is_known).map(|(meaning, _)| *meaning)
    };
    if let Some(meaning) = known(&own) {
        return Some((meaning, None));
    }
    ["degrees", "degree", "deg", "°", "radians", "radian", "rad"]
        .iter()
        .filter_map(|unit| Some((known(own.strip_suffix(unit)?)?, Unit::of(unit))))
        .find(|(meaning, _)| *meaning == Meaning::Angle)
}

/// A name in small letters, without blanks and signs.
fn letters(name: &str) -> String {
    let is_part = |own: &char| own.is_alphanumeric() || *own == '°';
    name.to_lowercase().chars().filter(is_part).collect()
}

/// Whether cells name an angle, a lift and a drag.
pub(super) fn is_heading(cells: &[String]) -> bool {
    let is_there = |wanted: Meaning| {
        cells
            .iter()
            .any(|own| meaning(own).is_some_and(|(found, _)| found == wanted))
    };
    [Meaning::Angle, Meaning::Lift, Meaning::Drag]
        .into_iter()
        .all(is_there)
}

/// Whether cells are units: words such as deg, or brackets and dashes.
pub(super) fn are_units(cells: &[String]) -> bool {
    let is_unit = |cell: &String| {
        let is_bracketed = cell.starts_with(['(', '[']) && cell.ends_with([')', ']']);
        is_bracketed || Unit::of(cell).is_some() || letters(cell).is_empty()
    };
    cells.iter().all(is_unit) && cells.iter().any(|cell| !cell.is_empty())
}

/// Where the columns stand.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    pub count: usize,
    /// The angle, CL, CD, CM.
    pub places: [usize; 4],
    pub slopes: Vec<(&'static str, usize)>,
    /// The errors of CD, CL and CM, as far as they are given.
    pub errors: [Option<usize>; 3],
    /// What is said of the unit of the angle.
    pub unit: Option<Unit>,
    /// What is not used.
    pub others: Vec<String>,
}

impl Columns {
    /// Finds the columns by their names.
    ///
    /// # Errors
    ///
    /// What is missing, or there twice.
    pub fn read(place: &Place, heading: &[String]) -> Result<Self, InputError> {
        let meanings: Vec<_> = heading.iter().map(|name| meaning(name)).collect();
        let find = |wanted: Meaning| -> Result<Option<usize>, InputError> {
            let is_wanted =
                |&own: &usize| meanings[own].is_some_and(|(meaning, _)| meaning == wanted);
            let mut found = (0..heading.len()).filter(is_wanted);
            match (found.next(), found.next()) {
                (Some(first), Some(second)) => Err(twice(place, heading, first, second)),
                (own, _) => Ok(own),
            }
        };
        let mut places = [0; 4];
        for (own, (wanted, name)) in places.iter_mut().zip(NEEDED) {
            *own = find(wanted)?.ok_or_else(|| missing(place, heading, name))?;
        }
        let mut slopes = Vec::new();
        for name in &COLUMNS[4..7] {
            slopes.extend(find(Meaning::Slope(name))?.map(|own| (*name, own)));
        }
        let mut errors = [None; 3];
        for (own, name) in errors.iter_mut().zip(&COLUMNS[7..]) {
            *own = find(Meaning::Error(name))?;
        }
        let is_other = |own: &usize| meanings[*own].is_none() && !heading[*own].is_empty();
        let others = (0..heading.len()).filter(is_other);
        Ok(Columns {
            count: heading.len(),
            places,
            slopes,
            errors,
            unit: meanings[places[0]].and_then(|(_, unit)| unit),
            others: others.map(|own| heading[own].clone()).collect(),
        })
    }
}

fn twice(place: &Place, heading: &[String], first: usize, second: usize) -> InputError {
    let [first, second] = [first, second].map(|own| quoted(&heading[own]));
    let what = match first == second {
        true => format!("the column `{first}` is there twice"),
        false => format!("the columns `{first}` and `{second}` mean the same"),
    };
    InputError::new(place.clone(), what, "keep one of them")
}

/// A column that is not there, with one that may be meant.
fn missing(place: &Place, heading: &[String], name: &str) -> InputError {
    if let Some(number) = heading.iter().find(|own| own.parse::<f64>().is_ok()) {
        let number = quoted(number);
        let what = format!("the first row begins its columns with a number, {number}");
        let help = "name the columns: alpha_deg,CL,CD,CM";
        return InputError::new(place.clone(), what, help);
    }
    let unknown = |own: &&String| meaning(own).is_none() && !own.is_empty();
    let near = heading.iter().filter(unknown).find_map(|own| {
        let help = meant_among(&[name], own, &COLUMNS);
        help.starts_with("did you mean").then_some((own, help))
    });
    let (what, help) = match near {
        Some((own, help)) => (format!("there is no column `{}`", quoted(own)), help),
        None => (format!("the column {name} is missing"), HELP.to_string()),
    };
    InputError::new(place.clone(), what, help)
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
        ] {
            assert_eq!(meaning(name), Some(expected), "{name}");
        }
        for name in ["", "Re", "C_N", "CLrad", "degrees", "Cpmin"] {
            assert_eq!(meaning(name), None, "{name}");
        }
    }

    #[test]
    fn units_are_told_from_numbers_and_names() {
        let cells = |text: &str| text.split(',').map(String::from).collect::<Vec<_>>();
        assert!(are_units(&cells("(deg),(-),(-),(-)")));
        assert!(are_units(&cells("°,-,-,-")));
        assert!(are_units(&cells("deg,,,")));
        for other in ["1,2,3", "deg,1,-,-", "a,b,c", ",,"] {
            assert!(!are_units(&cells(other)), "{other}");
        }
    }
}
