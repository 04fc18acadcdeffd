//! A document as it reads, with what became of each statement in its place.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::Serialize;

use super::assertion::{AssertionView, class};
use super::matching::MatchingView;
use super::mathematics::phrase;
use super::prose::{Heading, Section, sections};
use super::statement::{LineView, QuantityView, line, quantity};
use crate::derivation::audit::Audit;
use crate::derivation::document::parse_document_with;
use crate::derivation::name::Aliases;
use crate::derivation::notation::Notation;
use crate::derivation::syntax::{Statement, StatementKind};
use crate::derivation::verdict::Claim;
use crate::report::summary::Summary;
use crate::report::{residuals, words};

/// What the template is given of a document.
#[derive(Serialize)]
pub struct DocumentView {
    anchor: String,
    title: String,
    path: String,
    conclusion: String,
    as_expected: bool,
    counts: Vec<CountView>,
    /// HTML: a line a matching.
    matchings: Vec<String>,
    lists: Vec<ListView>,
    chapters: Vec<ChapterView>,
    parts: Vec<Part>,
}

#[derive(Serialize)]
struct CountView {
    class: &'static str,
    verdict: String,
    count: usize,
}

/// Claims that a reader should see first.
#[derive(Serialize)]
struct ListView {
    heading: &'static str,
    claims: Vec<ReferenceView>,
}

#[derive(Serialize)]
struct ReferenceView {
    anchor: String,
    label: String,
    description: Option<String>,
}

#[derive(Serialize)]
struct ChapterView {
    anchor: String,
    text: String,
}

/// A part of a document, in its order.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Part {
    Prose { html: String },
    Quantities { rows: Vec<QuantityView> },
    Line { line: LineView },
    Assertion { claim: Box<AssertionView> },
    Matching { matching: Box<MatchingView> },
}

impl DocumentView {
    /// What became of a document, which is the `number`-th of its page.
    pub fn new(audit: &Audit, number: usize) -> Self {
        let anchor = format!("document-{number}");
        let summary = Summary::new(audit);
        let counts = summary.counts.iter().map(|(verdict, count)| CountView {
            class: class(*verdict),
            verdict: words::verdict(*verdict),
            count: *count,
        });
        let surprises = ("Verdicts that differ", summary.surprises.as_slice());
        let lists = [surprises]
            .into_iter()
            .filter(|(_, claims)| !claims.is_empty());
        let lists = lists
            .chain(summary.failures())
            .map(|(heading, claims)| ListView {
                heading,
                claims: claims
                    .iter()
                    .map(|claim| reference(claim, &anchor))
                    .collect(),
            });
        let matchings = summary.matchings.iter().map(|matched| {
            let overview = phrase(&residuals::overview(matched, Notation::Latex));
            let overview = overview.trim_end_matches("; see sextic match");
            format!(
                "{} {overview}",
                super::escape(&words::label(&matched.label))
            )
        });
        let (parts, chapters) = parts(audit, &anchor);
        DocumentView {
            title: audit.title.clone().unwrap_or_else(|| audit.path.clone()),
            path: audit.path.clone(),
            conclusion: summary.conclusion(),
            as_expected: audit.as_expected(),
            counts: counts.collect(),
            matchings: matchings.collect(),
            lists: lists.collect(),
            chapters: chapters
                .into_iter()
                .map(|Heading { text, anchor }| ChapterView { anchor, text })
                .collect(),
            parts,
            anchor,
        }
    }

    /// Its first heading, or its path.
    pub fn title(&self) -> &str {
        &self.title
    }
}

fn reference(claim: &Claim, anchor: &str) -> ReferenceView {
    ReferenceView {
        anchor: format!("{anchor}-claim-{}", claim.label.id),
        label: words::label(&claim.label),
        description: claim.description.clone(),
    }
}

/// The prose and the statements of a document in order, and its chapters.
fn parts(audit: &Audit, anchor: &str) -> (Vec<Part>, Vec<Heading>) {
    let text = audit.sources.last().map_or("", |source| &source.text);
    let statements = statements(audit);
    let (sections, chapters) = sections(text, anchor);
    let mut parts = Vec::new();
    for section in sections {
        match section {
            Section::Prose(html) => parts.push(Part::Prose { html }),
            Section::Block(span) => block(audit, anchor, &statements, &span, &mut parts),
        }
    }
    (parts, chapters)
}

/// The statements of a document, which was read once to be judged: the documents that it imports come
/// first, with the spellings that they declare.
fn statements(audit: &Audit) -> Vec<Statement> {
    let mut aliases = Aliases::default();
    let mut statements = Vec::new();
    for source in &audit.sources {
        let Ok(document) = parse_document_with(source, &aliases) else {
            return Vec::new();
        };
        aliases.extend(&document.aliases);
        statements = document.statements;
    }
    statements
}

/// The statements of a block; declarations that follow each other share a table.
fn block(
    audit: &Audit,
    anchor: &str,
    statements: &[Statement],
    block: &Range<usize>,
    parts: &mut Vec<Part>,
) {
    let claims: BTreeMap<&str, &Claim> = audit
        .claims
        .iter()
        .map(|claim| (claim.label.id.as_str(), claim))
        .collect();
    let first = parts.len();
    let inside = statements
        .iter()
        .filter(|statement| block.contains(&statement.span.start));
    for statement in inside {
        if let Some(row) = quantity(&statement.kind) {
            match parts[first..].last_mut() {
                Some(Part::Quantities { rows }) => rows.push(row),
                _ => parts.push(Part::Quantities { rows: vec![row] }),
            }
        } else if let Some(line) = line(&statement.kind) {
            parts.push(Part::Line { line });
        }
        match &statement.kind {
            StatementKind::Assertion { label, .. } | StatementKind::Eigenpair { label, .. } => {
                parts.extend(claims.get(label.id.as_str()).map(|claim| Part::Assertion {
                    claim: Box::new(AssertionView::new(claim, anchor)),
                }));
            }
            StatementKind::Match(matching) => {
                let matched = audit.matchings.iter();
                let mut own = matched.filter(|own| own.label.id == matching.label.id);
                parts.extend(own.next().map(|matched| Part::Matching {
                    matching: Box::new(MatchingView::new(matched, anchor)),
                }));
            }
            _ => {}
        }
    }
}
