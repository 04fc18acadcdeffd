//! A closed form for every eccentricity: the three modes together.

use nalgebra::Matrix3;
use num_complex::Complex;
use sextic_evaluators::uniform_cubic::{UniformCubicInputs, uniform_cubic};

use super::closed_form::ClosedForm;
use super::cubic;
use super::limitation::{Limitation, STRONG};
use super::modal::Modal;
use super::model::Model;

/// How much of the damping a uniform form keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Its first power.
    First,
    /// Its first and second power.
    Second,
}

/// The uniform form of the second order, which is meant where no order is named.
///
/// # Errors
///
/// As [`uniform_form_of`].
pub fn uniform_form(model: &Model) -> Result<ClosedForm, Limitation> {
    uniform_form_of(Order::Second, model)
}

/// A uniform form: λ_k = i ν_2 + μ_k with the roots μ_k of the cubic |μI − (A − i ν_2 I)|, where
///
/// ```text
/// A_1 = iW − B/2,   A_2 = A_1 − (i/4) B·G,   W = diagonal(ν_1, ν_2, ν_3),   G_jk = B_jk/(ν_j + ν_k)
/// ```
///
/// with the frequencies ν_k without wind in rad/s and the damping matrix B in 1/s in the coordinates of
/// the modes without wind (`derivations/uniform.md`). Frequencies may coincide or differ, and structural
/// damping is a part of B. What is left out is of the second or third order in B/ν, and aerodynamic
/// stiffness.
///
/// # Errors
///
/// [`Limitation::NotAllFree`]; [`Limitation::NoRoots`] if a decomposition fails, as where e is 1 but for
/// rounding.
pub fn uniform_form_of(order: Order, model: &Model) -> Result<ClosedForm, Limitation> {
    if !model.section().parameters().free.are_all() {
        return Err(Limitation::NotAllFree);
    }
    let modal = Modal::new(model).ok_or(Limitation::NoRoots)?;
    let [_, nu_2, nu_3] = modal.frequencies;
    let mut eigenvalues = cubic::roots(coefficients(order, &modal))
        .ok_or(Limitation::NoRoots)?
        .map(|root| (root + Complex::new(0.0, nu_2)) * model.frequency_unit);
    eigenvalues.sort_by(|one, other| other.im.total_cmp(&one.im));
    let damping = strength(&modal.damping, nu_3);
    let is_stiffened = model.section().parameters().aerodynamic_stiffness;
    let stiffness = is_stiffened.then_some(Limitation::AerodynamicStiffness);
    let is_strong = damping > STRONG;
    let strong = is_strong.then_some(Limitation::StrongDamping { damping });
    Ok(ClosedForm {
        eigenvalues,
        warnings: stiffness.into_iter().chain(strong).collect(),
    })
}

/// The coefficients of μ², μ and 1.
#[allow(non_snake_case)]
fn coefficients(order: Order, modal: &Modal) -> [Complex<f64>; 3] {
    let B = modal.damping;
    let [Delta_1, Delta_3] = modal.distances;
    let cubic = uniform_cubic(&UniformCubicInputs {
        nu_2: modal.frequencies[1],
        B_11: B[(0, 0)],
        B_12: B[(0, 1)],
        B_13: B[(0, 2)],
        B_21: B[(1, 0)],
        B_22: B[(1, 1)],
        B_23: B[(1, 2)],
        B_31: B[(2, 0)],
        B_32: B[(2, 1)],
        B_33: B[(2, 2)],
        Delta_1,
        Delta_3,
        second: match order {
            Order::First => 0.0,
            Order::Second => 1.0,
        },
    });
    [
        Complex::new(cubic.re_1, cubic.im_1),
        Complex::new(cubic.re_2, cubic.im_2),
        Complex::new(cubic.re_3, cubic.im_3),
    ]
}

/// |B|/(2ν) with the Frobenius norm of B.
fn strength(damping: &Matrix3<f64>, frequency: f64) -> f64 {
    damping.norm() / (2.0 * frequency)
}
