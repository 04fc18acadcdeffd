//! Where the lines of a document end: at `\n`, `\r\n` or a lone `\r`, as in CommonMark.

use std::borrow::Cow;

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

/// The line ends of a text, in order.
pub(crate) fn ends(text: &str) -> impl Iterator<Item = Span> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lone_carriage_returns_end_lines() {
        assert_eq!(unified("a\rb\r\nc\nd\r"), "a\nb\r\nc\nd\n");
        assert!(matches!(unified("a\r\nb\n"), Cow::Borrowed(_)));
    }
}
