//! The closed forms (21) to (23), and where they may be used.

use std::iter;

use num_complex::Complex;
use sextic_evaluators::closed_form::{ClosedFormInputs, closed_form as evaluated};
use sextic_evaluators::small_quantities::SmallQuantitiesOutputs;

use super::forces::norm;
use super::given::Given;
use super::limitation::{Limitation, STRONG};
use super::section::{Parameters, Section};

/// The three eigenvalues with positive frequencies that a closed form gives.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// λ_k = λ_Rk + i ω_k in 1/s, the highest frequency first.
    pub eigenvalues: [Complex<f64>; 3],
    /// What speaks against them.
    pub warnings: Vec<Limitation>,
}

impl ClosedForm {
    /// The largest real part, in 1/s.
    pub fn largest_real_part(&self) -> f64 {
        let parts = self.eigenvalues.iter().map(|value| value.re);
        parts.fold(f64::NEG_INFINITY, f64::max)
    }
}

/// S by a closed form, and what speaks against it: all of it, or its names as a table has them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate<L = Vec<Limitation>> {
    /// S; `None` where the form does not apply, or without wind.
    pub value: Option<f64>,
    /// What speaks against it.
    pub limitations: L,
}

impl<L: FromIterator<Limitation>> Estimate<L> {
    /// None, since the form does not apply.
    pub(super) fn without(limitation: Limitation) -> Self {
        Estimate {
            value: None,
            limitations: iter::once(limitation).collect(),
        }
    }
}

/// The closed forms for a section: the real parts of Eqs. (21)–(23) with the frequencies of Eq. (15).
///
/// # Errors
///
/// If they do not apply: [`Limitation::NotAllFree`], [`Limitation::NotTuned`]. Frequencies count as
/// equal if they differ by at most 1e-9 of themselves.
pub fn closed_form(section: &Section) -> Result<ClosedForm, Limitation> {
    let given = Given::of(section.parameters());
    let p = &given.parameters;
    if !p.free.are_all() {
        return Err(Limitation::NotAllFree);
    }
    if !are_tuned(p.natural_frequencies) {
        return Err(Limitation::NotTuned);
    }
    let omega_n = p.natural_frequencies[0];
    let s_a = given.scaled_damping();
    let parts = evaluated(&given.closed_form_inputs(&s_a));
    let parts = [parts.lamda_R1, parts.lamda_R2, parts.lamda_R3];
    let squares = given.squares_without_wind(omega_n);
    let mode = |place: usize| Complex::new(parts[place], squares[place].sqrt());
    let eigenvalues = [0, 1, 2].map(mode);
    Ok(ClosedForm {
        eigenvalues,
        warnings: warnings(p, norm(&s_a), &eigenvalues),
    })
}

/// Whether natural frequencies are equal, but for 1e-9 of themselves.
pub(super) fn are_tuned([omega_x, omega_y, omega_theta]: [f64; 3]) -> bool {
    let is_equal = |omega: f64| (omega - omega_x).abs() <= 1e-9 * omega_x;
    is_equal(omega_y) && is_equal(omega_theta)
}

/// What the evaluator of Eqs. (21)–(23) takes, of a section.
pub fn inputs(section: &Section) -> ClosedFormInputs<f64> {
    let given = Given::of(section.parameters());
    given.closed_form_inputs(&given.scaled_damping())
}

/// What the closed forms are judged by where they apply.
pub(super) struct Judged {
    /// e and δ.
    pub small: SmallQuantitiesOutputs<f64>,
    /// |S_a|
    pub size: f64,
    /// S by the largest real part; `None` where it is none.
    pub coefficient: Option<f64>,
    /// The largest |λ_R|/ω of a mode.
    pub share: f64,
    pub is_damped: bool,
    pub is_stiffened: bool,
}

impl Judged {
    /// What speaks against them, in order.
    #[inline]
    pub fn limitations(&self) -> [Option<Limitation>; 4] {
        let damped = Limitation::StructuralDamping;
        let stiffened = Limitation::AerodynamicStiffness;
        let strong = Limitation::StrongDamping {
            damping: self.share,
        };
        [
            self.is_damped.then_some(damped),
            self.is_stiffened.then_some(stiffened),
            self.outside(),
            (self.share > STRONG).then_some(strong),
        ]
    }

    /// Where what is left out counts as much as what is kept.
    #[inline]
    fn outside(&self) -> Option<Limitation> {
        let (eccentricity, damping) = (self.small.e, self.small.delta * self.size);
        if eccentricity <= damping {
            return Some(Limitation::Eccentricity {
                damping,
                eccentricity,
            });
        }
        let second_order = (damping / eccentricity).powi(2);
        let is_below = |own: f64| own.abs() <= second_order * self.size;
        let is_open = self.coefficient.is_some_and(is_below);
        is_open.then_some(Limitation::Sign { second_order })
    }
}

/// What speaks against the closed forms where they apply; `size` is |S_a|.
fn warnings(p: &Parameters, size: f64, eigenvalues: &[Complex<f64>; 3]) -> Vec<Limitation> {
    let largest = |number: fn(&Complex<f64>) -> f64| {
        let numbers = eigenvalues.iter().map(number);
        numbers.fold(f64::NEG_INFINITY, f64::max)
    };
    let judged = Judged {
        small: p.small_quantities(),
        size,
        coefficient: p.damping_coefficient(largest(|value| value.re)),
        share: largest(|value| value.re.abs() / value.im),
        is_damped: p.damping_ratios.iter().any(|&ratio| ratio > 0.0),
        is_stiffened: p.aerodynamic_stiffness,
    };
    judged.limitations().into_iter().flatten().collect()
}
