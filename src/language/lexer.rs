//! The tokens of a block.

use logos::Logos;

use super::syntax::Span;

/// What a token is.
#[derive(Logos, Clone, Copy, Debug, PartialEq, Eq)]
#[logos(skip r"[ \t\u{A0}\u{2009}\u{202F}]+")]
#[logos(skip(r"#[^\r\n]*", allow_greedy = true))]
pub(crate) enum TokenKind {
    /// The end of a line; it never leaves this module.
    #[regex(r"\r\n?|\n")]
    Newline,
    /// A word: a name, or a keyword where one may stand.
    // `∆` (increment) is a symbol, not a letter, but it is what keyboards give for Δ.
    #[regex(r"[\p{L}\u{2206}][\p{L}\p{M}\u{2206}0-9_]*")]
    Name,
    /// `12`, `0.25`
    #[regex(r"[0-9]+(\.[0-9]+)?")]
    Number,
    /// `²`, `⁻¹`
    #[regex(r"⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")]
    Superscript,
    /// `"words"`
    #[regex(r#""[^"\r\n]*""#)]
    Text,
    /// A quotation mark without its partner on the same line.
    #[regex(r#""[^"\r\n]*"#)]
    UnclosedText,
    /// `'`, `′′`, `″`
    #[regex(r"['′″‴]+")]
    Primes,
    /// `+`
    #[token("+")]
    Plus,
    /// `-`
    #[token("-")]
    #[token("−")]
    Minus,
    /// `*`
    #[token("*")]
    #[token("·")]
    #[token("⋅")]
    #[token("×")]
    Star,
    /// `/`
    #[token("/")]
    Slash,
    /// `^`
    #[token("^")]
    #[token("**")]
    Caret,
    /// `(`
    #[token("(")]
    OpenRound,
    /// `)`
    #[token(")")]
    CloseRound,
    /// `[`
    #[token("[")]
    OpenSquare,
    /// `]`
    #[token("]")]
    CloseSquare,
    /// `|`: opens a determinant before an operand, closes it behind one.
    #[token("|")]
    Bar,
    /// `√`
    #[token("√")]
    Root,
    /// `,`
    #[token(",")]
    Comma,
    /// `;`
    #[token(";")]
    Semicolon,
    /// `:`
    #[token(":")]
    Colon,
    /// `:=`
    #[token(":=")]
    Define,
    /// `=`
    #[token("=")]
    Equals,
    /// `==`, or `≈` in an approximation
    #[token("==")]
    #[token("≈")]
    EqualsEquals,
    /// `!=`
    #[token("!=")]
    #[token("≠")]
    NotEqual,
    /// `<`
    #[token("<")]
    Less,
    /// `<=`
    #[token("<=")]
    #[token("≤")]
    LessOrEqual,
    /// `>`
    #[token(">")]
    Greater,
    /// `>=`
    #[token(">=")]
    #[token("≥")]
    GreaterOrEqual,
    /// Anything else; an error where a parser meets it, but a unit or a label may contain it.
    Unknown,
}

impl TokenKind {
    /// Whether an operand can begin with this token.
    pub(crate) fn begins_operand(self) -> bool {
        matches!(
            self,
            Self::Name | Self::Number | Self::OpenRound | Self::OpenSquare | Self::Root | Self::Bar
        )
    }

    /// Whether an operand can end with this token.
    pub(crate) fn ends_operand(self) -> bool {
        matches!(
            self,
            Self::Name
                | Self::Number
                | Self::Superscript
                | Self::Primes
                | Self::CloseRound
                | Self::CloseSquare
                | Self::Bar
        )
    }
}

/// Where a token stands in its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LinePosition {
    /// At the very beginning: a statement may begin here.
    Margin,
    /// First, but behind white space: the statement above goes on.
    Indented,
    /// Behind another token.
    Inside,
}

/// A token and its place.
#[derive(Clone, Debug)]
pub(crate) struct Token {
    /// What it is.
    pub(crate) kind: TokenKind,
    /// Where it stands in the whole document.
    pub(crate) span: Span,
    /// Where it stands in its line.
    pub(crate) position: LinePosition,
}

/// The tokens in a range of a text, which begins at the beginning of a line.
pub(crate) fn tokens(text: &str, range: &Span) -> Vec<Token> {
    let mut line_start = Some(0);
    let mut tokens = Vec::new();
    let block = text.get(range.clone()).unwrap_or_default();
    for (kind, span) in TokenKind::lexer(block).spanned() {
        let kind = kind.unwrap_or(TokenKind::Unknown);
        if kind == TokenKind::Newline {
            line_start = Some(span.end);
            continue;
        }
        let position = match line_start.take() {
            None => LinePosition::Inside,
            Some(start) if start == span.start => LinePosition::Margin,
            Some(_) => LinePosition::Indented,
        };
        let span = range.start + span.start..range.start + span.end;
        tokens.push(Token {
            kind,
            span,
            position,
        });
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        let tokens = tokens(text, &(0..text.len()));
        tokens.iter().map(|token| token.kind).collect()
    }

    #[test]
    fn every_way_to_write_an_operator_is_one_token() {
        assert_eq!(kinds("^ **"), [TokenKind::Caret; 2]);
        assert_eq!(kinds("* · × ⋅"), [TokenKind::Star; 4]);
        assert_eq!(kinds("- −"), [TokenKind::Minus; 2]);
        assert_eq!(kinds("<= ≤"), [TokenKind::LessOrEqual; 2]);
        assert_eq!(kinds("== ≈"), [TokenKind::EqualsEquals; 2]);
    }

    #[test]
    fn a_name_keeps_its_marks_and_leaves_its_primes_and_powers() {
        assert_eq!(kinds("θ̇_d²"), [TokenKind::Name, TokenKind::Superscript]);
        assert_eq!(kinds("C_D′"), [TokenKind::Name, TokenKind::Primes]);
        assert_eq!(
            kinds("ρ·D"),
            [TokenKind::Name, TokenKind::Star, TokenKind::Name]
        );
    }

    #[test]
    fn comments_and_strings_end_with_their_line() {
        assert_eq!(
            kinds("a # b \" c\n\"d # e\" \"f\n"),
            [TokenKind::Name, TokenKind::Text, TokenKind::UnclosedText]
        );
        assert_eq!(kinds("a # b\rc # d\r\n\"e\rf"), {
            use TokenKind::{Name, UnclosedText};
            [Name, Name, UnclosedText, Name]
        });
    }

    #[test]
    fn spans_and_positions_are_those_of_the_document() {
        let text = "```\nα\n  b c\n";
        let tokens = tokens(text, &(4..text.len()));
        let places: Vec<_> = tokens
            .iter()
            .map(|token| (&text[token.span.clone()], token.position))
            .collect();
        assert_eq!(
            places,
            [
                ("α", LinePosition::Margin),
                ("b", LinePosition::Indented),
                ("c", LinePosition::Inside)
            ]
        );
    }
}
