//! The critical wind speeds of a case, for a terminal.

use crate::report::speeds::{SpeedsFound, alike, conclusion, listed};
use crate::report::stability::with_stiffness;
use crate::stability::comparison::angle;
use crate::stability::critical_speed::{Speeds, Stability};

use super::page::Page;
use super::palette::{PLAIN, STRONG};
use super::run::{Run, column};

/// A line for each angle at which something is unstable or not decided; neighbours with the same kinds of
/// ranges share one, with the lowest and the highest of their speeds.
pub fn speeds(found: &SpeedsFound, width: usize) -> String {
    let mut page = Page::new(width);
    let title = format!(
        "{}: wind speeds up to {} m/s{}",
        found.case.title(),
        found.highest,
        with_stiffness(&found.case)
    );
    page.prose(&[], &[Run::words(title, STRONG)]);
    page.gap();
    page.prose(&[], &[Run::words(conclusion(found), PLAIN)]);
    page.heading("Wind speeds, by the angle");
    for run in alike(&found.angles) {
        let (Some((first, _)), Some((last, _))) = (run.first(), run.last()) else {
            continue;
        };
        let angles = match run.len() {
            1 => format!("  {}°", angle(*first)),
            _ => format!("  {}° to {}°", angle(*first), angle(*last)),
        };
        page.prose(
            &column(&angles, 20, PLAIN),
            &[Run::words(at_angles(run, found.highest), PLAIN)],
        );
    }
    page.finish()
}

/// What is so at angles that are alike.
fn at_angles(run: &[(f64, Speeds)], highest: f64) -> String {
    let Some((_, speeds)) = run.first() else {
        return String::new();
    };
    let parts = [
        (Stability::Unstable, "gallops"),
        (Stability::Divergent, "diverges"),
        (Stability::Undecided, "not decided"),
    ];
    let mut words: Vec<String> = parts
        .into_iter()
        .filter(|(stability, _)| speeds.ranges.iter().any(|own| own.stability == *stability))
        .map(|(stability, word)| format!("{word} {}", listed(run, stability, highest)))
        .collect();
    if words.is_empty() {
        words.push("stable at every speed".into());
    }
    if speeds.is_neutral {
        words.push("a real part is 0 at every speed, exactly".into());
    }
    words.join("; ")
}
