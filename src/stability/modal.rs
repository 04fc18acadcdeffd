//! A section in the coordinates of its modes without wind.

use nalgebra::{Cholesky, Matrix3, SymmetricEigen};

use super::model::Model;

/// The most iterations of the decomposition.
const MOST_ITERATIONS: usize = 200;

/// The equations of motion q̈ + B q̇ + diagonal(ν_1², ν_2², ν_3²) q = 0 of a section with all coordinates
/// free, in units of its model.
#[derive(Clone, Copy, Debug)]
pub(super) struct Modal {
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
    pub fn new(model: &Model) -> Option<Self> {
        if !model.section().parameters().free.are_all() {
            return None;
        }
        let lower = Cholesky::new(model.scaled_mass())?.l();
        let by_mass = |matrix: Matrix3<f64>| {
            let rows = lower.solve_lower_triangular(&matrix)?;
            let columns = lower.solve_lower_triangular(&rows.transpose())?;
            Some(columns.transpose())
        };
        let (reference, shifted) = model.shifted_stiffness();
        let modes = SymmetricEigen::try_new(by_mass(shifted)?, f64::EPSILON, MOST_ITERATIONS)?;
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| modes.eigenvalues[b].total_cmp(&modes.eigenvalues[a]));
        let shapes = Matrix3::from_columns(&order.map(|place| modes.eigenvectors.column(place)));
        let above = order.map(|place| modes.eigenvalues[place]);
        let frequencies = above.map(|own| (reference * reference + own).sqrt());
        let distance = |one: usize| (above[one] - above[1]) / (frequencies[one] + frequencies[1]);
        Some(Modal {
            frequencies,
            distances: [distance(0), distance(2)],
            damping: shapes.transpose() * by_mass(model.scaled_damping())? * shapes,
        })
    }
}
