//! What the methods say at points of a grid.

use crate::stability::closed_form::Estimate;
use crate::stability::comparison::Value;
use crate::stability::coordinate::Coordinate;
use crate::stability::limitation::Limits;
use crate::stability::mean_twist::Twist;

/// What the methods say at points of a grid: a column a method, empty unless it is asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GridRows {
    /// The values of each axis, in order; those of the angle, in degrees, last: NaN if none is the worst.
    pub values: Vec<Vec<f64>>,
    /// The mean twist, where the case asks for it; `None` where there is none that is certain.
    pub twists: Vec<Option<Twist>>,
    /// S by the exact eigenvalues; `None` where they have no bounded answer.
    pub exact: Vec<Option<Value>>,
    /// S by the companion matrix.
    pub companion: Vec<Option<Value>>,
    /// S by the closed forms (21)–(23).
    pub closed: Vec<Estimate<Limits>>,
    /// S by the uniform form.
    pub uniform: Vec<Estimate<Limits>>,
    /// The frequency in Hz of the mode with the least damping, and the coordinate that moves most in it: asked for
    /// with the exact eigenvalues.
    pub critical: Vec<Option<(f64, Coordinate)>>,
}

impl GridRows {
    /// Of so many rows after each other that with the smallest S; no angle where none has one.
    pub(super) fn worst_of_each(&self, angles: usize) -> Self {
        let mut sizes = self.leading();
        // An angle at which springs and wind have no balance is worse than any other.
        for (size, twist) in sizes.iter_mut().zip(&self.twists) {
            if twist.is_none() {
                *size = f64::NEG_INFINITY;
            }
        }
        let smaller = |one: usize, other: usize| match sizes[other] < sizes[one] {
            true => other,
            false => one,
        };
        let smallest = |first: usize| (first..first + angles).reduce(smaller).unwrap_or(first);
        let rows: Vec<usize> = (0..sizes.len()).step_by(angles).map(smallest).collect();
        let mut worst = self.only(&rows);
        for (place, row) in rows.iter().enumerate() {
            if sizes[*row] == f64::INFINITY {
                worst.forget_angle(place);
            }
        }
        worst
    }

    /// No angle is the worst in this row, and no mode.
    fn forget_angle(&mut self, row: usize) {
        if let Some(degrees) = self.values.last_mut() {
            degrees[row] = f64::NAN;
        }
        if let Some(critical) = self.critical.get_mut(row) {
            *critical = None;
        }
    }

    /// Some of the rows.
    fn only(&self, rows: &[usize]) -> Self {
        GridRows {
            values: self.values.iter().map(|own| only(own, rows)).collect(),
            twists: only(&self.twists, rows),
            exact: only(&self.exact, rows),
            companion: only(&self.companion, rows),
            closed: only(&self.closed, rows),
            uniform: only(&self.uniform, rows),
            critical: only(&self.critical, rows),
        }
    }

    /// S by the first method that is asked, of exact eigenvalues, companion matrix, uniform and closed forms;
    /// infinite where it has no answer.
    fn leading(&self) -> Vec<f64> {
        let values =
            |own: &[Option<Value>]| own.iter().map(|own| own.map(|own| own.value)).collect();
        let estimates = |own: &[Estimate<Limits>]| own.iter().map(|own| own.value).collect();
        let columns: [Vec<Option<f64>>; 4] = [
            values(&self.exact),
            values(&self.companion),
            estimates(&self.uniform),
            estimates(&self.closed),
        ];
        let asked = columns.into_iter().find(|own| !own.is_empty());
        let sizes = asked.into_iter().flatten();
        sizes.map(|own| own.unwrap_or(f64::INFINITY)).collect()
    }
}

/// Some entries of a column that may be empty.
fn only<T: Copy>(column: &[T], rows: &[usize]) -> Vec<T> {
    rows.iter()
        .filter_map(|row| column.get(*row).copied())
        .collect()
}
