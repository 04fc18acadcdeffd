//! What a language is to the rest of the crate.

use crate::evaluator::Evaluator;

use super::documentation::Comments;
use super::taken::Taken;
use super::{Error, File};

/// A language: one constant in the file of each.
pub(super) struct Printer {
    /// What it is called on the command line.
    pub name: &'static str,
    /// What it is called in a sentence.
    pub title: &'static str,
    /// The names that its texts have themselves.
    pub taken: Taken,
    /// How comments are written.
    pub comments: Comments,
    /// Evaluators become files, in no particular order.
    pub emit: fn(&[Evaluator]) -> Result<Vec<File>, Error>,
}
