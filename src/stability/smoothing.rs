//! Smoothing splines: curves that follow points no closer than their scatter allows.
//!
//! Written here because no maintained crate was found that chooses the smoothness of a periodic spline.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::spline::Ends;

/// The most points that are smoothed: the cost grows with their third power.
pub const MOST_POINTS: usize = 1_000;

/// How often the decomposition may step for each point.
const STEPS: usize = 100;

/// How many powers of ten of smoothness are looked at on either side of the middle, and how many in each.
const DECADES: usize = 12;
const IN_A_DECADE: usize = 8;

/// How often the ratio is taken from there on: to some millionths of a power of ten.
const SECTIONS: usize = 24;

/// What smooths values at the same places, as much as they scatter.
///
/// Among all curves f the one with the least Σ(y_i − f(x_i))² + λ∫f″² is a cubic spline (Reinsch 1967), whose values at
/// the points are (I + λK)⁻¹y with K = Q R⁻¹ Qᵀ: Qᵀ takes second differences, and R gives the integral of their products
/// (Green & Silverman, *Nonparametric Regression and Generalized Linear Models*, 1994, section 2.3). λ is chosen for
/// each column where the generalised cross-validation n|y − f|²/(n − tr)² is least (Craven & Wahba 1979), with the trace of
/// (I + λK)⁻¹.
///
/// ```
/// use sextic::stability::smoothing::Smoother;
/// use sextic::stability::spline::Ends;
///
/// let x: Vec<f64> = (0..40).map(f64::from).collect();
/// let line: Vec<f64> = x.iter().map(|own| 2.0 + 0.5 * own).collect();
/// let smoothed = Smoother::new(&x, Ends::Natural).unwrap().smoothed(&line);
/// assert!(smoothed.values.iter().zip(&line).all(|(own, other)| (own - other).abs() < 1e-9));
/// ```
#[derive(Clone, Debug)]
pub struct Smoother {
    /// The eigenvectors of K.
    vectors: DMatrix<f64>,
    /// Its eigenvalues, none below 0.
    roughness: DVector<f64>,
}

/// Values that are smoothed.
#[derive(Clone, Debug, PartialEq)]
pub struct Smoothed {
    /// The values of the curve at the points.
    pub values: Vec<f64>,
    /// The standard deviation of the scatter about it, √(|y − f|²/(n − tr)).
    pub scatter: f64,
    /// λ
    pub smoothness: f64,
}

impl Smoother {
    /// For points at these places, in increasing order: at least 4; with [`Ends::Periodic`] the last one is the first
    /// again, and counts once. `None` for fewer than 4 or more than [`MOST_POINTS`], or where no decomposition is found.
    ///
    /// n³ for n points.
    pub fn new(x: &[f64], ends: Ends) -> Option<Self> {
        let widths: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let is_periodic = ends == Ends::Periodic;
        let count = if is_periodic { widths.len() } else { x.len() };
        if x.len() < 4 || count > MOST_POINTS {
            return None;
        }
        let (differences, products) = bands(&widths, count, is_periodic);
        let solved = products.cholesky()?.solve(&differences.transpose());
        let penalty = differences * solved;
        let penalty = (&penalty + penalty.transpose()) / 2.0;
        let found = SymmetricEigen::try_new(penalty, f64::EPSILON, STEPS * count)?;
        Some(Smoother {
            vectors: found.eigenvectors,
            roughness: found.eigenvalues.map(|own| own.max(0.0)),
        })
    }

    /// The values smoothed by the λ of the least generalised cross-validation; for a periodic curve with or without the
    /// last value, which is the first again.
    ///
    /// n² for n values.
    ///
    /// # Panics
    ///
    /// If there are fewer values than points.
    pub fn smoothed(&self, y: &[f64]) -> Smoothed {
        let count = self.roughness.len();
        let parts = self
            .vectors
            .tr_mul(&DVector::from_column_slice(&y[..count]));
        let smoothness = self.best(&parts);
        let mut values = self.curve(&parts, smoothness);
        let [left, freedom] = self.left(&parts, smoothness);
        let scatter = match freedom > 0.0 {
            true => (left / freedom).sqrt(),
            false => 0.0,
        };
        values.resize(y.len(), values[0]);
        Smoothed {
            values,
            scatter,
            smoothness,
        }
    }

