//! What is wrong with documents, and what is skipped for it.

use serde::Serialize;

use crate::language::diagnostic::{Diagnostic, SourceFile};
use crate::verdict::audit::{Audit, Mistake};

/// How many mistakes are told, and how many statements that build on them; more help nobody.
pub const MOST: usize = 50;

/// A mistake in a document, as a program reads it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Message {
    /// The document.
    pub path: String,
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// Its code.
    pub kind: &'static str,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Message {
    /// What a diagnostic says of a document.
    pub fn new(diagnostic: &Diagnostic, source: &SourceFile) -> Self {
        let (line, column) = source.line_and_column(&diagnostic.span);
        Message {
            path: source.path.clone(),
            line,
            column,
            kind: diagnostic.kind.code(),
            message: diagnostic.message.clone(),
            help: diagnostic.help.clone(),
        }
    }
}

/// The mistakes in documents: the first of them, and how many there are beside.
#[derive(Clone, Debug, Default)]
pub struct Messages {
    /// The first.
    pub told: Vec<Message>,
    /// How many more there are.
    pub left_out: usize,
}

/// What is refused and what is skipped, under a heading each: `paper.md:7:4: …`, and `line 9: …`.
pub fn lists(audit: &Audit) -> Vec<(&'static str, Vec<String>)> {
    // A claim says itself that the program is at fault.
    let is_fault = |mistake: &&Mistake| {
        let span = &mistake.diagnostic.span;
        let mut faults = audit.claims.iter().filter(|claim| claim.fault);
        mistake.path == audit.path && faults.any(|claim| span.contains(&claim.label.span.start))
    };
    let mistakes = || audit.mistakes.iter().filter(|mistake| !is_fault(mistake));
    let refused = mistakes().filter_map(|mistake| {
        let source = audit.source_of(mistake)?;
        let (line, column) = source.line_and_column(&mistake.diagnostic.span);
        let (path, message) = (&mistake.path, &mistake.diagnostic.message);
        Some(format!("{path}:{line}:{column}: {message}"))
    });
    // A claim says itself why it is skipped.
    let others = || audit.skipped.iter().filter(|skipped| !skipped.is_claim);
    let skipped = others().map(|skipped| {
        let (line, what, reason) = (skipped.line, &skipped.what, &skipped.basis.reason);
        format!("line {line}: {what} {reason}")
    });
    let lists = [
        ("Refused", capped(refused, mistakes().count())),
        ("Skipped beside claims", capped(skipped, others().count())),
    ];
    let is_some = |(_, list): &(_, Vec<String>)| !list.is_empty();
    lists.into_iter().filter(is_some).collect()
}

/// The first of so many lines, and how many more there are.
fn capped(lines: impl Iterator<Item = String>, count: usize) -> Vec<String> {
    let mut told: Vec<String> = lines.take(MOST).collect();
    if count > told.len() {
        told.push(format!("and {} more", count - told.len()));
    }
    told
}
