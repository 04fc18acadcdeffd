//! What a reader of a document would not see as it is read: characters and line ends.

use unicode_normalization::char::is_combining_mark;

use super::character::{code, fault, is_right_to_left};
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::line_end::ends;
use super::syntax::Span;

/// How many marks a letter may bear in a block; a pile of them reaches into other lines.
const MOST_MARKS: usize = 3;

/// No mark stands before this one.
const FIRST_MARK: char = '\u{300}';

/// Every character of a text that may stand in no document.
pub(crate) fn faults(text: &str) -> impl Iterator<Item = Diagnostic> {
    text.char_indices().filter_map(|(start, character)| {
        let reason = fault(character)?;
        Some(hidden(start, character, reason).with_help("take it away"))
    })
}

/// Every character of a block that would be shown elsewhere than it stands, comments and strings
/// included: on another character, in another line, or in another order.
pub(crate) fn displaced(text: &str, block: &Span) -> Vec<Diagnostic> {
    let mut errors = Vec::new();
    let (mut bears, mut marks) = (false, 0);
    let characters = text.get(block.clone()).unwrap_or_default().char_indices();
    for (start, character) in characters.filter(|(_, character)| *character != '\r') {
        let start = block.start + start;
        if is_right_to_left(character) {
            let reason = "is written from right to left, which may reorder what stands beside it";
            let help = "write it in prose, outside of the block";
            errors.push(hidden(start, character, reason).with_help(help));
        }
        // Most letters are found to be none without a table.
        if character < FIRST_MARK || !is_combining_mark(character) {
            (bears, marks) = (character.is_alphabetic(), 0);
            continue;
        }
        marks += 1;
        if !bears || marks > MOST_MARKS {
            let reason = "is a mark without a letter of its own";
            let help = format!("take it away, or put it behind a letter, {MOST_MARKS} at most");
            errors.push(hidden(start, character, reason).with_help(help));
        }
    }
    errors
}

fn hidden(start: usize, character: char, reason: &str) -> Diagnostic {
    let code = code(character);
    let span = start..start + character.len_utf8();
    Diagnostic::new(DiagnosticKind::Hidden, span, format!("{code} {reason}"))
        .with_label(format!("{code} stands here"))
}

/// The first line end of another sort than the first of all.
///
/// Editors and renderers do not agree on what a lone `\r` among others is, so that a reader may see
/// lines that are not read, or the other way round.
pub(crate) fn mixed_line_ends(text: &str) -> Option<Diagnostic> {
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

fn escaped(end: &str) -> String {
    format!("`{}`", end.escape_default())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::character::visible;

    #[test]
    fn what_papers_hold_is_no_fault() {
        let text = "Größe, ṁ, θ̈_d²: “naïve” — 5 µm ≤ √(a·b)… Ж 风 שלום ☺ \u{A0}\u{2009}\u{202F}|";
        assert_eq!(faults(text).count(), 0);
        assert_eq!(displaced("θ̇_d (ẍ) # \u{1EC7}", &(0..19)), []);
    }

    #[test]
    fn what_is_not_seen_is_a_fault() {
        for character in [
            '\0',
            '\u{1B}',
            '\u{7F}',
            '\u{85}',
            '\u{9B}',
            '\u{AD}',
            '\u{34F}',
            '\u{61C}',
            '\u{115F}',
            '\u{180E}',
            '\u{200B}',
            '\u{200F}',
            '\u{2028}',
            '\u{202E}',
            '\u{2060}',
            '\u{2069}',
            '\u{2800}',
            '\u{3164}',
            '\u{E000}',
            '\u{FE0F}',
            '\u{FEFF}',
            '\u{FFFE}',
            '\u{1D173}',
            '\u{E0041}',
            '\u{E0100}',
            '\u{10FFFF}',
            '\u{B}',
            '\u{C}',
        ] {
            let text = format!("prose{character}");
            assert_eq!(faults(&text).next().map(|error| error.span.start), Some(5));
            assert_eq!(visible(&text).len(), text.len(), "{}", code(character));
            assert_eq!(faults(&visible(&text)).count(), 0);
        }
    }

    #[test]
    fn marks_need_a_letter() {
        for text in [
            "=\u{338}",
            "\"\u{307}",
            "a\u{300}\u{301}\u{302}\u{303}",
            "# א",
        ] {
            assert_eq!(displaced(text, &(0..text.len())).len(), 1, "{text}");
        }
    }

    #[test]
    fn one_sort_of_line_end_is_no_mixture() {
        for text in ["", "a", "a\nb\n\n", "a\r\n\r\nb", "a\r\rb\r"] {
            assert_eq!(mixed_line_ends(text), None, "{text:?}");
        }
        for (text, place) in [("a\nb\r\n", 3..5), ("a\r\n\r", 3..4), ("\r\n\n", 2..3)] {
            assert_eq!(
                mixed_line_ends(text).map(|error| error.span),
                Some(place),
                "{text:?}"
            );
        }
    }
}
