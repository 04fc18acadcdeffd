//! Emitted text in tokens, without its comments.
//!
//! Only comments are left out. What a compiler might take for something else than it seems here is
//! refused: continued lines, nested comments, letters beyond ASCII.

use super::body::Unreadable;

/// Whose tokens and comments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dialect {
    Rust,
    C,
    Python,
    Octave,
}

/// A word, a number, a sign, a text in quotation marks, a line for the preprocessor of C, the start of a
/// line of Octave, or that of a line of Python with its indentation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token<'a> {
    pub(super) text: &'a str,
    /// Counted from 1.
    pub(super) line: usize,
    /// Its first byte in the text.
    pub(super) start: usize,
}

/// Signs of two characters, which are not the same as these characters one by one.
const LONG: [&str; 20] = [
    "::", "->", "..", "--", "++", "**", "//", "==", "!=", "<=", ">=", "+=", "-=", "*=", "/=", "&&",
    "||", ".*", "./", "~=",
];

const SHORT: &str = "+-*/=<>&!?.,;:()[]{}'#@|~";

/// The start of a line of Python, as deep as lines go.
const LINE: &str = "\n                ";

/// All tokens of a text.
///
/// # Errors
///
/// [`Unreadable`] at the first character that belongs to none.
pub(super) fn tokens(text: &str, dialect: Dialect) -> Result<Vec<Token<'_>>, Unreadable> {
    let mut scanner = Scanner {
        text,
        dialect,
        at: 0,
        line: 1,
        brackets: 0,
        tokens: Vec::new(),
    };
    if dialect == Dialect::C {
        scanner.refuse_continued_lines()?;
    }
    while scanner.at < text.len() {
        scanner.step()?;
    }
    Ok(scanner.tokens)
}

struct Scanner<'a> {
    text: &'a str,
    dialect: Dialect,
    at: usize,
    line: usize,
    brackets: usize,
    tokens: Vec<Token<'a>>,
}

