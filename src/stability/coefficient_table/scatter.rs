//! How much the numbers of a table scatter.

use std::f64::consts::SQRT_2;

use super::{CoefficientTable, Row};

/// Scatter below this share of what a coefficient varies by is that of its rounding.
const NOTABLE: f64 = 1e-3;

/// Differences of neighbouring rows of what scatters have this correlation at most; those of a curve are above 0, and
/// those of independent errors −0.8.
const MOST_CORRELATED: f64 = -0.3;

/// The median of absolute values of normal errors, as a share of their standard deviation.
const MEDIAN: f64 = 0.674_489_750_196_081_7;

/// Fewer differences show nothing.
const FEWEST: usize = 12;

/// The standard deviations of what scatters about smooth curves of C_D, C_L and C_M: 0 where it is not told from
/// rounding, or from a curve that bends.
///
/// Fourth divided differences leave nothing of a cubic; over the root of the sum of the squares of their weights they
/// are as large as independent errors. Their median is taken, which a spike does not move, and they must change
/// their sign from row to row as differences of errors do.
///
/// Linear in the number of rows, but for sorting.
pub fn scatter(table: &CoefficientTable) -> [f64; 3] {
    let columns: [fn(&Row) -> f64; 3] = [|row| row.drag, |row| row.lift, |row| row.moment];
    columns.map(|column| {
        let differences: Vec<f64> = table
            .rows()
            .windows(5)
            .map(|rows| difference(rows, column))
            .collect();
        let deviation = median(&differences) / MEDIAN;
        let is_notable = deviation > NOTABLE * table.span(column);
        match is_notable && is_scattered(&differences) {
            true => deviation,
            false => 0.0,
        }
    })
}

/// By how much the slopes between neighbouring rows scatter, per radian, where these do so by such standard deviations: in
/// the middle of all steps.
pub fn slopes(table: &CoefficientTable, deviations: [f64; 3]) -> [f64; 3] {
    let steps = table.rows().windows(2);
    let steps: Vec<f64> = steps.map(|pair| pair[1].angle - pair[0].angle).collect();
    let step = median(&steps).to_radians();
    deviations.map(|own| SQRT_2 * own / step)
}

/// The fourth divided difference of five rows, in units of an error of one of them.
fn difference(rows: &[Row], column: fn(&Row) -> f64) -> f64 {
    let weight = |own: &Row| -> f64 {
        let others = rows.iter().filter(|other| other.angle != own.angle);
        1.0 / others.map(|other| own.angle - other.angle).product::<f64>()
    };
    let weights: Vec<f64> = rows.iter().map(weight).collect();
    let size = weights.iter().map(|own| own * own).sum::<f64>().sqrt();
    let sum: f64 = rows
        .iter()
        .zip(&weights)
        .map(|(row, own)| column(row) * own)
        .sum();
    sum / size
}

fn median(differences: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = differences.iter().map(|own| own.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

/// Whether neighbouring differences are against each other.
fn is_scattered(differences: &[f64]) -> bool {
    if differences.len() < FEWEST {
        return false;
    }
    // Differences are cut at some medians, so that one spike decides nothing.
    let bound = 3.0 * median(differences);
    let kept = |own: f64| own.clamp(-bound, bound);
    let pairs = differences
        .windows(2)
        .map(|pair| kept(pair[0]) * kept(pair[1]));
    let squares = differences.iter().map(|own| kept(*own).powi(2));
    pairs.sum::<f64>() < MOST_CORRELATED * squares.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(step: f64, error: f64) -> CoefficientTable {
        let mut state = 7_u64;
        let mut noise = || {
            // The sum of twelve even numbers is nearly normal, with the standard deviation 1.
            let sum: f64 = (0..12)
                .map(|_| {
                    state = state
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1);
                    (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
                })
                .sum();
            error * sum
        };
        let rows = (0..=(360.0 / step) as usize).map(|row| {
            let angle = row as f64 * step;
            let wave = |times: f64| (times * angle).to_radians().sin();
            let own = [wave(1.0) + noise(), wave(2.0) + noise(), 0.1 * wave(3.0)];
            format!("{angle},{},{},{}", own[0], own[1], own[2])
        });
        let heading = std::iter::once("alpha_deg,CD,CL,CM".to_string());
        let text: Vec<String> = heading.chain(rows).collect();
        CoefficientTable::read("table.csv", &text.join("\n")).expect("a table")
    }

    #[test]
    fn the_standard_deviation_is_found() {
        for step in [1.0, 2.0, 5.0] {
            let [drag, lift, moment] = scatter(&table(step, 0.05));
            for own in [drag, lift] {
                assert!((own - 0.05).abs() < 0.02, "{step}°: {own}");
            }
            assert_eq!(moment, 0.0);
        }
    }

    #[test]
    fn a_curve_does_not_scatter() {
        for step in [0.5, 2.0, 5.0, 10.0, 15.0] {
            assert_eq!(scatter(&table(step, 0.0)), [0.0; 3], "{step}°");
        }
    }
}
