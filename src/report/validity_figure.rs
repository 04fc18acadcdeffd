//! Where the closed forms of a case may be trusted, as maps.

use crate::stability::validity::{Form, Validity};

use super::figure::{Map, Panel};
use super::stability_figure::{set, titled};

/// The errors of the closed form and of both uniform forms over L_g/r and δ, with the case marked and what has
/// the wrong sign hatched.
pub fn map(validity: &Validity) -> Map {
    let panel = |form: Form| Panel {
        title: form.name().into(),
        cells: validity
            .cells
            .iter()
            .map(|cell| cell[form as usize])
            .map(|own| (own.error, own.wrong_signs > 0))
            .collect(),
    };
    let [eccentricity, wind] = validity.own;
    let mark = match eccentricity > 0.0 {
        true => "the case",
        false => "the case: e = 0, left of the map",
    };
    Map {
        title: titled(
            "Errors of the closed forms over eccentricity and wind",
            &validity.case,
        ),
        subtitle: set(
            &validity.case,
            &format!(
                "perfectly tuned and without structural damping; at each place the worst of all {} angles",
                validity.angles
            ),
        ),
        x_label: "e = L_{g} / r".into(),
        y_label: "δ = ρDU / (2mω_{n})".into(),
        shade: "error of S / |S_{a}|".into(),
        hatched: "wrong sign of stability".into(),
        columns: validity.eccentricities.clone(),
        rows: validity.winds.clone(),
        panels: Form::ALL.map(panel).into(),
        line: (1.0 / validity.strength, "δ|S_{a}| = e".into()),
        mark: ((eccentricity, wind), mark.into()),
    }
}
