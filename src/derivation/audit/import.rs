//! Imports: each document is read once, before those that import it.

use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use crate::derivation::document::Document;
use crate::derivation::syntax::{Spanned, StatementKind};

use super::reader::Reader;
use super::{Rejected, rejected};

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
            self.open.push(source.path.clone());
            self.read(&imported)?;
            self.open.pop();
            self.finished.push(imported);
            count += 1;
        }
        Ok(count)
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
