//! The cells between the angles of a table: whether they close round the circle, and which mean nothing.

use super::CoefficientTable;
use super::angle::{ONE_ANGLE, WHOLE};

/// A cell is a hole if it is wider than so many times both of its neighbours, or than a quarter of the circle.
const HOLE: f64 = 8.0;
const WIDEST: f64 = 90.0;

/// No cell up to this width, in degrees, is a hole.
const NO_HOLE: f64 = 3.0;

/// A cell is narrow if it is less than this share of both of its neighbours, or than this share of the median.
const NARROW: f64 = 0.05;
const NARROW_OF_ALL: f64 = 1e-3;

impl CoefficientTable {
    /// Whether the table goes round: over 360°, or one step short of it.
    pub fn is_circle(&self) -> bool {
        let [first, last] = self.outer_steps();
        360.0 - self.reach() <= first.max(last) * (1.0 + 1e-9)
    }

    /// Whether the last angle is the first one again.
    pub fn is_closed(&self) -> bool {
        (360.0 - self.reach()).abs() < WHOLE
    }

    /// How the table is read, in words: `91 rows from 0° to 90°, closed round the circle`.
    pub fn reading(&self) -> String {
        let holes = self.holes().len();
        let own = match &self.mirror {
            Some(mirror) => mirror.to_string(),
            None => {
                let [from, to] = self.ends();
                format!("{} rows from {from}° to {to}°", self.rows.len())
            }
        };
        let closed = match (self.is_closed(), self.is_circle()) {
            (true, _) => ", once round the circle",
            (false, true) => ", closed round the circle with the first row",
            _ => "",
        };
        let holes = match holes {
            0 => String::new(),
            1 => ", with a hole".to_string(),
            more => format!(", with {more} holes"),
        };
        format!("{own}{closed}{holes}")
    }

    /// The cells that are holes: an angle within is outside of the table. Cell i lies above row i; of a circle that
    /// is not closed the last one lies above the last row.
    pub fn holes(&self) -> Vec<usize> {
        self.cells(|width, beside, _| {
            let widest = beside.fold(0.0, f64::max);
            width > NO_HOLE && width > HOLE * widest || width > WIDEST
        })
    }

    /// The cells that are far narrower than others: a difference of two measurements says little of a slope there.
    pub(super) fn narrow_cells(&self) -> Vec<usize> {
        let (holes, count) = (self.holes(), self.widths().len());
        let is_hole = |place: usize| holes.binary_search(&(place % count)).is_ok();
        let mut narrow = self.cells(|width, beside, median| {
            let narrowest = beside.fold(f64::INFINITY, f64::min);
            width < NARROW * narrowest || width < NARROW_OF_ALL * median
        });
        // Beside a hole everything is narrow.
        narrow.retain(|&place| !is_hole(place + count - 1) && !is_hole(place + 1));
        narrow
    }

    /// The ends of a cell, each with its line and its angle.
    pub(super) fn cell(&self, place: usize) -> [(usize, f64); 2] {
        let row = |place: usize| {
            let row = &self.rows[place % self.rows.len()];
            (row.line, row.angle)
        };
        [row(place), row(place + 1)]
    }

    /// The first and the last angle.
    pub fn ends(&self) -> [f64; 2] {
        [&self.rows[0], &self.rows[self.rows.len() - 1]].map(|row| row.angle)
    }

    /// The widths of all cells, in degrees.
    pub(super) fn widths(&self) -> Vec<f64> {
        let pairs = self.rows.windows(2);
        let mut widths: Vec<f64> = pairs.map(|pair| pair[1].angle - pair[0].angle).collect();
        if self.is_circle() && !self.is_closed() {
            widths.push(360.0 - self.reach());
        }
        widths
    }

    /// The cells for whose width, the widths of their neighbours and the median of all something holds.
    fn cells(&self, holds: impl Fn(f64, std::vec::IntoIter<f64>, f64) -> bool) -> Vec<usize> {
        let (widths, is_circle) = (self.widths(), self.is_circle());
        let mut sorted = widths.clone();
        sorted.sort_by(f64::total_cmp);
        let median = sorted[sorted.len() / 2];
        let count = widths.len();
        let beside = |place: usize| {
            let before = (is_circle || place > 0).then(|| widths[(place + count - 1) % count]);
            let after = (is_circle || place + 1 < count).then(|| widths[(place + 1) % count]);
            before.into_iter().chain(after).collect::<Vec<f64>>()
        };
        let all = 0..count;
        all.filter(|&place| holds(widths[place], beside(place).into_iter(), median))
            .collect()
    }

    /// Reads ends that are one angle as one: that in their middle.
    pub(super) fn join_ends(&mut self) {
        let [first, last] = self.outer_steps();
        let apart = (360.0 - self.reach()).abs();
        if apart < WHOLE || apart >= ONE_ANGLE * first.min(last) {
            return;
        }
        let count = self.rows.len();
        let written = [self.rows[0].angle, self.rows[count - 1].angle];
        let middle = (written[0] + written[1] - 360.0) / 2.0;
        self.joined = Some(written);
        (self.rows[0].angle, self.rows[count - 1].angle) = (middle, middle + 360.0);
    }

