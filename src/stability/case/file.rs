//! The tables of a case file as they are written.

use serde::Deserialize;

use super::Turn;
use super::keys::Lines;
use crate::stability::coordinate::{Coordinate, FreeCoordinates};
use crate::stability::input::{InputError, quoted};
use crate::stability::interpolation::Interpolation;
use crate::stability::section::Parameters;

/// Every key may be missing here: all that are, and are needed, are told at once.
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
    pub(super) D: Option<f64>,
    pub(super) m: Option<f64>,
    pub(super) r: Option<f64>,
    pub(super) L_g: Option<f64>,
    pub(super) alpha_g_deg: Option<f64>,
    pub(super) L_a: Option<f64>,
    pub(super) gamma_r_deg: Option<f64>,
    pub(super) coefficients: Option<String>,
    pub(super) interpolation: Option<Interpolation>,
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
    pub(super) rho: Option<f64>,
    pub(super) U: Option<f64>,
    #[serde(default)]
    pub(super) aerodynamic_stiffness: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SweepTable {
    pub(super) alpha_deg: Option<Steps>,
    pub(super) turn: Option<Turn>,
}

/// A key that is needed: its table, its name, whether it is there, and what it may be.
type Needed = (&'static str, &'static str, bool, &'static str);

impl File {
    /// The keys that are needed with these free coordinates.
    fn needed(&self, free: FreeCoordinates) -> Vec<Needed> {
        let (section, structure) = (&self.section, &self.structure);
        let (wind, sweep) = (&self.wind, &self.sweep);
        let mut needed = vec![
            (
                "section",
                "D",
                section.D.is_some(),
                "the reference dimension in m",
            ),
            ("section", "m", section.m.is_some(), "the mass in kg/m"),
        ];
        if free.as_slice().contains(&Coordinate::Theta) {
            needed.extend([
                (
                    "section",
                    "r",
                    section.r.is_some(),
                    "the radius of gyration in m",
                ),
                (
                    "section",
                    "L_g",
                    section.L_g.is_some(),
                    "from the elastic centre to the mass centre in m",
                ),
                (
                    "section",
                    "alpha_g_deg",
                    section.alpha_g_deg.is_some(),
                    "and its angle in degrees",
                ),
                (
                    "section",
                    "L_a",
                    section.L_a.is_some(),
                    "from the elastic centre to the aerodynamic centre in m",
                ),
                (
                    "section",
                    "gamma_r_deg",
                    section.gamma_r_deg.is_some(),
                    "and its angle in degrees",
                ),
            ]);
        }
        needed.extend([
            (
                "section",
                "coefficients",
                section.coefficients.is_some(),
                "the file of the table",
            ),
            (
                "section",
                "interpolation",
                section.interpolation.is_some(),
                "\"cubic\" or \"linear\"",
            ),
        ]);
        needed.extend(structure.needed(free));
        needed.extend([
            (
                "wind",
                "rho",
                wind.rho.is_some(),
                "the density of air, about 1.25 kg/m³",
            ),
            ("wind", "U", wind.U.is_some(), "the wind speed in m/s"),
            (
                "sweep",
                "alpha_deg",
                sweep.alpha_deg.is_some(),
                "{ from = 0, to = 180, step = 0.5 }",
            ),
            (
                "sweep",
                "turn",
                sweep.turn.is_some(),
                "\"section\" or \"wind\", what turns with alpha",
            ),
        ]);
        needed
    }

    /// Refuses a file in which keys are missing, with all of them.
    pub(super) fn check_needed(
        &self,
        free: FreeCoordinates,
        file: &str,
        lines: &Lines,
    ) -> Result<(), InputError> {
        let needed = self.needed(free);
        let missing: Vec<&Needed> = needed
            .iter()
            .filter(|(_, _, is_there, _)| !is_there)
            .collect();
        let Some((first, ..)) = missing.first() else {
            return Ok(());
        };
        let names = |table: &str| {
            let own = missing.iter().filter(|own| own.0 == table);
            own.map(|(_, key, ..)| *key).collect::<Vec<_>>().join(", ")
        };
        let mut tables: Vec<&str> = missing.iter().map(|own| own.0).collect();
        tables.dedup();
        let tables = tables
            .iter()
            .map(|own| format!("[{own}] lacks {}", names(own)));
        let what = tables.collect::<Vec<_>>().join("; ");
        let meanings = missing
            .iter()
            .map(|(_, key, _, meaning)| format!("{key}, {meaning}"));
        let help = format!("give {}", meanings.collect::<Vec<_>>().join("; "));
        Err(InputError::new(lines.place(file, first, ""), what, help))
    }
}

#[derive(Default, Deserialize)]
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

    fn frequencies(&self) -> [Option<f64>; 3] {
        [self.f_x, self.f_y, self.f_theta]
    }

    fn ratios(&self) -> [Option<f64>; 3] {
        [self.zeta_x, self.zeta_y, self.zeta_theta]
    }

    /// A frequency and a ratio for each coordinate that is free.
    fn needed(&self, free: FreeCoordinates) -> Vec<Needed> {
        let (frequencies, ratios) = (self.frequencies(), self.ratios());
        let mut needed = Vec::new();
        for own in free.as_slice().iter().map(|free| free.index()) {
            let (frequency, ratio) = (FREQUENCIES[own], DAMPING_RATIOS[own]);
            needed.extend([
                (
                    "structure",
                    frequency,
                    frequencies[own].is_some(),
                    "a frequency in Hz",
                ),
                (
                    "structure",
                    ratio,
                    ratios[own].is_some(),
                    "a damping ratio, which may be 0",
                ),
            ]);
        }
        needed
    }

    /// What the table says; the rest is to be filled in.
    pub(super) fn parameters(&self, free: FreeCoordinates) -> Parameters {
        let (frequencies, ratios) = (self.frequencies(), self.ratios());
        let turn = std::f64::consts::TAU;
        Parameters {
            natural_frequencies: frequencies.map(|own| turn * own.unwrap_or(0.0)),
            damping_ratios: ratios.map(|own| own.unwrap_or(0.0)),
            free,
            ..Parameters::default()
        }
    }
}
