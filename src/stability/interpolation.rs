//! Coefficients between the angles of a table.

use std::fmt;

use serde::Deserialize;

use super::coefficient_table::{CoefficientTable, Row};
use super::section::Coefficients;
use super::spline::{CubicSpline, Ends, cell};

/// How a table is read between its angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight lines; the derivative is the slope of the cell, at an angle of the table that of the
    /// cell above it.
    Linear,
    /// A cubic spline, periodic where the table goes round the circle, not-a-knot elsewhere.
    Cubic,
}

/// An angle that a table does not reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideTable {
    /// The angle, in degrees.
    pub angle: f64,
    /// The first and the last angle of the table, in degrees.
    pub reach: [f64; 2],
}

impl fmt::Display for OutsideTable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, last] = self.reach;
        write!(
            formatter,
            "the angle {}° is outside of the table, which goes from {first}° to {last}°",
            self.angle
        )
    }
}

impl std::error::Error for OutsideTable {}

/// Curves of C_D, C_L and C_M through a table.
#[derive(Clone, Debug)]
pub struct CoefficientCurves {
    angles: Vec<f64>,
    is_circle: bool,
    /// C_D, C_L, C_M.
    curves: [Curve; 3],
}

#[derive(Clone, Debug)]
enum Curve {
    Lines(Vec<f64>),
    Spline(CubicSpline),
}

impl CoefficientCurves {
    /// Curves through a table: linear in its length.
    pub fn new(table: &CoefficientTable, interpolation: Interpolation) -> Self {
        let mut rows = table.rows().to_vec();
        // A table that stops one step short of the circle is closed with its first row.
        if table.is_circle() && !table.is_closed() {
            let first = rows[0];
            rows.push(Row {
                angle: first.angle + 360.0,
                ..first
            });
        }
        let angles: Vec<f64> = rows.iter().map(|row| row.angle).collect();
        let ends = if table.is_circle() && !table.has_a_jump_at_its_end() {
            Ends::Periodic
        } else {
            Ends::NotAKnot
        };
        let columns: [fn(&Row) -> f64; 3] = [|row| row.drag, |row| row.lift, |row| row.moment];
        let curves = columns.map(|column| {
            let values: Vec<f64> = rows.iter().map(column).collect();
            match interpolation {
                Interpolation::Linear => Curve::Lines(values),
                Interpolation::Cubic => Curve::Spline(CubicSpline::new(&angles, &values, ends)),
            }
        });
        CoefficientCurves {
            angles,
            is_circle: table.is_circle(),
            curves,
        }
    }

    /// The coefficients at an angle in degrees, and their derivatives per radian; on the circle, at any
    /// angle.
    ///
    /// Logarithmic in the length of the table.
    ///
    /// # Errors
    ///
    /// If the table does not reach the angle.
    pub fn at(&self, angle: f64) -> Result<Coefficients, OutsideTable> {
        let reach = [self.angles[0], self.angles[self.angles.len() - 1]];
        let is_inside = (reach[0]..=reach[1]).contains(&angle);
        let place = if is_inside {
            angle
        } else if self.is_circle {
            reach[0] + (angle - reach[0]).rem_euclid(360.0)
        } else {
            return Err(OutsideTable { angle, reach });
        };
        let [drag, lift, moment] = [0, 1, 2].map(|curve: usize| match &self.curves[curve] {
            Curve::Spline(spline) => spline.at(place),
            Curve::Lines(values) => {
                let i = cell(&self.angles, place);
                let width = self.angles[i + 1] - self.angles[i];
                let slope = (values[i + 1] - values[i]) / width;
                (values[i] + slope * (place - self.angles[i]), slope)
            }
        });
        let per_radian = |slope: f64| slope.to_degrees();
        Ok(Coefficients {
            drag: drag.0,
            lift: lift.0,
            moment: moment.0,
            drag_slope: per_radian(drag.1),
            lift_slope: per_radian(lift.1),
            moment_slope: per_radian(moment.1),
        })
    }

    /// How many of these angles are corners of straight lines, where the slope jumps.
    pub fn corners(&self, angles: &[f64]) -> usize {
        if !matches!(self.curves[0], Curve::Lines(_)) {
            return 0;
        }
        let is_corner = |angle: &&f64| {
            let i = cell(&self.angles, **angle);
            self.angles[i..=i + 1]
                .iter()
                .any(|own| (own - **angle).abs() < 1e-9)
        };
        angles.iter().filter(is_corner).count()
    }
}
