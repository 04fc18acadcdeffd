//! `{"case", "eccentricity", "delta", "strength", "forms": […], "map": […]}`.

use serde::Serialize;

use crate::stability::coefficient_table::reference::Reference;
use crate::stability::validity::{Departure, Form, Validity};

use super::pairs::{Pairs, is_empty, settings};
use super::write;

#[derive(Serialize)]
struct Shown<'a> {
    case: &'a str,
    /// What was set in place of what the case says.
    #[serde(skip_serializing_if = "is_empty")]
    set: Pairs<f64>,
    /// The lengths that its coefficients stand over, where they are not D.
    #[serde(skip_serializing_if = "Reference::is_usual")]
    reference: Reference,
    eccentricity: f64,
    delta: f64,
    largest_scaled_damping: f64,
    angles: usize,
    forms: Vec<OneForm>,
    closed_within: f64,
    closed_least_eccentricity: Option<f64>,
    closed_largest_wind_speed: Option<f64>,
    map_angles: usize,
    map: Vec<Place>,
}

#[derive(Serialize)]
struct OneForm {
    form: &'static str,
    case: Option<Shift>,
    error_over_order: f64,
}

#[derive(Serialize)]
struct Shift {
    error: f64,
    at_deg: f64,
    wrong_signs: usize,
    open_signs: usize,
    answers: usize,
}

#[derive(Serialize)]
struct Place {
    eccentricity: f64,
    delta: f64,
    closed: Shift,
    uniform_first: Shift,
    uniform_second: Shift,
}

/// The errors of the forms for the case and over the map.
pub fn validity(validity: &Validity) -> String {
    let [eccentricity, delta] = validity.own;
    let form = |form: Form| OneForm {
        form: form.word(),
        case: validity.own_departures[form as usize].map(shift),
        error_over_order: validity.constant(form),
    };
    let places = validity.winds.iter().flat_map(|wind| {
        let places = validity.eccentricities.iter();
        places.map(move |eccentricity| (*eccentricity, *wind))
    });
    let place = |((eccentricity, delta), cell): ((f64, f64), &[Departure; 3])| {
        let [closed, uniform_first, uniform_second] = cell.map(shift);
        Place {
            eccentricity,
            delta,
            closed,
            uniform_first,
            uniform_second,
        }
    };
    write(&Shown {
        case: &validity.case.file,
        set: settings(&validity.case),
        reference: validity.case.reference,
        eccentricity,
        delta,
        largest_scaled_damping: validity.strength,
        angles: validity.angles,
        forms: Form::ALL.map(form).into(),
        closed_within: crate::stability::validity::TOLERANCE,
        closed_least_eccentricity: validity.least_eccentricity,
        closed_largest_wind_speed: validity.largest_wind.map(|wind| validity.wind_speed(wind)),
        map_angles: validity.angles,
        map: places.zip(&validity.cells).map(place).collect(),
    })
}

fn shift(own: Departure) -> Shift {
    Shift {
        error: own.error,
        at_deg: own.angle,
        wrong_signs: own.wrong_signs,
        open_signs: own.open_signs,
        answers: own.answers,
    }
}
