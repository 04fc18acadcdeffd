//! Why a derived system has no answer.

use std::fmt;

/// Why there are no numbers for a system.
#[derive(Clone, Debug, PartialEq)]
pub enum SystemError {
    /// Parameters without a value.
    Missing {
        /// Their names, in order.
        names: Vec<String>,
    },
    /// Values for what is no parameter.
    Unknown {
        /// Their names, in order.
        names: Vec<String>,
        /// The names of the parameters.
        known: Vec<String>,
    },
    /// A value is too large, or too small, for a double.
    TooLarge {
        /// The name of the parameter.
        name: String,
    },
    /// The program of the system has not the outputs of its matrices.
    Outputs {
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// There is no coordinate, or there are too many.
    Coordinates {
        /// How many there are.
        found: usize,
    },
    /// A matrix has an entry that no double holds.
    Entry {
        /// The matrix: `M`, `C` or `K`.
        matrix: char,
        /// Its row, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
    },
    /// What the matrices divide by is 0, or not told from it.
    Division,
    /// A root is taken in the matrices of what is negative, or not told from that.
    Root,
    /// The determinant of the mass matrix is 0, or not told from it.
    SingularMass,
    /// No eigenvalues were found, or none with a bound of their errors.
    NoEigenvalues,
    /// A range has no width, or its ends are no numbers.
    Range {
        /// The parameter.
        name: String,
        /// What is wrong and what it must be.
        reason: &'static str,
    },
}

impl fmt::Display for SystemError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SystemError::Missing { names } => write!(
                formatter,
                "{} no value: give {}",
                listed(names, "has", "have"),
                names.iter().map(|name| format!("{name}=…")).collect::<Vec<_>>().join(", ")
            ),
            SystemError::Unknown { names, known } => write!(
                formatter,
                "{} no parameter of the system{}; its parameters are {}",
                listed(names, "is", "are"),
                suggestion(names, known),
                known.join(", ")
            ),
            SystemError::TooLarge { name } => write!(
                formatter,
                "the value of {name} is beyond the doubles, which end at 1.8e308, and at 2.2e-308 near 0: check its unit"
            ),
            SystemError::Outputs { found, expected } => write!(
                formatter,
                "the program of the system has {found} outputs where its matrices have {expected} entries: name square matrices of one size, one row and column for each coordinate"
            ),
            SystemError::Coordinates { found } => write!(
                formatter,
                "the system has {found} coordinates: it must have from 1 to {}",
                super::MOST_COORDINATES
            ),
            SystemError::Entry { matrix, row, column } => write!(
                formatter,
                "entry ({row}, {column}) of {matrix} is too large for a double: check the units of the parameters"
            ),
            SystemError::Division => formatter.write_str(
                "the matrices have no value here, since they divide by what is 0 or not told from it: change the parameters that make it vanish"
            ),
            SystemError::Root => formatter.write_str(
                "the matrices have no value here, since they take the square root of what is negative or not told from that: change the parameters under it"
            ),
            SystemError::SingularMass => formatter.write_str(
                "the determinant of the mass matrix M is 0 or not told from it, so that the accelerations do not follow: give every coordinate a mass"
            ),
            SystemError::NoEigenvalues => formatter.write_str(
                "no eigenvalues with a bounded error were found: check the units of the parameters"
            ),
            SystemError::Range { name, reason } => write!(formatter, "the range of {name} {reason}"),
        }
    }
}

impl std::error::Error for SystemError {}

/// `a has`, or `a and b have`.
fn listed(names: &[String], one: &str, several: &str) -> String {
    match names.split_last() {
        None => format!("nothing {one}"),
        Some((last, [])) => format!("{last} {one}"),
        Some((last, others)) => format!("{} and {last} {several}", others.join(", ")),
    }
}

/// What a misspelt name may be meant to be.
fn suggestion(names: &[String], known: &[String]) -> String {
    let near = |name: &String| {
        let likeness = |own: &&String| strsim::jaro_winkler(name, own);
        let best = known
            .iter()
            .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
        (likeness(&best) > 0.7).then(|| best.clone())
    };
    let found: Vec<String> = names.iter().filter_map(near).collect();
    match found.is_empty() {
        true => String::new(),
        false => format!(" (perhaps {})", found.join(", ")),
    }
}
