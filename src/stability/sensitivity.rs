//! What structural damping does to the critical mode.

use super::ball::Ball;
use super::coordinate::Coordinate;
use super::eigenvalue::{Eigenvalue, Spectrum};
use super::model::Model;

/// The free coordinates whose structural damping ratio ζ lowers S as it grows, for certain, with ∂S/∂ζ < 0.
///
/// With |B(λ)| = 0, B(λ) = λ²M + λC + K, aerodynamic stiffness being a part of K, and the damping 2mω_iζ_i of
/// coordinate i,
///
/// ```text
/// ∂λ/∂ζ_i = −2 ω_i λ adj(B)_ii/(d|B|/dλ)      ∂S/∂ζ_i = −4m Re(∂λ/∂ζ_i)/(ρDU)
/// ```
///
/// for the eigenvalue λ with the largest real part; rθ stands for θ, and all is divided by m. None are
/// given where that eigenvalue is not the largest for certain, or not simple.
pub fn weakened_by(model: &Model, spectrum: &Spectrum) -> Vec<(Coordinate, f64)> {
    let section = model.section();
    let mut pairs: Vec<_> = spectrum.one_of_each_pair().collect();
    pairs.sort_by(|one, other| other.value.re.total_cmp(&one.value.re));
    let Some((critical, others)) = pairs.split_first() else {
        return Vec::new();
    };
    let may_reach = |other: &&Eigenvalue| other.value.re + other.error;
    let highest = others
        .iter()
        .map(may_reach)
        .fold(f64::NEG_INFINITY, f64::max);
    if critical.value.re - critical.error <= highest {
        return Vec::new();
    }
    let unit = model.frequency_unit;
    let lambda = Ball {
        centre: critical.value / unit,
        radius: critical.error / unit * (1.0 + 8.0 * f64::EPSILON),
    };
    let matrix = model
        .dynamic_stiffness(lambda)
        .map(|row| row.map(|entry| entry[0]));
    let slope = model.taylor(lambda)[1];
    let rates = model.structural_damping_rates();
    let weakened = |(place, &coordinate): (usize, &Coordinate)| {
        let (j, k) = ((place + 1) % 3, (place + 2) % 3);
        let minor = matrix[j][j] * matrix[k][k] + -(matrix[j][k] * matrix[k][j]);
        let rate = rates[place];
        // ∂λ/∂ζ times |d|B|/dλ|², which is above 0.
        let product = -(rate * lambda * minor * slope.conjugate());
        let is_growing = product.centre.re > product.radius && slope.smallest() > 0.0;
        let growth = product.centre.re / slope.centre.norm_sqr() * unit;
        let weakening = section.damping_coefficient(growth)?;
        is_growing.then_some((coordinate, weakening))
    };
    section
        .free()
        .iter()
        .enumerate()
        .filter_map(weakened)
        .collect()
}
