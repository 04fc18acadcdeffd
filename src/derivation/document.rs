//! A document: the statements of all its blocks.

use std::collections::BTreeMap;

use super::character;
use super::cursor::Cursor;
use super::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use super::lexer::{self, LinePosition, Token, TokenKind};
use super::line_end::{self, unified};
use super::markdown;
use super::name::Aliases;
use super::name::skeleton::skeleton;
use super::statement_parser::is_keyword;
use super::syntax::{Label, Span, Statement, StatementKind};

/// How many bytes a document may have.
pub const MAXIMUM_SIZE: usize = 4 << 20;
/// How many mistakes are reported; more help nobody.
const MAXIMUM_DIAGNOSTICS: usize = 100;

/// What a document says.
#[derive(Clone, Debug)]
pub struct Document {
    /// Its first heading.
    pub title: Option<String>,
    /// The statements of its blocks, in order.
    pub statements: Vec<Statement>,
    /// The ASCII spellings that it declares by `as`.
    pub aliases: Aliases,
}

/// Reads a document.
///
/// # Errors
///
/// All mistakes against the grammar, in the order of their places, at most a hundred; or that there is
/// no statement at all.
pub fn parse_document(source: &SourceFile) -> Result<Document, Vec<Diagnostic>> {
    parse_document_with(source, &Aliases::default())
}

/// Reads a document that imports others, with the spellings that those declare.
///
/// # Errors
///
/// Those of [`parse_document`].
pub fn parse_document_with(
    source: &SourceFile,
    imported: &Aliases,
) -> Result<Document, Vec<Diagnostic>> {
    let text = unified(&source.text);
    let text = text.as_ref();
    if text.len() > MAXIMUM_SIZE {
        let message = format!("a document may have {MAXIMUM_SIZE} bytes");
        return Err(vec![
            Diagnostic::new(DiagnosticKind::Budget, 0..0, message)
                .with_label(format!("this one has {}", text.len()))
                .with_help("split it into documents that import each other"),
        ]);
    }
    let hidden = line_end::mixed(&source.text)
        .into_iter()
        .chain(character::faults(text));
    let hidden: Vec<Diagnostic> = hidden.take(MAXIMUM_DIAGNOSTICS).collect();
    if !hidden.is_empty() {
        return Err(hidden);
    }
    let (found, mut errors) = markdown::blocks(text);
    let mut statements = Vec::new();
    let mut aliases = imported.clone();
    for block in &found.blocks {
        errors.extend(character::displaced(text, block));
        let tokens = lexer::tokens(text, block);
        for range in statement_ranges(text, &tokens) {
            match Cursor::new(text, &tokens[range], &mut aliases).statement() {
                Ok(statement) => statements.push(statement),
                Err(error) => errors.push(error),
            }
        }
    }
    errors.extend(duplicate_labels(&statements));
    errors.extend(aliases.looks.declare_all(&statements));
    if errors.is_empty() && statements.is_empty() {
        errors.push(found.nothing_found());
    }
    if errors.is_empty() {
        aliases.looks.leave_document(source);
        return Ok(Document {
            title: found.title,
            statements,
            aliases,
        });
    }
    errors.sort_by_key(|error| error.span.start);
    errors.truncate(MAXIMUM_DIAGNOSTICS);
    Err(errors)
}

/// Splits tokens into statements: one begins at the margin, outside of brackets.
fn statement_ranges(text: &str, tokens: &[Token]) -> Vec<Span> {
    let mut starts = Vec::new();
    let mut open_brackets = 0_usize;
    for (index, token) in tokens.iter().enumerate() {
        let at_margin = token.position == LinePosition::Margin;
        if index == 0 || at_margin && (open_brackets == 0 || surely_begins(text, &tokens[index..]))
        {
            starts.push(index);
            open_brackets = 0;
        }
        match token.kind {
            TokenKind::OpenRound | TokenKind::OpenSquare => open_brackets += 1,
            TokenKind::CloseRound | TokenKind::CloseSquare => {
                open_brackets = open_brackets.saturating_sub(1);
            }
            _ => {}
        }
    }
    let ends = starts.iter().skip(1).copied().chain([tokens.len()]);
    starts
        .iter()
        .copied()
        .zip(ends)
        .map(|(start, end)| start..end)
        .collect()
}

/// Whether a line cannot be inside of a bracket, so that a bracket above it was forgotten.
fn surely_begins(text: &str, tokens: &[Token]) -> bool {
    let [first, rest @ ..] = tokens else {
        return false;
    };
    let word = text.get(first.span.clone()).unwrap_or_default();
    let mut line = rest
        .iter()
        .take_while(|token| token.position == LinePosition::Inside)
        .map(|token| token.kind)
        .peekable();
    // `angle,` and `angle]` are an entry of a matrix that is called like a keyword.
    let is_entry = matches!(
        line.peek(),
        Some(TokenKind::Comma | TokenKind::Semicolon | TokenKind::CloseSquare)
    );
    is_keyword(word) && !is_entry || line.any(|kind| kind == TokenKind::Define)
}

/// An error for every label whose identifier an earlier one has, or that looks like an earlier one.
fn duplicate_labels(statements: &[Statement]) -> Vec<Diagnostic> {
    let mut first: BTreeMap<&str, &Label> = BTreeMap::new();
    let mut looks: BTreeMap<String, &Label> = BTreeMap::new();
    let mut errors = Vec::new();
    let taken: Vec<&str> = statements
        .iter()
        .filter_map(label_of)
        .map(|l| &*l.id)
        .collect();
    for label in statements.iter().filter_map(label_of) {
        let Some(earlier) = first.get(label.id.as_str()) else {
            first.insert(&label.id, label);
            let alike = *looks.entry(skeleton(&label.text)).or_insert(label);
            if alike.id != label.id {
                errors.push(labels_look_alike(label, alike));
            }
            continue;
        };
        let message = format!("two labels are called `{}`", label.id);
        errors.push(
            Diagnostic::new(DiagnosticKind::Duplicate, label.span.clone(), message)
                .with_label("the same again")
                .with_secondary(earlier.span.clone(), "the first one")
                .with_help(format!(
                    "give one of them a label that no other has, such as `{}`",
                    label.free_variant(&taken)
                )),
        );
    }
    errors
}

fn labels_look_alike(label: &Label, earlier: &Label) -> Diagnostic {
    let message = format!("the label `{}` looks like an earlier one", label.text);
    Diagnostic::new(DiagnosticKind::LookAlike, label.span.clone(), message)
        .with_label(format!("this is `{}` in ASCII", label.id))
        .with_secondary(
            earlier.span.clone(),
            format!("and this is `{}`", earlier.id),
        )
        .with_help("give one of them a label that looks different")
}

fn label_of(statement: &Statement) -> Option<&Label> {
    match &statement.kind {
        StatementKind::Assertion { label, .. } | StatementKind::Eigenpair { label, .. } => {
            Some(label)
        }
        StatementKind::Match(matching) => Some(&matching.label),
        _ => None,
    }
}