    /// The widths of the first and the last cell between rows.
    fn outer_steps(&self) -> [f64; 2] {
        let count = self.rows.len();
        [1, count - 1].map(|place| self.rows[place].angle - self.rows[place - 1].angle)
    }

    pub(super) fn reach(&self) -> f64 {
        self.rows[self.rows.len() - 1].angle - self.rows[0].angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A table with these angles, of CL = the angle, CD = 1 and CM = 0.
    fn table(angles: &[f64]) -> CoefficientTable {
        let rows = angles.iter().map(|angle| format!("{angle},{angle},1,0\n"));
        let text = "alpha_deg,CL,CD,CM\n".to_string() + &rows.collect::<String>();
        CoefficientTable::read("table.csv", &text).expect("a table")
    }

    fn steps(from: f64, to: f64, step: f64) -> Vec<f64> {
        let count = ((to - from) / step).round() as usize;
        (0..=count)
            .map(|place| from + place as f64 * step)
            .collect()
    }

    #[test]
    fn a_circle_closes_with_steps_like_those_beside() {
        for (angles, is_circle, is_closed) in [
            (steps(0.0, 360.0, 10.0), true, true),
            (steps(-180.0, 180.0, 10.0), true, true),
            (steps(0.0, 350.0, 10.0), true, false),
            (steps(0.0, 345.0, 5.0), false, false),
            (steps(0.0, 180.0, 10.0), false, false),
            // A wide cell elsewhere closes nothing.
            (
                [steps(0.0, 90.0, 2.0), steps(200.0, 300.0, 2.0)].concat(),
                false,
                false,
            ),
            // Rounded ends, on both sides of the circle.
            (
                [vec![-179.9998], steps(-175.0, 175.0, 5.0), vec![179.9998]].concat(),
                true,
                true,
            ),
            (
                [vec![-180.0001], steps(-175.0, 175.0, 5.0), vec![180.0002]].concat(),
                true,
                true,
            ),
            // One step is left, wherever they begin.
            (steps(-178.75, 178.75, 2.5), true, false),
        ] {
            let table = table(&angles);
            assert_eq!(
                (table.is_circle(), table.is_closed()),
                (is_circle, is_closed),
                "{angles:?}"
            );
        }
        let joined = table(&[vec![-179.9998], steps(-175.0, 175.0, 5.0), vec![179.9998]].concat());
        assert_eq!(joined.ends(), [-180.0, 180.0]);
        assert_eq!(joined.joined, Some([-179.9998, 179.9998]));
        assert_eq!(
            joined.reading(),
            "73 rows from -180° to 180°, once round the circle"
        );
    }

    #[test]
    fn holes_and_narrow_cells_are_found_by_their_neighbours() {
        for (angles, holes, narrow) in [
            (steps(0.0, 360.0, 10.0), vec![], vec![]),
            // A table that is finer in the middle.
            (
                [
                    steps(-30.0, -5.0, 5.0),
                    steps(-4.5, 5.0, 0.5),
                    steps(10.0, 40.0, 5.0),
                ]
                .concat(),
                vec![],
                vec![],
            ),
            (
                [steps(0.0, 90.0, 2.0), steps(270.0, 358.0, 2.0)].concat(),
                vec![45],
                vec![],
            ),
            (
                [steps(0.0, 90.0, 2.0), steps(110.0, 180.0, 2.0)].concat(),
                vec![45],
                vec![],
            ),
            // What stands alone between two holes is no narrow cell.
            (
                [
                    steps(0.0, 60.0, 2.0),
                    vec![120.0, 122.0],
                    steps(180.0, 330.0, 2.0),
                ]
                .concat(),
                vec![30, 32],
                vec![],
            ),
            // At an end there is one neighbour; across the end of a circle there are two.
            (
                [steps(0.0, 20.0, 1.0), vec![45.0]].concat(),
                vec![20],
                vec![],
            ),
            (
                [vec![0.0], steps(60.0, 360.0, 3.0)].concat(),
                vec![0],
                vec![],
            ),
            (steps(0.0, 360.0, 120.0), vec![0, 1, 2], vec![]),
            (vec![0.0, 0.01, 0.02, 0.03, 1.0], vec![], vec![]),
            (
                [steps(0.0, 10.0, 1.0), vec![10.01], steps(11.0, 20.0, 1.0)].concat(),
                vec![],
                vec![10],
            ),
            // Narrow cells beside each other, across the end of a circle.
            (
                [
                    vec![-180.0, -179.9999],
                    steps(-175.0, 175.0, 5.0),
                    vec![179.9999, 180.0],
                ]
                .concat(),
                vec![],
                vec![0, 73],
            ),
            // Not so narrow that its ends are one angle.
            (
                [vec![-179.95], steps(-175.0, 175.0, 5.0), vec![179.95]].concat(),
                vec![],
                vec![72],
            ),
        ] {
            let table = table(&angles);
            assert_eq!(
                (table.holes(), table.narrow_cells()),
                (holes, narrow),
                "{angles:?}"
            );
        }
    }
}
