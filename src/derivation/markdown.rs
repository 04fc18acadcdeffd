//! The blocks of a Markdown document that are written in this language.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::syntax::Span;

/// The first word behind the fence of a block in this language.
const LANGUAGE: &str = "sextic";

/// What a document contains besides its prose.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Blocks {
    /// The text of the first heading.
    pub title: Option<String>,
    /// The lines between the fences of each block.
    pub blocks: Vec<Span>,
}

/// Finds the blocks as a Markdown reader does, and the fences that do not pair up.
pub fn blocks(text: &str) -> (Blocks, Vec<Diagnostic>) {
    let mut found = Blocks::default();
    let mut errors = Vec::new();
    let mut heading: Option<String> = None;
    for (event, span) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        match event {
            Event::Start(Tag::Heading { .. }) if found.title.is_none() => {
                heading = Some(String::new())
            }
            Event::End(TagEnd::Heading(_)) => found.title = found.title.or(heading.take()),
            Event::Text(part) | Event::Code(part) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&part);
                }
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(information))) => {
                let is_ours = information.split_whitespace().next() == Some(LANGUAGE);
                match lines_of(text, &span, is_ours) {
                    Ok(lines) if is_ours => found.blocks.push(lines),
                    Ok(_) => {}
                    Err(error) => errors.push(error),
                }
            }
            _ => {}
        }
    }
    (found, errors)
}

/// The lines between two fences.
fn lines_of(text: &str, block: &Span, is_ours: bool) -> Result<Span, Diagnostic> {
    let line_start = text[..block.start]
        .rfind('\n')
        .map_or(0, |newline| newline + 1);
    let content = &text[block.clone()];
    let opening = content.lines().next().unwrap_or_default();
    let fence = fence_of(opening);
    let opening_span = block.start..block.start + opening.len();
    let first = (opening_span.end + 1).min(block.end);
    let last = text[first..block.end]
        .trim_end_matches(['\n', '\r'])
        .rfind('\n')
        .map_or(first, |newline| first + newline + 1);
    // In a quotation the closing fence stands behind `>`.
    let closing = text[last..block.end]
        .trim_start_matches(['>', ' ', '\t'])
        .trim_end();
    if last < first || !closes(closing, fence) {
        return Err(unbalanced(opening_span, "this block is never closed")
            .with_label("opened here")
            .with_help(format!("close the block with a line `{fence}`")));
    }
    let lines = first..last;
    if let Some(inner) = opening_inside(text, &lines, fence) {
        return Err(unbalanced(inner, "a block begins inside of another one")
            .with_label("this line does not begin a block")
            .with_secondary(opening_span, "this block is not closed before it")
            .with_help(format!(
                "close the first block with a line `{fence}`, or give it a longer fence"
            )));
    }
    if is_ours
        && (line_start < block.start
            || fence.len() < opening.trim_end().len() && !opening.starts_with(fence))
    {
        return Err(Diagnostic::new(
            DiagnosticKind::Unsupported,
            opening_span,
            "a block in a list or a quotation",
        )
        .with_label("not at the margin")
        .with_help("begin the block at the left margin"));
    }
    Ok(lines)
}

/// The run of backticks or tildes that a line begins with.
fn fence_of(line: &str) -> &str {
    let line = line.trim_start();
    let mark = line.chars().next().unwrap_or('`');
    &line[..line.len() - line.trim_start_matches(mark).len()]
}

fn closes(line: &str, fence: &str) -> bool {
    line.len() >= fence.len() && line.starts_with(fence) && fence_of(line) == line
}

/// A line that would begin a block of this language if the block around it were closed.
fn opening_inside(text: &str, lines: &Span, fence: &str) -> Option<Span> {
    let mut start = lines.start;
    for line in text[lines.clone()].split_inclusive('\n') {
        let inner = fence_of(line);
        if inner.starts_with(fence)
            && line
                .trim_start()
                .trim_start_matches(inner)
                .split_whitespace()
                .next()
                == Some(LANGUAGE)
        {
            return Some(start..start + line.trim_end().len());
        }
        start += line.len();
    }
    None
}

fn unbalanced(span: Span, message: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::UnbalancedFence, span, message)
}
