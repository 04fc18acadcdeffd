//! A position in the tokens of a statement, and the messages for what stands there.

mod unexpected;

use super::diagnostic::Diagnostic;
use super::keyword::is_keyword;
use super::lexer::{LinePosition, Token, TokenKind};
use super::name::{Aliases, DottedName};
use super::syntax::{Name, Span, Spanned};

/// What a parser returns: the thing, or why there is none.
pub(crate) type Parsed<T> = Result<T, Diagnostic>;

/// Walks over the tokens of one statement.
pub(crate) struct Cursor<'document> {
    text: &'document str,
    tokens: &'document [Token],
    position: usize,
    /// The spellings declared so far in the document.
    pub(crate) aliases: &'document mut Aliases,
    /// How many brackets, signs and powers enclose the position.
    pub(crate) nesting: usize,
}

impl<'document> Cursor<'document> {
    /// Begins at the first of the tokens.
    pub(crate) fn new(
        text: &'document str,
        tokens: &'document [Token],
        aliases: &'document mut Aliases,
    ) -> Self {
        Self {
            text,
            tokens,
            position: 0,
            aliases,
            nesting: 0,
        }
    }

    /// The sort of the next token; none at the end of the statement.
    pub(crate) fn peek(&self) -> Option<TokenKind> {
        self.peek_at(0)
    }

    /// The sort of a token further on.
    pub(crate) fn peek_at(&self, distance: usize) -> Option<TokenKind> {
        self.tokens
            .get(self.position + distance)
            .map(|token| token.kind)
    }

    /// Whether there is such a token in the rest of the statement.
    pub(crate) fn is_ahead(&self, kind: TokenKind) -> bool {
        let rest = self.tokens.get(self.position..).unwrap_or_default();
        rest.iter().any(|token| token.kind == kind)
    }

