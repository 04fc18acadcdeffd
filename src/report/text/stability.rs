//! Where a section gallops, and how the methods agree, for a terminal.

use std::iter::once;

use anstyle::Style;

use crate::report::stability::{
    PROOF, WITHIN, agreement, conclusion, frequency, largest_error, mode, power, reasons, rounded,
    title, twists, within_errors,
};
use crate::stability::comparison::{Comparison, FollowedMode, Method, UnstableRange, angle};

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// As wide as the widest name of a method.
const METHODS: usize = 13;

/// As wide as `unstable for all` and the margin.
const CERTAINTIES: usize = 20;

/// On narrower pages a table has its cells in prose.
const TABLE: usize = 70;

/// A page: unstable ranges, agreement of the methods, remarks.
pub fn comparison(comparison: &Comparison, width: usize) -> String {
    let mut page = Page::new(width);
    page.prose(&[], &[Run::words(title(comparison), STRONG)]);
    page.prose(&[], &[Run::words(&comparison.reading, FAINT)]);
    unstable(&mut page, comparison);
    if let Some(words) = twists(comparison) {
        page.heading("Mean twist");
        page.prose(&[spaces(2)], &[Run::words(words, PLAIN)]);
    }
    within(&mut page, comparison);
    methods(&mut page, comparison);
    if !comparison.remarks.is_empty() {
        page.heading("Warnings");
        for remark in &comparison.remarks {
            page.prose(&[spaces(2)], &[Run::words(remark.to_string(), PLAIN)]);
        }
    }
    page.finish()
}

fn unstable(page: &mut Page, comparison: &Comparison) {
    let name = comparison.coefficient_name();
    page.gap();
    page.prose(&[], &[Run::words(conclusion(comparison), PLAIN)]);
    if !comparison.unstable.is_empty() {
        let step = comparison.case.angles.step;
        page.heading(&format!("Unstable ranges, in steps of {step}°"));
        let heading = ["angles", "worst at", name, "frequency", "mode"].map(str::to_string);
        let cells = |own: &UnstableRange| {
            let of_mode = |text: &dyn Fn(&FollowedMode) -> String| {
                own.mode.as_ref().map_or(String::new(), text)
            };
            [
                own.angles.to_string(),
                format!("{}°", angle(own.worst)),
                rounded(own.damping, 4),
                of_mode(&|mode| frequency(mode, own.diverges, &comparison.case)),
                of_mode(&mode),
            ]
        };
        let rows: Vec<[String; 5]> = comparison.unstable.iter().map(cells).collect();
        let all = || once(&heading).chain(&rows);
        let widths = LEAST.map(|(place, least)| {
            let widest = all().map(|row| row[place].chars().count()).max();
            least.max(widest.unwrap_or(0) + 2)
        });
        for (place, row) in all().enumerate() {
            let style = if place == 0 { FAINT } else { PLAIN };
            self::row(page, row, widths, style);
        }
    }
    page.hint(2, PROOF);
}

/// The columns before the last, and how wide they are at least.
const LEAST: [(usize, usize); 4] = [(0, 20), (1, 11), (2, 11), (3, 12)];

fn row(page: &mut Page, cells: &[String; 5], widths: [usize; 4], style: Style) {
    if page.width() < TABLE {
        return page.prose(&[spaces(2)], &[Run::words(cells.join(", "), style)]);
    }
    let [others @ .., mode] = cells;
    let columns = others.iter().zip(widths);
    let columns = columns.flat_map(|(cell, width)| column(cell, width, style));
    let prefix: Vec<Run> = once(spaces(2)).chain(columns).collect();
    page.prose(&prefix, &[Run::words(mode, style)]);
}

fn within(page: &mut Page, comparison: &Comparison) {
    let lines = within_errors(comparison);
    if lines.is_empty() {
        return;
    }
    page.heading("Within the errors of the coefficients");
    for (name, angles) in lines {
        let name = column(&format!("  {name}"), CERTAINTIES, FAINT);
        page.prose(&name, &[Run::words(angles, PLAIN)]);
    }
    page.hint(2, WITHIN);
}

fn methods(page: &mut Page, comparison: &Comparison) {
    page.heading("Methods");
    let mut line = |name: &str, text: String| {
        page.prose(
            &column(&format!("  {name}"), METHODS, FAINT),
            &[Run::words(text, PLAIN)],
        );
    };
    let name = comparison.coefficient_name();
    let error = power(largest_error(&comparison.points));
    line(
        "exact",
        format!("state matrix, Eq. (16); {name} is certain to {error}"),
    );
    for own in &comparison.agreements {
        let source = match own.method {
            Method::Companion => "Eq. (19)",
            Method::Closed => "Eqs. (21)–(23)",
            Method::Uniform => "derived in uniform.md",
        };
        let text = agreement(own, comparison.points.len());
        line(own.method.name(), format!("{source}: {text}"));
        for reason in reasons(own) {
            line("", format!("because {reason}"));
        }
    }
}
