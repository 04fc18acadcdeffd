//! A document, read from its first statement to its last.

mod compiled;
mod declaration;
mod failed;
mod import;
mod judgement;
mod reader;
mod refusal;
mod showing;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::claim::Claim;
use super::explanation::Explanation;
use crate::derivation::domain::Domain;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::matching::Matched;
use crate::derivation::shown::Shown;
use crate::language::diagnostic::{Diagnostic, SourceFile, render};
use crate::language::evaluator::Evaluator;
use crate::language::mention::Mention;
use crate::language::name::Aliases;
use crate::language::syntax::{Name, Relation, Sign, Span, Statement};
use crate::language::system::System;

use failed::FailedMatchings;
use reader::Reader;
use refusal::Refusals;

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
    /// What it shows, in order.
    pub shown: Vec<Shown>,
    /// What it wants compiled itself, in order.
    pub evaluators: Vec<Evaluator>,
    /// The systems that it wants computed itself, in order.
    pub systems: Vec<System>,
    /// Where its quantities lie in practice.
    pub domain: Domain,
    /// What it and its imports assume beside the signs of quantities, in order.
    pub assumptions: Vec<Assumption>,
    /// Where it and its imports would assume something that is refused, in order.
    pub refused_assumptions: Vec<Place>,
    /// The signs that it and its imports declare, in order.
    pub declarations: Vec<Declaration>,
    /// The mistakes in it and in its imports: those of imports first, and each document's in order.
    pub mistakes: Vec<Mistake>,
    /// Its statements that are well and build on refused ones, in order; assertions are claims too.
    pub skipped: Vec<Skipped>,
    /// The names and the ring that all of this is about.
    pub elaborator: Elaborator,
    /// The spellings that it and its imports declare.
    aliases: Aliases,
    /// What it and its imports want compiled.
    all_evaluators: Vec<Evaluator>,
    /// The systems that it and its imports want computed, in order.
    pub all_systems: Vec<System>,
    /// Of it and its imports: what has no meaning, as far as reading tells.
    refusals: Refusals,
    /// The imports of which nothing could be read.
    unreadable: BTreeSet<String>,
    /// Whether matchings were refused that reading it once does not refuse.
    was_read_again: bool,
}

/// A line of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The document.
    pub path: String,
    /// The line, counted from 1.
    pub line: usize,
}

/// What a document assumes.
#[derive(Clone, Debug)]
pub struct Assumption {
    /// What is assumed.
    pub relation: Relation,
    /// Why, in words.
    pub description: Option<String>,
    /// Where.
    pub place: Place,
}

impl Assumption {
    /// The names in it.
    pub(super) fn names(&self) -> Vec<Name> {
        let mut mentions: Vec<Mention> = Vec::new();
        for side in [&self.relation.left, &self.relation.right] {
            side.collect_mentions(&mut mentions);
        }
        mentions.into_iter().map(|mention| mention.name).collect()
    }
}

/// What a document declares of the sign of quantities.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// The quantities.
    pub names: Vec<Name>,
    /// Their sign.
    pub sign: Sign,
    /// Where.
    pub place: Place,
}

/// A mistake in a document, which costs the statement in which it is, and what builds on that.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// The document: one of the sources of the audit.
    pub path: String,
    /// What is wrong.
    pub diagnostic: Diagnostic,
}

/// A statement that is well and builds on a refused one.
#[derive(Clone, Debug)]
pub struct Skipped {
    /// Where it stands.
    pub span: Span,
    /// The line on which it stands.
    pub line: usize,
    /// Whether it is an assertion, and so a claim too.
    pub is_claim: bool,
    /// What it is: `the definition of K`.
    pub what: String,
    /// What it builds on.
    pub basis: Basis,
}

/// A refused statement, as others see it that build on it.
#[derive(Clone, Debug)]
pub struct Basis {
    /// The name that has no meaning; nothing for an assumption.
    pub name: Option<Name>,
    /// Where the refused statement stands.
    pub place: Place,
    /// What a statement does that builds on it: `builds on K, which line 7 would declare`.
    pub reason: String,
}

impl Audit {
    /// Whether there is no mistake, and every verdict is the one that the author expects.
    pub fn as_expected(&self) -> bool {
        self.mistakes.is_empty() && self.claims.iter().all(Claim::as_expected)
    }

    /// The document in which a mistake is.
    pub fn source_of(&self, mistake: &Mistake) -> Option<&SourceFile> {
        let mut sources = self.sources.iter();
        sources.find(|source| source.path == mistake.path)
    }

