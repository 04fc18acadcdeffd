//! The coordinates of a section, and which of them are free.

use super::error::StabilityError;

/// A degree of freedom of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Coordinate {
    /// Sway x, in m.
    X,
    /// Heave y, in m.
    Y,
    /// Turn θ about the elastic centre, in rad.
    Theta,
}

impl Coordinate {
    /// All three, in the order of the matrices of Eq. (9).
    pub const ALL: [Coordinate; 3] = [Coordinate::X, Coordinate::Y, Coordinate::Theta];

    /// The name on the command line and in files: `x`, `y` or `theta`.
    pub fn name(self) -> &'static str {
        match self {
            Coordinate::X => "x",
            Coordinate::Y => "y",
            Coordinate::Theta => "theta",
        }
    }

    /// The row of the coordinate in the matrices of Eq. (9), from 0.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// The coordinates that are free to move, in the order of Eq. (9); the others are held.
///
/// ```
/// use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
///
/// let free = FreeCoordinates::new(&[Coordinate::Theta, Coordinate::Y])?;
/// assert_eq!(free.as_slice(), [Coordinate::Y, Coordinate::Theta]);
/// assert!(!free.are_all());
/// assert!(FreeCoordinates::new(&[]).is_err());
/// # Ok::<(), sextic::stability::error::StabilityError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FreeCoordinates(Vec<Coordinate>);

impl FreeCoordinates {
    /// These coordinates, in any order; one that is named twice is free once.
    ///
    /// # Errors
    ///
    /// If there are none.
    pub fn new(coordinates: &[Coordinate]) -> Result<Self, StabilityError> {
        let mut free = coordinates.to_vec();
        free.sort();
        free.dedup();
        if free.is_empty() {
            return Err(StabilityError::NothingIsFree);
        }
        Ok(FreeCoordinates(free))
    }

    /// All three.
    pub fn all() -> Self {
        FreeCoordinates(Coordinate::ALL.to_vec())
    }

    /// The free coordinates, 1 to 3 of them, in order.
    pub fn as_slice(&self) -> &[Coordinate] {
        &self.0
    }

    /// Whether all three are free.
    pub fn are_all(&self) -> bool {
        self.0.len() == Coordinate::ALL.len()
    }
}
