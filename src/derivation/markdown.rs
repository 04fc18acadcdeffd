//! The blocks of a Markdown document that are written in this language.

mod extension;
mod html;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::character::faults;
use super::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use super::syntax::Span;

/// The first word behind the fence of a block in this language.
const LANGUAGE: &str = "sextic";

/// The words that begin what a reader takes for judged.
const ASSERTIONS: [&str; 7] = [
    "claim",
    "refute",
    "approximate",
    "ill-formed",
    "eigenpair",
    "match",
    "evaluator",
];

/// What a document contains besides its prose.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Blocks {
    /// The text of the first heading.
    pub title: Option<String>,
    /// The lines between the fences of each block.
    pub blocks: Vec<Span>,
    /// The first fence of a block in no language.
    nameless: Option<Span>,
}

impl Blocks {
    /// What is wrong with a document that has nothing to execute.
    pub fn nothing_found(&self) -> Diagnostic {
        let help = format!(
            "begin a block at the left margin with a line that is ```{LANGUAGE}, and end it with ```"
        );
        let message = format!("no block fenced as `{LANGUAGE}` was found");
        let error = match (&self.nameless, self.blocks.first()) {
            (_, Some(block)) => {
                let message = format!("the blocks fenced as `{LANGUAGE}` hold no statement");
                Diagnostic::new(DiagnosticKind::NoBlock, block.start..block.start, message)
                    .with_label("nothing but comments from here on")
            }
            (Some(fence), None) => Diagnostic::new(DiagnosticKind::NoBlock, fence.clone(), message)
                .with_label("this fence names no language"),
            (None, None) => Diagnostic::new(DiagnosticKind::NoBlock, 0..0, message)
                .with_label("not here, nor below"),
        };
        error.with_help(help)
    }
}

/// Finds the blocks as a Markdown reader does, with the fences that do not pair up, and with whatever a
/// renderer may hide, move or show though it is not executed.
pub fn blocks(text: &str) -> (Blocks, Vec<Diagnostic>) {
    let mut found = Blocks::default();
    let mut errors = Vec::new();
    let mut whole = Vec::new();
    let mut heading: Option<String> = None;
    for (event, span) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        errors.extend(written_otherwise(text, &event, &span));
        match event {
            Event::Start(Tag::Heading { .. }) if found.title.is_none() => {
                heading = Some(String::new());
            }
            Event::End(TagEnd::Heading(_)) => found.title = found.title.or(heading.take()),
            Event::Text(part) | Event::Code(part) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&part);
                }
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(information))) => {
                let language = information.split_whitespace().next().unwrap_or_default();
                let is_ours = language == LANGUAGE;
                if !is_ours && is_nearly_ours(language) {
                    errors.push(misspelt(text, &span, language));
                }
                if language.is_empty() && found.nameless.is_none() {
                    found.nameless = Some(opening(text, &span));
                }
                match lines_of(text, &span, is_ours) {
                    Ok(lines) if is_ours => {
                        found.blocks.push(lines);
                        whole.push(span);
                    }
                    Ok(lines) if language.is_empty() => {
                        errors.extend(not_executed(text, &lines));
                    }
                    Ok(_) => {}
                    Err(error) => errors.push(error),
                }
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) => {
                errors.extend(not_executed(text, &span));
            }
            Event::Start(Tag::HtmlBlock) => {
                errors.extend(html::fault(text, &span).or_else(|| not_executed(text, &span)));
            }
            Event::InlineHtml(_) => errors.extend(html::fault(text, &span)),
            _ => {}
        }
    }
    if errors.is_empty() {
        errors.extend(extension::difference(text, &whole));
    }
    (found, errors)
}

/// What nobody sees in a text whose characters are written in another way, such as `&shy;`.
fn written_otherwise(text: &str, event: &Event<'_>, span: &Span) -> Option<Diagnostic> {
    let (shown, span) = match event {
        Event::Text(shown) | Event::Code(shown) => (shown, span.clone()),
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(information))) => {
            (information, opening(text, span))
        }
        _ => return None,
    };
    if text.get(span.clone()) == Some(shown) {
        return None;
    }
    let fault = faults(shown).next()?;
    Some(Diagnostic { span, ..fault })
}

/// The first line of a block that a reader takes for judged, and that is not executed.
fn not_executed(text: &str, lines: &Span) -> Option<Diagnostic> {
    let mut start = lines.start;
    for line in text[lines.clone()].split_inclusive('\n') {
        let said = line.trim();
        if is_assertion(said) || opens_ours(said) {
            let start = start + line.len() - line.trim_start().len();
            let message = "this looks like a block of `sextic`, and is not executed";
            let help = format!(
                "begin the block at the left margin with ```{LANGUAGE}, or name another language there"
            );
            let span = start..start + said.len();
            let error = Diagnostic::new(DiagnosticKind::Hidden, span, message);
            return Some(error.with_label("never judged").with_help(help));
        }
        start += line.len();
    }
    None
}

