//! A part of the wind speeds up to a highest one, and what is known on it.

use crate::algebra::number::{Integer, Rational};

/// What is certain of a section at all wind speeds of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// All eigenvalues have negative real parts.
    Stable,
    /// An eigenvalue has a positive real part: the section gallops.
    Unstable,
    /// A real eigenvalue is above 0: static divergence, whether the section gallops beside it or not.
    Divergent,
    /// None of these is shown.
    Undecided,
}

impl Stability {
    /// `stable`, `unstable`, `divergent` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Divergent => "divergent",
            Stability::Undecided => "undecided",
        }
    }
}

/// A part of the speeds, its ends as shares of the highest one.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub from: Rational,
    pub to: Rational,
    pub found: Found,
}

/// What is known at all speeds of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// Stability.
    Certain(Stability),
    /// At most one change, from the one to the other.
    Change([Stability; 2]),
}

impl Part {
    /// All speeds, of which nothing is known.
    pub fn undecided() -> Self {
        Part {
            from: Rational::ZERO,
            to: Rational::ONE,
            found: Found::Certain(Stability::Undecided),
        }
    }

    /// Stability, if it is certain.
    pub fn certain(&self) -> Option<Stability> {
        match self.found {
            Found::Certain(Stability::Undecided) | Found::Change(_) => None,
            Found::Certain(stability) => Some(stability),
        }
    }

    /// Whether it is so near to 0 that what is not decided there is left out.
    pub fn is_negligible(&self) -> bool {
        self.to <= share(Integer::ONE, LOWEST.into())
    }
}

/// place/2^depth
pub(super) fn share(place: Integer, depth: usize) -> Rational {
    Rational::from(place) / Rational::from(Integer::ONE << depth)
}

/// What is not decided below this power of 1/2 is left out.
pub(super) const LOWEST: u8 = 100;
