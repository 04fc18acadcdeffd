//! A document: the statements of all its blocks.

use std::collections::{BTreeMap, BTreeSet};

use super::blank;
use super::cursor::Cursor;
use super::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use super::foreign::cured;
use super::hidden;
use super::intent::{Intent, Unread};
use super::keyword::is_keyword;
use super::lexer::{self, LinePosition, Token, TokenKind};
use super::line_end::unified;
use super::markdown;
use super::name::Aliases;
use super::name::skeleton::skeleton;
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
    /// What of it is not understood, in order.
    pub unread: Vec<Unread>,
    /// The ASCII spellings that it declares by `as`.
    pub aliases: Aliases,
}

/// Reads a document in which there is no mistake.
///
/// # Errors
///
/// All mistakes against the grammar, in the order of their places, at most a hundred; or that there is
/// no statement at all.
pub fn parse_document(source: &SourceFile) -> Result<Document, Vec<Diagnostic>> {
    parse_document_with(source, &Aliases::default())
}

/// Reads a document in which there is no mistake and that imports others, with the spellings that those
/// declare.
///
/// # Errors
///
/// Those of [`parse_document`].
pub fn parse_document_with(
    source: &SourceFile,
    imported: &Aliases,
) -> Result<Document, Vec<Diagnostic>> {
    let document = read_document(source, imported)?;
    if document.unread.is_empty() {
        return Ok(document);
    }
    let errors = document.unread.into_iter().map(|unread| unread.diagnostic);
    let mut errors: Vec<Diagnostic> = errors.collect();
    errors.sort_by_key(|error| error.span.start);
    errors.truncate(MAXIMUM_DIAGNOSTICS);
    Err(errors)
}

/// Reads a document that imports others, with the spellings that those declare; what is not understood
/// costs the statement or the block in which it stands.
///
/// # Errors
///
/// That it is too large, that a character or a line end in it misleads, or that there is no statement at
/// all.
pub fn read_document(source: &SourceFile, imported: &Aliases) -> Result<Document, Vec<Diagnostic>> {
    let text = unified(&source.text);
    let text = text.as_ref();
    if text.len() > MAXIMUM_SIZE {
        let message = format!("a document may have {MAXIMUM_SIZE} bytes");
        let error = Diagnostic::new(DiagnosticKind::Budget, 0..0, message)
            .with_label(format!("this one has {}", text.len()))
            .with_help("split it into documents that import each other");
        return Err(vec![error]);
    }
    let hidden = hidden::mixed_line_ends(&source.text)
        .into_iter()
        .chain(hidden::faults(text));
    let hidden: Vec<Diagnostic> = hidden.take(MAXIMUM_DIAGNOSTICS).collect();
    if !hidden.is_empty() {
        return Err(hidden);
    }
    let (found, errors) = markdown::blocks(text);
    let unread_block = |diagnostic: Diagnostic| Unread {
        span: diagnostic.span.clone(),
        diagnostic,
        intent: Intent::anything(),
    };
    let mut unread: Vec<Unread> = errors.into_iter().map(unread_block).collect();
    let mut statements = Vec::new();
    let mut aliases = imported.clone();
    for block in &found.blocks {
        let displaced = hidden::displaced(text, block).into_iter();
        unread.extend(displaced.chain(blank::gaps(text, block)).map(unread_block));
        let tokens = lexer::tokens(text, block);
        for range in statement_ranges(text, &tokens) {
            let tokens = &tokens[range];
            match Cursor::new(text, tokens, &mut aliases).statement() {
                Ok(statement) => statements.push(statement),
                Err(diagnostic) => unread.push(Unread {
                    span: span_of(tokens),
                    diagnostic: cured(diagnostic, text),
                    intent: Intent::of_tokens(text, tokens, &aliases),
                }),
            }
        }
    }
    unread.extend(take_duplicates(&mut statements));
    let alike = aliases.looks.declare_all(&statements);
    unread.extend(take_out(&mut statements, alike));
    if unread.is_empty() && statements.is_empty() {
        return Err(vec![found.nothing_found()]);
    }
    unread.sort_by_key(|unread| unread.span.start);
    aliases.looks.leave_document(source);
    Ok(Document {
        title: found.title,
        statements,
        unread,
        aliases,
    })
}

/// Takes out the statements in which something is wrong.
fn take_out(statements: &mut Vec<Statement>, wrong: Vec<Diagnostic>) -> Vec<Unread> {
    let mut unread = Vec::new();
    for diagnostic in wrong {
        let place = diagnostic.span.start;
        let within = |statement: &Statement| statement.span.contains(&place);
        let (span, intent) = match statements.iter().position(within) {
            Some(found) => {
                let statement = statements.remove(found);
                (statement.span.clone(), Intent::of(&statement))
            }
            None => (diagnostic.span.clone(), Intent::default()),
        };
        unread.push(Unread {
            span,
            diagnostic,
            intent,
        });
    }
    unread
}

/// From the first to the last of some tokens.
fn span_of(tokens: &[Token]) -> Span {
    match tokens {
        [first, .., last] => first.span.start..last.span.end,
        [only] => only.span.clone(),
        [] => 0..0,
    }
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

/// Takes out every statement with a label whose identifier an earlier one has, or that looks like an
/// earlier one.
fn take_duplicates(statements: &mut Vec<Statement>) -> Vec<Unread> {
    let mut first: BTreeMap<&str, &Label> = BTreeMap::new();
    let mut looks: BTreeMap<String, &Label> = BTreeMap::new();
    let mut refused = BTreeMap::new();
    let labels = statements.iter().filter_map(label_of);
    let taken: BTreeSet<&str> = labels.map(|label| label.id.as_str()).collect();
    for (place, statement) in statements.iter().enumerate() {
        let Some(label) = label_of(statement) else {
            continue;
        };
        let alike = *looks.entry(skeleton(&label.text)).or_insert(label);
        let earlier = *first.entry(label.id.as_str()).or_insert(label);
        let diagnostic = match (earlier.span == label.span, alike.id == label.id) {
            (true, true) => continue,
            (true, false) => labels_look_alike(label, alike),
            (false, _) => duplicate(label, earlier, &taken),
        };
        let unread = Unread {
            span: statement.span.clone(),
            diagnostic,
            intent: Intent::of(statement),
        };
        refused.insert(place, unread);
    }
    let mut place = 0..;
    statements.retain(|_| {
        place
            .next()
            .is_none_or(|place| !refused.contains_key(&place))
    });
    refused.into_values().collect()
}

fn duplicate(label: &Label, earlier: &Label, taken: &BTreeSet<&str>) -> Diagnostic {
    let message = format!("two labels are called `{}`", label.id);
    Diagnostic::new(DiagnosticKind::Duplicate, label.span.clone(), message)
        .with_label("the same again")
        .with_secondary(earlier.span.clone(), "the first one")
        .with_help(format!(
            "give one of them a label that no other has, such as `{}`",
            label.free_variant(taken)
        ))
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
