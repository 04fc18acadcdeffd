//! The labels of assertions: `(8, printed)`, `[centre of rotation]`.

use std::collections::BTreeSet;

use unicode_normalization::UnicodeNormalization;

use super::character::{code, is_known};
use super::cursor::{Cursor, Parsed};
use super::diagnostic::Diagnostic;
use super::lexer::TokenKind;
use super::name::greek::transliterate;
use super::syntax::Label;

impl Cursor<'_> {
    /// A label, whose text may be anything but its closing bracket.
    pub(crate) fn label(&mut self) -> Parsed<Label> {
        let open = self.here();
        let (closing, is_equation) = match self.peek() {
            Some(TokenKind::OpenRound) => (TokenKind::CloseRound, true),
            Some(TokenKind::OpenSquare) => (TokenKind::CloseSquare, false),
            _ => {
                let help = "write an equation's number in `(…)`, other labels in `[…]`";
                return Err(self.expected("a label, `(8)` or `[words]`").with_help(help));
            }
        };
        self.advance();
        while self.peek().is_some_and(|kind| kind != closing) {
            self.advance();
        }
        let close = self.here();
        self.expect_closing(closing, &open)?;
        let inside = open.end..close.start;
        let text = self.text_of(&inside).trim();
        if let Some((at, foreign)) = self.text_of(&inside).char_indices().find(is_foreign) {
            let start = inside.start + at;
            let message = format!("`{foreign}` is of a script that labels are not written in");
            return Err(
                Diagnostic::syntax(start..start + foreign.len_utf8(), message)
                    .with_label(code(foreign))
                    .with_help("write labels in Latin or Greek letters, digits and punctuation"),
            );
        }
        let label = Label {
            text: text.to_owned(),
            equation: is_equation.then(|| first_part(text).to_owned()),
            id: identifier(text),
            span: open.start..close.end,
        };
        if label.id.is_empty() {
            return Err(
                Diagnostic::syntax(label.span, "a label needs a letter or a digit")
                    .with_label("nothing to call this by")
                    .with_help("name it: `(8)` or `[energy]`"),
            );
        }
        Ok(label)
    }
}

impl Label {
    /// `(8, printed)` or `[centre of rotation]`, as the document writes it.
    pub fn written(&self) -> String {
        match self.equation {
            Some(_) => format!("({})", self.text),
            None => format!("[{}]", self.text),
        }
    }

    /// This label with the first number that makes it another than all that are taken, as it would
    /// stand in the document.
    pub(crate) fn free_variant(&self, taken: &BTreeSet<&str>) -> String {
        let (number, rest) = match self.text.split_once(',') {
            Some((number, rest)) => (number, format!(",{rest}")),
            None => (self.text.as_str(), String::new()),
        };
        let variants = (2..).map(|count| format!("{number}, {count}{rest}"));
        let mut free = variants.filter(|text| !taken.contains(identifier(text).as_str()));
        let text = free.next().unwrap_or_default();
        match self.equation {
            Some(_) => format!("({text})"),
            None => format!("[{text}]"),
        }
    }
}

/// Whether a character of a label is of a block of Unicode that the language does not know.
fn is_foreign(place: &(usize, char)) -> bool {
    !is_known(place.1) && !matches!(place.1, '\r' | '\n')
}

/// What stands before the first comma.
fn first_part(text: &str) -> &str {
    text.split(',').next().unwrap_or(text).trim()
}

/// Lower-case ASCII letters, digits and dots, with a hyphen for whatever stands between them.
fn identifier(text: &str) -> String {
    let mut identifier = String::with_capacity(text.len());
    // Decomposed, `é` loses its accent, `₂` becomes 2 and `″` two primes.
    for character in text.nfkd() {
        match character {
            'a'..='z' | '0'..='9' | '.' => identifier.push(character),
            'A'..='Z' => identifier.push(character.to_ascii_lowercase()),
            // Equations (8) and (8′) are not the same.
            '′' => identifier.push_str("-prime"),
            '\'' | '’' | '\u{300}'..='\u{36F}' => {}
            _ => match transliterate(character) {
                Some(name) => identifier.push_str(&name.to_ascii_lowercase()),
                None if identifier.is_empty() || identifier.ends_with('-') => {}
                None => identifier.push('-'),
            },
        }
    }
    identifier.trim_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_plain() {
        for (text, expected) in [
            ("8, printed", "8-printed"),
            ("centre of rotation", "centre-of-rotation"),
            ("A.3", "a.3"),
            ("8′", "8-prime"),
            ("λ₁ of Routh's — Ωé", "lamda1-of-rouths-omegae"),
            ("  (x)  ", "x"),
            ("§", ""),
        ] {
            assert_eq!(identifier(text), expected);
        }
    }
}
