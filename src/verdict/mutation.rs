//! Edits of one token, and whether a verdict notices them.

mod dependence;
mod edit;
mod likeness;

use super::audit::{Audit, Library, Part, audit_part};
use super::claim::Verdict;
use crate::language::diagnostic::SourceFile;
use crate::language::document::read_document;
use crate::language::name::Aliases;
use crate::language::syntax::{Statement, StatementKind};

use dependence::Dependence;
pub use edit::Edit;

/// How many claims are judged before the others, as those that an edit is most likely to turn.
const FIRST: usize = 4;

/// What becomes of an edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// A verdict is another one than the author expects, or a statement is refused.
    Noticed,
    /// What is defined is the same as before.
    Equal,
    /// Every verdict is as expected.
    Survives,
}

/// Documents whose every verdict is as expected, and which are edited.
pub struct Mutation<'a> {
    /// Audits of the documents, each behind those that it imports.
    audits: &'a [Audit],
    library: &'a (dyn Library + Sync),
    /// What each document says.
    documents: Vec<Vec<Statement>>,
    dependence: Dependence,
}

impl<'a> Mutation<'a> {
    /// Documents that were audited, each behind those that it imports.
    pub fn new(audits: &'a [Audit], library: &'a (dyn Library + Sync)) -> Self {
        let documents = audits.iter().map(|own| statements(own, audits));
        let documents: Vec<Vec<Statement>> = documents.collect();
        Mutation {
            audits,
            library,
            dependence: Dependence::new(audits, &documents),
            documents,
        }
    }

    /// The edits of one token in definitions, substitutions, assumptions, systems and evaluators of a document, which
    /// stands at a place among all.
    pub fn edits(&self, document: usize) -> Vec<Edit> {
        let audit = &self.audits[document];
        let statements = self.documents[document].iter();
        let statements = statements.filter(|own| is_edited(&own.kind));
        let of = |own: &Statement| {
            let line = audit.line_of(own);
            edit::edits(&audit.source().text, own, line, &audit.elaborator.scope)
        };
        statements.flat_map(of).collect()
    }

    /// What becomes of an edit of a document: claims that do not build on it are not judged, and the nearest ones come
    /// first.
    pub fn fate(&self, document: usize, edit: &Edit) -> Fate {
        let Some(statement) = self.dependence.on(document, edit.statement_line) else {
            return Fate::Noticed;
        };
        let source = self.audits[document].source();
        let texts = self.texts(document, &edit.applied(&source.text));
        let parts = self.dependence.parts(statement, FIRST);
        if parts
            .iter()
            .any(|(place, part)| self.is_noticed(&texts, *place, part))
        {
            return Fate::Noticed;
        }
        match self.is_equal(document, statement, edit) {
            true => Fate::Equal,
            false => Fate::Survives,
        }
    }

    /// The documents, one of which has another text.
    fn texts(&self, document: usize, text: &str) -> Texts<'_> {
        Texts {
            edited: SourceFile::new(self.audits[document].path.clone(), text),
            library: self.library,
        }
    }

    /// Whether a part of a document differs from what its author expects.
    fn is_noticed(&self, texts: &Texts<'_>, place: usize, part: &Part) -> bool {
        let audit = &self.audits[place];
        let source = match audit.path == texts.edited.path {
            true => &texts.edited,
            false => audit.source(),
        };
        audit_part(source, texts, part).is_none_or(|audit| !audit.as_expected())
    }

    /// Whether a definition is equal to what it was.
    fn is_equal(&self, document: usize, statement: usize, edit: &Edit) -> bool {
        let Some((text, line)) = edit.compared(&self.audits[document].source().text) else {
            return false;
        };
        let part = self.dependence.alone(statement, line);
        let texts = self.texts(document, &text);
        audit_part(&texts.edited, &texts, &part).is_some_and(|audit| {
            let claim = audit.claims.first();
            audit.mistakes.is_empty() && claim.is_some_and(|own| own.verdict == Verdict::Holds)
        })
    }
}

/// The statements that are edited.
fn is_edited(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Definition { .. }
            | StatementKind::Substitution { .. }
            | StatementKind::Assume { .. }
            | StatementKind::System(_)
            | StatementKind::Evaluator { .. }
    )
}

/// What a document says: it was understood, with the spellings of what it imports.
fn statements(audit: &Audit, audits: &[Audit]) -> Vec<Statement> {
    let mut aliases = Aliases::default();
    let imports = |own: &&Audit| own.path != audit.path && audit.imports(&own.path);
    for import in audits.iter().filter(imports) {
        aliases.extend(import.aliases());
    }
    let read = read_document(audit.source(), &aliases);
    read.map(|document| document.statements).unwrap_or_default()
}

/// A library in which one document is edited.
struct Texts<'a> {
    edited: SourceFile,
    library: &'a (dyn Library + Sync),
}

impl Library for Texts<'_> {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let found = self.library.read(path, from)?;
        match found.path == self.edited.path {
            true => Ok(self.edited.clone()),
            false => Ok(found),
        }
    }
}
