//! Why a section has no answer.

use std::fmt;

/// Why there is no section, or no answer for it.
#[derive(Clone, Debug, PartialEq)]
pub enum StabilityError {
    /// A parameter is out of its range.
    Parameter {
        /// Its name as on the command line: `L_g`.
        name: &'static str,
        /// Its value, in SI units.
        value: f64,
        /// What it must be, as it follows on "must be".
        must_be: String,
    },
    /// No coordinate is free.
    NothingIsFree,
    /// Aerodynamic stiffness is asked for, and S_a is given in place of the coefficients it follows from.
    StiffnessWithoutCoefficients,
    /// The parameters are finite, but the matrices made of them are not.
    OutOfRange,
    /// No remedy gave eigenvalues whose error is bounded.
    NoEigenvalues,
    /// S is not certain to a thousandth of |S_a|.
    WeakWind,
}

impl fmt::Display for StabilityError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StabilityError::Parameter {
                name,
                value,
                must_be,
            } => write!(
                formatter,
                "{name} = {value} must be {must_be}: correct {name}; values are in SI units and radians"
            ),
            StabilityError::NothingIsFree => write!(
                formatter,
                "no coordinate is free: name at least one of x, y, theta"
            ),
            StabilityError::StiffnessWithoutCoefficients => write!(
                formatter,
                "aerodynamic stiffness does not follow from the scaled damping matrix: give force coefficients and \
                 their derivatives, or leave the stiffness out"
            ),
            StabilityError::OutOfRange => write!(
                formatter,
                "the matrices of the section are too large or too small for doubles: check the units of its parameters"
            ),
            StabilityError::WeakWind => write!(
                formatter,
                "the wind is so weak beside the stiffness that S is not certain to a thousandth of |S_a|: give a higher wind speed"
            ),
            StabilityError::NoEigenvalues => write!(
                formatter,
                "no eigenvalues with a bounded error were found: check the units of the parameters"
            ),
        }
    }
}

impl std::error::Error for StabilityError {}
