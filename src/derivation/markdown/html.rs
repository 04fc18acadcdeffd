//! Raw HTML in a document: it may hide what is executed, or show what is not.

use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind};
use crate::derivation::syntax::Span;

/// The tags that neither hide nor move anything.
const HARMLESS: [&str; 7] = [
    "<br>", "<br/>", "<br />", "<sub>", "</sub>", "<sup>", "</sup>",
];

/// What is wrong with a piece of raw HTML, if it is more than comments and harmless tags.
pub(super) fn fault(text: &str, piece: &Span) -> Option<Diagnostic> {
    let mut from = piece.start;
    while let Some(offset) = text[from..piece.end].find('<') {
        from += offset;
        let rest = &text[from..piece.end];
        let Some(length) = harmless(rest).or_else(|| comment(rest)) else {
            return Some(refused(rest, from));
        };
        from += length;
    }
    None
}

/// The length of a harmless tag at the beginning of a text.
fn harmless(text: &str) -> Option<usize> {
    let begins = |tag: &&&str| {
        let start = text.get(..tag.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(tag))
    };
    HARMLESS.iter().find(begins).map(|tag| tag.len())
}

/// The length of a comment at the beginning of a text, if it ends where every program sees its end.
fn comment(text: &str) -> Option<usize> {
    let body = text.strip_prefix("<!--")?;
    let (body, _) = body.split_once("-->")?;
    let is_odd = body.starts_with('>') || body.starts_with("->") || body.contains("--!>");
    (!is_odd).then_some("<!--".len() + body.len() + "-->".len())
}

fn refused(html: &str, start: usize) -> Diagnostic {
    let is_comment = html.starts_with("<!--");
    let end = html.find(['\n', '>']).map_or(html.len(), |end| end + 1);
    let shown = html[..end].trim_end();
    let (message, help) = if is_comment {
        (
            "this comment ends elsewhere for other programs, or never".to_owned(),
            "begin it with `<!-- ` and end it with the first `-->` behind that",
        )
    } else {
        (
            format!("`{shown}` may hide what stands below it, or show it in another way"),
            "leave HTML out: only comments, `<br>`, `<sub>` and `<sup>` are allowed",
        )
    };
    Diagnostic::new(DiagnosticKind::Hidden, start..start + shown.len(), message)
        .with_label("raw HTML")
        .with_help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_a_few_tags_are_harmless() {
        for text in [
            "<!-- a -->",
            "<!---->",
            "<!-- <div> \n-- > -->\n<!-- b -->",
            "H<sub>2</SUB>O<br/><br />",
        ] {
            assert_eq!(fault(text, &(0..text.len())), None, "{text}");
        }
        for (text, place) in [
            ("<!-- a", 0..6),
            ("<!--> a -->", 0..5),
            ("<!---> a -->", 0..6),
            ("<!-- a --!> b -->", 0..11),
            ("<!-- a --><div hidden>", 10..22),
            ("<sub class=\"x\">", 0..15),
            ("<?php a ?>", 0..10),
            ("<details\nopen>", 0..8),
        ] {
            let error = fault(text, &(0..text.len()));
            assert_eq!(error.map(|error| error.span), Some(place), "{text}");
        }
    }
}
