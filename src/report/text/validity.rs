//! Where the closed forms of a case may be trusted, for a terminal.

use crate::report::stability::options;
use crate::report::validity::{departure, reach, rounded_up};
use crate::stability::validity::{Form, Validity};

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// A page: the errors for the case, how far its closed form reaches, and the measured bounds.
pub fn validity(validity: &Validity, width: usize) -> String {
    let mut page = Page::new(width);
    let [e, wind] = validity.own;
    let place = format!(
        "{}: e = L_g/r = {e:.3e}, δ = ρDU/(2mω_n) = {wind:.3e}, δ|S_a| up to {:.3e}{}",
        validity.case.title(),
        wind * validity.strength,
        options(&validity.case)
    );
    page.prose(&[], &[Run::words(place, STRONG)]);
    page.heading(&format!(
        "The case as it is, at all of its {} angles: largest errors of S over |S_a|",
        validity.angles
    ));
    for form in Form::ALL {
        line(&mut page, form.name(), departure(validity, form));
    }
    page.heading("Perfectly tuned and without structural damping");
    line(&mut page, "closed form (21)–(23)", reach(validity));
    page.heading(&format!(
        "Errors over their orders there, at most, for all e and δ of the map, at the same {} angles",
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
