//! Numbers of a table that fit those beside them badly.

use std::ops::RangeInclusive;

use super::column::Column;
use super::row::Row;

/// A number is odd if it is so many times farther off than the curve bends beside, and than it mostly bends.
const FAR: f64 = 6.0;

/// No number is odd that is off by less than this share of what its column varies by.
const LEAST: f64 = 0.05;

/// No coefficient is odd that is off by less.
const ALMOST_NOTHING: f64 = 1e-3;

/// What is less than this share of a coefficient is its rounding.
const ROUNDING: f64 = 1e-9;

/// A jump is larger than what seems to be one in the cells beside it, by this factor; a corner is not.
const SHARP: f64 = 1.5;

/// A place where a curve is odd.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Oddity {
    /// A row lies off the curve of the others, by so much.
    Spike { row: usize, off: f64 },
    /// The curve jumps from a row to the next, by so much.
    Jump { row: usize, by: f64 },
}

/// Angles and numbers of a column.
struct Curve {
    points: Vec<[f64; 2]>,
    /// How much the curve mostly bends.
    usual: f64,
    /// What is too little to be odd.
    least: f64,
}

/// Where a column is odd: spikes, and jumps. The three rows at either end are not looked at.
///
/// n log n in the number of rows.
pub(super) fn oddities(rows: &[Row], column: &Column) -> Vec<Oddity> {
    let curve = Curve::new(rows, column);
    let last = rows.len().saturating_sub(4);
    let spikes: Vec<Oddity> = (3..=last).filter_map(|row| curve.spike(row)).collect();
    let is_near = |place: usize| {
        let mut spikes = spikes.iter().map(Oddity::row);
        spikes.any(|own| own.abs_diff(place) <= 3)
    };
    let jumps = (3..last).filter_map(|row| curve.jump(row));
    let jumps: Vec<Oddity> = jumps.filter(|own| !is_near(own.row())).collect();
    [spikes, jumps].concat()
}

impl Oddity {
    /// The rows that it is about.
    pub fn rows(&self) -> RangeInclusive<usize> {
        match self {
            Oddity::Spike { row, .. } => *row..=*row,
            Oddity::Jump { row, .. } => *row..=*row + 1,
        }
    }

    /// The row, or the one before the jump.
    pub fn row(&self) -> usize {
        match self {
            Oddity::Spike { row, .. } | Oddity::Jump { row, .. } => *row,
        }
    }
}

impl Curve {
    fn new(rows: &[Row], column: &Column) -> Self {
        let points: Vec<[f64; 2]> = rows.iter().map(|row| [row.angle, column.of(row)]).collect();
        let mut bends: Vec<f64> = points.windows(3).map(bend).collect();
        bends.sort_by(f64::total_cmp);
        Curve {
            usual: bends.get(bends.len() / 2).copied().unwrap_or_default(),
            least: least(&points),
            points,
        }
    }

    /// A row against the cubic through the two rows on either side.
    fn spike(&self, row: usize) -> Option<Oddity> {
        let others = [-3, -2, -1, 1, 2, 3].map(|step| self.points[row.saturating_add_signed(step)]);
        let [angle, value] = self.points[row];
        let off = value - through(&others[1..5], angle);
        let widths = (angle - others[2][0]) * (others[3][0] - angle);
        let bent = others.windows(3).map(bend).fold(self.usual, f64::max) * widths;
        (off.abs() > self.least && off.abs() > FAR * bent).then_some(Oddity::Spike { row, off })
    }

    /// A cell against the straight lines on either side of it.
    fn jump(&self, row: usize) -> Option<Oddity> {
        let by = self.gap(row);
        let beside = self.gap(row - 1).abs().max(self.gap(row + 1).abs());
        let below = self.points[row - 3..=row].windows(3);
        let above = self.points[row + 1..].windows(3).take(2);
        let bends = below.chain(above).map(bend).fold(self.usual, f64::max);
        let [a, b, c, d] = [row - 1, row, row + 1, row + 2].map(|own| self.points[own][0]);
        let half = (c - b) / 2.0;
        let bent = bends * half * ((half + b - a) + (half + d - c));
        let least = self.least.max(FAR * bent).max(SHARP * beside);
        (by.abs() > least).then_some(Oddity::Jump { row, by })
    }

    /// What is between the lines on either side, in the middle of the cell above a row.
    fn gap(&self, row: usize) -> f64 {
        let middle = (self.points[row][0] + self.points[row + 1][0]) / 2.0;
        let line = |from: usize| through(&self.points[from..from + 2], middle);
        line(row + 1) - line(row - 1)
    }
}

/// How much three points bend: half of a second derivative.
fn bend(points: &[[f64; 2]]) -> f64 {
    let slope = |one: usize| {
        let [[from, low], [to, high]] = [points[one], points[one + 1]];
        (high - low) / (to - from)
    };
    ((slope(1) - slope(0)) / (points[2][0] - points[0][0])).abs()
}

/// The value at a place of the polynomial through points.
fn through(points: &[[f64; 2]], place: f64) -> f64 {
    let term = |(own, [x, y]): (usize, &[f64; 2])| {
        let others = points.iter().enumerate().filter(|(other, _)| *other != own);
        let shares = others.map(|(_, [other, _])| (place - other) / (x - other));
        y * shares.product::<f64>()
    };
    points.iter().enumerate().map(term).sum()
}

/// What is too little to be odd.
fn least(points: &[[f64; 2]]) -> f64 {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let [low, high] = points.iter().fold(ends, |[low, high], [_, own]| {
        [low.min(*own), high.max(*own)]
    });
    let rounding = ROUNDING * high.max(-low);
    (LEAST * (high - low)).max(ALMOST_NOTHING).max(rounding)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is odd about a lift at every third degree.
    fn found(lift: impl Fn(f64) -> f64) -> Vec<Oddity> {
        let row = |place: i32| Row {
            angle: 3.0 * f64::from(place),
            lift: lift(3.0 * f64::from(place)),
            drag: 1.0,
            moment: 0.0,
            errors: [0.0; 3],
            slopes: [None; 3],
            line: 0,
        };
        let rows: Vec<Row> = (0..=40).map(row).collect();
        oddities(&rows, &Column::LIFT)
    }

    #[test]
    fn spikes_and_jumps_are_told_from_corners_and_from_what_is_steep() {
        let smooth = |angle: f64| angle.to_radians().sin() - 0.9 * (3.0 * angle.to_radians()).sin();
        let is_none = |lift: &dyn Fn(f64) -> f64| assert_eq!(found(lift), []);
        is_none(&smooth);
        is_none(&|_| 1.0);
        // A corner, and a fall over three rows.
        is_none(&|angle| (angle - 60.0).abs());
        is_none(&|angle| (angle - 60.0).clamp(-3.0, 3.0));
        // What scatters all over.
        is_none(&|angle| smooth(angle) + 0.2 * (angle * angle).sin());
        let at = |lift: &dyn Fn(f64) -> f64| -> Vec<usize> {
            found(lift).iter().map(Oddity::row).collect()
        };
        assert_eq!(
            at(&|angle| smooth(angle) + if angle == 60.0 { 0.5 } else { 0.0 }),
            [20]
        );
        let jump = found(|angle| smooth(angle) + if angle > 60.0 { 0.6 } else { 0.0 });
        assert!(
            matches!(jump[..], [Oddity::Jump { row: 20, by }] if (by - 0.6).abs() < 0.1),
            "{jump:?}"
        );
    }
}
