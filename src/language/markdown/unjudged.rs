//! Code that a reader would take for judged, though it is not executed.

use std::borrow::Cow;

use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::is_combining_mark;

use super::{LANGUAGE, closes, fence_of, opens_ours};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use crate::language::syntax::Span;

/// The words that begin what a reader takes for judged.
const ASSERTIONS: [&str; 5] = ["claim", "refute", "approximate", "ill-formed", "eigenpair"];

/// The words that do so before a label and a name: other languages have them too.
const NAMED: [&str; 3] = ["match", "system", "evaluator"];

/// What may stand before an assertion as it does before one of several.
const MARKS: &str = ">-+*";

/// The languages of blocks that show fences, so that a reader sees what is quoted.
const QUOTING: [&str; 2] = ["markdown", "md"];

/// The text of a block as a reader sees it, without the marks of quotations and lists around it.
#[derive(Debug, Default)]
pub(super) struct Shown {
    text: String,
    /// Where its parts begin, and where they stand in the document.
    parts: Vec<(usize, Span)>,
    is_quoting: bool,
}

impl Shown {
    /// A block of a language, of which nothing is read yet.
    pub(super) fn of(language: &str) -> Self {
        Shown {
            is_quoting: QUOTING.contains(&language),
            ..Shown::default()
        }
    }

    /// Reads a part of it.
    pub(super) fn push(&mut self, part: &str, span: Span) {
        self.parts.push((self.text.len(), span));
        self.text.push_str(part);
    }

    /// The first line that a reader takes for judged.
    pub(super) fn fault(&self) -> Option<Diagnostic> {
        let mut quotation: Option<&str> = None;
        let mut start = 0;
        for line in self.text.split_inclusive('\n') {
            let said = line.trim();
            match quotation {
                Some(fence) if closes(said, fence) => quotation = None,
                Some(_) => {}
                None if self.is_quoting && opens_ours(said) => quotation = Some(fence_of(said)),
                None if opens_ours(said) || is_assertion(&self.text[start..]) => {
                    let start = start + line.len() - line.trim_start().len();
                    return Some(never_judged(self.place(start, said.len())));
                }
                None => {}
            }
            start += line.len();
        }
        None
    }

    /// Where something stands in the document, as far as it stands in one part.
    fn place(&self, start: usize, length: usize) -> Span {
        let behind = self.parts.partition_point(|(begin, _)| *begin <= start);
        let part = behind.checked_sub(1).and_then(|last| self.parts.get(last));
        part.map_or(0..0, |(begin, span)| {
            let place = (span.start + start - begin).min(span.end);
            place..(place + length).min(span.end)
        })
    }
}

fn never_judged(span: Span) -> Diagnostic {
    let message = format!("this looks like a block of `{LANGUAGE}`, and is not executed");
    let help = format!(
        "begin the block at the left margin with ```{LANGUAGE}; a block of `markdown` may quote another one with its fences"
    );
    Diagnostic::new(DiagnosticKind::Hidden, span, message)
        .with_label("never judged")
        .with_help(help)
}

/// Whether a text begins as an assertion does, with its label, which may stand in the line below.
fn is_assertion(text: &str) -> bool {
    let lines = text.split_inclusive('\n').take(2);
    let text: String = lines.collect();
    let text = text.trim_start_matches(|mark: char| mark.is_whitespace() || MARKS.contains(mark));
    let text = unmarked(text);
    let mut words = text.split(|letter: char| letter.is_whitespace() || "([".contains(letter));
    let word = words.next().unwrap_or_default();
    let rest = text[word.len()..].trim_start();
    let is_any = |known: &[&str]| known.iter().any(|known| looks_like(word, known));
    rest.starts_with(['(', '[']) && (is_any(&ASSERTIONS) || is_any(&NAMED) && is_named(rest))
}

/// Whether a name and a colon stand behind a label.
fn is_named(label: &str) -> bool {
    let mut depth = 0_usize;
    let close = label.find(|letter| {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    });
    let behind = close.and_then(|close| label.get(close + 1..));
    let behind = behind.unwrap_or_default().trim_start();
    behind.starts_with(char::is_alphabetic) && behind.contains(':')
}

/// Whether what stands behind a fence is `Sextic`, `sextix`, `{.sextic}` or `language-sextic`, or looks so:
/// the block would be passed over.
pub(super) fn is_nearly_ours(information: &str) -> bool {
    let information = unmarked(information);
    let words = information.split(|letter: char| !letter.is_alphanumeric());
    let mut words = words.filter(|word| !word.is_empty()).peekable();
    let first = words
        .peek()
        .is_some_and(|word| nearest(word, [LANGUAGE]).is_some());
    let is_ours = |word: &str| looks_like(word, LANGUAGE) || word.to_lowercase().contains(LANGUAGE);
    first || words.any(is_ours)
}

/// Whether a word is drawn as a known one: a letter beyond ASCII may be drawn as any other.
fn looks_like(word: &str, known: &str) -> bool {
    let mut pairs = word.chars().zip(known.chars());
    let is_same =
        |(own, letter): (char, char)| !own.is_ascii() || own.eq_ignore_ascii_case(&letter);
    word.chars().count() == known.len()
        && word.contains(|letter: char| letter.is_ascii())
        && pairs.all(is_same)
}

/// A text without the marks on its letters, and with plain letters for those of other fonts.
fn unmarked(text: &str) -> Cow<'_, str> {
    match text.is_ascii() {
        true => Cow::Borrowed(text),
        false => text
            .nfkd()
            .filter(|letter| !is_combining_mark(*letter))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assertions_are_known_by_their_looks() {
        for text in [
            "claim (1): 1 == 2",
            "  refute[a]: 1 == 1",
            "Claim (1) 1 == 2",
            "claim\n  (1): 1 == 2",
            "ill\u{2010}formed (1): a == b",
            "сlаim (1): 1 == 2",
            "𝖼𝗅𝖺𝗂𝗆 （1）: 1 == 2",
            "cláim [1]: 1 == 2",
            "eigenpair (5) of K, M:\n  value 1",
            "match (6, f(x)) other: p with q",
            "evaluator (7) plate: A = area",
            "> - claim (1): 1 == 2",
        ] {
            assert!(is_assertion(text), "{text}");
        }
        for text in [
            "claims (1): 1 == 2",
            "claim: 1 == 2",
            "we claim (1): 1 == 2",
            "match (a, b) { (X::Y, _) => 1 }",
            "match (a, b):\n    case _: pass",
            "match (f x) with\n| A -> 1",
            "(1): 1 == 2",
            "мысль (1): 1 == 2",
            "",
        ] {
            assert!(!is_assertion(text), "{text}");
        }
    }

    #[test]
    fn languages_are_known_by_their_looks() {
        for language in [
            "Sextic",
            "sextix",
            "{.sextic}",
            "language-sextic",
            "text sextic",
            "ѕеxtіс",
            "𝗌𝖾𝗑𝗍𝗂𝖼",
            "séxtic",
            "sextics",
        ] {
            assert!(is_nearly_ours(language), "{language}");
        }
        for language in [
            "",
            "text",
            "rust",
            "python title=\"Größe\"",
            "text title=\"static\"",
        ] {
            assert!(!is_nearly_ours(language), "{language}");
        }
    }
}
