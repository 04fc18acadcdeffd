//! What is wrong, or odd, with what the user wrote: where, what, and what to do.

use std::fmt;

/// A place in a file of the user's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as the user named it.
    pub file: String,
    /// The line, from 1, if it is about one line.
    pub line: Option<usize>,
}

impl Place {
    /// A whole file.
    pub fn file(file: &str) -> Self {
        Place {
            file: file.into(),
            line: None,
        }
    }

    /// A line of a file, from 1.
    pub fn line(file: &str, line: usize) -> Self {
        Place {
            file: file.into(),
            line: Some(line),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(formatter, "{}:{line}", self.file),
            None => write!(formatter, "{}", self.file),
        }
    }
}

/// Why a case file or a table cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// Where it was seen.
    pub place: Place,
    /// What was seen.
    pub what: String,
    /// What to do about it.
    pub help: String,
}

impl InputError {
    /// An error at a place.
    pub fn new(place: Place, what: impl Into<String>, help: impl Into<String>) -> Self {
        InputError {
            place,
            what: what.into(),
            help: help.into(),
        }
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}: {}", self.place, self.what, self.help)
    }
}

impl std::error::Error for InputError {}

/// Something odd that does not stop the computation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// Where it was seen.
    pub place: Place,
    /// What was seen, and what follows from it.
    pub what: String,
}

impl fmt::Display for Remark {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}: {}", self.place, self.what)
    }
}

/// `a`, `b` or `c`, and which of them a misspelt name may mean.
pub(super) fn meant(name: &str, known: &[&str]) -> String {
    meant_among(known, name, known)
}

/// As [`meant`], but only some of them may be meant.
pub(super) fn meant_among(some: &[&str], name: &str, known: &[&str]) -> String {
    let distance =
        |own: &&&str| strsim::damerau_levenshtein(&own.to_lowercase(), &name.to_lowercase());
    let nearest = some.iter().min_by_key(distance);
    let list = known.join(", ");
    match nearest.filter(|own| distance(own) <= 1 + own.chars().count() / 3) {
        Some(nearest) => format!("did you mean {nearest}? Known are {list}"),
        None => format!("known are {list}"),
    }
}
