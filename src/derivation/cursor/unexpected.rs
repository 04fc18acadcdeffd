//! The messages for what stands where something else must.

use super::Cursor;
use crate::derivation::diagnostic::Diagnostic;
use crate::derivation::lexer::TokenKind;
use crate::derivation::name::InvalidName;

/// The words that begin a clause of a statement: behind an operand they are no second factor.
const CLAUSES: [&str; 11] = [
    "as", "at", "to", "of", "value", "vector", "with", "in", "unknown", "neglect", "small",
];

impl Cursor<'_> {
    /// The error for something else than `what` at the position.
    pub(crate) fn expected(&self, what: &str) -> Diagnostic {
        let found = match self.peek() {
            None => {
                let message = format!("expected {what}, but the statement ends");
                return Diagnostic::syntax(self.here(), message)
                    .with_label("something is missing here")
                    .with_help("to continue a statement on the next line, indent that line");
            }
            Some(TokenKind::Unknown) => return self.unknown_character(),
            Some(TokenKind::Text | TokenKind::UnclosedText) => "a string".to_owned(),
            Some(_) => format!("`{}`", self.peek_text()),
        };
        Diagnostic::syntax(self.here(), format!("expected {what}, found {found}"))
            .with_label("not expected here")
    }

    /// Like [`Cursor::expected`], behind an expression: there, two operands side by side are the usual mistake.
    pub(crate) fn expected_after_operand(&self, what: &str) -> Diagnostic {
        let mistake = self.expected(what);
        let (Some(previous), Some(kind)) = (self.previous(), self.peek()) else {
            return mistake;
        };
        if kind == TokenKind::Equals {
            return mistake.with_help("equality is written `==`, a definition `:=`");
        }
        let are_operands = previous.kind.ends_operand() && kind.begins_operand();
        if !are_operands || CLAUSES.contains(&self.peek_text()) {
            return mistake;
        }
        let (left, right) = (self.text_of(&previous.span), self.peek_text());
        let help = if [previous.kind, kind].iter().all(|kind| is_word(*kind)) {
            format!("a product needs its sign: write `{left}*{right}`")
        } else {
            "a product needs its sign: write `*` between its factors".to_owned()
        };
        let message = format!("`{left}` and `{right}` stand side by side");
        Diagnostic::syntax(self.here(), message)
            .with_label(format!("expected an operator, or {what}"))
            .with_help(help)
    }

    /// The error for a bracket at the position that no other one opens, if there is a bracket.
    pub(crate) fn surplus_bracket(&self) -> Option<Diagnostic> {
        let is_closing = matches!(
            self.peek(),
            Some(TokenKind::CloseRound | TokenKind::CloseSquare)
        );
        let message = format!("`{}` closes no bracket", self.peek_text());
        let error = Diagnostic::syntax(self.here(), message);
        is_closing.then(|| error.with_label("no bracket of this kind is open here"))
    }

    /// The error for a character that is no token, with what was probably meant.
    fn unknown_character(&self) -> Diagnostic {
        let found = self.peek_text();
        let error = Diagnostic::syntax(self.here(), format!("`{found}` has no meaning here"))
            .with_label("not part of the language");
        let help = match found {
            "–" | "—" => "the minus sign is `-` or `−`",
            "÷" | "∕" | "⁄" => "a quotient is written `a/b`",
            "∙" | "∗" => "a product is written `a*b` or `a·b`",
            "“" | "”" | "„" | "«" | "»" => {
                "a string stands between straight quotation marks: `\"…\"`"
            }
            "." => "a decimal fraction has digits on both sides of its point: `0.5`",
            "{" | "}" => "expressions are grouped by `(` and `)`",
            "\\" | "$" | "&" => "LaTeX is not read here: write `α` or `alpha`, and `a/b`",
            "`" | "~" => "close this block before another one begins",
            _ if found
                .chars()
                .all(|character| ('₀'..='₉').contains(&character)) =>
            {
                "a subscript is written behind `_`: `x_1`"
            }
            _ => return error,
        };
        error.with_help(help)
    }

    /// The error for a word that is no name.
    pub(crate) fn invalid_name(&self, reason: InvalidName) -> Diagnostic {
        let word = self.peek_text();
        let (message, help) = match reason {
            InvalidName::ForeignLetter => (
                format!("`{word}` has letters that are neither Latin nor Greek"),
                "spell names with the letters a-z, A-Z and Greek ones, digits and `_`",
            ),
            InvalidName::MisplacedDot => (
                format!("`{word}` has a dot above a letter that is not its first"),
                "write the dot above the first letter, as in `ẋ_d`, or write `dt(x_d)`",
            ),
            InvalidName::TooManyDots => (
                format!("`{word}` has more than two dots"),
                "write `dt(ẍ)` for a third derivative",
            ),
        };
        Diagnostic::syntax(self.here(), message)
            .with_label("not a name")
            .with_help(help)
    }
}

fn is_word(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Name | TokenKind::Number)
}
