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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FreeCoordinates {
    /// The free ones first, in order; the others are held.
    order: [Coordinate; 3],
    count: usize,
}

impl Default for FreeCoordinates {
    /// All three.
    fn default() -> Self {
        FreeCoordinates::all()
    }
}

impl FreeCoordinates {
    /// These coordinates, in any order; one that is named twice is free once.
    ///
    /// # Errors
    ///
    /// If there are none.
    pub fn new(coordinates: &[Coordinate]) -> Result<Self, StabilityError> {
        let mut order = Coordinate::ALL;
        // A stable sort keeps the order of Eq. (9) within both groups.
        order.sort_by_key(|own| !coordinates.contains(own));
        let is_free = |own: &&Coordinate| coordinates.contains(own);
        match Coordinate::ALL.iter().filter(is_free).count() {
            0 => Err(StabilityError::NothingIsFree),
            count => Ok(FreeCoordinates { order, count }),
        }
    }

    /// All three.
    pub fn all() -> Self {
        FreeCoordinates {
            order: Coordinate::ALL,
            count: Coordinate::ALL.len(),
        }
    }

    /// The free coordinates, 1 to 3 of them, in order.
    pub fn as_slice(&self) -> &[Coordinate] {
        &self.order[..self.count]
    }

    /// The name of the damping coefficient of such a section: `S_3D`, `S_2D` or `S_1D`.
    pub fn coefficient_name(&self) -> &'static str {
        match self.count {
            1 => "S_1D",
            2 => "S_2D",
            _ => "S_3D",
        }
    }

    /// Whether all three are free.
    pub fn are_all(&self) -> bool {
        self.count == Coordinate::ALL.len()
    }
}
