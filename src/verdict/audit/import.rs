//! Imports: each document is read once, before those that import it.

use crate::language::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use crate::language::document::{Document, read_document};
use crate::language::syntax::{Spanned, StatementKind};

use super::failed::{Failed, FailedImports};
use super::reader::Reader;
use super::{Audit, Rejected, rejected};

/// How many documents may import each other in a chain.
const MOST_OPEN: usize = 64;

impl Reader<'_> {
    /// Reads a document behind all that it imports, which may declare spellings that the rest is parsed
    /// with.
    ///
    /// # Errors
    ///
    /// [`Rejected`] where nothing of the document can be read.
    pub(super) fn read_with_imports(
        &mut self,
        source: &SourceFile,
    ) -> Result<(Document, FailedImports), Box<Rejected>> {
        let mut failed = FailedImports::new();
        loop {
            let document = read_document(source, &self.aliases)
                .map_err(|diagnostics| rejected(source, diagnostics))?;
            if self.import(&document, source, &mut failed) == 0 {
                return Ok((document, failed));
            }
        }
    }

    /// Reads the imports that were not read yet: how many there were.
    fn import(
        &mut self,
        document: &Document,
        source: &SourceFile,
        failed: &mut FailedImports,
    ) -> usize {
        let mut count = 0;
        for statement in &document.statements {
            let StatementKind::Import { path } = &statement.kind else {
                continue;
            };
            let place = statement.span.start;
            if failed.contains_key(&place) {
                continue;
            }
            match self.import_one(path, source) {
                Ok(true) => count += 1,
                Ok(false) => {}
                Err(diagnostic) => {
                    let path = path.clone();
                    failed.insert(place, Failed { path, diagnostic });
                }
            }
        }
        count
    }

    /// Reads a document that is imported: whether it was not read before.
    fn import_one(
        &mut self,
        path: &Spanned<String>,
        source: &SourceFile,
    ) -> Result<bool, Option<Diagnostic>> {
        let imported = self.library.read(&path.value, &source.path);
        let imported = imported.map_err(|reason| Some(missing(path, reason)))?;
        let is_imported = |known: &SourceFile| known.path == imported.path;
        if self.unreadable.contains(&imported.path) {
            return Err(None);
        }
        if self.finished.iter().any(is_imported) {
            return Ok(false);
        }
        if self.open.contains(&imported.path) || imported.path == source.path {
            let mut chain = self.open.clone();
            chain.extend([source.path.clone(), imported.path.clone()]);
            return Err(Some(circular(path, &imported, &chain)));
        }
        if self.open.len() >= MOST_OPEN {
            return Err(Some(too_deep(path)));
        }
        if self.go_on_from(&imported) {
            return Ok(true);
        }
        self.open.push(source.path.clone());
        let read = self.read(&imported);
        self.open.pop();
        let unreadable = read.err();
        let is_readable = unreadable.is_none();
        for diagnostic in unreadable.into_iter().flat_map(|own| own.diagnostics) {
            self.refusals.note(diagnostic, &imported.path);
            self.unreadable.insert(imported.path.clone());
        }
        self.finished.push(imported);
        is_readable.then_some(true).ok_or(None)
    }

    /// Takes over all that an earlier audit read, where nothing was read yet: the names and the ring are
    /// what reading the document anew would make them.
    fn go_on_from(&mut self, imported: &SourceFile) -> bool {
        let known = |audit: &&Audit| audit.sources.last() == Some(imported);
        let Some(known) = self.earlier.iter().find(known) else {
            return false;
        };
        if !self.finished.is_empty() || !self.refusals.mistakes.is_empty() || known.was_read_again {
            return false;
        }
        self.elaborator = known.elaborator.clone();
        self.assumptions.clone_from(&known.assumptions);
        self.declarations.clone_from(&known.declarations);
        self.finished.clone_from(&known.sources);
        self.unreadable.clone_from(&known.unreadable);
        self.aliases = known.aliases.clone();
        self.evaluators.clone_from(&known.all_evaluators);
        self.systems.clone_from(&known.all_systems);
        self.domain = known.domain.clone();
        self.refusals = known.refusals.clone();
        true
    }
}

/// What follows is said once, and not of every name that is then not known.
const LOST: &str =
    "what builds on a name that is not known is skipped, since it may come from there";

fn missing(path: &Spanned<String>, reason: String) -> Diagnostic {
    let message = format!("`{}` cannot be imported", path.value);
    Diagnostic::new(DiagnosticKind::MissingFile, path.span.clone(), message)
        .with_label(reason)
        .with_help(format!(
            "the path is relative to the document that imports; {LOST}"
        ))
}

fn circular(path: &Spanned<String>, imported: &SourceFile, chain: &[String]) -> Diagnostic {
    let message = format!("`{}` imports itself", imported.path);
    Diagnostic::new(DiagnosticKind::CircularImport, path.span.clone(), message)
        .with_label(chain.join(" → "))
        .with_help(format!("move what both need into a third document; {LOST}"))
}

fn too_deep(path: &Spanned<String>) -> Diagnostic {
    let message = format!("more than {MOST_OPEN} documents import each other in a chain");
    Diagnostic::new(DiagnosticKind::Budget, path.span.clone(), message)
        .with_label("not read")
        .with_help(format!("import the last of them directly; {LOST}"))
}
