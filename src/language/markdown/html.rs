//! Raw HTML in a document: it may hide what is executed, or show what is not.

use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::Span;

/// The tags that neither hide nor move anything within their paragraph.
const HARMLESS: [&str; 7] = [
    "<br>", "<br/>", "<br />", "<sub>", "</sub>", "<sup>", "</sup>",
];

/// The tags of a paragraph that are open.
#[derive(Debug, Default)]
pub(super) struct Paragraph {
    open: Vec<Span>,
}

impl Paragraph {
    /// What is wrong with a piece of raw HTML in a line, if it is more than comments and harmless tags
    /// that pair up.
    pub(super) fn fault(&mut self, text: &str, piece: &Span) -> Option<Diagnostic> {
        let mut from = piece.start;
        while let Some(offset) = text[from..piece.end].find('<') {
            from += offset;
            let rest = &text[from..piece.end];
            let length = match harmless(rest) {
                Some(tag) if !self.pairs(text, from..from + tag.len()) => {
                    return Some(unpaired(text, from..from + tag.len()));
                }
                Some(tag) => tag.len(),
                None => match comment(rest) {
                    Some(length) => length,
                    None => return Some(refused(rest, from)),
                },
            };
            from += length;
        }
        None
    }

    /// Opens what a tag opens, or closes what it closes: whether that is open.
    fn pairs(&mut self, text: &str, tag: Span) -> bool {
        let name = |tag: &Span| {
            text[tag.clone()]
                .trim_matches(['<', '/', '>'])
                .to_lowercase()
        };
        if text[tag.clone()].starts_with("</") {
            return self
                .open
                .pop()
                .is_some_and(|open| name(&open) == name(&tag));
        }
        if !name(&tag).starts_with("br") {
            self.open.push(tag);
        }
        true
    }

    /// Ends the paragraph: a tag that is left open reaches into what is below, and thirty of them shrink
    /// that to nothing.
    pub(super) fn end(&mut self, text: &str) -> Option<Diagnostic> {
        let open = self.open.first().cloned();
        self.open.clear();
        Some(unpaired(text, open?))
    }
}

/// What is wrong with a block of raw HTML, if it is more than comments.
///
/// No tag is harmless there, since it pairs with none of its own paragraph.
pub(super) fn fault(text: &str, block: &Span) -> Option<Diagnostic> {
    let mut from = block.start;
    while let Some(offset) = text[from..block.end].find('<') {
        from += offset;
        let rest = &text[from..block.end];
        let Some(length) = comment(rest) else {
            return Some(match harmless(rest) {
                Some(tag) => in_no_paragraph(from..from + tag.len(), tag),
                None => refused(rest, from),
            });
        };
        from += length;
    }
    None
}

/// The first line that begins with a tag, outside of code.
///
/// Below a quotation or a list that such a line seems to go on, some programs begin raw HTML there, which
/// lasts to the next empty line; others do not.
pub(super) fn line_of_its_own(text: &str, fenced: &[Span]) -> Option<Diagnostic> {
    let mut start = 0;
    text.split_inclusive('\n').find_map(|line| {
        let body = line.trim_start_matches([' ', '\t', '>']);
        let place = start + line.len() - body.len();
        start += line.len();
        let tag = tag(body)?;
        let before = fenced.partition_point(|block| block.start <= place);
        let is_code = before
            .checked_sub(1)
            .is_some_and(|last| fenced[last].contains(&place));
        (!is_code).then(|| in_no_paragraph(place..place + tag.len(), tag))
    })
}

/// The tag at the beginning of a line, as far as it stands in this line; `<https://…>` is none.
fn tag(line: &str) -> Option<&str> {
    let name = line.strip_prefix('<')?;
    let name = name.strip_prefix('/').unwrap_or(name);
    let behind =
        name.trim_start_matches(|letter: char| letter.is_ascii_alphanumeric() || letter == '-');
    let ends = |letter: char| letter.is_whitespace() || letter == '/' || letter == '>';
    let is_tag = name.starts_with(|letter: char| letter.is_ascii_alphabetic())
        && (behind.is_empty() || behind.starts_with(ends));
    let end = line.find('>').map_or(line.trim_end().len(), |end| end + 1);
    is_tag.then(|| &line[..end])
}

/// A harmless tag at the beginning of a text.
fn harmless(text: &str) -> Option<&'static str> {
    let begins = |tag: &&str| {
        let start = text.get(..tag.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(tag))
    };
    HARMLESS.into_iter().find(begins)
}

