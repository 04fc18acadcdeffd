//! A phrase in which words and mathematics alternate.

/// A part of a phrase.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Prose, to be escaped where a format gives characters a meaning.
    Words(String),
    /// Mathematics, written in the notation of the view.
    Mathematics(String),
}

/// Words and mathematics, in reading order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Phrase {
    pieces: Vec<Piece>,
}

impl Phrase {
    /// A phrase of words alone.
    pub fn of_words(words: impl Into<String>) -> Self {
        Phrase::default().words(words)
    }

    /// A phrase of one formula alone.
    pub fn of_mathematics(formula: impl Into<String>) -> Self {
        Phrase::default().mathematics(formula)
    }

    /// Appends words.
    #[must_use]
    pub fn words(mut self, words: impl Into<String>) -> Self {
        self.pieces.push(Piece::Words(words.into()));
        self
    }

    /// Appends a formula.
    #[must_use]
    pub fn mathematics(mut self, formula: impl Into<String>) -> Self {
        self.pieces.push(Piece::Mathematics(formula.into()));
        self
    }

    /// Appends formulas with words between them.
    #[must_use]
    pub fn list(
        mut self,
        formulas: impl IntoIterator<Item = String>,
        separator: &'static str,
    ) -> Self {
        for (index, formula) in formulas.into_iter().enumerate() {
            if index > 0 {
                self = self.words(separator);
            }
            self = self.mathematics(formula);
        }
        self
    }

    /// Appends another phrase.
    #[must_use]
    pub fn then(mut self, other: Phrase) -> Self {
        self.pieces.extend(other.pieces);
        self
    }

    /// The parts, in reading order.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The formula of a phrase that is nothing else.
    pub fn as_mathematics(&self) -> Option<&str> {
        match self.pieces.as_slice() {
            [Piece::Mathematics(formula)] => Some(formula),
            _ => None,
        }
    }

    /// The phrase as a text, its parts converted by what the format does to them.
    pub fn render(
        &self,
        words: impl Fn(&str) -> String,
        mathematics: impl Fn(&str) -> String,
    ) -> String {
        let pieces = self.pieces.iter().map(|piece| match piece {
            Piece::Words(text) => words(text),
            Piece::Mathematics(formula) => mathematics(formula),
        });
        pieces.collect()
    }

    /// The phrase as it stands.
    pub fn plain(&self) -> String {
        self.render(str::to_owned, str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_formulas_are_converted_apart() {
        let phrase = Phrase::of_words("small in ").list(["a".into(), "b".into()], ", ");
        assert_eq!(phrase.plain(), "small in a, b");
        let marked = phrase.render(str::to_uppercase, |formula| format!("${formula}$"));
        assert_eq!(marked, "SMALL IN $a$, $b$");
        assert_eq!(phrase.as_mathematics(), None);
        assert_eq!(Phrase::of_mathematics("x").as_mathematics(), Some("x"));
    }
}
