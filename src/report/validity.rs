//! Where the closed forms of a case may be trusted in words and numbers, said once for every view.

use crate::stability::comparison::angle;
use crate::stability::validity::{Form, TOLERANCE, Validity};

/// The largest error of a form for the case as it is, and what is wrong: `1.2e-1 (at 68.5°), wrong sign at 9 of
/// 361 angles`.
pub fn departure(validity: &Validity, form: Form) -> String {
    let angles = validity.angles;
    let Some(own) = validity.own_departures[form as usize] else {
        return "does not apply".to_string();
    };
    let signs = match own.wrong_signs {
        0 => "no wrong sign".to_string(),
        wrong => format!("wrong sign at {wrong} of {angles} angles"),
    };
    let open = match own.open_signs {
        0 => String::new(),
        open => format!(", not decided at {open}"),
    };
    let silent = match angles - own.answers {
        0 => String::new(),
        silent => format!(", no answer at {silent}"),
    };
    format!(
        "{:.1e} (at {}°), {signs}{open}{silent}",
        rounded_up(own.error),
        angle(own.angle)
    )
}

/// How far the closed form reaches, perfectly tuned and without structural damping.
pub fn reach(validity: &Validity) -> String {
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
pub fn rounded_up(number: f64) -> f64 {
    if !(number > 0.0 && number.is_finite()) {
        return number;
    }
    let unit = 10_f64.powf(number.log10().floor() - 1.0);
    (number / unit).ceil() * unit
}
