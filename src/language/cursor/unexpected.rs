//! The messages for what stands where something else must.

use super::Cursor;
use crate::language::diagnostic::Diagnostic;
use crate::language::lexer::{Token, TokenKind};
use crate::language::name::InvalidName;

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
        if self.is_at_indented_statement() {
            return mistake.with_help(
                "this line is indented, so it continues the one above: begin a statement at the margin",
            );
        }
        if kind == TokenKind::Equals {
            return mistake.with_help("equality is written `==`, a definition `:=`");
        }
        let are_operands = previous.kind.ends_operand() && kind.begins_operand();
        if !are_operands || CLAUSES.contains(&self.peek_text()) {
            return mistake;
        }
        if let Some(error) = self.exponential_number(previous) {
            return error;
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

    /// The error for `1e3`, a number and a name without a space between them.
    fn exponential_number(&self, number: &Token) -> Option<Diagnostic> {
        let here = self.here();
        let is_number = number.kind == TokenKind::Number && number.span.end == here.start;
        let digits = self
            .peek_text()
            .strip_prefix(['e', 'E'])
            .filter(|_| is_number)?;
        let (span, exponent) = match (digits, self.peek_at(1), self.peek_at(2)) {
            ("", Some(TokenKind::Plus | TokenKind::Minus), Some(TokenKind::Number)) => {
                let sign = self.span_of_next(2).end..self.span_of_next(3).end;
                let minus = if self.peek_at(1) == Some(TokenKind::Minus) {
                    "-"
                } else {
                    ""
                };
                let digits = self.text_of(&sign).trim();
                (number.span.start..sign.end, format!("{minus}{digits}"))
            }
            (digits, ..)
                if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) =>
            {
                (number.span.start..here.end, digits.to_owned())
            }
            _ => return None,
        };
        let written = self.text_of(&span);
        let help = match self.text_of(&number.span) {
            "1" if exponent.len() == 1 => {
                let zeros = "0".repeat(exponent.parse().unwrap_or(0));
                format!("write 1{zeros} or 10^{exponent}")
            }
            mantissa => format!("write {mantissa}*10^{exponent}"),
        };
        let error = Diagnostic::syntax(span.clone(), format!("there is no `{written}`"));
        Some(
            error
                .with_label("numbers have no exponents")
                .with_help(help),
        )
    }

    /// The error for a bracket at the position that no other one opens, if there is a bracket.
    pub(crate) fn surplus_bracket(&self) -> Option<Diagnostic> {
        let is_closing = matches!(
            self.peek(),
            Some(TokenKind::CloseRound | TokenKind::CloseSquare)
        );
        let message = format!("`{}` closes no bracket", self.peek_text());
        let error = Diagnostic::syntax(self.here(), message);
        is_closing.then(|| {
            error
                .with_label("no bracket of this kind is open here")
                .with_help("take it away, or open one where it should begin")
        })
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
            "≟" | "≡" => "equality is written `==`, in an approximation also `≈`",
            _ => {
                "outside of strings and comments there are letters, digits and + - * / ^ ( ) [ ] | √ ' , ; : = < >"
            }
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
            InvalidName::TwoScripts(greek, latin) => (
                format!("`{word}` has the Greek `{greek}`, which looks like the Latin `{latin}`"),
                "write each part of a name in one script, or take a letter that looks different",
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
