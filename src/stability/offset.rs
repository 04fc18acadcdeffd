//! A section with its mass centre moved away from the elastic centre.

use rayon::prelude::*;

use super::batch::Batch;
use super::comparison::{FollowedMode, Following, Modes};
use super::error::StabilityError;
use super::section::{Parameters, Section};

/// The modes of a section whose mass centre is at a distance e r from O.
#[derive(Clone, Debug, PartialEq)]
pub struct OffsetPoint {
    /// e = L_g/r.
    pub eccentricity: f64,
    /// The modes, with the numbers that they have at e = 0.
    pub modes: Vec<FollowedMode>,
}

/// The modes of a section, with e from 0 to a largest value below 1, in so many steps;
/// they are numbered by their frequency at e = 0, the highest first, and followed by their shapes.
///
/// The shape and the mass stay as they are, as in Fig. 7 of the paper. Linear in the number of steps.
///
/// # Errors
///
/// As [`Section::new`], and if a section has no answer.
pub fn against_offset(
    own: &Section,
    largest: f64,
    steps: usize,
) -> Result<Vec<OffsetPoint>, StabilityError> {
    let eccentricity = |step: usize| largest * step as f64 / steps.max(1) as f64;
    let section = |step: usize| {
        Section::new(Parameters {
            mass_centre_distance: eccentricity(step) * own.parameters().radius_of_gyration,
            ..*own.parameters()
        })
    };
    let sections: Vec<Section> = (0..=steps).map(section).collect::<Result<_, _>>()?;
    let found = Batch::of(&sections).own_eigenvalues();
    let modes = sections.par_iter().zip(found);
    let modes: Vec<_> = modes
        .map(|(section, found)| Modes::new(section, found))
        .collect();
    // The first error, not the one that was found first.
    let modes: Vec<Modes> = modes.into_iter().collect::<Result<_, _>>()?;
    let numbers = Following::default().numbers(&modes);
    let point = |((step, modes), numbers): ((usize, &Modes), &Vec<usize>)| OffsetPoint {
        eccentricity: eccentricity(step),
        modes: modes.numbered(numbers),
    };
    Ok(modes.iter().enumerate().zip(&numbers).map(point).collect())
}
