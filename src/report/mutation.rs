//! What became of the edits of a document.

use crate::language::diagnostic::SourceFile;
use crate::verdict::mutation::Edit;

/// The edits of a document that no verdict notices.
#[derive(Clone, Debug)]
pub struct Mutated {
    /// The document.
    pub source: SourceFile,
    /// How many edits there are.
    pub mutants: usize,
    /// How many a verdict notices.
    pub noticed: usize,
    /// How many leave what they define equal.
    pub equal: usize,
    /// The others.
    pub survivors: Vec<Edit>,
}
