//! Modes that keep their numbers from section to section.

use rayon::prelude::*;

use super::value::Value;
use crate::stability::coordinate::Coordinate;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::error::StabilityError;
use crate::stability::exact_modes;
use crate::stability::model::Model;
use crate::stability::section::Section;
use crate::stability::tracking::{Mode, Place, follow, places};

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

/// The modes of a section, before they are told by those of another one.
pub(in crate::stability) struct Modes {
    pub model: Model,
    pub spectrum: Spectrum,
    modes: Vec<(Mode, Value)>,
}

impl Modes {
    /// By what the iteration found, else by all that is known of the eigenvalues.
    pub fn new(section: &Section, found: Option<[Eigenvalue; 3]>) -> Result<Self, StabilityError> {
        let model = Model::new(section)?;
        let spectrum = exact_modes::enough_for_tables(found, &model)?;
        Ok(Modes {
            modes: modes_of(&model, &spectrum),
            model,
            spectrum,
        })
    }

    /// With numbers, which are given in the order in which the modes were found.
    pub fn numbered(&self, numbers: &[usize]) -> Vec<FollowedMode> {
        let section = self.model.section();
        let mode = |(&label, (mode, damping)): (&usize, &(Mode, Value))| FollowedMode {
            label,
            damping: *damping,
            frequency: mode.frequency(),
            mostly: mode.mostly(section),
        };
        let mut modes: Vec<FollowedMode> = numbers.iter().zip(&self.modes).map(mode).collect();
        modes.sort_by_key(|mode| mode.label);
        modes
    }
}

/// Modes of the last section, and their numbers.
#[derive(Default)]
pub(in crate::stability) struct Following {
    modes: Vec<(Mode, Value)>,
    numbers: Vec<usize>,
}

impl Following {
    /// The numbers of the modes of the next sections. A mode that continues one keeps its number; one that begins, as
    /// where a pair of eigenvalues becomes real, takes the lowest that is free.
    pub fn numbers(&mut self, found: &[Modes]) -> Vec<Vec<usize>> {
        let modes = |place: usize| found.get(place).map(|own| own.modes.as_slice());
        let continued = |place: usize| {
            let before = place.checked_sub(1).and_then(modes);
            let pair = [before.unwrap_or(&self.modes), modes(place)?];
            let [old, new] = pair.map(|modes| modes.iter().map(|(mode, _)| mode));
            let model = &found.get(place)?.model;
            follow(model, &old.collect::<Vec<_>>(), &new.collect::<Vec<_>>())
        };
        let places = (0..found.len()).into_par_iter();
        let continued: Vec<Option<&[usize]>> = places.map(continued).collect();
        if let Some(last) = found.last() {
            self.modes.clone_from(&last.modes);
        }
        let numbered = |(own, continued): (&Modes, Option<&[usize]>)| {
            let mut numbers = vec![None; own.modes.len()];
            for (&number, &place) in self.numbers.iter().zip(continued.unwrap_or_default()) {
                if let Some(own) = numbers.get_mut(place) {
                    *own = Some(number);
                }
            }
            let mut free = (1..).filter(|number| !numbers.contains(&Some(*number)));
            let number = |own: &Option<usize>| own.or_else(|| free.next());
            self.numbers = numbers.iter().filter_map(number).collect();
            self.numbers.clone()
        };
        found.iter().zip(continued).map(numbered).collect()
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
