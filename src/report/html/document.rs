//! A document as it reads, with what became of each statement in its place.

use std::ops::Range;

use serde::Serialize;

use super::assertion::{AssertionView, class};
use super::matching::MatchingView;
use super::mathematics::phrase;
use super::prose::{Heading, Section, sections};
use super::shown::ShownView;
use super::statement::{LineView, QuantityView, line, quantity};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::document::read_document;
use crate::language::intent::Unread;
use crate::language::name::Aliases;
use crate::language::notation::Notation;
use crate::language::syntax::{Statement, StatementKind};
use crate::report::summary::Summary;
use crate::report::{premises, refusals, residuals, words};
use crate::verdict::audit::Audit;
use crate::verdict::claim::Claim;

/// What the template is given of a document.
#[derive(Serialize)]
pub struct DocumentView {
    anchor: String,
    title: String,
    path: String,
    conclusion: String,
    as_expected: bool,
    counts: Vec<CountView>,
    /// HTML: what the verdicts stand under, a line each.
    premises: Vec<String>,
    /// HTML: a line a matching.
    matchings: Vec<String>,
    /// What is refused, and what is skipped for it.
    refusals: Vec<RefusalsView>,
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

/// What is refused or skipped, a line each.
#[derive(Serialize)]
struct RefusalsView {
    heading: &'static str,
    lines: Vec<String>,
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
    Shown { shown: Box<ShownView> },
    Refused { statement: RefusedView },
}

/// A statement or a block that is refused or skipped.
#[derive(Serialize)]
struct RefusedView {
    /// `refused` or `skipped`.
    word: &'static str,
    line: usize,
    /// The text of the document, as long as fits.
    source: String,
    reason: String,
}

/// Of a refused statement, so many characters are shown.
const MOST_SOURCE: usize = 400;

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
            premises: premises::lines(audit, Notation::Latex)
                .iter()
                .map(|(keyword, line)| format!("{keyword} {}", phrase(line)))
                .collect(),
            matchings: matchings.collect(),
            refusals: refusals::lists(audit)
                .into_iter()
                .map(|(heading, lines)| RefusalsView { heading, lines })
                .collect(),
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
    let (statements, unread) = statements(audit);
    let document = Judged {
        audit,
        anchor,
        text,
        statements,
        unread,
    };
    let (sections, chapters) = sections(text, anchor);
    let mut parts = Vec::new();
    for section in sections {
        match section {
            Section::Prose(html) => parts.push(Part::Prose { html }),
            Section::Block(span) => document.block(&span, &mut parts),
        }
    }
    (parts, chapters)
}

/// The statements of a document, which was read once to be judged, and what is not understood of it: the
/// documents that it imports come first, with the spellings that they declare.
fn statements(audit: &Audit) -> (Vec<Statement>, Vec<Unread>) {
    let mut aliases = Aliases::default();
    let mut last = (Vec::new(), Vec::new());
    for source in &audit.sources {
        if let Ok(document) = read_document(source, &aliases) {
            aliases.extend(&document.aliases);
            last = (document.statements, document.unread);
        }
    }
    last
}

/// A document and what became of it.
struct Judged<'a> {
    audit: &'a Audit,
    anchor: &'a str,
    text: &'a str,
    statements: Vec<Statement>,
    unread: Vec<Unread>,
}

impl Judged<'_> {
    /// The statements of a block; declarations that follow each other share a table.
    fn block(&self, block: &Range<usize>, parts: &mut Vec<Part>) {
        let first = parts.len();
        let inside = self.statements.iter();
        let inside = inside.filter(|statement| block.contains(&statement.span.start));
        let mut found: Vec<(usize, Part)> = Vec::new();
        for statement in inside {
            let place = statement.span.start;
            let own = self.refused(statement).map_or_else(
                || self.carried_out(statement),
                |statement| vec![Part::Refused { statement }],
            );
            found.extend(own.into_iter().map(|part| (place, part)));
        }
        let unread = self.unread.iter();
        for unread in unread.filter(|unread| block.contains(&unread.span.start)) {
            let message = &unread.diagnostic.message;
            let statement = self.shown("refused", &unread.span, message.clone());
            found.push((unread.span.start, Part::Refused { statement }));
        }
        found.sort_by_key(|(place, _)| *place);
        for (_, part) in found {
            match (parts[first..].last_mut(), part) {
                (Some(Part::Quantities { rows }), Part::Quantities { rows: more }) => {
                    rows.extend(more);
                }
                (_, part) => parts.push(part),
            }
        }
    }

    /// What a statement gives.
    fn carried_out(&self, statement: &Statement) -> Vec<Part> {
        let mut parts = Vec::new();
        if let Some(row) = quantity(&statement.kind) {
            parts.push(Part::Quantities { rows: vec![row] });
        } else if let Some(line) = line(&statement.kind) {
            parts.push(Part::Line { line });
        }
        match &statement.kind {
            StatementKind::Assertion { label, .. } | StatementKind::Eigenpair { label, .. } => {
                let mut claims = self.audit.claims.iter();
                let claim = claims.find(|claim| claim.label.id == label.id);
                parts.extend(claim.map(|claim| Part::Assertion {
                    claim: Box::new(AssertionView::new(claim, self.anchor)),
                }));
            }
            StatementKind::Match(matching) => {
                let mut matched = self.audit.matchings.iter();
                let own = matched.find(|own| own.label.id == matching.label.id);
                parts.extend(own.map(|matched| Part::Matching {
                    matching: Box::new(MatchingView::new(matched, self.anchor)),
                }));
            }
            StatementKind::Show { .. } => {
                let mut shown = self.audit.shown.iter();
                let own = shown.find(|own| own.span == statement.span);
                parts.extend(own.map(|shown| Part::Shown {
                    shown: Box::new(ShownView::new(shown)),
                }));
            }
            _ => {}
        }
        parts
    }

    /// How a statement is shown that is refused, or skipped and no assertion.
    fn refused(&self, statement: &Statement) -> Option<RefusedView> {
        let (span, audit) = (&statement.span, self.audit);
        let mut mistakes = audit.mistakes.iter();
        let own = mistakes.find(|own| {
            let Diagnostic {
                kind, span: place, ..
            } = &own.diagnostic;
            let is_own = own.path == audit.path && span.contains(&place.start);
            is_own && *kind != DiagnosticKind::Disagreement
        });
        if let Some(own) = own {
            return Some(self.shown("refused", span, own.diagnostic.message.clone()));
        }
        let mut skipped = audit.skipped.iter().filter(|own| !own.is_claim);
        let own = skipped.find(|own| own.span == *span)?;
        Some(self.shown("skipped", span, format!("it {}", own.basis.reason)))
    }

    fn shown(&self, word: &'static str, span: &Range<usize>, reason: String) -> RefusedView {
        let source = self.text.get(span.clone()).unwrap_or_default();
        RefusedView {
            word,
            line: self
                .text
                .get(..span.start)
                .unwrap_or_default()
                .matches('\n')
                .count()
                + 1,
            source: source.chars().take(MOST_SOURCE).collect(),
            reason,
        }
    }
}