impl<'a> Scanner<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn refuse(&self, reason: impl Into<String>) -> Unreadable {
        Unreadable {
            line: self.line,
            reason: reason.into(),
        }
    }

    /// Moves behind some bytes, and counts the lines among them.
    fn skip(&mut self, length: usize) {
        let (passed, _) = self.rest().split_at(length);
        self.line += passed.bytes().filter(|byte| *byte == b'\n').count();
        self.at += length;
    }

    fn push(&mut self, length: usize) {
        self.tokens.push(Token {
            text: &self.rest()[..length],
            line: self.line,
            start: self.at,
        });
        self.skip(length);
    }

    /// A line that ends in a backslash goes on in the next one, even inside of `*/`. To some compilers a
    /// carriage return ends a line.
    fn refuse_continued_lines(&mut self) -> Result<(), Unreadable> {
        for line in self.text.lines() {
            let is_continued = line.split('\r').any(|part| part.trim_end().ends_with('\\'));
            if is_continued || line.contains("??") {
                return Err(self.refuse("a line that is continued, or a trigraph"));
            }
            self.line += 1;
        }
        self.line = 1;
        Ok(())
    }

    fn is_at_start_of_line(&self) -> bool {
        let before = &self.text[..self.at];
        before
            .rsplit('\n')
            .next()
            .is_none_or(|line| line.trim().is_empty())
    }

    fn step(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        let is_start = self.at == 0 || self.text[..self.at].ends_with('\n');
        if self.dialect == Dialect::Octave && is_start {
            return self.start_of_line();
        }
        if self.dialect == Dialect::Python && is_start {
            let indentation = rest.len() - rest.trim_start_matches(' ').len();
            self.skip(indentation);
            let rest = self.rest();
            if rest.is_empty() || rest.starts_with('\n') {
                self.skip(rest.len().min(1));
                return Ok(());
            }
            if rest.starts_with("\"\"\"") && self.brackets == 0 {
                return self.documentation();
            }
            let Some(text) = LINE.get(..=indentation) else {
                return Err(self.refuse("a line that is indented too far"));
            };
            let (line, start) = (self.line, self.at);
            self.tokens.push(Token { text, line, start });
            // The line has a character, which is no line feed.
            return self.sign_or_word();
        }
        self.sign_or_word()
    }

    /// A line ends a statement, however far it is indented; one without a statement says nothing.
    fn start_of_line(&mut self) -> Result<(), Unreadable> {
        let indentation = self.rest().len() - self.rest().trim_start_matches(' ').len();
        self.at += indentation;
        if !self.rest().is_empty() && !self.rest().starts_with(['\n', '%']) {
            let (text, line, start) = (&LINE[..1], self.line, self.at);
            self.tokens.push(Token { text, line, start });
        }
        self.sign_or_word()
    }

    /// Whether a comment of Octave ends with its line: `%{` alone on one hides those behind it, and to
    /// some a carriage return ends a line.
    fn is_line_comment(&self) -> bool {
        let line = self.rest().lines().next().unwrap_or("");
        !line.starts_with("%{") && !line.contains('\r')
    }

    fn sign_or_word(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        let Some(first) = rest.chars().next() else {
            return Ok(());
        };
        match (self.dialect, first) {
            (_, '\n') => self.skip(1),
            (_, ' ') => self.at += rest.len() - rest.trim_start_matches(' ').len(),
            (Dialect::Octave, '%') if self.is_line_comment() => {
                self.skip(rest.find('\n').unwrap_or(rest.len()));
            }
            (Dialect::Octave, '\'' | '#' | '!') => {
                return Err(self.refuse("a text or a comment of another kind"));
            }
            (Dialect::Octave, _) if rest.starts_with("...") => {
                return Err(self.refuse("a line that is continued"));
            }
            (Dialect::Rust, '/') if rest.starts_with("//") => {
                self.skip(rest.find('\n').unwrap_or(rest.len()));
            }
            (Dialect::C, '/') if rest.starts_with("/*") => match rest[2..].find("*/") {
                Some(end) => self.skip(end + 4),
                None => return Err(self.refuse("a comment without an end")),
            },
            (Dialect::Rust | Dialect::C, '/')
                if rest.starts_with("/*") || rest.starts_with("//") =>
            {
                return Err(self.refuse("a comment of another kind"));
            }
            (Dialect::C, '#') if self.is_at_start_of_line() => {
                let line = rest.lines().next().unwrap_or("");
                self.push(line.trim_end_matches(' ').len());
            }
            (Dialect::Python, '#') => return Err(self.refuse("a comment of another kind")),
            (_, '"') => match rest[1..].find(['"', '\\', '\n']) {
                Some(end) if rest[1 + end..].starts_with('"') => self.push(end + 2),
                _ => return Err(self.refuse("a text without an end")),
            },
            (_, '0'..='9') => {
                let length = number(rest);
                let behind = rest[length..].chars().next();
                if behind.is_some_and(|next| next.is_ascii_alphanumeric() || next == '_') {
                    return Err(self.refuse("a number that runs into a word"));
                }
                self.push(length);
            }
            // Holes of shapes begin with a dollar sign.
            _ if first.is_ascii_alphabetic() || first == '_' || first == '$' => {
                let length =
                    rest[1..].find(|next: char| !next.is_ascii_alphanumeric() && next != '_');
                self.push(length.map_or(rest.len(), |length| length + 1));
            }
            _ => return self.sign(),
        }
        Ok(())
    }

    fn sign(&mut self) -> Result<(), Unreadable> {
        let rest = self.rest();
        // Most signs stand alone, before a blank or a word.
        let is_long = |two: &str| two.ends_with(|next| SHORT.contains(next)) && LONG.contains(&two);
        if rest.get(..2).is_some_and(is_long) {
            self.push(2);
            return Ok(());
        }
        match rest.chars().next() {
            Some(sign) if SHORT.contains(sign) => {
                match sign {
                    '(' | '[' | '{' => self.brackets += 1,
                    ')' | ']' | '}' => self.brackets = self.brackets.saturating_sub(1),
                    _ => {}
                }
                self.push(1);
                Ok(())
            }
            other => {
                let character = other.map(String::from).unwrap_or_default();
                Err(self.refuse(format!("the character {character:?}")))
            }
        }
    }

    /// A text in three quotation marks that is a line, or several, of its own.
    fn documentation(&mut self) -> Result<(), Unreadable> {
        let (rest, mut end) = (self.rest(), 3);
        loop {
            let behind = &rest[end.min(rest.len())..];
            match behind.find(['\\', '"']) {
                Some(place) if behind[place..].starts_with("\"\"\"") => {
                    end += place + 3;
                    break;
                }
                Some(place) if behind[place..].starts_with('\\') => {
                    let escaped = behind[place + 1..].chars().next().map_or(0, char::len_utf8);
                    end += place + 1 + escaped;
                }
                Some(place) => end += place + 1,
                None => return Err(self.refuse("a text without an end")),
            }
        }
        if !(rest[end..].is_empty() || rest[end..].starts_with('\n')) {
            return Err(self.refuse("a text that is not alone on its lines"));
        }
        self.skip(end);
        Ok(())
    }
}

/// How long a number is: `8`, `8.0`, `1.5e-3`.
fn number(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = &text[from..];
        rest.len()
            - rest
                .trim_start_matches(|next: char| next.is_ascii_digit())
                .len()
    };
    let mut length = digits(0);
    if text[length..].starts_with('.') && digits(length + 1) > 0 {
        length += 1 + digits(length + 1);
    }
    if text[length..].starts_with(['e', 'E']) {
        let sign = usize::from(text[length + 1..].starts_with(['+', '-']));
        let exponent = digits(length + 1 + sign);
        if exponent > 0 {
            length += 1 + sign + exponent;
        }
    }
    length
}
