//! Comparisons and grids as tables for spreadsheets and programs.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::stability::closed_form::Limitation;
use crate::stability::comparison::{Comparison, angle};
use crate::stability::grid::{Grid, GridPoint};
use crate::stability::system::critical::Ranges;
use crate::stability::system::sweep::{Sweep, SweepRow};
use crate::stability::validity::{Form, Validity};

use super::speeds::{SpeedsFound, ends};
use super::stability::{bound, certain, decimal};

/// A row an angle: S by every method, bounds of the errors, the verdict, the mode with the least damping, and S
/// and the frequency in Hz of every mode. An empty cell is a method that does not apply, or a mode that is not
/// there.
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
        "verdict",
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
        let optional = |cell: Option<String>| cell.unwrap_or_default();
        let mut cells = vec![
            angle(point.angle).to_string(),
            certain(point.exact),
            optional(point.companion.map(certain)),
            optional(point.closed.value.map(|closed| decimal(closed, 9))),
            optional(point.uniform.value.map(|uniform| decimal(uniform, 9))),
            bound(point.exact),
            optional(point.companion.map(bound)),
            point.verdict.name().to_string(),
            optional(critical.map(|mode| mode.label.to_string())),
            optional(critical.map(|mode| decimal(mode.frequency, 6))),
        ];
        for label in 1..=modes {
            let mode = point.mode(label);
            cells.push(optional(mode.map(|mode| certain(mode.damping))));
            cells.push(optional(mode.map(|mode| decimal(mode.frequency, 6))));
        }
        text += &(cells.join(",") + "\n");
    }
    text
}

/// A row a range of wind speeds: the angle, the ends in m/s, and the verdict that is certain between them.
pub fn speeds(found: &SpeedsFound) -> String {
    let mut text = "alpha_deg,from,to,verdict\n".to_string();
    for (place, speeds) in &found.angles {
        for own in &speeds.ranges {
            let [from, to] = ends(own, speeds, 9);
            let verdict = own.stability.name();
            text += &format!("{},{from},{to},{verdict}\n", angle(*place));
        }
    }
    text
}

/// A row for each place of a map: e, δ, and for each form its error, at how many angles its sign is wrong, and at
/// how many that is not known.
pub fn validity(validity: &Validity) -> String {
    let mut heading = vec!["eccentricity".to_string(), "delta".to_string()];
    for form in Form::ALL {
        heading.push(format!("error_{}", form.word()));
        heading.push(format!("wrong_signs_{}", form.word()));
        heading.push(format!("open_signs_{}", form.word()));
    }
    let mut text = heading.join(",") + "\n";
    let rows = validity.cells.chunks(validity.eccentricities.len());
    for (wind, cells) in validity.winds.iter().zip(rows) {
        for (eccentricity, cell) in validity.eccentricities.iter().zip(cells) {
            let mut row = vec![format!("{eccentricity:.6e}"), format!("{wind:.6e}")];
            for own in cell {
                row.push(format!("{:.2e}", own.error));
                row.push(own.wrong_signs.to_string());
                row.push(own.open_signs.to_string());
            }
            text += &(row.join(",") + "\n");
        }
    }
    text
}

/// The heading of the rows of a grid, with the end of the line: its quantities, S by the methods that are
/// asked, bounds of their errors, the frequency and the coordinate that moves most in the mode with the
/// least damping, and what speaks against the closed and the uniform form.
pub fn grid_heading(grid: &Grid) -> String {
    let methods = grid.methods();
    let optional = [
        (methods.exact, "s3d_exact"),
        (methods.companion, "s3d_companion"),
        (methods.closed, "s3d_closed"),
        (methods.uniform, "s3d_uniform"),
        (methods.exact, "error_exact"),
        (methods.companion, "error_companion"),
        (methods.exact, "frequency_hz"),
        (methods.exact, "mostly"),
        (methods.closed, "closed_limits"),
        (methods.uniform, "uniform_limits"),
    ];
    let asked = optional.iter().filter(|(is_asked, _)| *is_asked);
    let variables = grid.variables().map(|variable| variable.name);
    let names: Vec<&str> = variables.chain(asked.map(|(_, name)| *name)).collect();
    names.join(",") + "\n"
}

