//! The messages for what stands where something else must.

use super::Cursor;
use crate::derivation::diagnostic::Diagnostic;
use crate::derivation::lexer::TokenKind;
use crate::derivation::name::InvalidName;

impl Cursor<'_> {
    /// The error for something else than `what` at the position.
    pub(crate) fn expected(&self, what: &str) -> Diagnostic {
        let found = self.peek_text();
        match self.peek() {
            None => {
                let message = format!("the statement ends where {what} must stand");
                let error = Diagnostic::syntax(self.here(), message);
                let error = error.with_label(format!("expected {what} here"));
                error.with_help("indent the next line if the statement goes on there")
            }
            Some(TokenKind::Unknown) => self.unknown_character(),
            Some(TokenKind::Text | TokenKind::UnclosedText) => Diagnostic::syntax(
                self.here(),
                format!("a string stands where {what} must stand"),
            )
            .with_label(format!("expected {what}")),
            Some(_) => Diagnostic::syntax(
                self.here(),
                format!("`{found}` stands where {what} must stand"),
            )
            .with_label(format!("expected {what}")),
        }
    }

    /// Like [`Cursor::expected`], behind an expression: there, two operands side by side are the usual mistake.
    pub(crate) fn expected_after_operand(&self, what: &str) -> Diagnostic {
        let (Some(previous), Some(kind)) = (self.previous(), self.peek()) else {
            return self.expected(what);
        };
        let mistake = self.expected(what);
        if kind == TokenKind::Equals {
            return mistake.with_help("equality is written `==`, a definition `:=`");
        }
        if kind == TokenKind::UnclosedText
            || !(previous.kind.ends_operand() && kind.begins_operand())
        {
            return mistake;
        }
        let (left, right) = (self.text_of(&previous.span), self.peek_text());
        let product = format!("{left}*{right}");
        Diagnostic::syntax(
            self.here(),
            format!("`{left}` and `{right}` stand side by side"),
        )
        .with_label(format!("expected an operator, or {what}"))
        .with_help(format!("a product needs its sign: write `{product}`"))
    }

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
