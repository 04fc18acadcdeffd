//! Exact modes: the roots of the characteristic polynomial without an eigenvalue routine.

use std::fmt;
use std::iter::once;

use num_complex::Complex;
use sextic_evaluators::exact_modes::exact_modes;
use sextic_evaluators::section_matrices::SectionMatricesInputs;

use super::ball::Ball;
use super::eigenvalue::{Spectrum, best_spectrum};
use super::enclosure::error_bounds;
use super::error::StabilityError;
use super::given::Given;
use super::model::Model;
use super::section::Section;
use super::state_matrix;

/// The eigenvalues of a section, and how they were found.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactModes {
    /// The eigenvalues with bounds of their errors.
    pub spectrum: Spectrum,
    /// Why they are those of the state matrix; `None` where they are those of the iteration.
    pub fallback: Option<Fallback>,
}

/// Why the state matrix stands in for the iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fallback {
    /// A coordinate is held: the polynomial is not of degree 6.
    Held,
    /// There is aerodynamic stiffness, which the iteration does not count.
    AerodynamicStiffness,
    /// The iteration gave no radius.
    NoRadius,
}

impl fmt::Display for Fallback {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Fallback::Held => "a coordinate is held: these are the eigenvalues of the state matrix",
            Fallback::AerodynamicStiffness => {
                "the iteration leaves aerodynamic stiffness out: these are the eigenvalues of the state matrix"
            }
            Fallback::NoRadius => {
                "the polynomial gave no roots of certain accuracy (modes that coincide, do not oscillate, or are beyond all scales): these are the eigenvalues of the state matrix"
            }
        })
    }
}

/// The six eigenvalues as roots of |λ²M + λ(C_s + C_a) + K|, expanded about iω_0 symbolically.
///
/// No coefficient is a difference of nearly equal numbers (`derivations/exact-modes.md`), so that real parts
/// are as exact as the damping is given, however small it is beside the frequencies, and with any detuning.
/// The errors are bounded as those of the [state matrix](state_matrix::eigenvalues) are: they count the
/// rounding of sines, cosines and the scaled damping matrix.
///
/// About 1,600 operations and three Taylor expansions; a shape of a mode is given by
/// [`Mode::new`](super::tracking::Mode::new).
///
/// # Errors
///
/// Those of the [state matrix](state_matrix::eigenvalues), which stands in where a coordinate is held, with
/// aerodynamic stiffness, or where the iteration has no radius; that is told as [`Fallback`].
pub fn eigenvalues(model: &Model) -> Result<ExactModes, StabilityError> {
    let (fallback, spectrum) = match iterated(model) {
        Ok(spectrum) => (None, spectrum),
        Err(fallback) => (Some(fallback), state_matrix::eigenvalues(model)?),
    };
    Ok(ExactModes { spectrum, fallback })
}

fn iterated(model: &Model) -> Result<Spectrum, Fallback> {
    if !model.section().parameters().free.are_all() {
        return Err(Fallback::Held);
    }
    if model.section().parameters().aerodynamic_stiffness {
        return Err(Fallback::AerodynamicStiffness);
    }
    let modes = exact_modes(&inputs(model.section()));
    if !modes.radius.iter().all(|radius| radius.is_finite()) {
        return Err(Fallback::NoRadius);
    }
    let unit = model.frequency_unit;
    let value = |place: usize| Complex::new(modes.real[place], modes.frequency[place]) / unit;
    let [a, b, c] = [0, 1, 2].map(value);
    let values = vec![a, b, c, a.conj(), b.conj(), c.conj()];
    let bounds = |values: &[_]| error_bounds(values, |point| model.taylor(Ball::exact(point)));
    best_spectrum(once(values), bounds, unit).map_err(|_| Fallback::NoRadius)
}

/// What the evaluators of exact modes take, of a section.
pub fn inputs(section: &Section) -> SectionMatricesInputs<f64> {
    let given = Given::of(section.parameters());
    given.section_matrices_inputs(&given.scaled_damping())
}