    /// The text of the next token; empty at the end.
    pub(crate) fn peek_text(&self) -> &'document str {
        self.tokens
            .get(self.position)
            .map_or("", |token| self.text_of(&token.span))
    }

    /// The text of a range.
    pub(crate) fn text_of(&self, span: &Span) -> &'document str {
        self.text.get(span.clone()).unwrap_or_default()
    }

    /// Where the next token stands; the empty place behind the last one at the end.
    pub(crate) fn here(&self) -> Span {
        match self.tokens.get(self.position) {
            Some(token) => token.span.clone(),
            None => self.previous_end()..self.previous_end(),
        }
    }

    /// Where the next few tokens stand, together.
    pub(crate) fn span_of_next(&self, count: usize) -> Span {
        let last = self.tokens.get(self.position..self.position + count);
        let end = last.and_then(<[Token]>::last).map(|token| token.span.end);
        self.here().start..end.unwrap_or_else(|| self.here().end)
    }

    /// From a beginning to the end of the token before the position.
    pub(crate) fn since(&self, start: usize) -> Span {
        start..self.previous_end().max(start)
    }

    /// Where the token before the position stands.
    pub(crate) fn previous(&self) -> Option<&Token> {
        self.tokens.get(self.position.checked_sub(1)?)
    }

    fn previous_end(&self) -> usize {
        self.previous().map_or(0, |token| token.span.end)
    }

    /// Whether a line begins here that was meant as a statement of its own, but is indented.
    pub(crate) fn is_at_indented_statement(&self) -> bool {
        let token = self.tokens.get(self.position);
        let is_indented = token.is_some_and(|token| token.position == LinePosition::Indented);
        is_indented && (is_keyword(self.peek_text()) || self.peek_at(1) == Some(TokenKind::Define))
    }

    /// Steps over the next token.
    pub(crate) fn advance(&mut self) {
        self.position += 1;
    }

    /// Steps over the next token if it is of this sort.
    pub(crate) fn accept(&mut self, kind: TokenKind) -> Option<Span> {
        if self.peek() != Some(kind) {
            return None;
        }
        let span = self.here();
        self.advance();
        Some(span)
    }

    /// Whether the next token is this word.
    pub(crate) fn is_at_word(&self, word: &str) -> bool {
        self.peek() == Some(TokenKind::Name) && self.peek_text() == word
    }

    /// Steps over the next token if it is this word.
    pub(crate) fn accept_word(&mut self, word: &str) -> bool {
        let found = self.is_at_word(word);
        if found {
            self.advance();
        }
        found
    }

    /// Steps over a token that must be there; `what` describes it.
    pub(crate) fn expect(&mut self, kind: TokenKind, what: &str) -> Parsed<Span> {
        self.accept(kind).ok_or_else(|| self.expected(what))
    }

    /// Steps over a word that must be there.
    pub(crate) fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.accept_word(word) {
            Ok(())
        } else {
            Err(self.expected(&format!("`{word}`")))
        }
    }

    /// Steps over the closing bracket of one that stands at `open`.
    pub(crate) fn expect_closing(&mut self, kind: TokenKind, open: &Span) -> Parsed<()> {
        if self.accept(kind).is_some() {
            return Ok(());
        }
        if self.peek().is_some() {
            let what = match kind {
                TokenKind::CloseRound => "`)`",
                TokenKind::CloseSquare => "`]`",
                _ => "`|`",
            };
            let error = self
                .expected_after_operand(what)
                .or_help(format!("close the bracket with {what} before this"));
            return Err(error.with_secondary(open.clone(), "the bracket is opened here"));
        }
        let bracket = self.text_of(open);
        Err(
            Diagnostic::syntax(open.clone(), format!("`{bracket}` is never closed"))
                .with_label("opened here")
                .with_help("close it where it ends, or take it away")
                .with_secondary(self.here(), "the statement ends here"),
        )
    }

    /// Steps over a string, and returns what stands between its quotation marks.
    pub(crate) fn accept_text(&mut self) -> Parsed<Option<Spanned<String>>> {
        if self.peek() == Some(TokenKind::UnclosedText) {
            return Err(Diagnostic::syntax(
                self.here(),
                "a string must end on the line where it begins",
            )
            .with_label("no second `\"` on this line")
            .with_help("close the string with `\"`; a string cannot contain one"));
        }
        let Some(span) = self.accept(TokenKind::Text) else {
            return Ok(None);
        };
        let value = self.text_of(&span).trim_matches('"').to_owned();
        Ok(Some(Spanned { value, span }))
    }

    /// Reads the word at the position as a name that may have dots.
    pub(crate) fn dotted_name(&mut self, what: &str) -> Parsed<(DottedName, Span)> {
        if self.peek() != Some(TokenKind::Name) {
            return Err(self.expected(what));
        }
        let span = self.here();
        let dotted = match DottedName::read(self.peek_text()) {
            Ok(dotted) => dotted,
            Err(reason) => return Err(self.invalid_name(reason)),
        };
        self.advance();
        Ok((
            DottedName {
                name: self.aliases.resolve(dotted.name),
                dots: dotted.dots,
            },
            span,
        ))
    }

    /// Reads a name without dots; `what` describes it.
    pub(crate) fn name(&mut self, what: &str) -> Parsed<Spanned<Name>> {
        let (dotted, span) = self.dotted_name(what)?;
        if dotted.dots == 0 {
            return Ok(Spanned {
                value: dotted.name,
                span,
            });
        }
        let message = format!("expected {what}, found the rate `{}`", self.text_of(&span));
        Err(Diagnostic::syntax(span, message)
            .with_label("this has a dot")
            .with_help(format!("name `{}` without the dot", dotted.name)))
    }

    /// Reads names with commas between them; `what` describes one.
    pub(crate) fn names(&mut self, what: &str) -> Parsed<Vec<Spanned<Name>>> {
        let mut names = vec![self.name(what)?];
        while self.accept(TokenKind::Comma).is_some() {
            names.push(self.name(what)?);
        }
        Ok(names)
    }

    /// Fails unless the statement ends here; `what` describes what else could have stood here.
    pub(crate) fn expect_end(&self, what: &str) -> Parsed<()> {
        if self.peek().is_none() {
            return Ok(());
        }
        let unexpected = || self.expected_after_operand(&format!("{what}the end of the statement"));
        Err(self.surplus_bracket().unwrap_or_else(unexpected))
    }
}