/// A row of a grid, with the end of the line: an empty cell is a method that does not apply, or has no
/// answer.
///
/// S has the decimals that are certain, nine at most.
pub fn grid_row(grid: &Grid, point: &GridPoint) -> String {
    let methods = grid.methods();
    let mut row = String::with_capacity(96);
    // Writing to a string cannot fail.
    if let Some((degrees, others)) = point.values.split_last() {
        for value in others {
            let _ = write!(row, "{value},");
        }
        // No angle is the worst where no method has an answer.
        let _ = match degrees.is_nan() {
            true => write!(row, ","),
            false => write!(row, "{},", angle(*degrees)),
        };
    }
    let mut cell = |is_asked: bool, text: Option<String>| {
        if is_asked {
            row += &text.unwrap_or_default();
            row.push(',');
        }
    };
    cell(methods.exact, point.exact.map(certain));
    cell(methods.companion, point.companion.map(certain));
    cell(
        methods.closed,
        point.closed.value.map(|closed| decimal(closed, 9)),
    );
    cell(
        methods.uniform,
        point.uniform.value.map(|uniform| decimal(uniform, 9)),
    );
    cell(methods.exact, point.exact.map(bound));
    cell(methods.companion, point.companion.map(bound));
    let (frequency, mostly) = point.critical.unzip();
    cell(
        methods.exact,
        frequency.map(|frequency| decimal(frequency, 6)),
    );
    cell(
        methods.exact,
        mostly.map(|mostly| mostly.name().to_string()),
    );
    let words = |limits: &[Limitation]| -> Option<String> {
        let names: Vec<&str> = limits.iter().map(Limitation::name).collect();
        Some(names.join(" "))
    };
    cell(methods.closed, words(&point.closed.limitations));
    cell(methods.uniform, words(&point.uniform.limitations));
    row.pop();
    row.push('\n');
    row
}

/// The heading of the rows of a sweep of a system, with the end of the line.
pub fn system_heading(sweep: &Sweep<'_>) -> String {
    let names = sweep.axes().iter().map(|axis| axis.name.as_str());
    let names: Vec<&str> = names.chain(SYSTEM_COLUMNS).collect();
    names.join(",") + "\n"
}

/// What is known of a system at a point: the largest real part and its error in 1/s, the frequency of that
/// mode in Hz, and whether the system is stable.
const SYSTEM_COLUMNS: [&str; 4] = ["growth", "error", "frequency_hz", "verdict"];

/// A row of a sweep of a system, with the end of the line, in full precision: cells are empty where the system
/// has no numbers, and the verdict where the errors do not decide it.
pub fn system_row(values: &[f64], row: &SweepRow) -> String {
    let number = |value: &f64| format!("{value:?}");
    let mut cells: Vec<String> = values.iter().map(number).collect();
    match &row.growth {
        Ok(own) => {
            let numbers = [own.value.re, own.error, own.value.im / TAU];
            cells.extend(numbers.iter().map(number));
        }
        Err(_) => cells.extend([const { String::new() }; 3]),
    }
    let verdict = row.verdict.map(|own| own.name().to_string());
    cells.push(verdict.unwrap_or_default());
    cells.join(",") + "\n"
}

/// A row a range of a quantity of a system: its ends, and the verdict that is certain between them.
pub fn ranges(ranges: &Ranges) -> String {
    let rows = ranges.ranges.iter().map(|own| {
        let (from, to, verdict) = (own.from, own.to, own.stability.name());
        format!("{from:?},{to:?},{verdict}\n")
    });
    ["from,to,verdict\n".to_string()]
        .into_iter()
        .chain(rows)
        .collect()
}
