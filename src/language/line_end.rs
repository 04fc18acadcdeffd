//! Where the lines of a document end: at `\n`, `\r\n` or a lone `\r`, as in CommonMark.

use std::borrow::Cow;

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::syntax::Span;

/// The text with `\n` for every lone `\r`; no byte moves.
pub(crate) fn unified(text: &str) -> Cow<'_, str> {
    let mut lone = ends(text)
        .filter(|end| &text[end.clone()] == "\r")
        .peekable();
    if lone.peek().is_none() {
        return Cow::Borrowed(text);
    }
    let mut unified = String::with_capacity(text.len());
    for end in lone {
        unified.push_str(&text[unified.len()..end.start]);
        unified.push('\n');
    }
    unified.push_str(&text[unified.len()..]);
    Cow::Owned(unified)
}

/// The first line end of another sort than the first of all.
///
/// Editors and renderers do not agree on what a lone `\r` among others is, so that a reader may see
/// lines that are not read, or the other way round.
pub(crate) fn mixed(text: &str) -> Option<Diagnostic> {
    let mut ends = ends(text);
    let first = ends.next()?;
    let other = ends.find(|end| text[end.clone()] != text[first.clone()])?;
    let (usual, here) = (escaped(&text[first.clone()]), escaped(&text[other.clone()]));
    let message = format!("this line ends in {here}, the first one in {usual}");
    let error = Diagnostic::new(DiagnosticKind::Hidden, other, message);
    Some(
        error
            .with_label(format!("{here} ends this line"))
            .with_secondary(first, format!("{usual} ends this one"))
            .with_help("save the document with one sort of line end"),
    )
}

/// The line ends of a text, in order.
fn ends(text: &str) -> impl Iterator<Item = Span> {
    let bytes = text.as_bytes();
    let mut from = 0;
    std::iter::from_fn(move || {
        let rest = bytes.get(from..)?;
        let start = from + rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'))?;
        let is_pair = bytes[start..].starts_with(b"\r\n");
        from = start + 1 + usize::from(is_pair);
        Some(start..from)
    })
}

fn escaped(end: &str) -> String {
    format!("`{}`", end.escape_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lone_carriage_returns_end_lines() {
        assert_eq!(unified("a\rb\r\nc\nd\r"), "a\nb\r\nc\nd\n");
        assert!(matches!(unified("a\r\nb\n"), Cow::Borrowed(_)));
    }

    #[test]
    fn one_sort_of_line_end_is_no_mixture() {
        for text in ["", "a", "a\nb\n\n", "a\r\n\r\nb", "a\r\rb\r"] {
            assert_eq!(mixed(text), None, "{text:?}");
        }
        for (text, place) in [("a\nb\r\n", 3..5), ("a\r\n\r", 3..4), ("\r\n\n", 2..3)] {
            assert_eq!(mixed(text).map(|error| error.span), Some(place), "{text:?}");
        }
    }
}
