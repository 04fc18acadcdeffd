//! A row of a table.

use super::heading::{Columns, ERRORS, SLOPES};
use super::meaning::Unit;
use super::sheet::Separator;
use crate::stability::input::{InputError, Place, quoted};

/// A row of a table: C_D, C_L and C_M at an angle of attack in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// α, in degrees.
    pub angle: f64,
    /// C_D.
    pub drag: f64,
    /// C_L.
    pub lift: f64,
    /// C_M.
    pub moment: f64,
    /// C_D, C_L and C_M may be as far from these; 0 where nothing is said.
    pub errors: [f64; 3],
    /// The derivatives of C_D, C_L and C_M per radian that the table gives.
    pub slopes: [Option<f64>; 3],
    /// The line of the file, from 1.
    pub line: usize,
}

/// Larger numbers than any that mean something, and far from where products of them overflow.
const LARGEST: f64 = 1e30;

impl Row {
    /// Reads the cells of a line.
    pub(super) fn read(
        place: &Place,
        columns: &Columns,
        unit: Unit,
        cells: &[String],
        separator: Separator,
    ) -> Result<Self, InputError> {
        check_count(place, columns.count, cells.len(), separator)?;
        let number = |column: usize, name: &str| number(place, name, &cells[column]);
        let [angle, lift, drag, moment] = columns.places;
        let mut errors = [0.0; 3];
        for ((own, column), name) in errors.iter_mut().zip(columns.errors).zip(ERRORS) {
            if let Some(column) = column {
                *own = not_negative(place, name, number(column, name)?)?;
            }
        }
        let mut slopes = [None; 3];
        for ((own, column), name) in slopes.iter_mut().zip(columns.slopes).zip(SLOPES) {
            if let Some((column, unit)) = column {
                let unit = unit.unwrap_or(Unit::Radians);
                *own = Some(unit.slope(number(column, name)?));
            }
        }
        Ok(Row {
            angle: unit.degrees(number(angle, "alpha_deg")?),
            lift: number(lift, "CL")?,
            drag: number(drag, "CD")?,
            moment: number(moment, "CM")?,
            errors,
            slopes,
            line: place.line.unwrap_or_default(),
        })
    }

    /// The row once more beyond an axis of symmetry: drag is even about it, lift and moment are odd.
    pub(super) fn mirrored(&self, axis: f64) -> Self {
        let [drag, lift, moment] = self.slopes;
        Row {
            angle: 2.0 * axis - self.angle,
            lift: -self.lift,
            moment: -self.moment,
            slopes: [drag.map(|own| -own), lift, moment],
            ..*self
        }
    }
}

/// Refuses a line with more or fewer cells than columns.
fn check_count(
    place: &Place,
    columns: usize,
    cells: usize,
    separator: Separator,
) -> Result<(), InputError> {
    if cells == columns {
        return Ok(());
    }
    let what = format!("{cells} cells below {columns} columns");
    let help = if separator == Separator::Comma && cells > columns {
        "if the comma is a decimal comma, write decimal points, or separate the columns with semicolons"
    } else {
        "each row has a number for each column"
    };
    Err(InputError::new(place.clone(), what, help))
}

fn not_negative(place: &Place, name: &str, error: f64) -> Result<f64, InputError> {
    if error >= 0.0 {
        return Ok(error);
    }
    let what = format!("{name} is {error}, below 0");
    let help = "an error is how far a coefficient may be off, to both sides";
    Err(InputError::new(place.clone(), what, help))
}

/// A cell as a number; a comma in it is a decimal comma, since it separates no columns.
fn number(place: &Place, column: &str, cell: &str) -> Result<f64, InputError> {
    let wrong = |help: &str| {
        let what = format!("`{}` in the column {column} is no number", quoted(cell));
        InputError::new(place.clone(), what, help)
    };
    // Signs that typesetting programs write, and a unit that the heading says.
    let cell = cell.replace(['−', '–'], "-");
    let cell = cell.trim_end_matches('°').trim();
    let has_comma = cell.contains(',');
    if has_comma && (cell.contains('.') || cell.matches(',').count() > 1) {
        return Err(wrong(
            "it may have a decimal point or a decimal comma, and nothing between thousands",
        ));
    }
    let text = if has_comma {
        cell.replace(',', ".")
    } else {
        cell.to_string()
    };
    match text.parse::<f64>() {
        Ok(number) if number.abs() <= LARGEST => Ok(number),
        Ok(number) if number.is_finite() => {
            let cell = quoted(cell);
            let what = format!("{cell} in the column {column} is too large to be computed with");
            let help = "coefficients are dimensionless, angles in degrees";
            Err(InputError::new(place.clone(), what, help))
        }
        Ok(_) => Err(wrong("give a finite number, or leave the row out")),
        Err(_) if cell.is_empty() => Err(wrong(
            "the cell is empty: give a number, or leave the row out",
        )),
        Err(_) => Err(wrong(
            "give a number such as -0.25 or 2.5e-1, without a unit",
        )),
    }
}
