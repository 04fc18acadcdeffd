//! The critical wind speeds of a case, for a terminal.

use crate::report::speeds::{SpeedsFound, conclusion, listed};
use crate::report::stability::with_stiffness;
use crate::stability::comparison::angle;
use crate::stability::critical_speed::{Speeds, Stability};

use super::page::Page;
use super::palette::{PLAIN, STRONG};
use super::run::{Run, column};

/// A line for each angle at which something is unstable or not decided; neighbours that say the same share one.
pub fn speeds(found: &SpeedsFound, width: usize) -> String {
    let mut page = Page::new(width);
    let title = format!(
        "{}: wind speeds up to {} m/s{}",
        found.case.file,
        found.highest,
        with_stiffness(&found.case)
    );
    page.prose(&[], &[Run::words(title, STRONG)]);
    page.gap();
    page.prose(&[], &[Run::words(conclusion(found), PLAIN)]);
    page.heading("Wind speeds, by the angle");
    let said: Vec<(f64, String)> = found
        .angles
        .iter()
        .map(|(place, speeds)| (*place, at_angle(speeds, found.highest)))
        .collect();
    for run in said.chunk_by(|one, other| one.1 == other.1) {
        let (Some(first), Some(last)) = (run.first(), run.last()) else {
            continue;
        };
        let angles = match run.len() {
            1 => format!("  {}°", angle(first.0)),
            _ => format!("  {}° to {}°", angle(first.0), angle(last.0)),
        };
        page.prose(
            &column(&angles, 20, PLAIN),
            &[Run::words(first.1.clone(), PLAIN)],
        );
    }
    page.finish()
}

fn at_angle(speeds: &Speeds, highest: f64) -> String {
    let parts = [
        (Stability::Unstable, "gallops"),
        (Stability::Divergent, "diverges"),
        (Stability::Undecided, "not decided"),
    ];
    let mut words: Vec<String> = parts
        .into_iter()
        .filter(|(stability, _)| speeds.ranges.iter().any(|own| own.stability == *stability))
        .map(|(stability, word)| format!("{word} {}", listed(speeds, stability, highest)))
        .collect();
    if words.is_empty() {
        words.push("stable at every speed".into());
    }
    if speeds.is_neutral {
        words.push("a motion neither grows nor dies out, exactly".into());
    }
    words.join("; ")
}
