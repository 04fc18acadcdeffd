//! Exact modes: the roots of the characteristic polynomial without an eigenvalue routine.

use std::fmt;
use std::iter::once;

use num_complex::Complex;
use sextic_evaluators::bounded::Bounded;
use sextic_evaluators::exact_modes::{ExactModesInputs, Modes, exact_modes};

use super::ball::Ball;
use super::eigenvalue::{Eigenvalue, Spectrum, best_spectrum};
use super::enclosure::error_bounds;
use super::error::StabilityError;
use super::model::{Model, given_with_bounds};
use super::section::{Parameters, Section};
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
/// The errors are bounded as those of the [state matrix](state_matrix::eigenvalues) are, where that gives bounds, else
/// by the radii of the iteration. Both count the rounding of sines, cosines and the scaled damping matrix.
///
/// About 1,600 operations and three Taylor expansions; a shape of a mode is given by [`Mode::new`](super::tracking::Mode::new).
///
/// # Errors
///
/// Those of the [state matrix](state_matrix::eigenvalues), which stands in where a coordinate is held, with
/// aerodynamic stiffness, or where the iteration has no radius; that is told as [`Fallback`].
pub fn eigenvalues(model: &Model) -> Result<ExactModes, StabilityError> {
    let (fallback, spectrum) = match iterated(model.section()) {
        Ok(found) => (None, sharper(Spectrum::of_pairs(found), model)),
        Err(fallback) => (Some(fallback), state_matrix::eigenvalues(model)?),
    };
    Ok(ExactModes { spectrum, fallback })
}

/// The eigenvalues with the radii of the iteration, which cost nothing, where these leave nine decimals of S certain;
/// else as [`eigenvalues`].
///
/// # Errors
///
/// As [`eigenvalues`].
pub fn eigenvalues_for_tables(model: &Model) -> Result<Spectrum, StabilityError> {
    enough_for_tables(iterated(model.section()).ok(), model)
}

/// The eigenvalues of which the iteration found one of each pair, if their radii are enough for tables; else as
/// [`eigenvalues`].
pub(super) fn enough_for_tables(
    found: Option<[Eigenvalue; 3]>,
    model: &Model,
) -> Result<Spectrum, StabilityError> {
    let are_enough = |own: &Spectrum| are_enough(own.damping_coefficient(model.section()));
    match found.map(Spectrum::of_pairs).filter(are_enough) {
        Some(spectrum) => Ok(spectrum),
        None => Ok(eigenvalues(model)?.spectrum),
    }
}

/// Whether an S with a bound of its error has nine certain decimals.
pub(super) fn are_enough(coefficient: Option<(f64, f64)>) -> bool {
    coefficient.is_some_and(|(_, error)| error <= 4e-10)
}

/// The same eigenvalues with bounds by Taylor expansions, if these give some.
fn sharper(spectrum: Spectrum, model: &Model) -> Spectrum {
    let unit = model.frequency_unit;
    let values = spectrum.eigenvalues.iter().map(|own| own.value / unit);
    let bounds = |values: &[_]| error_bounds(values, |point| model.taylor(Ball::exact(point)));
    best_spectrum(once(values.collect()), bounds, unit).unwrap_or(spectrum)
}

/// One of each pair.
fn iterated(section: &Section) -> Result<[Eigenvalue; 3], Fallback> {
    let p = section.parameters();
    if !p.free.are_all() {
        return Err(Fallback::Held);
    }
    if p.aerodynamic_stiffness {
        return Err(Fallback::AerodynamicStiffness);
    }
    eigenvalues_of(&exact_modes(&inputs(section))).ok_or(Fallback::NoRadius)
}

/// One of each pair, with bounds of their errors; `None` without radii.
pub(super) fn eigenvalues_of(modes: &Modes<f64>) -> Option<[Eigenvalue; 3]> {
    let eigenvalue = |place: usize| {
        let value = Complex::new(modes.real[place], modes.frequency[place]);
        // The frequency is rounded besides, by half a unit in its last place.
        let error = (modes.radius[place] + f64::EPSILON * value.im) * (1.0 + 2.0 * f64::EPSILON);
        Eigenvalue { value, error }
    };
    let is_known = modes.radius.iter().all(|radius| radius.is_finite());
    is_known.then(|| [0, 1, 2].map(eigenvalue))
}

/// What the evaluator of exact modes takes, of a section: with the rounding of sines, cosines and S_a.
pub fn inputs(section: &Section) -> ExactModesInputs<f64> {
    inputs_of(section.parameters())
}

/// The same of numbers that are known to be possible.
fn inputs_of(p: &Parameters) -> ExactModesInputs<f64> {
    let given = given_with_bounds(p, 1.0);
    let s_a = given.scaled_damping();
    let largest = |own: &[Bounded]| own.iter().map(|own| own.error).fold(0.0, f64::max);
    let values = s_a.map(|row| row.map(|own| own.value));
    let open = [largest(&given.mass_centre), largest(s_a.as_flattened())];
    given.map(|own| own.value).exact_modes_inputs(&values, open)
}

/// What is open of the directions of a section, and of its S_a.
pub(super) fn open(p: &Parameters) -> [f64; 2] {
    let inputs = inputs_of(p);
    [inputs.direction_error, inputs.damping_error]
}
