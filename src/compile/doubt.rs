//! Why a text is not proven to compute what was derived.

use std::fmt;

use crate::algebra::error::AlgebraError;

use super::reading::Unreadable;

/// Why a body is not proven to compute what was derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It is not one of the texts that can be read.
    Unreadable(Unreadable),
    /// It has other inputs or outputs than the evaluator.
    Interface(String),
    /// A name is used before it is assigned, or assigned twice.
    Name(String),
    /// A literal is another number to a compiler than it is to a reader.
    Literal(String),
    /// An output differs from what was derived.
    Different(String),
    /// An output is computed by other operations than those of the program.
    Operations(String),
    /// The algebra cannot follow it.
    Algebra(AlgebraError),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Unreadable(unreadable) => unreadable.fmt(f),
            Reason::Interface(what) | Reason::Name(what) | Reason::Literal(what) => {
                f.write_str(what)
            }
            Reason::Different(output) => {
                write!(f, "the output `{output}` differs from what was derived")
            }
            Reason::Operations(output) => write!(
                f,
                "the output `{output}` is computed by other operations than those of the program"
            ),
            Reason::Algebra(error) => write!(f, "the algebra cannot follow it: {error}"),
        }
    }
}

impl std::error::Error for Reason {}

impl From<AlgebraError> for Reason {
    fn from(error: AlgebraError) -> Self {
        Reason::Algebra(error)
    }
}

/// Why emitted files are not proven to compute what was derived, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Doubt {
    /// The file, and the function in it where that is known.
    pub place: String,
    /// What is wrong there.
    pub reason: Reason,
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            Reason::Unreadable(unreadable) => write!(f, "{}, {unreadable}", self.place),
            reason => write!(f, "{}: {reason}", self.place),
        }
    }
}

impl std::error::Error for Doubt {}
