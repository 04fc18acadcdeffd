//! The modes of a section or a system by one method.

use num_complex::Complex;

use crate::stability::coordinate::Coordinate;
use crate::stability::forces::Coefficients;
use crate::stability::mean_twist::Twist;
use crate::stability::tolerance::Tolerance;
use crate::stability::verdict::Verdict;

/// What a method says of a section or a system.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesFound {
    /// What has the modes.
    pub subject: Subject,
    /// The method that found them: `closed`, `uniform`, `exact`, `companion`, `state`.
    pub method: &'static str,
    /// Whether eigenvalues are those of a formula, and their errors what it leaves out; else they are exact
    /// but for rounding, and shown as far as they are certain.
    pub is_formula: bool,
    /// One of each pair of conjugates.
    pub modes: Vec<ModeFound>,
    /// S; `None` without wind.
    pub damping_coefficient: Option<DampingCoefficient>,
    /// Whether it is stable, with proof, by whichever method the modes are found.
    pub verdict: Verdict,
    /// Whether it diverges, with proof: else what grows gallops.
    pub diverges: bool,
    /// What a table gives there, for a section of a case.
    pub reading: Option<Reading>,
    /// The mean twist of a case that asks for it.
    pub twist: Option<Twist>,
    /// What speaks against the answer, and what was given in vain.
    pub warnings: Vec<String>,
}

/// S of the mode with the least damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingCoefficient {
    /// `S_3D`, or that of a section with fewer free coordinates.
    pub name: &'static str,
    /// The number.
    pub value: f64,
    /// A bound of its error, if the method gives one.
    pub error: Option<f64>,
}

/// What a table gives at the angle of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// α, in degrees.
    pub angle: f64,
    /// The coefficients that the section has there; `None` where S_a is set in place of them.
    pub coefficients: Option<Coefficients>,
    /// What is certain for all coefficients within their errors, if they have some.
    pub within_errors: Option<Tolerance>,
}

/// What modes are found of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A section in the wind.
    Section,
    /// A system that a document derives.
    System,
}

impl Subject {
    /// What it is called.
    pub const fn name(self) -> &'static str {
        match self {
            Subject::Section => "section",
            Subject::System => "system",
        }
    }

    /// What is said of a motion that grows.
    pub const fn growth(self) -> &'static str {
        match self {
            Subject::Section => "it gallops",
            Subject::System => "it grows",
        }
    }
}

/// A mode as a method finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeFound {
    /// λ in 1/s.
    pub value: Complex<f64>,
    /// A bound of its error, if the method gives one.
    pub error: Option<f64>,
    /// How it moves, if that is asked for.
    pub shape: Option<Shape>,
}

/// The entries of a mode shape, the largest of them 1; `None` if there is none that is certain.
pub type Shape = Option<Vec<Moving>>;

/// How far a coordinate moves, and how far it is ahead.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// The coordinate as a person reads it: `rθ`.
    pub shown: String,
    /// The coordinate as a program reads it: `r_theta`.
    pub name: String,
    /// Its entry of the shape.
    pub entry: Complex<f64>,
}

impl Moving {
    /// A coordinate of a section as a length.
    pub fn of_section(coordinate: Coordinate, entry: Complex<f64>) -> Self {
        let name = match coordinate {
            Coordinate::X | Coordinate::Y => coordinate.name(),
            Coordinate::Theta => "r_theta",
        };
        Moving {
            shown: length(coordinate).to_string(),
            name: name.to_string(),
            entry,
        }
    }
}

/// A coordinate as a length, as mode shapes have it: the turn θ counts as rθ.
pub fn length(coordinate: Coordinate) -> &'static str {
    match coordinate {
        Coordinate::X | Coordinate::Y => coordinate.name(),
        Coordinate::Theta => "rθ",
    }
}
