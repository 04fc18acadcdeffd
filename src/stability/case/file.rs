//! The tables of a case file as they are written.

use serde::Deserialize;

use super::Turn;
use super::keys::Lines;
use crate::stability::coordinate::{Coordinate, FreeCoordinates};
use crate::stability::forces::Forces;
use crate::stability::input::{InputError, quoted};
use crate::stability::interpolation::Interpolation;
use crate::stability::section::Parameters;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub(super) section: SectionTable,
    pub(super) structure: StructureTable,
    pub(super) wind: WindTable,
    pub(super) sweep: SweepTable,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)]
pub(super) struct SectionTable {
    pub(super) D: f64,
    pub(super) m: f64,
    pub(super) r: f64,
    pub(super) L_g: f64,
    pub(super) alpha_g_deg: f64,
    pub(super) L_a: f64,
    pub(super) gamma_r_deg: f64,
    pub(super) coefficients: String,
    pub(super) interpolation: Interpolation,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StructureTable {
    pub(super) f_x: Option<f64>,
    pub(super) f_y: Option<f64>,
    pub(super) f_theta: Option<f64>,
    pub(super) zeta_x: Option<f64>,
    pub(super) zeta_y: Option<f64>,
    pub(super) zeta_theta: Option<f64>,
    pub(super) free: Option<Vec<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)]
pub(super) struct WindTable {
    pub(super) rho: f64,
    pub(super) U: f64,
    #[serde(default)]
    pub(super) aerodynamic_stiffness: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SweepTable {
    pub(super) alpha_deg: Steps,
    pub(super) turn: Turn,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Steps {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) step: f64,
}

/// The keys of frequencies and damping ratios, in the order x, y, θ.
const FREQUENCIES: [&str; 3] = ["f_x", "f_y", "f_theta"];
const DAMPING_RATIOS: [&str; 3] = ["zeta_x", "zeta_y", "zeta_theta"];

impl StructureTable {
    /// What the table says; the rest is to be filled in.
    pub(super) fn parameters(&self, file: &str, lines: &Lines) -> Result<Parameters, InputError> {
        let place = lines.place(file, "structure", "free");
        let free = match &self.free {
            None => FreeCoordinates::all(),
            Some(names) => {
                let known = Coordinate::ALL;
                let one = |name: &String| known.into_iter().find(|own| own.name() == name);
                let unknown = names.iter().find(|name| one(name).is_none());
                let free: Vec<Coordinate> = names.iter().filter_map(one).collect();
                match (unknown, FreeCoordinates::new(&free)) {
                    (Some(name), _) => {
                        let what = format!("there is no coordinate `{}`", quoted(name));
                        let help = "free holds some of \"x\", \"y\", \"theta\"";
                        return Err(InputError::new(place, what, help));
                    }
                    (None, Ok(own)) if own.as_slice().len() < free.len() => {
                        let what = "free names a coordinate twice";
                        let help = "free holds each of \"x\", \"y\", \"theta\" once at most";
                        return Err(InputError::new(place, what, help));
                    }
                    (None, Ok(free)) => free,
                    (None, Err(_)) => {
                        let help = "free holds at least one of \"x\", \"y\", \"theta\"";
                        return Err(InputError::new(place, "no coordinate is free", help));
                    }
                }
            }
        };
        let (frequencies, ratios) = (
            [self.f_x, self.f_y, self.f_theta],
            [self.zeta_x, self.zeta_y, self.zeta_theta],
        );
        for coordinate in free.as_slice() {
            let index = coordinate.index();
            let given = [
                (FREQUENCIES[index], frequencies[index], "a frequency in Hz"),
                (
                    DAMPING_RATIOS[index],
                    ratios[index],
                    "a damping ratio, which may be 0",
                ),
            ];
            if let Some((key, _, help)) = given.iter().find(|(_, value, _)| value.is_none()) {
                let (place, name) = (lines.place(file, "structure", ""), coordinate.name());
                let what = format!("{key} is missing, and {name} is free");
                return Err(InputError::new(place, what, format!("give {key}, {help}")));
            }
        }
        let turn = std::f64::consts::TAU;
        Ok(Parameters {
            mass: 0.0,
            radius_of_gyration: 0.0,
            mass_centre_distance: 0.0,
            mass_centre_angle: 0.0,
            aerodynamic_centre_distance: 0.0,
            aerodynamic_centre_angle: 0.0,
            reference_dimension: 0.0,
            natural_frequencies: frequencies.map(|own| turn * own.unwrap_or(0.0)),
            damping_ratios: ratios.map(|own| own.unwrap_or(0.0)),
            air_density: 0.0,
            wind_speed: 0.0,
            wind_angle: 0.0,
            attitude: 0.0,
            forces: Forces::default(),
            free,
            aerodynamic_stiffness: false,
        })
    }
}
