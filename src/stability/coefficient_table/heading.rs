//! Where the columns of a table stand.

use super::meaning::{Meaning, Unit, meaning};
use super::names::Names;
use crate::stability::input::{InputError, Place, meant_among, quoted};

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

/// The columns of derivatives.
pub(super) const SLOPES: [&str; 3] = ["dCD", "dCL", "dCM"];

/// The columns of errors.
pub(super) const ERRORS: [&str; 3] = ["CD_error", "CL_error", "CM_error"];

/// How the first row names the columns.
const HELP: &str = "the first row that is no comment names the columns alpha_deg, CL, CD, CM";

/// So many columns of a heading are named.
const MOST_NAMED: usize = 12;

/// Where the columns stand.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    pub count: usize,
    /// The angle, CL, CD, CM.
    pub places: [usize; 4],
    /// The derivatives of CD, CL and CM, as far as they are given, and what is said of their units.
    pub slopes: [Option<(usize, Option<Unit>)>; 3],
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
    pub fn read(place: &Place, heading: &[String], names: &Names) -> Result<Self, InputError> {
        names.check(place, heading)?;
        let meanings: Vec<_> = heading.iter().map(|name| names.meaning(name)).collect();
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
        let mut lacking = Vec::new();
        for (own, (wanted, name)) in places.iter_mut().zip(NEEDED) {
            match find(wanted)? {
                Some(found) => *own = found,
                None => lacking.push(name),
            }
        }
        if let [name, ..] = lacking.as_slice() {
            return Err(missing(place, heading, name, &lacking, names));
        }
        let unit = |place: usize| meanings[place].and_then(|(_, unit)| unit);
        let mut slopes = [None; 3];
        for (own, name) in slopes.iter_mut().zip(SLOPES) {
            *own = find(Meaning::Slope(name))?.map(|place| (place, unit(place)));
        }
        let mut errors = [None; 3];
        for (own, name) in errors.iter_mut().zip(ERRORS) {
            *own = find(Meaning::Error(name))?;
        }
        let is_other = |own: &usize| meanings[*own].is_none() && !heading[*own].is_empty();
        let others = (0..heading.len()).filter(is_other);
        Ok(Columns {
            count: heading.len(),
            places,
            slopes,
            errors,
            unit: unit(places[0]),
            others: others.map(|own| heading[own].clone()).collect(),
        })
    }

    /// Takes units from the row below the heading, where this says none.
    ///
    /// # Errors
    ///
    /// If both say a unit of the angle, and not the same.
    pub fn read_units(&mut self, place: &Place, units: &[String]) -> Result<(), InputError> {
        let named = units.get(self.places[0]).and_then(|own| Unit::of(own));
        if let (Some(one), Some(other)) = (self.unit, named)
            && one != other
        {
            let what = "the heading says another unit of the angle than the row of units below";
            return Err(InputError::new(place.clone(), what, "correct one of them"));
        }
        self.unit = self.unit.or(named);
        for (column, unit) in self.slopes.iter_mut().flatten() {
            *unit = unit.or_else(|| Unit::per(units.get(*column)?));
        }
        Ok(())
    }

    /// The columns that are used, with the names that they have.
    pub fn used(&self, heading: &[String], unit: Unit, slopes: bool) -> Vec<String> {
        let angle = match unit {
            Unit::Degrees => "alpha_deg",
            Unit::Radians => "alpha_rad",
        };
        let needed = [angle, COLUMNS[1], COLUMNS[2], COLUMNS[3]].into_iter();
        let needed = needed.zip(self.places);
        let slopes = SLOPES.iter().zip(self.slopes).filter(|_| slopes);
        let slopes = slopes.filter_map(|(name, own)| Some((*name, own?.0)));
        let errors = ERRORS.iter().zip(self.errors);
        let errors = errors.filter_map(|(name, own)| Some((*name, own?)));
        let shown = |(name, place): (&str, usize)| match &heading[place] {
            own if own == name => name.to_string(),
            own => format!("{name} = `{}`", quoted(own)),
        };
        needed.chain(slopes).chain(errors).map(shown).collect()
    }

    /// Refuses a table without some of the columns of derivatives.
    pub fn check_slopes(&self, place: &Place) -> Result<(), InputError> {
        let names = SLOPES.iter().zip(self.slopes);
        let missing = names.filter_map(|(name, own)| own.is_none().then_some(*name));
        let missing: Vec<&str> = missing.collect();
        if missing.is_empty() {
            return Ok(());
        }
        Err(InputError::new(
            place.clone(),
            format!(
                "the case has `slopes = true`, and the table no column {}",
                missing.join(", ")
            ),
            "derivatives are taken from dCL, dCD and dCM if all are there; else leave `slopes` out",
        ))
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

/// Columns that are not there, with one that may be meant by the first of them.
fn missing(
    place: &Place,
    heading: &[String],
    name: &str,
    lacking: &[&str],
    names: &Names,
) -> InputError {
    if let Some(number) = heading.iter().find(|own| own.parse::<f64>().is_ok()) {
        let number = quoted(number);
        let what = format!("the first row begins its columns with a number, {number}");
        let help = "name the columns: alpha_deg,CL,CD,CM";
        return InputError::new(place.clone(), what, help);
    }
    let unknown = |own: &&String| names.meaning(own).is_none() && !own.is_empty();
    let unusual = heading
        .iter()
        .filter(|own| unknown(own) && meaning(own).is_none());
    let near = unusual.into_iter().find_map(|own| {
        let help = meant_among(&[name], own, &COLUMNS);
        help.starts_with("did you mean").then_some((own, help))
    });
    let (what, mut help) = match near {
        Some((own, help)) => (format!("there is no column `{}`", quoted(own)), help),
        None => {
            let there: Vec<String> = heading
                .iter()
                .take(MOST_NAMED)
                .map(|own| quoted(own))
                .collect();
            let what = format!(
                "no column means {}; there are {}",
                lacking.join(", or "),
                there.join(", ")
            );
            (what, HELP.to_string())
        }
    };
    let mapped: Vec<String> = lacking
        .iter()
        .map(|own| format!("{own} = \"its name\""))
        .collect();
    help += &format!(
        "; if a column has another name, say so in [section] of the case: columns = {{ {} }}",
        mapped.join(", ")
    );
    if lacking.contains(&COLUMNS[3]) {
        help += "; where theta is held CM does nothing, and a column of 0 will do";
    }
    InputError::new(place.clone(), what, help)
}
