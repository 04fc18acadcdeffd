//! The blocks of a Markdown document that are written in this language.

mod extension;
mod html;
mod unjudged;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::hidden::faults;
use super::syntax::Span;
use unjudged::{Shown, is_nearly_ours};

/// The first word behind the fence of a block in this language.
const LANGUAGE: &str = "sextic";

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
    let mut reading = Reading {
        text,
        ..Reading::default()
    };
    for (event, span) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        reading.read(event, span);
    }
    reading.finish()
}

/// A document as far as it is read.
#[derive(Default)]
struct Reading<'a> {
    text: &'a str,
    found: Blocks,
    errors: Vec<Diagnostic>,
    /// The blocks in this language with their fences.
    whole: Vec<Span>,
    /// The blocks with fences in whatever language.
    fenced: Vec<Span>,
    /// The first heading, as long as it is open.
    heading: Option<String>,
    paragraph: html::Paragraph,
    /// The block that is open and not executed.
    unjudged: Option<Shown>,
}

impl Reading<'_> {
    fn read(&mut self, event: Event<'_>, span: Span) {
        let text = self.text;
        self.errors.extend(written_otherwise(text, &event, &span));
        if bounds_paragraph(&event) {
            self.errors.extend(self.paragraph.end(text));
        }
        match event {
            Event::Start(tag) => self.open(&tag, span),
            Event::End(tag) => self.close(tag),
            Event::Text(part) | Event::Code(part) | Event::Html(part) => self.show(&part, span),
            Event::InlineHtml(_) => self.errors.extend(self.paragraph.fault(text, &span)),
            _ => {}
        }
    }

    fn open(&mut self, tag: &Tag<'_>, span: Span) {
        match tag {
            Tag::Heading { .. } if self.found.title.is_none() => {
                self.heading = Some(String::new());
            }
            Tag::CodeBlock(CodeBlockKind::Fenced(information)) => {
                self.open_fenced(information, span);
            }
            Tag::CodeBlock(CodeBlockKind::Indented) => self.unjudged = Some(Shown::default()),
            Tag::HtmlBlock => match html::fault(self.text, &span) {
                Some(error) => self.errors.push(error),
                None => self.unjudged = Some(Shown::default()),
            },
            _ => {}
        }
    }

    fn open_fenced(&mut self, information: &str, span: Span) {
        self.fenced.push(span.clone());
        let language = information.split_whitespace().next().unwrap_or_default();
        let is_ours = language == LANGUAGE;
        if !is_ours && is_nearly_ours(information) {
            self.errors.push(misspelt(self.text, &span, information));
        }
        if language.is_empty() && self.found.nameless.is_none() {
            self.found.nameless = Some(opening(self.text, &span));
        }
        match lines_of(self.text, &span, is_ours) {
            Ok(lines) if is_ours => {
                self.found.blocks.push(lines);
                self.whole.push(span);
            }
            Ok(_) => self.unjudged = Some(Shown::of(language)),
            Err(error) => self.errors.push(error),
        }
    }

    fn show(&mut self, part: &str, span: Span) {
        if let Some(heading) = &mut self.heading {
            heading.push_str(part);
        }
        if let Some(unjudged) = &mut self.unjudged {
            unjudged.push(part, span);
        }
    }

    fn close(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Heading(_) => {
                let heading = self.heading.take();
                self.found.title = self.found.title.take().or(heading);
            }
            TagEnd::CodeBlock | TagEnd::HtmlBlock => {
                let unjudged = self.unjudged.take();
                self.errors.extend(unjudged.and_then(|shown| shown.fault()));
            }
            _ => {}
        }
    }

    /// What is found; where nothing is wrong by itself, also what programs do not agree on.
    fn finish(self) -> (Blocks, Vec<Diagnostic>) {
        let mut errors = self.errors;
        if errors.is_empty() {
            let difference = html::line_of_its_own(self.text, &self.fenced);
            let difference = difference.or_else(|| extension::difference(self.text, &self.whole));
            errors.extend(difference);
        }
        (self.found, errors)
    }
}

/// Whether a paragraph ends or another one begins, be it that of a heading or of a list.
fn bounds_paragraph(event: &Event<'_>) -> bool {
    match event {
        Event::Start(tag) => bounds(&tag.to_end()),
        Event::End(tag) => bounds(tag),
        _ => false,
    }
}

/// Whether something is more than a part of a line.
fn bounds(tag: &TagEnd) -> bool {
    !matches!(
        tag,
        TagEnd::Emphasis | TagEnd::Strong | TagEnd::Link | TagEnd::Image
    )
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

/// Whether a line opens a block of this language.
fn opens_ours(line: &str) -> bool {
    let fence = fence_of(line);
    let information = line.trim_start().trim_start_matches(fence);
    let is_fence = fence.len() >= 3 && fence.starts_with(['`', '~']);
    is_fence && information.split_whitespace().next() == Some(LANGUAGE)
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