    /// Its text.
    ///
    /// # Panics
    ///
    /// Never: an audit has read its document last.
    pub fn source(&self) -> &SourceFile {
        let last = self.sources.last();
        last.expect("an audit has read its document last")
    }

    /// Whether it imports another document, also through others.
    pub fn imports(&self, path: &str) -> bool {
        path != self.path && self.sources.iter().any(|own| own.path == path)
    }

    /// The line on which one of its statements begins.
    pub(crate) fn line_of(&self, statement: &Statement) -> usize {
        self.source().line_and_column(&statement.span).0
    }

    /// The names that the document and its imports declare.
    pub fn names(&self) -> impl Iterator<Item = &Name> {
        let entries = self.elaborator.scope.entries();
        entries.map(|entry| &entry.name)
    }

    /// The spellings that it and its imports declare.
    pub fn aliases(&self) -> &Aliases {
        &self.aliases
    }

    /// How the verdict on one of its claims was reached.
    pub fn explain(&self, claim: &Claim) -> Explanation {
        self.elaborator.explain(claim)
    }
}

/// A document of which nothing can be read: it is too large, or has no statement.
#[derive(Clone, Debug)]
pub struct Rejected {
    /// The document.
    pub source: SourceFile,
    /// What is wrong with it.
    pub diagnostics: Vec<Diagnostic>,
}

impl fmt::Display for Rejected {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown = self.diagnostics.iter();
        let shown: Vec<String> = shown.map(|own| render(own, &self.source, false)).collect();
        formatter.write_str(shown.concat().trim_end())
    }
}

impl std::error::Error for Rejected {}

/// Reads a document and gives the verdict on each of its assertions; a mistake costs the statement in
/// which it is, and what builds on that.
///
/// # Errors
///
/// [`Rejected`] where nothing of the document can be read.
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
    audit_some(earlier, source, library, None)
}

/// Some statements of documents, by the paths of these: the lines on which they begin. Of other documents all are read.
pub(super) type Part = BTreeMap<String, BTreeSet<usize>>;

/// Reads some statements of a document and its imports, as if the others were not there; nothing where nothing can be
/// read.
pub(super) fn audit_part(source: &SourceFile, library: &dyn Library, part: &Part) -> Option<Audit> {
    audit_some(&[], source, library, Some(part)).ok()
}

fn audit_some(
    earlier: &[Audit],
    source: &SourceFile,
    library: &dyn Library,
    part: Option<&Part>,
) -> Result<Audit, Box<Rejected>> {
    let mut failed = FailedMatchings::new();
    // A matching that does not stand is refused from the beginning, so that nothing rests on it.
    let (mut reader, read, refusals, claims) = loop {
        let mut reader = Reader::new(library, earlier, failed.clone(), part);
        let mut read = reader.read(source)?;
        let refusals = reader.refusals.clone();
        let (claims, more) = reader.judge(&mut read);
        if more.is_empty() {
            break (reader, read, refusals, claims);
        }
        failed.extend(more);
    };
    reader.finished.push(source.clone());
    Ok(Audit {
        path: source.path.clone(),
        title: read.title,
        claims,
        matchings: read.matchings,
        shown: read.shown,
        evaluators: read.evaluators,
        systems: read.systems,
        mistakes: in_order(reader.refusals.mistakes, &reader.finished),
        skipped: read.skipped,
        sources: reader.finished,
        domain: reader.domain,
        assumptions: reader.assumptions,
        refused_assumptions: refusals.assumptions(),
        declarations: reader.declarations,
        elaborator: reader.elaborator,
        aliases: reader.aliases,
        all_evaluators: reader.evaluators,
        all_systems: reader.systems,
        refusals,
        unreadable: reader.unreadable,
        was_read_again: !failed.is_empty(),
    })
}

/// The mistakes of each document together, in the order of their places.
fn in_order(mut mistakes: Vec<Mistake>, sources: &[SourceFile]) -> Vec<Mistake> {
    let number = |path: &str| sources.iter().position(|source| source.path == path);
    mistakes.sort_by_cached_key(|own| (number(&own.path), own.diagnostic.span.start));
    mistakes
}

fn rejected(source: &SourceFile, diagnostics: Vec<Diagnostic>) -> Box<Rejected> {
    Box::new(Rejected {
        source: source.clone(),
        diagnostics,
    })
}