    /// What the values of the curve with one λ are of each of the given ones: a row for each point.
    pub fn weights(&self, smoothness: f64) -> Vec<Vec<f64>> {
        let count = self.roughness.len();
        let shares = self.roughness.map(|own| 1.0 / (1.0 + smoothness * own));
        let matrix = &self.vectors * DMatrix::from_diagonal(&shares) * self.vectors.transpose();
        (0..count)
            .map(|row| matrix.row(row).iter().copied().collect())
            .collect()
    }

    fn curve(&self, parts: &DVector<f64>, smoothness: f64) -> Vec<f64> {
        let kept = parts.zip_map(&self.roughness, |own, rough| {
            own / (1.0 + smoothness * rough)
        });
        (&self.vectors * kept).iter().copied().collect()
    }

    /// |y − f|² and n − tr.
    fn left(&self, parts: &DVector<f64>, smoothness: f64) -> [f64; 2] {
        let share = |rough: f64| smoothness * rough / (1.0 + smoothness * rough);
        let pairs = parts.iter().zip(self.roughness.iter());
        pairs.fold([0.0, 0.0], |[left, freedom], (own, rough)| {
            let share = share(*rough);
            [left + (share * own).powi(2), freedom + share]
        })
    }

    /// The λ of the least generalised cross-validation: the best of some powers of ten, the smoothest of equal ones, and from
    /// there by sections of the golden ratio.
    fn best(&self, parts: &DVector<f64>) -> f64 {
        let middle = self.middle();
        let of = |power: f64| middle * 10.0_f64.powf(power);
        let score = |power: f64| {
            let [left, freedom] = self.left(parts, of(power));
            left / (freedom * freedom)
        };
        let steps = (DECADES * IN_A_DECADE) as i32;
        let powers = (-steps..=steps).rev();
        let powers = powers.map(|step| f64::from(step) / IN_A_DECADE as f64);
        let better = |best: (f64, f64), own: (f64, f64)| if own.0 < best.0 { own } else { best };
        let scored = powers.map(|own| (score(own), own));
        let (_, best) = scored.fold((f64::INFINITY, 0.0), better);
        let step = 1.0 / IN_A_DECADE as f64;
        of(least(score, [best - step, best + step]))
    }

    /// A λ in the middle of those that matter: one over the geometric mean of the roughnesses above 0.
    fn middle(&self) -> f64 {
        let largest = self.roughness.iter().copied().fold(0.0, f64::max);
        let rough = self.roughness.iter().filter(|own| **own > largest * 1e-12);
        let logarithms: Vec<f64> = rough.map(|own| own.ln()).collect();
        (-logarithms.iter().sum::<f64>() / logarithms.len().max(1) as f64).exp()
    }
}

/// Where a function of one valley is least between two places.
fn least(function: impl Fn(f64) -> f64, [mut from, mut to]: [f64; 2]) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    for _ in 0..SECTIONS {
        let [low, high] = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
        match function(low) <= function(high) {
            true => to = high,
            false => from = low,
        }
    }
    0.5 * (from + to)
}

