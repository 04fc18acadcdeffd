//! Why an expression has no value at an assignment, or none that is known.

use std::fmt;

/// Why no value is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// There certainly is none.
    NoValue(NoValue),
    /// There may be one.
    Unknown(Unknown),
}

/// Why there certainly is no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoValue {
    /// Something is divided by 0.
    DivisionByZero,
    /// The root of a number below 0 is taken.
    NegativeRadicand,
    /// The angle of the vector (0, 0) is taken.
    ZeroVector,
    /// What takes real numbers gets another one.
    NotReal,
    /// A matrix that is to be inverted is singular.
    Singular,
    /// A function is expanded where it is not smooth.
    NotSmooth,
}

/// Why a value is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// No number has the signs that are declared and assumed.
    NoAssignment,
    /// An enclosure is too wide to tell a sign.
    Sign,
    /// The graph, or a number, becomes too large.
    TooLarge,
    /// Definitions rest on each other too deeply.
    TooDeep,
    /// Too few terms of an expansion are found.
    NoExpansion,
    /// What should be a polynomial is not seen to be one of a degree that is followed.
    NoPolynomial,
    /// A step that was chosen to find the value fails where the value itself may exist.
    Detour,
    /// The sine of something that is no sum of angles is taken.
    NotAnAngle,
    /// A variable is needed, and something else stands there.
    NoVariable,
    /// Whether two expressions are equal everywhere could not be found out.
    Identity,
    /// The shapes of matrices do not fit.
    Shape,
    /// Something in the expression is not known to this route.
    Unsupported,
}

impl From<NoValue> for Failure {
    fn from(why: NoValue) -> Self {
        Failure::NoValue(why)
    }
}

impl From<Unknown> for Failure {
    fn from(why: Unknown) -> Self {
        Failure::Unknown(why)
    }
}

impl Failure {
    /// The failure of a step that the value does not ask for.
    pub fn of_detour(self) -> Failure {
        match self {
            Failure::NoValue(_) => Unknown::Detour.into(),
            Failure::Unknown(_) => self,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::NoValue(why) => why.fmt(formatter),
            Failure::Unknown(why) => why.fmt(formatter),
        }
    }
}

impl fmt::Display for NoValue {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            NoValue::DivisionByZero => "something is divided by 0",
            NoValue::NegativeRadicand => "the root of a negative number",
            NoValue::ZeroVector => "the angle of a vector that vanishes",
            NoValue::NotReal => "a complex number where only real ones have a meaning",
            NoValue::Singular => "a matrix is singular",
            NoValue::NotSmooth => "there is no expansion where the small quantities vanish",
        })
    }
}

impl fmt::Display for Unknown {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Unknown::NoAssignment => "no number has the sign that it must have",
            Unknown::Sign => "the sign of a number is not known there",
            Unknown::TooLarge => "it becomes too large",
            Unknown::TooDeep => "definitions rest on each other too deeply",
            Unknown::NoExpansion => "no expansion was found where the small quantities vanish",
            Unknown::NoPolynomial => "it is not seen to be a polynomial of a degree below 37",
            Unknown::Detour => "a step to its value fails there",
            Unknown::NotAnAngle => "the sine of what is no sum of angles",
            Unknown::NoVariable => {
                "something other than a variable is replaced or differentiated by"
            }
            Unknown::Identity => "whether two arguments are equal cannot be told",
            Unknown::Shape => "the shapes of matrices do not fit",
            Unknown::Unsupported => "it cannot be evaluated at a point",
        })
    }
}
