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

/// The most characters of an input that a message repeats.
const MOST_QUOTED: usize = 60;

/// A part of an input as a message repeats it: its first line, cut off behind 60 characters, with what would change
/// the look of the message written as its code.
///
/// ```
/// use sextic::stability::input::quoted;
///
/// assert_eq!(quoted("0.25 m"), "0.25 m");
/// assert_eq!(quoted("a\u{1b}[31mb"), "a\\u{1b}[31mb");
/// assert_eq!(quoted(&"9".repeat(1_000_000)).chars().count(), 61);
/// assert_eq!(quoted("one line\nand another"), "one line…");
/// ```
pub fn quoted(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    let end = line.char_indices().nth(MOST_QUOTED);
    let shown = &line[..end.map_or(line.len(), |(end, _)| end)];
    let rest = if shown.len() < text.len() { "…" } else { "" };
    plain(shown) + rest
}

/// The most characters of a path, or of what a library says of an input, at either end.
const MOST_SHOWN: usize = 150;

/// A path, or what a library says of an input, without its middle where it is longer than any that helps.
pub fn shortened(text: &str) -> String {
    let head = text.char_indices().nth(MOST_SHOWN);
    let tail = text.char_indices().nth_back(MOST_SHOWN);
    match (head, tail) {
        (Some((head, _)), Some((tail, _))) if head < tail => {
            format!("{}…{}", plain(&text[..head]), plain(&text[tail..]))
        }
        _ => plain(text),
    }
}

/// A text with what would change its look written as its code.
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for own in text.chars() {
        match changes_the_look(own) {
            true => plain.extend(own.escape_unicode()),
            false => plain.push(own),
        }
    }
    plain
}

/// Control codes, what is not seen, and what turns the direction of writing.
fn changes_the_look(own: char) -> bool {
    own.is_control()
        || matches!(own, '\u{ad}' | '\u{61c}' | '\u{feff}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}')
}

/// `a`, `b` or `c`, and which of them a misspelt name may mean.
pub(super) fn meant(name: &str, known: &[&str]) -> String {
    meant_among(known, name, known)
}

/// As [`meant`], but only some of them may be meant.
pub(super) fn meant_among(some: &[&str], name: &str, known: &[&str]) -> String {
    let distance =
        |own: &&&str| strsim::damerau_levenshtein(&own.to_lowercase(), &name.to_lowercase());
    let list = known.join(", ");
    // What is far longer than all of them is none of them, and would take long to be compared.
    let is_long = name.chars().nth(MOST_QUOTED).is_some();
    let nearest = some.iter().filter(|_| !is_long).min_by_key(distance);
    match nearest.filter(|own| distance(own) <= 1 + own.chars().count() / 3) {
        Some(nearest) => format!("did you mean {nearest}? Known are {list}"),
        None => format!("known are {list}"),
    }
}
