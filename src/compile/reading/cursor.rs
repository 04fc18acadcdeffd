//! A position among tokens.

use super::body::Unreadable;
use super::token::Token;

/// A position among the tokens of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor<'t, 'a> {
    tokens: &'t [Token<'a>],
    at: usize,
}

impl<'t, 'a> Cursor<'t, 'a> {
    pub(super) fn new(tokens: &'t [Token<'a>]) -> Self {
        Cursor { tokens, at: 0 }
    }

    /// The next token, if there is one.
    pub(super) fn token(&self) -> Option<Token<'a>> {
        self.tokens.get(self.at).copied()
    }

    /// The text of the next token.
    pub(super) fn peek(&self) -> Option<&'a str> {
        self.token().map(|token| token.text)
    }

    /// The line of the next token, or of the last one.
    pub(super) fn line(&self) -> usize {
        let token = self.tokens.get(self.at).or(self.tokens.last());
        token.map_or(1, |token| token.line)
    }

    pub(super) fn advance(&mut self) {
        self.at += 1;
    }

    /// Whether the next tokens are these.
    pub(super) fn is_at(&self, texts: &[&str]) -> bool {
        let rest = &self.tokens[self.at.min(self.tokens.len())..];
        rest.len() >= texts.len()
            && rest
                .iter()
                .zip(texts)
                .all(|(token, text)| token.text == *text)
    }

    /// Moves behind these tokens, if they are the next ones.
    pub(super) fn accept(&mut self, texts: &[&str]) -> bool {
        let is_at = self.is_at(texts);
        if is_at {
            self.at += texts.len();
        }
        is_at
    }

    /// Moves behind these tokens.
    ///
    /// # Errors
    ///
    /// [`Unreadable`] at the first one that is another.
    pub(super) fn expect(&mut self, texts: &[&str]) -> Result<(), Unreadable> {
        for text in texts {
            if !self.accept(&[text]) {
                return Err(match text.trim() {
                    "" => self.refuse("the end of the line"),
                    text => self.refuse(&format!("`{text}`")),
                });
            }
        }
        Ok(())
    }

    /// Moves behind a word, and gives it.
    pub(super) fn word(&mut self) -> Result<&'a str, Unreadable> {
        match self.peek().filter(|text| is_word(text)) {
            Some(word) => {
                self.at += 1;
                Ok(word)
            }
            None => Err(self.refuse("a name")),
        }
    }

    /// Something else is expected here.
    pub(super) fn refuse(&self, expected: &str) -> Unreadable {
        let found = match self.peek() {
            Some(text) if text.trim().is_empty() => "the end of the line".to_string(),
            Some(text) => format!("`{text}`"),
            None => "the end of the text".to_string(),
        };
        Unreadable {
            line: self.line(),
            reason: format!("{found} stands where {expected} is expected"),
        }
    }

    /// # Errors
    ///
    /// [`Unreadable`] if there is another token.
    pub(super) fn end(&self) -> Result<(), Unreadable> {
        match self.peek() {
            Some(_) => Err(self.refuse("the end of the text")),
            None => Ok(()),
        }
    }
}

/// Whether a token is a word.
pub(super) fn is_word(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
}
