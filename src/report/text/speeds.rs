//! The critical wind speeds of a case, for a terminal.

use crate::report::speeds::{SpeedsFound, conclusion, lines};
use crate::report::stability::options;

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
        options(&found.case)
    );
    page.prose(&[], &[Run::words(title, STRONG)]);
    page.gap();
    page.prose(&[], &[Run::words(conclusion(found), PLAIN)]);
    page.heading("Wind speeds, by the angle");
    for (angles, words) in lines(found) {
        let angles = column(&format!("  {angles}"), 20, PLAIN);
        page.prose(&angles, &[Run::words(words, PLAIN)]);
    }
    page.finish()
}
