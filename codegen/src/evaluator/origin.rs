//! Where the values of inputs come from.

use super::Quantity;
use crate::program::Rational;

/// A number that is not asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// The number, or a rational closer to it than 2⁻¹⁰⁰.
    pub value: Rational,
    /// What it is: `r = 0.0178`, `cos(α_g) at α_g = 0.3`.
    pub text: String,
}

/// A circular function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// cos
    Cosine,
    /// sin
    Sine,
}

/// The cosine or sine of a sum of angles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circular {
    /// Which of the two.
    pub function: Function,
    /// How often each angle of the evaluator occurs in the sum, by name: 2·α − β.
    pub angle: Vec<(i32, String)>,
}

/// Where the value of an input comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The caller knows it.
    Given,
    /// The caller gives it, or the angles that it is made of.
    Circular(Circular),
    /// It is the same at every point, and no input any more of what is emitted.
    Fixed(Fixed),
}

/// An input of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// What it is.
    pub quantity: Quantity,
    /// Where its value comes from.
    pub origin: Origin,
}

impl Input {
    /// An input of which nothing but the name is known.
    pub fn plain(name: impl Into<String>) -> Self {
        Input {
            quantity: Quantity::plain(name),
            origin: Origin::Given,
        }
    }

    /// Its value, if it is the same at every point.
    pub fn fixed(&self) -> Option<&Fixed> {
        match &self.origin {
            Origin::Fixed(fixed) => Some(fixed),
            Origin::Given | Origin::Circular(_) => None,
        }
    }

    /// The circular function that it is, if it is one that is not fixed.
    pub fn circular(&self) -> Option<&Circular> {
        match &self.origin {
            Origin::Circular(circular) => Some(circular),
            Origin::Given | Origin::Fixed(_) => None,
        }
    }
}

/// An angle in radians whose sine and cosine, or those of a sum with it, are inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angle {
    /// What it is.
    pub quantity: Quantity,
    /// Its value, if it is not asked for.
    pub fixed: Option<Fixed>,
}
