//! Comparisons and sweeps as tables for spreadsheets and programs.

use std::fmt::Write;

use crate::stability::comparison::{Comparison, angle};
use crate::stability::forces::Coefficients;
use crate::stability::system::critical::Ranges;
use crate::stability::validity::{Form, Validity};

use super::columns::{Cells, Column, Digits};
use super::speeds::{SpeedsFound, ends};
use super::stability::{bound, certain, decimal};

/// A row an angle: S by every method, bounds of the errors, the verdict, the mode with the least damping, and S
/// and the frequency in Hz of every mode. An empty cell is a method that does not apply, or a mode that is not
/// there.
///
/// Then the coefficients and their derivatives per radian, as the curves through the table have them.
///
/// Where the case has a mean twist: that in degrees, and what is known of its balance; where there is none, no other number.
/// Where the coefficients have errors: what is certain for all within them, and between which numbers S is then.
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
    heading.extend(
        Coefficients::<f64>::default()
            .named()
            .map(|(name, _)| name.to_string()),
    );
    let is_twisted = comparison.case.is_twisted();
    if is_twisted {
        heading.extend(["twist_deg", "balance"].map(String::from));
    }
    let errors = comparison.within.as_ref();
    let errors = errors.filter(|own| own.has_errors());
    if errors.is_some() {
        heading.extend(["within_errors", "s3d_least", "s3d_most"].map(String::from));
    }
    let mut text = heading.join(",") + "\n";
    let mut tolerances = errors.into_iter().flat_map(|own| &own.tolerances);
    for (at, point) in comparison.at_all_angles() {
        let Some(point) = point else {
            text += &(without_balance(at, &heading) + "\n");
            continue;
        };
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
        cells.extend(match &point.coefficients {
            Some(own) => own.named().map(|(_, value)| decimal(value, 9)),
            None => Default::default(),
        });
        if is_twisted {
            let twist = point.twist.as_ref();
            cells.push(optional(
                twist.map(|own| decimal(own.angle.to_degrees(), 9)),
            ));
            cells.push(optional(twist.map(|own| own.word().to_string())));
        }
        if let Some(own) = tolerances.next() {
            cells.push(own.certainty.name().to_string());
            // Rounded outwards.
            let end = |own: f64, round: fn(f64) -> f64| decimal(round(own * 1e6) / 1e6, 6);
            let ends = own
                .damping
                .map(|[least, most]| [end(least, f64::floor), end(most, f64::ceil)]);
            let ends = [0, 1].map(|place: usize| ends.as_ref().map(|own| own[place].clone()));
            cells.extend(ends.map(optional));
        }
        text += &(cells.join(",") + "\n");
    }
    text
}

/// The row of an angle without a certain mean twist: no other cell has a number.
fn without_balance(at: f64, heading: &[String]) -> String {
    let cell = |own: &String| match own.as_str() {
        "alpha_deg" => angle(at).to_string(),
        "balance" => "none".to_string(),
        _ => String::new(),
    };
    heading.iter().map(cell).collect::<Vec<_>>().join(",")
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

/// The heading of a table, with the end of the line.
pub fn heading(columns: &[Column]) -> String {
    let names: Vec<&str> = columns.iter().map(|own| own.name.as_str()).collect();
    names.join(",") + "\n"
}

/// The rows of a table, with the ends of their lines.
///
/// Numbers with bounds have the decimals that are certain, nine at most.
pub fn rows(columns: &[Column]) -> String {
    let count = columns.first().map_or(0, |own| own.cells.len());
    let mut text = String::with_capacity(16 * count * columns.len());
    for row in 0..count {
        for own in columns {
            write_cell(&mut text, &own.cells, row);
            text.push(',');
        }
        text.pop();
        text.push('\n');
    }
    text
}

/// Writes a cell; writing to a string cannot fail.
fn write_cell(text: &mut String, cells: &Cells, row: usize) {
    let _ = match cells {
        Cells::Numbers(numbers, _) if numbers[row].is_nan() => Ok(()),
        Cells::Numbers(numbers, Digits::All) => write!(text, "{}", numbers[row]),
        Cells::Numbers(numbers, Digits::Point) => write!(text, "{:?}", numbers[row]),
        Cells::Numbers(numbers, Digits::Decimals(decimals)) => {
            text.write_str(&decimal(numbers[row], i32::from(*decimals)))
        }
        Cells::Certain(values) => text.write_str(&values[row].map(certain).unwrap_or_default()),
        Cells::Bounds(values) => text.write_str(&values[row].map(bound).unwrap_or_default()),
        Cells::Words(words) => text.write_str(words[row]),
    };
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
