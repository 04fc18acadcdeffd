//! Cubic splines: smooth curves through points, with their slopes.
//!
//! Written here because no maintained crate was found that closes a spline round the circle and gives its
//! slope as well.

/// What holds at the ends of a spline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The last point is the first one again: value, slope and curvature go round.
    Periodic,
    /// The first two pieces are one polynomial, and so are the last two.
    NotAKnot,
    /// The curvature is 0 there.
    Natural,
}

/// A curve of cubic pieces through points, twice continuously differentiable.
///
/// With h_i = x_{i+1} − x_i and δ_i = (y_{i+1} − y_i)/h_i, the slopes d_i at the points satisfy
///
/// ```text
/// h_i d_{i−1} + 2 (h_{i−1} + h_i) d_i + h_{i−1} d_{i+1} = 3 (h_i δ_{i−1} + h_{i−1} δ_i)
/// ```
///
/// ```
/// use sextic::stability::spline::{CubicSpline, Ends};
///
/// let x = [0.0, 1.0, 3.0, 4.0, 6.0];
/// let cube = x.map(|x: f64| x.powi(3));
/// let (value, slope) = CubicSpline::new(&x, &cube, Ends::NotAKnot).at(2.0);
/// assert!((value - 8.0).abs() < 1e-12 && (slope - 12.0).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline {
    x: Vec<f64>,
    y: Vec<f64>,
    slopes: Vec<f64>,
}

impl CubicSpline {
    /// The spline through points: at least 4, x increasing, as many y; for [`Ends::Periodic`] the last
    /// y is taken to be the first.
    ///
    /// Linear in the number of points.
    ///
    /// # Panics
    ///
    /// If there are fewer than 4 points, or as many y are not there.
    pub fn new(x: &[f64], y: &[f64], ends: Ends) -> Self {
        assert!(x.len() >= 4 && x.len() == y.len());
        let mut y = y.to_vec();
        if ends == Ends::Periodic {
            *y.last_mut().expect("at least 4") = y[0];
        }
        let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let delta: Vec<f64> = (0..h.len()).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
        let slopes = match ends {
            Ends::Periodic => periodic_slopes(&h, &delta),
            Ends::NotAKnot => not_a_knot_slopes(&h, &delta),
            Ends::Natural => natural_slopes(&h, &delta),
        };
        CubicSpline {
            x: x.to_vec(),
            y,
            slopes,
        }
    }

    /// Value and slope at a place; beyond the ends the first or last piece goes on.
    ///
    /// Logarithmic in the number of points.
    pub fn at(&self, place: f64) -> (f64, f64) {
        let i = cell(&self.x, place);
        let h = self.x[i + 1] - self.x[i];
        let t = (place - self.x[i]) / h;
        let delta = (self.y[i + 1] - self.y[i]) / h;
        let (left, right) = (self.slopes[i] - delta, self.slopes[i + 1] - delta);
        // The straight line, and what the slopes at its ends add.
        let value = self.y[i] + t * h * delta + t * (1.0 - t) * h * (left * (1.0 - t) - right * t);
        let slope = delta + left * (1.0 - t) * (1.0 - 3.0 * t) + right * t * (3.0 * t - 2.0);
        (value, slope)
    }

    /// The values at both ends of a cell, and the slopes there.
    pub(super) fn ends(&self, cell: usize) -> [f64; 4] {
        [
            self.y[cell],
            self.y[cell + 1],
            self.slopes[cell],
            self.slopes[cell + 1],
        ]
    }

    /// The largest second derivative in a cell, which is linear there.
    pub(super) fn largest_bend(&self, cell: usize) -> f64 {
        let h = self.x[cell + 1] - self.x[cell];
        let [from, to, rise, fall] = self.ends(cell);
        let delta = (to - from) / h;
        let (left, right) = (rise - delta, fall - delta);
        (2.0 * left + right).abs().max((left + 2.0 * right).abs()) * 2.0 / h
    }
}

