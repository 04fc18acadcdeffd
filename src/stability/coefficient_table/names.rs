//! What the names of columns mean: what a case says, and else what is usual.

use super::meaning::{Meaning, Unit, meaning};
use super::reading::Reading;
use crate::stability::input::{InputError, Place, meant, quoted, shortened};

/// The names of the columns of a table.
pub(super) struct Names<'a>(pub &'a Reading);

impl Names<'_> {
    /// What a name means, and the unit that it says.
    pub fn meaning(&self, name: &str) -> Option<(Meaning, Option<Unit>)> {
        if let Some(key) = self.key(name) {
            return meaning(key).map(|(own, unit)| (own, unit.or(Unit::within(name))));
        }
        let is_mapped = |wanted: Meaning| {
            let mut keys = self.0.columns.keys();
            keys.any(|key| meaning(key).is_some_and(|(own, _)| own == wanted))
        };
        meaning(name).filter(|(own, _)| !is_mapped(*own))
    }

    /// What the case calls a column with this name.
    fn key(&self, name: &str) -> Option<&str> {
        let mut columns = self.0.columns.iter();
        columns.find_map(|(key, own)| (own.trim() == name).then_some(key.as_str()))
    }

    /// Whether cells name an angle, a lift and a drag.
    pub fn are_in(&self, cells: &[String]) -> bool {
        let meanings: Vec<_> = cells.iter().filter_map(|own| self.meaning(own)).collect();
        let is_there = |wanted| meanings.iter().any(|(own, _)| *own == wanted);
        [Meaning::Angle, Meaning::Lift, Meaning::Drag]
            .into_iter()
            .all(is_there)
    }

    /// Whether any cell has a name that the case says.
    pub fn are_partly_in(&self, cells: &[String]) -> bool {
        cells.iter().any(|own| self.key(own).is_some())
    }

    /// Refuses what the case says of columns where it does not fit them.
    pub fn check(&self, place: &Place, heading: &[String]) -> Result<(), InputError> {
        let mut seen: Vec<(Meaning, &str, &str)> = Vec::new();
        for (key, name) in &self.0.columns {
            let name = name.trim();
            let wrong = |what: String, help: &str| Err(InputError::new(place.clone(), what, help));
            let Some((own, unit)) = meaning(key) else {
                let what = format!("`columns` in the case names `{}`, no column", quoted(key));
                return wrong(what, &meant(key, &KEYS));
            };
            if let Some((_, other, _)) = seen.iter().find(|(seen, ..)| *seen == own) {
                let what = format!("{other} and {key} in `columns` of the case are the same");
                return wrong(what, "keep the one with the unit of the table");
            }
            if let Some((_, other, _)) = seen.iter().find(|(_, _, seen)| *seen == name) {
                let name = quoted(name);
                let what = format!("{other} and {key} are both the column `{name}`, by the case");
                return wrong(what, "correct `columns` in the case");
            }
            if name.is_empty() || !heading.iter().any(|cell| cell == name) {
                let what = format!(
                    "there is no column `{}`, which the case calls {key}",
                    quoted(name)
                );
                return wrong(what, &format!("the columns are {}", listed(heading)));
            }
            if unit.is_some_and(|unit| Unit::within(name).is_some_and(|other| other != unit)) {
                let what = format!(
                    "`{}` says another unit than {key}, as the case calls it",
                    quoted(name)
                );
                return wrong(
                    what,
                    "correct `columns` in the case: alpha_deg or alpha_rad",
                );
            }
            seen.push((own, key, name));
        }
        Ok(())
    }
}

/// What `columns` in a case may name.
pub(in crate::stability) const KEYS: [&str; 11] = [
    "alpha_deg",
    "alpha_rad",
    "CL",
    "CD",
    "CM",
    "dCL",
    "dCD",
    "dCM",
    "CL_error",
    "CD_error",
    "CM_error",
];

/// The columns of a heading.
fn listed(heading: &[String]) -> String {
    let names = heading.iter().filter(|own| !own.is_empty());
    let names: Vec<String> = names.map(|own| format!("`{}`", quoted(own))).collect();
    shortened(&names.join(", "))
}
