//! Imports: each document is read once, before those that import it.

use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use crate::derivation::document::Document;
use crate::derivation::syntax::{Spanned, StatementKind};

use super::reader::Reader;
use super::{Audit, Rejected, rejected};

impl Reader<'_> {
    /// Reads the imports that were not read yet: how many there were.
    pub(super) fn import(
        &mut self,
        document: &Document,
        source: &SourceFile,
    ) -> Result<usize, Box<Rejected>> {
        let mut count = 0;
        for statement in &document.statements {
            let StatementKind::Import { path } = &statement.kind else {
                continue;
            };
            let reject = |diagnostic| rejected(source, vec![diagnostic]);
            let imported = self
                .library
                .read(&path.value, &source.path)
                .map_err(|reason| reject(missing(path, reason)))?;
            if self
                .finished
                .iter()
                .any(|known| known.path == imported.path)
            {
                continue;
            }
            if self.open.contains(&imported.path) || imported.path == source.path {
                let mut chain = self.open.clone();
                chain.extend([source.path.clone(), imported.path.clone()]);
                return Err(reject(circular(path, &imported, &chain)));
            }
            count += 1;
            if self.go_on_from(&imported) {
                continue;
            }
            self.open.push(source.path.clone());
            self.read(&imported)?;
            self.open.pop();
            self.finished.push(imported);
        }
        Ok(count)
    }

    /// Takes over all that an earlier audit read, where nothing was read yet: the names and the ring are
    /// what reading the document anew would make them.
    fn go_on_from(&mut self, imported: &SourceFile) -> bool {
        let known = |audit: &&Audit| audit.sources.last() == Some(imported);
        let Some(known) = self.earlier.iter().find(known) else {
            return false;
        };
        if !self.finished.is_empty() {
            return false;
        }
        self.elaborator = known.elaborator.clone();
        self.assumptions.clone_from(&known.assumptions);
        self.finished.clone_from(&known.sources);
        self.aliases = known.aliases.clone();
        self.evaluators.clone_from(&known.all_evaluators);
        self.domain = known.domain.clone();
        true
    }
}

fn missing(path: &Spanned<String>, reason: String) -> Diagnostic {
    let message = format!("`{}` cannot be imported", path.value);
    Diagnostic::new(DiagnosticKind::MissingFile, path.span.clone(), message)
        .with_label(reason)
        .with_help("the path is relative to the document that imports")
}

fn circular(path: &Spanned<String>, imported: &SourceFile, chain: &[String]) -> Diagnostic {
    let message = format!("`{}` imports itself", imported.path);
    Diagnostic::new(DiagnosticKind::CircularImport, path.span.clone(), message)
        .with_label(chain.join(" → "))
        .with_help("move what both need into a third document")
}
