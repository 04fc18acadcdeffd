//! A comparison as a table for spreadsheets and programs.

use crate::stability::comparison::{Comparison, Value};

use super::stability::{angle, certain, decimal};

/// A row an angle: S by every method, bounds of the errors, the mode with the least damping, and S and the
/// frequency in Hz of every mode. An empty cell is a method that does not apply.
///
/// Numbers have the decimals that are certain, nine at most.
pub fn comparison(comparison: &Comparison) -> String {
    let modes = comparison.mode_count();
    let mut heading: Vec<String> = [
        "alpha_deg",
        "s3d_exact",
        "s3d_companion",
        "s3d_closed",
        "s3d_uniform",
        "error_exact",
        "error_companion",
        "mode",
        "frequency_hz",
    ]
    .map(String::from)
    .to_vec();
    for label in 1..=modes {
        heading.push(format!("s_mode_{label}"));
        heading.push(format!("frequency_hz_mode_{label}"));
    }
    let mut text = heading.join(",") + "\n";
    for point in &comparison.points {
        let critical = point.critical();
        let error = |value: Value| format!("{:.0e}", value.error);
        let optional = |cell: Option<String>| cell.unwrap_or_default();
        let mut cells = vec![
            angle(point.angle).to_string(),
            certain(point.exact),
            optional(point.companion.map(certain)),
            optional(point.closed.map(|closed| decimal(closed, 9))),
            // The form that holds at every eccentricity is not built yet.
            String::new(),
            error(point.exact),
            optional(point.companion.map(error)),
            optional(critical.map(|mode| mode.label.to_string())),
            optional(critical.map(|mode| decimal(mode.frequency, 6))),
        ];
        for label in 1..=modes {
            let mode = point.modes.iter().find(|mode| mode.label == label);
            cells.push(optional(mode.map(|mode| certain(mode.damping))));
            cells.push(optional(mode.map(|mode| decimal(mode.frequency, 6))));
        }
        text += &(cells.join(",") + "\n");
    }
    text
}
