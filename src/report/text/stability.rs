//! Where a section gallops, and how the methods agree, for a terminal.

use crate::report::stability::{
    agreement, conclusion, decimal, frequency, largest_error, mode, power, reasons, title,
};
use crate::stability::comparison::{Comparison, Method, angle};

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// As wide as the widest name of a method.
const METHODS: usize = 13;

/// On narrower pages a table has its cells in prose.
const TABLE: usize = 70;

/// A page: unstable ranges, agreement of the methods, remarks.
pub fn comparison(comparison: &Comparison, width: usize) -> String {
    let mut page = Page::new(width);
    page.prose(&[], &[Run::words(title(comparison), STRONG)]);
    unstable(&mut page, comparison);
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
        row(
            page,
            ["angles", "worst at", &name, "frequency", "mode"],
            true,
        );
        for own in &comparison.unstable {
            let mode_of = own.mode.as_ref();
            row(
                page,
                [
                    &own.angles.to_string(),
                    &format!("{}°", angle(own.worst)),
                    &decimal(own.damping.value, 4),
                    &mode_of.map_or(String::new(), frequency),
                    &mode_of.map_or(String::new(), mode),
                ],
                false,
            );
        }
    }
}

fn row(page: &mut Page, cells: [&str; 5], is_heading: bool) {
    let style = if is_heading { FAINT } else { PLAIN };
    if page.width() < TABLE {
        return page.prose(&[spaces(2)], &[Run::words(cells.join(", "), style)]);
    }
    let [angles, worst, damping, frequency, mode] = cells;
    let prefix = [
        column("", 2, style),
        column(angles, 20, style),
        column(worst, 11, style),
        column(damping, 11, style),
        column(frequency, 12, style),
    ];
    page.prose(&prefix.concat(), &[Run::words(mode, style)]);
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
