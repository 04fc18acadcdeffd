//! One angle, by every method.

use num_complex::Complex;

use crate::stability::closed_form::{Limitation, closed_form};
use crate::stability::companion;
use crate::stability::coordinate::Coordinate;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::error::StabilityError;
use crate::stability::model::Model;
use crate::stability::modes;
use crate::stability::section::Section;
use crate::stability::tracking::{Mode, follow};

/// A number and a bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// The number.
    pub value: f64,
    /// What is exact is no farther away.
    pub error: f64,
}

/// A mode that is followed from angle to angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowedMode {
    /// Its number, from 1.
    pub label: usize,
    /// S of this mode.
    pub damping: Value,
    /// Its frequency in Hz; 0 for a motion that does not oscillate.
    pub frequency: f64,
    /// The coordinate with the largest part of its motion, rθ counting as a length.
    pub mostly: Coordinate,
}

/// What the methods say at an angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// α, in degrees.
    pub angle: f64,
    /// S by the state matrix.
    pub exact: Value,
    /// S by the companion matrix; `None` if it has no answer with a bounded error.
    pub companion: Option<Value>,
    /// S by the closed forms, where they apply.
    pub closed: Option<f64>,
    /// What speaks against the closed forms.
    pub limitations: Vec<Limitation>,
    /// (δ|S_a|/e)², the order of what the closed forms leave out.
    pub second_order: f64,
    /// The modes in the order of their numbers.
    pub modes: Vec<FollowedMode>,
}

impl Point {
    /// The mode with the least damping.
    pub fn critical(&self) -> Option<&FollowedMode> {
        let damping = |mode: &&FollowedMode| mode.damping.value;
        self.modes
            .iter()
            .min_by(|one, other| damping(one).total_cmp(&damping(other)))
    }
}

/// A section at an angle; `before` are the modes at the angle before, with their numbers.
pub(in crate::stability) fn point(
    angle: f64,
    section: &Section,
    before: &mut Vec<(usize, Mode)>,
) -> Result<Point, StabilityError> {
    let model = Model::new(section)?;
    let spectrum = modes::eigenvalues(&model)?;
    let value = |spectrum: &Spectrum| {
        let (value, error) = spectrum.damping_coefficient(section)?;
        Some(Value { value, error })
    };
    // Without wind there is no S; that is refused before.
    let exact = value(&spectrum).ok_or(StabilityError::OutOfRange)?;
    let companion = companion::eigenvalues(&model).ok();
    let (closed, limitations) = match closed_form(&model) {
        Ok(closed) => {
            let part = section.damping_coefficient(closed.largest_real_part());
            (part, closed.warnings)
        }
        Err(limitation) => (None, vec![limitation]),
    };
    let omega_n = section.parameters().natural_frequencies[section.free()[0].index()];
    let ratio = model.relative_aerodynamic_damping(omega_n) / section.eccentricity();
    Ok(Point {
        angle,
        exact,
        companion: companion.as_ref().and_then(value),
        closed,
        limitations,
        second_order: ratio * ratio,
        modes: followed(&model, &spectrum, before),
    })
}

/// The modes of a spectrum, each with the number of the one before that it continues.
fn followed(
    model: &Model,
    spectrum: &Spectrum,
    before: &mut Vec<(usize, Mode)>,
) -> Vec<FollowedMode> {
    let section = model.section();
    let pairs: Vec<&Eigenvalue> = spectrum.one_of_each_pair().collect();
    let mut next: Vec<(Mode, Value)> = Vec::new();
    for (index, own) in pairs.iter().enumerate() {
        let coincide =
            |other: &&&Eigenvalue| (other.value - own.value).norm() <= other.error + own.error;
        let place = pairs[..index].iter().filter(coincide).count();
        let damping = (
            section.damping_coefficient(own.value.re),
            section.damping_coefficient(own.error),
        );
        if let (Some(mode), (Some(value), Some(error))) =
            (Mode::new(model, own.value, place), damping)
        {
            let error = error.abs();
            next.push((mode, Value { value, error }));
        }
    }
    let old: Vec<Mode> = before.iter().map(|(_, mode)| mode.clone()).collect();
    let new: Vec<Mode> = next.iter().map(|(mode, _)| mode.clone()).collect();
    let labels: Vec<usize> = match follow(model, &old, &new) {
        Some(places) => {
            let mut labels = vec![0; next.len()];
            for ((label, _), place) in before.iter().zip(places) {
                labels[place] = *label;
            }
            labels
        }
        // Where a pair becomes real, or real ones a pair, modes are numbered anew.
        None => (1..=next.len()).collect(),
    };
    let mut modes: Vec<FollowedMode> = labels
        .iter()
        .zip(&next)
        .map(|(&label, (mode, damping))| FollowedMode {
            label,
            damping: *damping,
            frequency: mode.value.im / std::f64::consts::TAU,
            mostly: mostly(section, &mode.shape),
        })
        .collect();
    modes.sort_by_key(|mode| mode.label);
    *before = labels.into_iter().zip(new).collect();
    before.sort_by_key(|(label, _)| *label);
    modes
}

fn mostly(section: &Section, shape: &[Complex<f64>]) -> Coordinate {
    let parts = section.free().iter().zip(shape);
    let largest = parts.max_by(|one, other| one.1.norm().total_cmp(&other.1.norm()));
    largest.map_or(section.free()[0], |(coordinate, _)| *coordinate)
}
