//! One angle, by every method.

use rayon::prelude::*;

use crate::stability::closed_form::{Estimate, closed_form};
use crate::stability::companion;
use crate::stability::coordinate::Coordinate;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::error::StabilityError;
use crate::stability::exact_modes;
use crate::stability::exact_section::ExactSection;
use crate::stability::model::Model;
use crate::stability::section::Section;
use crate::stability::sensitivity::weakened_by;
use crate::stability::tracking::{Mode, Place, follow, places};
use crate::stability::uniform_form::uniform_form;
use crate::stability::verdict::{Verdict, verdict};

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

/// What the methods say of a section, before its modes are told by those of another one.
pub(in crate::stability) struct Answers {
    model: Model,
    exact: Value,
    verdict: Verdict,
    diverges: bool,
    companion: Option<Value>,
    closed: Estimate,
    uniform: Estimate,
    weakened_by: Vec<(Coordinate, f64)>,
    scaled_damping: f64,
    second_order: f64,
    modes: Vec<(Mode, Value)>,
}

impl Answers {
    pub(in crate::stability) fn new(section: &Section) -> Result<Self, StabilityError> {
        let model = Model::new(section)?;
        let spectrum = exact_modes::eigenvalues_for_tables(&model)?;
        let value = |spectrum: &Spectrum| {
            let (value, error) = spectrum.damping_coefficient(section)?;
            Some(Value { value, error })
        };
        // No wind is refused before.
        let exact = value(&spectrum).ok_or(StabilityError::OutOfRange)?;
        let companion = companion::eigenvalues(&model).ok();
        let closed = Estimate::new(section.parameters(), closed_form(section));
        let uniform = Estimate::new(section.parameters(), uniform_form(&model));
        let scaled_damping = section.scaled_damping_norm();
        let ratio = section.relative_wind() * scaled_damping / section.eccentricity();
        Ok(Answers {
            exact,
            verdict: verdict(section, &spectrum),
            diverges: (model.diverges()).unwrap_or_else(|| ExactSection::from(section).diverges()),
            companion: companion.as_ref().and_then(value),
            closed,
            uniform,
            weakened_by: weakened_by(&model, &spectrum),
            scaled_damping,
            second_order: ratio * ratio,
            modes: modes_of(&model, &spectrum),
            model,
        })
    }

    /// The point at an angle; `numbers` are those of the modes, in the order in which they were found.
    fn point(self, angle: f64, numbers: &[usize]) -> Point {
        let section = self.model.section();
        let mode = |(&label, (mode, damping)): (&usize, &(Mode, Value))| FollowedMode {
            label,
            damping: *damping,
            frequency: mode.frequency(),
            mostly: mode.mostly(section),
        };
        let mut modes: Vec<FollowedMode> = numbers.iter().zip(&self.modes).map(mode).collect();
        modes.sort_by_key(|mode| mode.label);
        Point {
            angle,
            modes,
            exact: self.exact,
            verdict: self.verdict,
            diverges: self.diverges,
            companion: self.companion,
            closed: self.closed,
            uniform: self.uniform,
            weakened_by: self.weakened_by,
            scaled_damping: self.scaled_damping,
            second_order: self.second_order,
        }
    }
}

/// Modes at the last angle, and their numbers.
#[derive(Default)]
pub(in crate::stability) struct Following {
    modes: Vec<(Mode, Value)>,
    numbers: Vec<usize>,
}

impl Following {
    /// The points at the next angles. A mode that continues one keeps its number; one that begins, as where a pair of
    /// eigenvalues becomes real, takes the lowest that is free.
    pub fn points(&mut self, answered: Vec<(f64, Answers)>) -> Vec<Point> {
        let modes = |place: usize| answered.get(place).map(|(_, own)| own.modes.as_slice());
        let continued = |place: usize| {
            let before = place.checked_sub(1).and_then(modes);
            let pair = [before.unwrap_or(&self.modes), modes(place)?];
            let [old, new] = pair.map(|modes| modes.iter().map(|(mode, _)| mode));
            let model = &answered.get(place)?.1.model;
            follow(model, &old.collect::<Vec<_>>(), &new.collect::<Vec<_>>())
        };
        let places = (0..answered.len()).into_par_iter();
        let continued: Vec<Option<&[usize]>> = places.map(continued).collect();
        if let Some((_, last)) = answered.last() {
            self.modes.clone_from(&last.modes);
        }
        let numbered = |((angle, own), continued): ((f64, Answers), Option<&[usize]>)| {
            let mut numbers = vec![None; own.modes.len()];
            for (&number, &place) in self.numbers.iter().zip(continued.unwrap_or_default()) {
                if let Some(own) = numbers.get_mut(place) {
                    *own = Some(number);
                }
            }
            let mut free = (1..).filter(|number| !numbers.contains(&Some(*number)));
            let number = |own: &Option<usize>| own.or_else(|| free.next());
            self.numbers = numbers.iter().filter_map(number).collect();
            own.point(angle, &self.numbers)
        };
        answered.into_iter().zip(continued).map(numbered).collect()
    }
}

/// The modes of a spectrum, each with S.
pub(in crate::stability) fn modes_of(model: &Model, spectrum: &Spectrum) -> Vec<(Mode, Value)> {
    let section = model.section();
    let mode = |(own, place): (Eigenvalue, Option<Place>)| {
        let damping = Value {
            value: section.damping_coefficient(own.value.re)?,
            error: section.damping_coefficient(own.error)?.abs(),
        };
        Some((Mode::new(model, own.value, place)?, damping))
    };
    places(spectrum).into_iter().filter_map(mode).collect()
}
