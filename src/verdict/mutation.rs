//! Edits of one token, and whether a verdict notices them.

mod dependence;
mod edit;
mod exchange;
mod likeness;

use super::audit::{Audit, Library, Part, audit_part};
use super::claim::Verdict;
use crate::language::diagnostic::SourceFile;
use crate::language::document::read_document;
use crate::language::name::Aliases;
use crate::language::syntax::{Statement, StatementKind};

use dependence::Dependence;
pub use edit::Edit;

/// How many claims are judged before the others, as those that an edit is most likely to turn: first the nearest alone,
/// since others may take long once it is wrong what they build on.
const FIRST: [usize; 2] = [1, 4];

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

/// A statement that is edited.
pub struct Subject {
    document: usize,
    /// Its place among the statements of all documents.
    place: usize,
    /// The edits of it.
    pub edits: Vec<Edit>,
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

    /// The statements of a document that are edited, which stands at a place among all: definitions, substitutions,
    /// assumptions, systems and evaluators.
    pub fn subjects(&self, document: usize) -> Vec<Subject> {
        let before: usize = self.documents[..document].iter().map(Vec::len).sum();
        let statements = self.documents[document].iter().enumerate();
        let edited = statements.filter(|(_, own)| is_edited(&own.kind));
        edited
            .map(|(place, own)| Subject {
                document,
                place: before + place,
                edits: self.edits(document, own),
            })
            .collect()
    }

    fn edits(&self, document: usize, statement: &Statement) -> Vec<Edit> {
        let audit = &self.audits[document];
        let (text, scope) = (&audit.source().text, &audit.elaborator.scope);
        edit::edits(text, statement, audit.line_of(statement), scope)
    }

    /// What becomes of each edit of a statement: what does not build on it is not judged again, and the nearest claims
    /// come first.
    pub fn fates(&self, subject: &Subject) -> Vec<Fate> {
        let parts = self.dependence.parts(subject.place, &FIRST);
        let parts: Vec<_> = parts.into_iter().map(|own| self.sound(own)).collect();
        let edits = subject.edits.iter();
        edits.map(|edit| self.fate(subject, &parts, edit)).collect()
    }

    /// A part that is as expected before anything is edited, so that only an edit is noticed: else the whole document.
    fn sound(&self, (place, part): (usize, Part)) -> (usize, Part) {
        let audit = audit_part(self.audits[place].source(), self.library, &part);
        match audit.is_some_and(|audit| audit.as_expected()) {
            true => (place, part),
            false => (place, Part::new()),
        }
    }

    fn fate(&self, subject: &Subject, parts: &[(usize, Part)], edit: &Edit) -> Fate {
        let source = self.audits[subject.document].source();
        let texts = self.texts(subject.document, &edit.applied(&source.text));
        let declaring = self.dependence.declaring(subject.document, &edit.name());
        let is_noticed = |(place, part): &(usize, Part)| {
            let part = self.dependence.with(part, declaring);
            self.is_noticed(&texts, *place, &part)
        };
        if parts.iter().any(is_noticed) {
            return Fate::Noticed;
        }
        match self.is_equal(subject, edit, declaring) {
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

    /// Whether a definition is equal to what it was, given the statement that declares the name that is new in it.
    fn is_equal(&self, subject: &Subject, edit: &Edit, declaring: Option<usize>) -> bool {
        let Some((text, line)) = edit.compared(&self.audits[subject.document].source().text) else {
            return false;
        };
        let statements = [subject.place].into_iter().chain(declaring);
        let part = self.dependence.alone(statements, line);
        let texts = self.texts(subject.document, &text);
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
