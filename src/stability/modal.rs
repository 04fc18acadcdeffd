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
    /// B, the structural and aerodynamic damping over the modal masses.
    pub damping: Matrix3<f64>,
}

impl Modal {
    /// With M = L Lᵀ and L⁻¹ K L⁻ᵀ = Q diagonal(ν²) Qᵀ, B = Qᵀ L⁻¹ (C_s + C_a) L⁻ᵀ Q. `None` if a
    /// coordinate is held, or if a decomposition fails.
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
        let stiffness = by_mass(model.scaled_stiffness())?;
        let modes = SymmetricEigen::try_new(stiffness, f64::EPSILON, MOST_ITERATIONS)?;
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| modes.eigenvalues[b].total_cmp(&modes.eigenvalues[a]));
        let shapes = Matrix3::from_columns(&order.map(|place| modes.eigenvectors.column(place)));
        Some(Modal {
            frequencies: order.map(|place| modes.eigenvalues[place].sqrt()),
            damping: shapes.transpose() * by_mass(model.scaled_damping())? * shapes,
        })
    }
}