/// The cell [x_i, x_{i+1}) of a place; the last one holds its upper end too.
pub(super) fn cell(x: &[f64], place: f64) -> usize {
    let above = x.partition_point(|&own| own <= place);
    above.saturating_sub(1).min(x.len() - 2)
}

/// A row of a tridiagonal system: what stands below, on and above the diagonal, and the right side.
type Row = [f64; 4];

/// The equation of an inner point between cells of widths h and slopes δ.
fn inner(h: [f64; 2], delta: [f64; 2]) -> Row {
    let right = 3.0 * (h[1] * delta[0] + h[0] * delta[1]);
    [h[1], 2.0 * (h[0] + h[1]), h[0], right]
}

fn natural_slopes(h: &[f64], delta: &[f64]) -> Vec<f64> {
    // 2 d_0 + d_1 = 3 δ_0
    let end = |delta: f64| [1.0, 2.0, 1.0, 3.0 * delta];
    let inner = (1..h.len()).map(|i| inner([h[i - 1], h[i]], [delta[i - 1], delta[i]]));
    let first = std::iter::once(end(delta[0]));
    let last = std::iter::once(end(delta[h.len() - 1]));
    tridiagonal(&first.chain(inner).chain(last).collect::<Vec<_>>())
}

fn not_a_knot_slopes(h: &[f64], delta: &[f64]) -> Vec<f64> {
    let n = h.len();
    // The third derivative does not jump at the second point.
    let end = |h: [f64; 2], delta: [f64; 2]| {
        let both = h[0] + h[1];
        let right = ((h[0] + 2.0 * both) * h[1] * delta[0] + h[0] * h[0] * delta[1]) / both;
        (h[1], both, right)
    };
    let (diagonal, beside, right) = end([h[0], h[1]], [delta[0], delta[1]]);
    let mut rows = vec![[0.0, diagonal, beside, right]];
    for i in 1..n {
        rows.push(inner([h[i - 1], h[i]], [delta[i - 1], delta[i]]));
    }
    let (diagonal, beside, right) = end([h[n - 1], h[n - 2]], [delta[n - 1], delta[n - 2]]);
    rows.push([beside, diagonal, 0.0, right]);
    tridiagonal(&rows)
}

/// By the formula of Sherman and Morrison: the corners are a product of a column with a row.
fn periodic_slopes(h: &[f64], delta: &[f64]) -> Vec<f64> {
    let n = h.len();
    let before = |i: usize| (i + n - 1) % n;
    let mut rows: Vec<Row> = (0..n)
        .map(|i| inner([h[before(i)], h[i]], [delta[before(i)], delta[i]]))
        .collect();
    let (first, last) = (rows[0][0], rows[n - 1][2]);
    let gamma = -rows[0][1];
    rows[0][1] -= gamma;
    rows[n - 1][1] -= first * last / gamma;
    let straight = tridiagonal(&rows);
    for (i, row) in rows.iter_mut().enumerate() {
        row[3] = if i == 0 {
            gamma
        } else if i == n - 1 {
            last
        } else {
            0.0
        };
    }
    let correction = tridiagonal(&rows);
    let along = |values: &[f64]| values[0] + first / gamma * values[n - 1];
    let factor = along(&straight) / (1.0 + along(&correction));
    let mut slopes: Vec<f64> = straight
        .iter()
        .zip(&correction)
        .map(|(own, other)| own - factor * other)
        .collect();
    slopes.push(slopes[0]);
    slopes
}

/// Gauss without pivots: these systems are diagonally dominant, or become so after their first row.
fn tridiagonal(rows: &[Row]) -> Vec<f64> {
    let n = rows.len();
    let (mut above, mut right) = (vec![0.0; n], vec![0.0; n]);
    for (i, [below, diagonal, beside, value]) in rows.iter().copied().enumerate() {
        let (pivot, rest) = match i {
            0 => (diagonal, value),
            _ => (
                diagonal - below * above[i - 1],
                value - below * right[i - 1],
            ),
        };
        above[i] = beside / pivot;
        right[i] = rest / pivot;
    }
    for i in (0..n - 1).rev() {
        right[i] -= above[i] * right[i + 1];
    }
    right
}