/// Q, n rows for the points, and R: a column for each second difference.
fn bands(widths: &[f64], count: usize, is_periodic: bool) -> (DMatrix<f64>, DMatrix<f64>) {
    let inner = if is_periodic { count } else { count - 2 };
    let mut differences = DMatrix::zeros(count, inner);
    let mut products = DMatrix::zeros(inner, inner);
    for column in 0..inner {
        // The widths below and above the point in the middle of the difference.
        let middle = if is_periodic { column } else { column + 1 };
        let below = (middle + widths.len() - 1) % widths.len();
        let (h, next) = (widths[below], widths[middle]);
        let points = [(middle + count - 1) % count, middle, (middle + 1) % count];
        for (point, weight) in points
            .into_iter()
            .zip([1.0 / h, -1.0 / h - 1.0 / next, 1.0 / next])
        {
            differences[(point, column)] += weight;
        }
        products[(column, column)] += (h + next) / 3.0;
        let above = (column + 1) % inner;
        if is_periodic || above != 0 {
            products[(column, above)] += next / 6.0;
            products[(above, column)] += next / 6.0;
        }
    }
    (differences, products)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::spline::CubicSpline;

    /// Numbers that look random, between −1 and 1.
    fn noise(count: usize) -> Vec<f64> {
        let mut state = 1_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        (0..count).map(|_| next()).collect()
    }

    #[test]
    fn a_noisy_wave_is_found_round_the_circle() {
        let x: Vec<f64> = (0..=180).map(|own| f64::from(own) * 2.0).collect();
        let truth = |own: f64| own.to_radians().sin() + 0.3 * (3.0 * own).to_radians().cos();
        let mut y: Vec<f64> = x
            .iter()
            .zip(noise(x.len()))
            .map(|(own, noise)| truth(*own) + 0.1 * noise)
            .collect();
        y[180] = y[0];
        let smoothed = Smoother::new(&x, Ends::Periodic).unwrap().smoothed(&y);
        // The standard deviation of numbers spread evenly between −0.1 and 0.1.
        let expected = 0.1 / 3.0_f64.sqrt();
        assert!(
            (smoothed.scatter - expected).abs() < 0.15 * expected,
            "{}",
            smoothed.scatter
        );
        let worst = |values: &[f64], ends| {
            let spline = CubicSpline::new(&x, values, ends);
            let slope = |own: f64| {
                let exact = own.to_radians().cos() - 0.9 * (3.0 * own).to_radians().sin();
                (spline.at(own).1.to_degrees() - exact).abs()
            };
            (0..720)
                .map(|own| slope(f64::from(own) / 2.0))
                .fold(0.0, f64::max)
        };
        let (before, after) = (
            worst(&y, Ends::Periodic),
            worst(&smoothed.values, Ends::Periodic),
        );
        assert!(
            after < before / 8.0,
            "slopes are wrong by {after}, and by {before} before"
        );
        assert_eq!(smoothed.values[0], smoothed.values[180]);
    }

    #[test]
    fn values_are_those_of_their_weights() {
        let x = [0.0, 1.0, 2.5, 3.0, 4.0, 6.0];
        let y = [1.0, 0.0, 2.0, 1.5, 3.0, 2.0];
        let smoother = Smoother::new(&x, Ends::Natural).unwrap();
        let smoothed = smoother.smoothed(&y);
        for (row, value) in smoother
            .weights(smoothed.smoothness)
            .iter()
            .zip(&smoothed.values)
        {
            let sum: f64 = row.iter().zip(&y).map(|(weight, own)| weight * own).sum();
            assert!((sum - value).abs() < 1e-12);
        }
    }

    /// The curve is the least of Σ(y − f)² + λ∫f″² among splines: no change of one value makes it less.
    #[test]
    fn no_other_spline_is_better() {
        let x = [0.0, 1.0, 2.5, 3.0, 4.0, 6.0, 6.5];
        let y = [1.0, 0.0, 2.0, 1.5, 3.0, 2.0, 2.5];
        let smoothed = Smoother::new(&x, Ends::Natural).unwrap().smoothed(&y);
        let cost = |values: &[f64]| {
            let spline = CubicSpline::new(&x, values, Ends::Natural);
            let curvature = |at: f64| (spline.at(at + 1e-4).1 - spline.at(at - 1e-4).1) / 2e-4;
            let steps = 6_500;
            let bent: f64 = (0..steps)
                .map(|step| curvature((f64::from(step) + 0.5) * 1e-3).powi(2) * 1e-3)
                .sum();
            let away: f64 = values
                .iter()
                .zip(&y)
                .map(|(own, other)| (own - other).powi(2))
                .sum();
            away + smoothed.smoothness * bent
        };
        let least = cost(&smoothed.values);
        for place in 0..x.len() {
            for change in [-1e-2, 1e-2] {
                let mut other = smoothed.values.clone();
                other[place] += change;
                assert!(cost(&other) > least, "{place}");
            }
        }
    }
}
