//! What a case file says, key by key.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::de::{DeTable, DeValue, Error, ValueDeserializer};

use super::keys::Lines;
use super::turn::Turn;
use crate::stability::coefficient_table::reading::Reading;
use crate::stability::coefficient_table::reference::Reference;
use crate::stability::coordinate::{Coordinate, FreeCoordinates};
use crate::stability::input::{InputError, quoted};
use crate::stability::interpolation::Interpolation;
use crate::stability::quantity::Quantity;
use crate::stability::section::Parameters;

/// Every key may be missing here: all that are, and are needed, are told at once.
#[derive(Default)]
pub(super) struct File {
    /// The quantities, by their keys.
    numbers: BTreeMap<String, f64>,
    pub(super) coefficients: Option<String>,
    pub(super) reading: Reading,
    pub(super) reference: Reference,
    pub(super) interpolation: Option<Interpolation>,
    free: Option<Vec<String>>,
    aerodynamic_stiffness: bool,
    pub(super) mean_twist: bool,
    pub(super) alpha_deg: Option<Steps>,
    pub(super) turn: Option<Turn>,
    pub(super) errors: Option<Errors>,
}

/// How far the coefficients of the table may be off.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Errors {
    #[serde(default, rename = "CD", alias = "C_D")]
    pub(super) drag: f64,
    #[serde(default, rename = "CL", alias = "C_L")]
    pub(super) lift: f64,
    #[serde(default, rename = "CM", alias = "C_M")]
    pub(super) moment: f64,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Steps {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) step: f64,
}

impl File {
    /// Reads the values of keys that are known: no two tables have the same.
    pub(super) fn read(document: DeTable<'_>) -> Result<Self, Error> {
        let mut file = File::default();
        for (_, table) in document {
            if let DeValue::Table(table) = table.into_inner() {
                for (key, value) in table {
                    file.take(key.get_ref(), value.into())?;
                }
            }
        }
        Ok(file)
    }

    fn take(&mut self, key: &str, value: ValueDeserializer<'_>) -> Result<(), Error> {
        match key {
            "coefficients" => self.coefficients = Deserialize::deserialize(value)?,
            "columns" => self.reading.columns = Deserialize::deserialize(value)?,
            "mirror" => self.reading.mirror = Deserialize::deserialize(value)?,
            "slopes" => self.reading.slopes = Deserialize::deserialize(value)?,
            "reference" => self.reference = Deserialize::deserialize(value)?,
            "interpolation" => self.interpolation = Deserialize::deserialize(value)?,
            "errors" => self.errors = Deserialize::deserialize(value)?,
            "free" => self.free = Deserialize::deserialize(value)?,
            "aerodynamic_stiffness" => {
                self.aerodynamic_stiffness = Deserialize::deserialize(value)?;
            }
            "mean_twist" => self.mean_twist = Deserialize::deserialize(value)?,
            "alpha_deg" => self.alpha_deg = Deserialize::deserialize(value)?,
            "turn" => self.turn = Deserialize::deserialize(value)?,
            _ => drop(self.numbers.insert(key.into(), f64::deserialize(value)?)),
        }
        Ok(())
    }

    /// The coordinates that are free.
    pub(super) fn free(&self, file: &str, lines: &Lines) -> Result<FreeCoordinates, InputError> {
        let place = lines.place(file, "structure", "free");
        let Some(names) = &self.free else {
            return Ok(FreeCoordinates::all());
        };
        let known = Coordinate::ALL;
        let one = |name: &String| known.into_iter().find(|own| own.name() == name);
        let unknown = names.iter().find(|name| one(name).is_none());
        let free: Vec<Coordinate> = names.iter().filter_map(one).collect();
        let (what, help) = match (unknown, FreeCoordinates::new(&free)) {
            (Some(name), _) => (
                format!("there is no coordinate `{}`", quoted(name)),
                "free holds some of \"x\", \"y\", \"theta\"",
            ),
            (None, Ok(own)) if own.as_slice().len() < free.len() => (
                "free names a coordinate twice".to_string(),
                "free holds each of \"x\", \"y\", \"theta\" once at most",
            ),
            (None, Ok(free)) => return Ok(free),
            (None, Err(_)) => (
                "no coordinate is free".to_string(),
                "free holds at least one of \"x\", \"y\", \"theta\"",
            ),
        };
        Err(InputError::new(place, what, help))
    }

    /// What the file says of the section; the rest is to be filled in.
    pub(super) fn parameters(&self, free: FreeCoordinates) -> Parameters {
        let number =
            |own: Quantity| Some(own.row().unit.to_si(*self.numbers.get(own.key()?.name)?));
        let mut parameters = Parameters {
            free,
            aerodynamic_stiffness: self.aerodynamic_stiffness,
            // Where theta is held nothing has a lever, and any radius will do.
            radius_of_gyration: number(Quantity::D).unwrap_or(1.0),
            ..Parameters::default()
        };
        for own in Quantity::ALL {
            if let Some(value) = number(*own) {
                own.set(&mut parameters, value);
            }
        }
        parameters
    }
}
