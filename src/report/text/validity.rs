//! Where the closed forms of a case may be trusted, for a terminal.

use crate::stability::comparison::angle;
use crate::stability::validity::{Departure, Form, TOLERANCE, Validity};

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// A page: the errors for the case, how far its closed form reaches, and the measured bounds.
pub fn validity(validity: &Validity, width: usize) -> String {
    let mut page = Page::new(width);
    let [e, wind] = validity.own;
    let place = format!(
        "{}: e = L_g/r = {e:.3e}, δ = ρDU/(2mω_n) = {wind:.3e}, δ|S_a| up to {:.3e}",
        validity.case.file,
        wind * validity.strength
    );
    page.prose(&[], &[Run::words(place, STRONG)]);
    page.heading(&format!(
        "The case as it is, at {} angles: largest errors of S over |S_a|",
        validity.own_angles
    ));
    for form in Form::ALL {
        let own = validity.own_departures[form as usize];
        let text = own.map_or("does not apply".to_string(), |own| {
            departure(own, validity.own_angles)
        });
        line(&mut page, form.name(), text);
    }
    page.heading("Perfectly tuned and without structural damping");
    line(&mut page, "closed form (21)–(23)", reach(validity));
    page.heading(&format!(
        "Errors over their orders there, at most, for all e and δ of the map ({} angles)",
        validity.angles
    ));
    for (form, order) in [
        (Form::Closed, "(δ|S_a|/e)²"),
        (Form::UniformFirst, "δ|S_a|"),
        (Form::UniformSecond, "(δ|S_a|)²"),
    ] {
        let text = format!("{:.1e} × {order}", rounded_up(validity.constant(form)));
        line(&mut page, form.name(), text);
    }
    page.hint(
        2,
        "measured, where the order is below 1; the orders are derived in uniform.md",
    );
    page.finish()
}

fn line(page: &mut Page, name: &str, text: String) {
    let prefix = [[spaces(2)].to_vec(), column(name, 28, FAINT).to_vec()];
    page.prose(&prefix.concat(), &[Run::words(text, PLAIN)]);
}

/// An error and what is wrong: `1.2e-1 (at 68.5°), wrong sign at 9 of 361 angles`.
fn departure(own: Departure, angles: usize) -> String {
    let signs = match own.wrong_signs {
        0 => "no wrong sign".to_string(),
        wrong => format!("wrong sign at {wrong} of {angles} angles"),
    };
    let silent = match angles - own.answers {
        0 => String::new(),
        silent => format!(", no answer at {silent}"),
    };
    format!(
        "{:.1e} (at {}°), {signs}{silent}",
        rounded_up(own.error),
        angle(own.angle)
    )
}

/// How far the closed form reaches.
fn reach(validity: &Validity) -> String {
    let share = TOLERANCE * 100.0;
    let [e, _] = validity.own;
    let from = match validity.least_eccentricity {
        Some(least) => format!("from L_g/r = {least:.2e} on at this wind"),
        None => "at no L_g/r at this wind".to_string(),
    };
    let up_to = match validity.largest_wind {
        Some(largest) => format!(
            "up to U = {:.2} m/s with L_g/r = {e:.2e}",
            validity.wind_speed(largest)
        ),
        None => format!("at no wind speed of the map with L_g/r = {e:.2e}"),
    };
    format!("within {share} % of |S_a| {from}; {up_to}")
}

/// The next number with two digits above another one.
fn rounded_up(number: f64) -> f64 {
    if !(number > 0.0 && number.is_finite()) {
        return number;
    }
    let unit = 10_f64.powf(number.log10().floor() - 1.0);
    (number / unit).ceil() * unit
}
