//! Closed forms beside the eigenvalues of their systems, for a terminal.

use crate::compile::fixed::written;
use crate::report::closeness::FormCompared;
use crate::report::stability::significant;
use crate::report::words::counted;
use crate::stability::closeness::Point;

/// The shares of the points of which the error is told.
const SHARES: [(&str, f64); 4] = [
    ("half of the points", 0.5),
    ("9 of 10", 0.9),
    ("99 of 100", 0.99),
    ("all", 1.0),
];

/// Digits of errors.
const DIGITS: usize = 2;

/// A paragraph for each closed form.
pub fn closeness(forms: &[FormCompared]) -> String {
    let paragraphs: Vec<String> = forms.iter().map(form).collect();
    paragraphs.join("\n")
}

fn form(found: &FormCompared) -> String {
    let own = &found.closeness;
    let mut text = format!(
        "{}: {}`{}` beside the {} of `{}`\n",
        found.document,
        if found.by_roots { "the roots of " } else { "" },
        found.form,
        found.quantities(),
        found.system
    );
    text += &format!(
        "  {} of the domain: {}\n",
        counted(own.points, "point"),
        found.domain
    );
    let error = |(share, number): &(&str, f64)| {
        let bound = own.quantile(*number)?;
        Some(format!("{} at {share}", significant(bound, DIGITS)))
    };
    let errors: Vec<String> = SHARES.iter().filter_map(error).collect();
    text += &match errors.is_empty() {
        true => "  Nothing could be compared\n".to_string(),
        false => format!(
            "  Error over the largest of the {}: at most {}\n",
            found.quantities(),
            errors.join(", ")
        ),
    };
    text += &format!(
        "  Wrong about stability at {} of {}\n",
        own.wrong_signs,
        counted(own.decided, "point")
    );
    if own.overdamped > 0 {
        text += &format!(
            "  Left out: {} at which not all modes oscillate\n",
            counted(own.overdamped, "point")
        );
    }
    if own.without_value > 0 {
        text += &format!(
            "  Left out: {} without a value\n",
            counted(own.without_value, "point")
        );
    }
    for (what, point) in [
        ("Largest error", &own.worst),
        ("First wrong sign", &own.first_wrong),
    ] {
        if let Some(point) = point {
            text += &format!("  {what}: {}\n", shown(point));
        }
    }
    text
}

fn shown(point: &Point) -> String {
    let quantities = point.iter();
    let quantities = quantities.map(|(name, value)| format!("{name}={}", written(value)));
    quantities.collect::<Vec<_>>().join(" ")
}
