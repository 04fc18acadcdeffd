//! Why an algebraic operation has no result.

use std::fmt;

use super::budget::Exhausted;

/// Why an algebraic operation has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AlgebraError {
    /// The divisor is zero.
    DivisionByZero,
    /// The result would cost more than is allowed.
    Exhausted(Exhausted),
    /// The ring has no room for another symbol.
    TooManySymbols,
    /// The sine of a fraction of an angle whose sine is a symbol.
    FractionalAngle,
    /// A sine is asked for of what is no sum of angles with whole coefficients.
    NotAnAngle,
    /// The sign of a root depends on a sign that is not known.
    UnknownSign,
    /// What stands under a root is negative.
    NegativeRadicand,
    /// A root, a function or the angle of a vector is asked for of what is not real.
    NotReal,
}

impl fmt::Display for AlgebraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AlgebraError::DivisionByZero => f.write_str("division by zero"),
            AlgebraError::Exhausted(exhausted) => exhausted.fmt(f),
            AlgebraError::TooManySymbols => f.write_str("too many symbols"),
            AlgebraError::FractionalAngle => {
                f.write_str("a fraction of an angle whose sine is a symbol")
            }
            AlgebraError::NotAnAngle => f.write_str("not a sum of angles with whole coefficients"),
            AlgebraError::UnknownSign => f.write_str("the sign of a root is not known"),
            AlgebraError::NegativeRadicand => f.write_str("the root of a negative element"),
            AlgebraError::NotReal => f.write_str("a complex element where only real ones are"),
        }
    }
}

impl std::error::Error for AlgebraError {}

impl From<Exhausted> for AlgebraError {
    fn from(exhausted: Exhausted) -> Self {
        AlgebraError::Exhausted(exhausted)
    }
}
