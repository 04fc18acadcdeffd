//! One angle, by every method.

use super::following::{FollowedMode, Modes};
use super::value::Value;
use crate::stability::batch::Batch;
use crate::stability::closed_form::Estimate;
use crate::stability::companion;
use crate::stability::coordinate::Coordinate;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::error::StabilityError;
use crate::stability::exact_section::ExactSection;
use crate::stability::forces::Coefficients;
use crate::stability::mean_twist::Twist;
use crate::stability::section::Section;
use crate::stability::sensitivity::weakened_by;
use crate::stability::uniform_form::Order;
use crate::stability::verdict::{Verdict, verdict};

/// What the methods say at an angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Which angle of the sweep it is, from 0.
    pub place: usize,
    /// α, in degrees.
    pub angle: f64,
    /// The coefficients there; `None` where S_a is set in place of them.
    pub coefficients: Option<Coefficients>,
    /// The mean twist, if the case asks for it.
    pub twist: Option<Twist>,
    /// S by the exact eigenvalues: those of the state matrix, which the exact modes find where they can.
    pub exact: Value,
    /// Whether the section is stable, with proof.
    pub verdict: Verdict,
    /// Whether it [diverges](ExactSection::diverges), with proof: else what is unstable gallops.
    pub diverges: bool,
    /// S by the companion matrix; `None` if it has no answer with a bounded error.
    pub companion: Option<Value>,
    /// S by the closed forms (21)–(23).
    pub closed: Estimate,
    /// S by the uniform form.
    pub uniform: Estimate,
    /// The coordinates whose structural damping lowers S as it grows, with ∂S/∂ζ.
    pub weakened_by: Vec<(Coordinate, f64)>,
    /// |S_a|, the size of all S.
    pub scaled_damping: f64,
    /// (δ|S_a|/e)², the order of what the closed forms leave out.
    pub second_order: f64,
    /// The modes in the order of their numbers.
    pub modes: Vec<FollowedMode>,
}

impl Point {
    /// The mode with a number.
    pub fn mode(&self, label: usize) -> Option<&FollowedMode> {
        self.modes.iter().find(|mode| mode.label == label)
    }

    /// The mode with the least damping.
    pub fn critical(&self) -> Option<&FollowedMode> {
        let damping = |mode: &&FollowedMode| mode.damping.value;
        self.modes
            .iter()
            .min_by(|one, other| damping(one).total_cmp(&damping(other)))
    }
}

/// The points at these angles with their places in the sweep, and the modes there, which have no numbers yet.
///
/// # Errors
///
/// That of the first section without an answer, and its angle.
pub(super) fn points(
    angles: &[(usize, f64)],
    sections: &[Section],
    twists: &[Option<Twist>],
) -> Result<Vec<(Point, Modes)>, (f64, StabilityError)> {
    let batch = Batch::of(sections);
    let eigenvalues = batch.own_eigenvalues();
    let [uniform] = batch.uniform_forms([Order::Second]);
    let forms = batch.closed_forms().into_iter().zip(uniform);
    let rows = angles.iter().zip(sections).zip(eigenvalues).zip(forms);
    let rows = rows.zip(twists);
    let points = rows.map(|((((&at, section), found), forms), twist)| {
        let found = point(at, section, found, forms);
        let (point, modes) = found.map_err(|error| (at.1, error))?;
        let twist = *twist;
        Ok((Point { twist, ..point }, modes))
    });
    points.collect()
}

fn point(
    (place, angle): (usize, f64),
    section: &Section,
    found: Option<[Eigenvalue; 3]>,
    (closed, uniform): (Estimate, Estimate),
) -> Result<(Point, Modes), StabilityError> {
    let modes = Modes::new(section, found)?;
    let (model, spectrum) = (&modes.model, &modes.spectrum);
    let value = |spectrum: &Spectrum| {
        let (value, error) = spectrum.damping_coefficient(section)?;
        Some(Value { value, error })
    };
    let scaled_damping = section.scaled_damping_norm();
    let ratio = section.relative_wind() * scaled_damping / section.eccentricity();
    let point = Point {
        place,
        angle,
        coefficients: section.parameters().forces.coefficients().copied(),
        twist: None,
        // No wind is refused before.
        exact: value(spectrum).ok_or(StabilityError::OutOfRange)?,
        verdict: verdict(section, spectrum),
        diverges: (model.diverges()).unwrap_or_else(|| ExactSection::from(section).diverges()),
        companion: companion::eigenvalues(model).ok().as_ref().and_then(value),
        closed,
        uniform,
        weakened_by: weakened_by(model, spectrum),
        scaled_damping,
        second_order: ratio * ratio,
        modes: Vec::new(),
    };
    Ok((point, modes))
}
