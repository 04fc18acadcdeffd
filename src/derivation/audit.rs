//! A document, read from its first statement to its last.

mod declaration;
mod import;
mod reader;

use super::diagnostic::{Diagnostic, SourceFile};
use super::domain::Domain;
use super::elaboration::Elaborator;
use super::evaluator::Evaluator;
use super::explanation::Explanation;
use super::judge::Judge;
use super::matching::Matched;
use super::name::Aliases;
use super::syntax::{Name, Relation};
use super::verdict::Claim;

use reader::Reader;

/// How many steps of the algebra one statement may take.
pub const STEPS: u64 = 50_000_000;

/// Where imported documents come from; the derivation itself reads no files.
pub trait Library {
    /// The document that `path` names when `from` imports it.
    ///
    /// # Errors
    ///
    /// Why it cannot be had, in a few words.
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String>;
}

/// What became of a document.
#[derive(Debug)]
pub struct Audit {
    /// How the document is called.
    pub path: String,
    /// The documents that it imports, and itself last.
    pub sources: Vec<SourceFile>,
    /// Its first heading.
    pub title: Option<String>,
    /// Its assertions, in order.
    pub claims: Vec<Claim>,
    /// Its matchings, in order.
    pub matchings: Vec<Matched>,
    /// What it wants compiled itself, in order.
    pub evaluators: Vec<Evaluator>,
    /// Where its quantities lie in practice.
    pub domain: Domain,
    /// What it assumes beside the signs of its quantities, in order.
    pub assumptions: Vec<Relation>,
    /// The names and the ring that all of this is about.
    pub elaborator: Elaborator,
    /// The spellings that it and its imports declare.
    aliases: Aliases,
    /// What it and its imports want compiled.
    all_evaluators: Vec<Evaluator>,
}

impl Audit {
    /// Whether every verdict is the one that the author expects.
    pub fn as_expected(&self) -> bool {
        self.claims.iter().all(Claim::as_expected)
    }

    /// The names that the document and its imports declare.
    pub fn names(&self) -> impl Iterator<Item = &Name> {
        let entries = self.elaborator.scope.entries();
        entries.map(|entry| &entry.name)
    }

    /// How the verdict on one of its claims was reached.
    pub fn explain(&self, claim: &Claim) -> Explanation {
        self.elaborator.explain(claim)
    }
}

/// A document that could not be read to its end: the file in which the mistakes are, and the mistakes.
#[derive(Clone, Debug)]
pub struct Rejected {
    /// The document, or one that it imports.
    pub source: SourceFile,
    /// What is wrong with it.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a document and gives the verdict on each of its assertions.
///
/// # Errors
///
/// [`Rejected`] where the document, or one that it imports, does not make sense.
pub fn audit(source: &SourceFile, library: &dyn Library) -> Result<Audit, Box<Rejected>> {
    audit_after(&[], source, library)
}

/// The same as [`audit`], without reading what was audited before once more: a document that begins
/// with the import of an earlier one goes on from where that ended.
///
/// # Errors
///
/// Those of [`audit`].
pub fn audit_after(
    earlier: &[Audit],
    source: &SourceFile,
    library: &dyn Library,
) -> Result<Audit, Box<Rejected>> {
    let reject = |diagnostic| rejected(source, vec![diagnostic]);
    let mut reader = Reader::new(library, earlier);
    let read = reader.read(source)?;
    let signs = reader.signs();
    let mut judge = Judge::new(&reader.elaborator.scope, &reader.assumptions, signs);
    let claims = judge
        .judge_all(&read.findings, &read.checks)
        .map_err(reject)?;
    let mut sources = reader.finished;
    sources.push(source.clone());
    Ok(Audit {
        path: source.path.clone(),
        sources,
        title: read.title,
        claims,
        matchings: read.matchings,
        evaluators: read.evaluators,
        domain: reader.domain,
        assumptions: reader.assumptions,
        elaborator: reader.elaborator,
        aliases: reader.aliases,
        all_evaluators: reader.evaluators,
    })
}

fn rejected(source: &SourceFile, diagnostics: Vec<Diagnostic>) -> Box<Rejected> {
    Box::new(Rejected {
        source: source.clone(),
        diagnostics,
    })
}
