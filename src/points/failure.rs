//! Why an expression has no value at an assignment, or none that can be found.

use std::fmt;

/// Why there is no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
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
    /// An enclosure is too wide to tell a sign.
    UnknownSign,
    /// The graph, or a number, becomes too large.
    TooLarge,
    /// Definitions rest on each other too deeply.
    TooDeep,
    /// An expansion does not exist where the small quantities vanish.
    NoExpansion,
    /// What should be a polynomial is none of a degree that is followed.
    NoPolynomial,
    /// The sine of something that is no sum of angles is taken.
    NotAnAngle,
    /// A variable is needed, and something else stands there.
    NoVariable,
    /// Whether two expressions are equal everywhere could not be found out.
    UnknownIdentity,
    /// Something in the expression is not known to this route.
    Unsupported,
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Failure::DivisionByZero => "something is divided by 0",
            Failure::NegativeRadicand => "the root of a negative number",
            Failure::ZeroVector => "the angle of a vector that vanishes",
            Failure::NotReal => "a complex number where only real ones have a meaning",
            Failure::Singular => "a matrix is singular",
            Failure::UnknownSign => "the sign of a number is not known there",
            Failure::TooLarge => "it becomes too large",
            Failure::TooDeep => "definitions rest on each other too deeply",
            Failure::NoExpansion => "there is no expansion where the small quantities vanish",
            Failure::NoPolynomial => "it is no polynomial of a degree below 37",
            Failure::NotAnAngle => "the sine of what is no sum of angles",
            Failure::NoVariable => {
                "something other than a variable is replaced or differentiated by"
            }
            Failure::UnknownIdentity => "whether two arguments are equal cannot be told",
            Failure::Unsupported => "it cannot be evaluated at a point",
        })
    }
}
