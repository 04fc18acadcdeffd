//! A closed form for every eccentricity: the three modes together.

use nalgebra::Matrix3;
use num_complex::Complex;
use sextic_evaluators::dispatch::Mode;
use sextic_evaluators::uniform_cubic::{
    UniformCubicInputs, UniformCubicOutputs, uniform_cubic, uniform_cubic_batch,
};

use super::closed_form::{ClosedForm, Estimate};
use super::columns::{Results, computed};
use super::cubic;
use super::given::Given;
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
    let p = model.section().parameters();
    let modal = Modal::new(&Given::of(p)).ok_or(Limitation::NoRoots)?;
    let cubic = uniform_cubic(&inputs(&modal.entries(), order.second()));
    form(&modal, &cubic, p.aerodynamic_stiffness)
}

impl Order {
    /// What stands before the second power of the damping.
    fn second(self) -> f64 {
        match self {
            Order::First => 0.0,
            Order::Second => 1.0,
        }
    }
}

impl Given<&[f64]> {
    /// S by a uniform form and what speaks against it, as [`uniform_form_of`] says it of each section, from the
    /// coordinates of its modes.
    pub fn uniform_forms<L>(&self, order: Order, modal: &[Option<Modal>]) -> Vec<Estimate<L>>
    where
        L: FromIterator<Limitation> + Clone,
    {
        let p = &self.parameters;
        if !p.free.are_all() {
            return vec![Estimate::without(Limitation::NotAllFree); self.rows()];
        }
        let cubics = cubics(order, modal);
        let forms = modal.iter().zip(cubics).map(|(modal, cubic)| {
            let modal = modal.as_ref().ok_or(Limitation::NoRoots)?;
            form(modal, &cubic, p.aerodynamic_stiffness)
        });
        let forms: Vec<Result<ClosedForm, Limitation>> = forms.collect();
        let part = |own: &Result<ClosedForm, _>| match own {
            Ok(form) => form.largest_real_part(),
            Err(_) => f64::NAN,
        };
        let coefficients = self.damping_coefficients(&forms.iter().map(part).collect::<Vec<_>>());
        let estimate = |(form, value): (Result<ClosedForm, _>, &f64)| match form {
            Ok(form) => Estimate {
                value: Some(*value).filter(|own| own.is_finite()),
                limitations: form.warnings.into_iter().collect(),
            },
            Err(limitation) => Estimate::without(limitation),
        };
        let rows = forms.into_iter().zip(coefficients.columns()[0]);
        rows.map(estimate).collect()
    }
}

/// The form of a section, by the coefficients of its cubic.
fn form(
    modal: &Modal,
    cubic: &UniformCubicOutputs<f64>,
    is_stiffened: bool,
) -> Result<ClosedForm, Limitation> {
    let [_, nu_2, nu_3] = modal.frequencies;
    let coefficients = [
        Complex::new(cubic.re_1, cubic.im_1),
        Complex::new(cubic.re_2, cubic.im_2),
        Complex::new(cubic.re_3, cubic.im_3),
    ];
    let mut eigenvalues = cubic::roots(coefficients)
        .ok_or(Limitation::NoRoots)?
        .map(|root| (root + Complex::new(0.0, nu_2)) * modal.unit);
    eigenvalues.sort_by(|one, other| other.im.total_cmp(&one.im));
    let damping = strength(&modal.damping, nu_3);
    let stiffness = is_stiffened.then_some(Limitation::AerodynamicStiffness);
    let is_strong = damping > STRONG;
    let strong = is_strong.then_some(Limitation::StrongDamping { damping });
    Ok(ClosedForm {
        eigenvalues,
        warnings: stiffness.into_iter().chain(strong).collect(),
    })
}

/// The cubics of sections; no numbers where there are no modal coordinates.
fn cubics(order: Order, modal: &[Option<Modal>]) -> Vec<UniformCubicOutputs<f64>> {
    let rows = modal.len();
    let mut entries = Results::<12>::new(rows);
    let mut columns = entries.columns_mut();
    let known = modal.iter().enumerate();
    for (row, modal) in known.filter_map(|(row, own)| Some((row, own.as_ref()?))) {
        for (column, entry) in columns.iter_mut().zip(modal.entries()) {
            column[row] = entry;
        }
    }
    let second = vec![order.second(); rows];
    let mut found = Results::<6>::new(rows);
    let mut results = outputs(found.columns_mut());
    let inputs = inputs(&entries.columns(), &second[..]);
    computed(uniform_cubic_batch(&inputs, &mut results, Mode::Strict));
    let columns = found.columns();
    let cubic = |row: usize| outputs(columns.map(|own| own[row]));
    (0..rows).map(cubic).collect()
}

#[allow(non_snake_case)]
fn inputs<T: Copy>(
    [
        nu_2,
        B_11,
        B_12,
        B_13,
        B_21,
        B_22,
        B_23,
        B_31,
        B_32,
        B_33,
        Delta_1,
        Delta_3,
    ]: &[T; 12],
    second: T,
) -> UniformCubicInputs<T> {
    UniformCubicInputs {
        nu_2: *nu_2,
        B_11: *B_11,
        B_12: *B_12,
        B_13: *B_13,
        B_21: *B_21,
        B_22: *B_22,
        B_23: *B_23,
        B_31: *B_31,
        B_32: *B_32,
        B_33: *B_33,
        Delta_1: *Delta_1,
        Delta_3: *Delta_3,
        second,
    }
}

fn outputs<T>([re_1, re_2, re_3, im_1, im_2, im_3]: [T; 6]) -> UniformCubicOutputs<T> {
    UniformCubicOutputs {
        re_1,
        re_2,
        re_3,
        im_1,
        im_2,
        im_3,
    }
}

/// |B|/(2ν) with the Frobenius norm of B.
fn strength(damping: &Matrix3<f64>, frequency: f64) -> f64 {
    damping.norm() / (2.0 * frequency)
}