/// The length of a comment at the beginning of a text, if it ends where every program sees its end.
fn comment(text: &str) -> Option<usize> {
    let body = text.strip_prefix("<!--")?;
    let (body, _) = body.split_once("-->")?;
    let is_odd = body.starts_with('>') || body.starts_with("->") || body.contains("--!>");
    (!is_odd).then_some("<!--".len() + body.len() + "-->".len())
}

fn refused(html: &str, start: usize) -> Diagnostic {
    let end = html.find(['\n', '>']).map_or(html.len(), |end| end + 1);
    let shown = html[..end].trim_end();
    let span = start..start + shown.len();
    if html.starts_with("<!--") {
        let message = "this comment ends elsewhere for other programs, or never";
        let help = "begin it with `<!-- ` and end it with the first `-->` behind that";
        return raw(span, message, help);
    }
    let message = format!("`{shown}` may hide what stands below it, or show it in another way");
    let help = "leave HTML out: only comments, `<br>`, `<sub>` and `<sup>` are allowed";
    raw(span, message, help)
}

fn in_no_paragraph(tag: Span, shown: &str) -> Diagnostic {
    let message = format!("programs do not agree on what `{shown}` does to the lines below it");
    raw(
        tag,
        message,
        "put it behind a word of its paragraph, in the same line",
    )
}

fn unpaired(text: &str, tag: Span) -> Diagnostic {
    let message = format!("`{}` has no partner in its paragraph", &text[tag.clone()]);
    raw(
        tag,
        message,
        "open and close it in one paragraph, the last one opened first",
    )
}

fn raw(span: Span, message: impl Into<String>, help: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Hidden, span, message)
        .with_label("raw HTML")
        .with_help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The place of what is wrong in a paragraph.
    fn place(text: &str) -> Option<Span> {
        let mut paragraph = Paragraph::default();
        let fault = paragraph.fault(text, &(0..text.len()));
        fault
            .or_else(|| paragraph.end(text))
            .map(|error| error.span)
    }

    #[test]
    fn comments_and_a_few_tags_are_harmless() {
        for text in [
            "<!-- a -->",
            "<!---->",
            "<!-- <div> \n-- > -->\n<!-- b -->",
            "H<sub>2</SUB>O<br/><br />",
            "a<sup>b<sub>c</sub></sup>",
        ] {
            assert_eq!(place(text), None, "{text}");
        }
        for (text, wrong) in [
            ("<!-- a", 0..6),
            ("<!--> a -->", 0..5),
            ("<!---> a -->", 0..6),
            ("<!-- a --!> b -->", 0..11),
            ("<!-- a --><div hidden>", 10..22),
            ("<sub class=\"x\">", 0..15),
            ("<?php a ?>", 0..10),
            ("<details\nopen>", 0..8),
        ] {
            assert_eq!(place(text), Some(wrong), "{text}");
        }
    }

    #[test]
    fn tags_pair_up_within_a_paragraph() {
        for (text, wrong) in [
            ("a<sub>", 1..6),
            ("a</sub>", 1..7),
            ("a<sub>b</sup>", 7..13),
            ("a<sup>b<sub>c</sup></sub>", 13..19),
        ] {
            assert_eq!(place(text), Some(wrong), "{text}");
        }
    }

    #[test]
    fn no_tag_stands_in_a_block() {
        for (text, wrong) in [
            ("<br>", 0..4),
            ("<!-- a --> <SUB>", 11..16),
            ("<div>", 0..5),
        ] {
            let error = fault(text, &(0..text.len()));
            assert_eq!(error.map(|error| error.span), Some(wrong), "{text}");
        }
        assert_eq!(fault("<!-- a -->\n", &(0..11)), None);
    }

    #[test]
    fn no_line_begins_with_a_tag() {
        for (text, wrong) in [
            ("> a\n<br>\n", 4..8),
            ("> `a\n> </foo>\nb`", 7..13),
            ("- a\n  <sub\n", 6..10),
        ] {
            let error = line_of_its_own(text, &[]);
            assert_eq!(error.map(|error| error.span), Some(wrong), "{text}");
        }
        for text in [
            "a<br>\n",
            "<https://a.b>\n",
            "<a@b.org>\n",
            "< b\n",
            "<!-- a -->\n",
        ] {
            assert_eq!(line_of_its_own(text, &[]), None, "{text}");
        }
        let code = std::slice::from_ref(&(0..13));
        assert_eq!(line_of_its_own("```\n<br>\n```\n", code), None);
    }
}