/// Whether a line begins as an assertion does, with its label.
fn is_assertion(line: &str) -> bool {
    let mut rests = ASSERTIONS.iter().filter_map(|word| line.strip_prefix(word));
    rests.any(|rest| rest.trim_start().starts_with(['(', '[']) && rest.contains(':'))
}

/// Whether a line opens a block of this language.
fn opens_ours(line: &str) -> bool {
    let fence = fence_of(line);
    let information = line.trim_start().trim_start_matches(fence);
    let is_fence = fence.len() >= 3 && fence.starts_with(['`', '~']);
    is_fence && information.split_whitespace().next() == Some(LANGUAGE)
}

/// Whether a language is `Sextic`, `sextix` or `{.sextic}`, which would be passed over.
fn is_nearly_ours(language: &str) -> bool {
    let mut words = language.split(|letter: char| !letter.is_alphanumeric());
    let word = words.find(|word| !word.is_empty()).unwrap_or_default();
    nearest(word, [LANGUAGE]).is_some()
}

/// A block that would be passed over, since its language is not spelled as it must be.
fn misspelt(text: &str, block: &Span, language: &str) -> Diagnostic {
    let message = format!("a block of `{language}` is not read");
    Diagnostic::syntax(opening(text, block), message)
        .with_label(format!("not spelled as `{LANGUAGE}`"))
        .with_help(format!(
            "begin the block with `{LANGUAGE}` behind its fence, and with nothing else"
        ))
}

/// The line that opens a block.
fn opening(text: &str, block: &Span) -> Span {
    let line = text[block.clone()].lines().next().unwrap_or_default();
    block.start..block.start + line.len()
}

/// The lines between the fences of a block.
fn lines_of(text: &str, block: &Span, is_ours: bool) -> Result<Span, Diagnostic> {
    let opening = opening(text, block);
    let opening_line = &text[opening.clone()];
    let fence = fence_of(opening_line);
    let first = (opening.end + 1).min(block.end);
    let rest = text[first..block.end].trim_end_matches(['\n', '\r']);
    let last = rest
        .rfind('\n')
        .map_or(first, |newline| first + newline + 1);
    // In a quotation the closing fence stands behind `>`.
    let closing = rest[last - first..].trim_start_matches(['>', ' ', '\t']);
    if !closes(closing.trim_end_matches([' ', '\t']), fence) {
        return Err(unbalanced(opening, "this block is never closed")
            .with_label("opened here")
            .with_help(format!("end it with a line that is only {fence}")));
    }
    let lines = first..last;
    if let Some(inner) = opening_inside(text, &lines, fence) {
        let help = format!(
            "end the first block with a line that is only {fence}, or begin it with a longer fence"
        );
        return Err(unbalanced(inner, "a block begins inside of another one")
            .with_label("this line does not begin a block")
            .with_secondary(opening, "this block is not closed before it")
            .with_help(help));
    }
    let information = opening_line.trim_matches(['`', '~', ' ', '\t', '\r']);
    if is_ours && information != LANGUAGE {
        return Err(misspelt(text, block, information));
    }
    let at_margin = text[..block.start].ends_with('\n') || block.start == 0;
    if is_ours && !(at_margin && opening_line.starts_with(fence)) {
        let message = "a block cannot stand in a list or a quotation, or be indented";
        return Err(
            Diagnostic::new(DiagnosticKind::Unsupported, opening, message)
                .with_label("not at the margin")
                .with_help("begin the block at the left margin"),
        );
    }
    Ok(lines)
}

/// The run of backticks or tildes that a line begins with.
fn fence_of(line: &str) -> &str {
    let line = line.trim_start();
    let mark = line.chars().next().unwrap_or('`');
    &line[..line.len() - line.trim_start_matches(mark).len()]
}

/// Whether a line closes a block that a fence opened.
fn closes(line: &str, fence: &str) -> bool {
    line.starts_with(fence) && fence_of(line) == line
}

/// A line that would begin a block of this language if the block around it were closed.
fn opening_inside(text: &str, lines: &Span, fence: &str) -> Option<Span> {
    let mut start = lines.start;
    for line in text[lines.clone()].split_inclusive('\n') {
        if opens_ours(line) && fence_of(line).starts_with(fence) {
            return Some(start..start + line.trim_end().len());
        }
        start += line.len();
    }
    None
}

fn unbalanced(span: Span, message: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::UnbalancedFence, span, message)
}
