//! Why nothing can be written.

use std::fmt;

/// Why nothing can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// A name is no ASCII identifier.
    Name(String),
    /// A name has more letters than a language keeps; how many it keeps.
    Long(String, usize),
    /// A name occurs twice among the inputs, the outputs or the evaluators.
    Twice(String),
    /// The names of two evaluators differ in nothing but underscores and the case of letters, which their
    /// files or types would not.
    Alike(String, String),
    /// A constant is beyond the doubles.
    Constant(String),
    /// The quantities of an evaluator are not those of its program.
    Quantities(String),
    /// What rests on fixed inputs alone is infinite, or no number.
    Fixed(String),
    /// An evaluator has no output.
    Nothing(String),
    /// A template failed: a bug.
    Template(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Name(name) => write!(
                f,
                "{name:?} is no name in an emitted text: it needs a letter of ASCII first, then \
                 letters, digits and _"
            ),
            Error::Long(name, most) => write!(
                f,
                "{name:?} is longer than the {most} letters of a name that are kept"
            ),
            Error::Twice(name) => write!(f, "the name {name:?} occurs twice"),
            Error::Alike(one, other) => write!(
                f,
                "the evaluators {one} and {other} differ in underscores and capital letters only"
            ),
            Error::Constant(value) => {
                let digits = value.len();
                match digits > 40 {
                    true => write!(
                        f,
                        "a constant of {digits} digits is beyond the range of a double"
                    ),
                    false => write!(f, "the constant {value} is beyond the range of a double"),
                }
            }
            Error::Quantities(name) => write!(
                f,
                "the quantities of the evaluator {name} are not the inputs and outputs of its program"
            ),
            Error::Fixed(name) => write!(
                f,
                "what is fixed in the evaluator {name} makes a divisor 0, a root imaginary or a number \
                 larger than all doubles"
            ),
            Error::Nothing(name) => write!(
                f,
                "the evaluator {name} has no output; there is nothing to compute"
            ),
            Error::Template(message) => write!(f, "a template failed: {message}"),
        }
    }
}

impl std::error::Error for Error {}
