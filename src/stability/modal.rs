//! A section in the coordinates of its modes without wind.

use nalgebra::{Cholesky, Matrix3, SymmetricEigen};

use super::forces::Matrix;
use super::given::Given;

/// The most iterations of the decomposition.
const MOST_ITERATIONS: usize = 200;

/// The equations of motion q̈ + B q̇ + diagonal(ν_1², ν_2², ν_3²) q = 0 of a section with all coordinates
/// free, with time in units of 1/unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Modal {
    /// A power of 2 near the largest natural frequency, in rad/s.
    pub unit: f64,
    /// ν_1 ≥ ν_2 ≥ ν_3, the frequencies without damping.
    pub frequencies: [f64; 3],
    /// ν_1 − ν_2 ≥ 0 and ν_3 − ν_2 ≤ 0.
    pub distances: [f64; 2],
    /// B, the structural and aerodynamic damping over the modal masses.
    pub damping: Matrix3<f64>,
}

impl Modal {
    /// With M = L Lᵀ and L⁻¹ (K − ω_0² M) L⁻ᵀ = Q diagonal(ν² − ω_0²) Qᵀ, B = Qᵀ L⁻¹ (C_s + C_a) L⁻ᵀ Q, for the
    /// median ω_0 of the natural frequencies: where they nearly coincide, their differences keep their digits.
    /// `None` if a coordinate is held, or if a decomposition fails.
    pub fn new(given: &Given<f64>) -> Option<Self> {
        if !given.parameters.free.are_all() {
            return None;
        }
        let unit = given.parameters.frequency_unit();
        let given = given.in_units_of(unit);
        let own = given.equations();
        let mass = matrix(&own.mass);
        let lower = Cholesky::new(mass)?.l();
        let by_mass = |matrix: Matrix3<f64>| {
            let rows = lower.solve_lower_triangular(&matrix)?;
            let columns = lower.solve_lower_triangular(&rows.transpose())?;
            Some(columns.transpose())
        };
        let natural = given.parameters.natural_frequencies;
        let reference = median(natural);
        let shifted = shifted_stiffness(natural, reference, &mass);
        let modes = SymmetricEigen::try_new(by_mass(shifted)?, f64::EPSILON, MOST_ITERATIONS)?;
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| modes.eigenvalues[b].total_cmp(&modes.eigenvalues[a]));
        let shapes = Matrix3::from_columns(&order.map(|place| modes.eigenvectors.column(place)));
        let above = order.map(|place| modes.eigenvalues[place]);
        let frequencies = above.map(|own| (reference * reference + own).sqrt());
        let distance = |one: usize| (above[one] - above[1]) / (frequencies[one] + frequencies[1]);
        let damping = matrix(&own.structural_damping) + matrix(&own.aerodynamic_damping);
        Some(Modal {
            unit,
            frequencies,
            distances: [distance(0), distance(2)],
            damping: shapes.transpose() * by_mass(damping)? * shapes,
        })
    }

    /// ν_2, B row by row, and the distances: what the uniform form is made of.
    pub fn entries(&self) -> [f64; 12] {
        let [_, nu_2, _] = self.frequencies;
        let [above, below] = self.distances;
        let own = |i, j| self.damping[(i, j)];
        let [[a, b, c], [d, e, f], [g, h, i]] = [0, 1, 2].map(|i| [0, 1, 2].map(|j| own(i, j)));
        [nu_2, a, b, c, d, e, f, g, h, i, above, below]
    }
}

fn matrix(rows: &Matrix<f64>) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

fn median([x, y, theta]: [f64; 3]) -> f64 {
    x.min(y).max(x.max(y).min(theta))
}

/// K − ω_0² M, where nearly equal frequencies lose no digits.
fn shifted_stiffness(natural: [f64; 3], reference: f64, mass: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| match i == j {
        true => (natural[i] - reference) * (natural[i] + reference),
        false => -reference * reference * mass[(i, j)],
    })
}
