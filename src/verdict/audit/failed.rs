//! Imports and matchings that give nothing.

use std::collections::BTreeMap;

use crate::language::diagnostic::Diagnostic;
use crate::language::syntax::Spanned;

/// An import that gives nothing.
pub(super) struct Failed {
    /// The path as the document writes it.
    pub(super) path: Spanned<String>,
    /// Why; nothing where the imported document says it.
    pub(super) diagnostic: Option<Diagnostic>,
}

/// The imports that give nothing, by their places.
pub(super) type FailedImports = BTreeMap<usize, Failed>;

/// What is wrong with matchings, by their document and the place of their label.
pub(super) type FailedMatchings = BTreeMap<(String, usize), Diagnostic>;
