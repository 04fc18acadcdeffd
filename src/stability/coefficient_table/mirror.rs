//! Half a table, continued by symmetry: drag is even about 0° and 180°, lift and moment are odd.

use std::fmt;

use super::angle::{ONE_ANGLE, WHOLE};
use super::row::Row;
use crate::stability::input::{InputError, Place, Remark};

/// How a table was continued.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mirror {
    /// The rows that were there.
    rows: usize,
    /// Their first and last angle.
    ends: [f64; 2],
    /// The angle about which they were mirrored.
    axis: f64,
}

impl fmt::Display for Mirror {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Mirror { rows, ends, axis } = self;
        let [from, to] = ends;
        write!(
            formatter,
            "{rows} rows from {from}° to {to}°, continued by symmetry about {axis}°"
        )
    }
}

impl Mirror {
    /// The mirror of rows that end at an axis, 0° or 180°.
    ///
    /// # Errors
    ///
    /// If they end at neither, or go on beyond one.
    pub fn of(file: &str, rows: &[Row]) -> Result<Self, InputError> {
        let ends = [rows[0], rows[rows.len() - 1]].map(|row| row.angle);
        let [from, to] = ends;
        let wrong = |what: &str, help: &str| {
            let what = format!("the table goes from {from}° to {to}° and {what}");
            Err(InputError::new(Place::file(file), what, help))
        };
        let between = nearest_axis((from + to) / 2.0);
        if from < between && between < to {
            return wrong(
                "is to be mirrored, but has angles on both sides of an axis, 0° or 180°",
                "leave `mirror = true` out of the case, or keep one half of the table",
            );
        }
        let axes = ends.into_iter().filter(|own| nearest_axis(*own) == *own);
        let nearest = axes.min_by(|one, other| one.abs().total_cmp(&other.abs()));
        let Some(axis) = nearest else {
            return wrong(
                "is to be mirrored, but neither begins nor ends at an axis, 0° or 180°",
                "add the row of the axis, or leave `mirror = true` out of the case",
            );
        };
        let rows = rows.len();
        Ok(Mirror { rows, ends, axis })
    }

    /// Whether a row is one of those that were there.
    pub fn holds(&self, row: &Row) -> bool {
        let [from, to] = self.ends;
        from <= row.angle && row.angle <= to
    }

    /// Adds the images of rows.
    pub fn add_images(&self, rows: &mut Vec<Row>) {
        let is_other = |row: &&Row| (row.angle - self.axis).abs() > WHOLE;
        let images: Vec<Row> = rows
            .iter()
            .filter(is_other)
            .map(|row| row.mirrored(self.axis))
            .collect();
        rows.extend(images);
        rows.sort_by(|one, other| one.angle.total_cmp(&other.angle));
    }
}

/// Puts ends that only rounding keeps from an axis there, as angles in radians, and says so.
pub(super) fn put_ends_on_axes(file: &str, rows: &mut [Row]) -> Vec<Remark> {
    let last = rows.len() - 1;
    let ends = [(0, 1), (last, last - 1)];
    let moved = ends.map(|(place, beside)| put_on_axis(file, rows, place, beside));
    moved.into_iter().flatten().collect()
}

fn put_on_axis(file: &str, rows: &mut [Row], place: usize, beside: usize) -> Option<Remark> {
    let Row { angle, line, .. } = rows[place];
    let axis = nearest_axis(angle);
    let apart = (angle - axis).abs();
    if apart >= ONE_ANGLE * (angle - rows[beside].angle).abs() {
        return None;
    }
    rows[place].angle = axis;
    (apart > WHOLE).then(|| Remark {
        place: Place::line(file, line),
        what: format!("{angle}° is read as {axis}°, about which the table is mirrored"),
    })
}

/// The multiple of 180° nearest to an angle.
fn nearest_axis(angle: f64) -> f64 {
    // Not -0.
    (angle / 180.0).round() * 180.0 + 0.0
}
