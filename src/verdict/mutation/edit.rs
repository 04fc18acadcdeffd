//! Edits of one token of a statement.

use super::exchange::exchanges;
use super::likeness::alike;
use crate::derivation::scope::{Entry, Meaning, Scope};
use crate::language::lexer::{Token, TokenKind, tokens};
use crate::language::syntax::{Expression, Name, Span, Statement, StatementKind};

/// One token that becomes another one, or two neighbours that are exchanged.
#[derive(Clone, Debug)]
pub struct Edit {
    /// The statement in which it is.
    statement: Statement,
    /// The line on which it is, counted from 1.
    pub line: usize,
    /// What is replaced.
    span: Span,
    /// What stands there.
    pub from: String,
    /// What stands there then.
    pub to: String,
}

impl Edit {
    /// The statement, in one line.
    pub fn statement(&self, text: &str) -> String {
        let words = text[self.statement.span.clone()].split_whitespace();
        words.collect::<Vec<_>>().join(" ")
    }

    /// The name that stands there then, if it is one.
    pub(super) fn name(&self) -> Name {
        name(&self.to)
    }

    /// A text after the edit.
    pub(super) fn applied(&self, text: &str) -> String {
        [&text[..self.span.start], &self.to, &text[self.span.end..]].concat()
    }

    /// A text in which what is defined after the edit is claimed to be what it is before, and the line of the claim.
    pub(super) fn compared(&self, text: &str) -> Option<(String, usize)> {
        let StatementKind::Definition {
            arguments, values, ..
        } = &self.statement.kind
        else {
            return None;
        };
        let holds =
            |own: &&Expression| own.span.start <= self.span.start && self.span.end <= own.span.end;
        let value = values.iter().find(holds).filter(|_| arguments.is_empty())?;
        let old = &text[value.span.clone()];
        let new = [
            &text[value.span.start..self.span.start],
            &self.to,
            &text[self.span.end..value.span.end],
        ];
        let end = self.statement.span.end;
        let claim = format!("\nclaim [the same]: ({old}) == ({})", new.concat());
        let line = 2 + text[..end].matches('\n').count();
        Some(([&text[..end], &claim, &text[end..]].concat(), line))
    }
}

/// All edits of a statement, which begins on a line.
pub(super) fn edits(text: &str, statement: &Statement, line: usize, scope: &Scope) -> Vec<Edit> {
    let all = with_outputs(tokens(text, &statement.span));
    let head = all.iter().position(|own| ends_head(own.kind));
    let first = head.map_or(0, |place| place + 1);
    let places = first..all.len();
    let edited = places.flat_map(|place| replacements(text, &all, place, statement, scope));
    let edit = |(span, to): (Span, String)| Edit {
        statement: statement.clone(),
        line: line + text[statement.span.start..span.start].matches('\n').count(),
        from: text[span.clone()].to_string(),
        span,
        to,
    };
    edited.chain(exchanges(text, statement)).map(edit).collect()
}

/// Tokens, of which those of the name of an output are one.
fn with_outputs(tokens: Vec<Token>) -> Vec<Token> {
    let mut all: Vec<Token> = Vec::new();
    for token in tokens {
        match all.as_mut_slice() {
            [.., owner, dot] if is_output(owner, dot, &token) => {
                owner.span.end = token.span.end;
                all.pop();
            }
            _ => all.push(token),
        }
    }
    all
}

/// Whether a name, what stands behind it and the next token are the name of an output, `closed_form.λ_R1`.
fn is_output(owner: &Token, dot: &Token, output: &Token) -> bool {
    let kinds = [owner, dot, output].map(|own| own.kind);
    kinds == [TokenKind::Name, TokenKind::Unknown, TokenKind::Name]
        && owner.span.end == dot.span.start
        && dot.span.end == output.span.start
}

/// A name as it is written.
fn name(text: &str) -> Name {
    match text.split_once('.') {
        Some((owner, output)) => Name::new(owner).output(&Name::new(output)),
        None => Name::new(text),
    }
}

/// Behind which a statement says what its name means; an assumption has no name.
fn ends_head(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Define | TokenKind::Colon)
}

/// What may stand in place of a token, and where.
fn replacements(
    text: &str,
    all: &[Token],
    place: usize,
    statement: &Statement,
    scope: &Scope,
) -> Vec<(Span, String)> {
    let token = &all[place];
    let own = &text[token.span.clone()];
    let before = place.checked_sub(1).map(|place| all[place].kind);
    let behind = all.get(place + 1).map(|own| own.kind);
    let is_sign = before.is_none_or(|own| !own.ends_operand());
    let by = |to: &str| vec![(token.span.clone(), to.to_string())];
    match token.kind {
        TokenKind::Plus => by("-"),
        // A sign is left out; what is subtracted is added.
        TokenKind::Minus => by(if is_sign { "" } else { "+" }),
        TokenKind::Star => by("/"),
        TokenKind::Slash => by("*"),
        TokenKind::Less => by(">"),
        TokenKind::Greater => by("<"),
        TokenKind::LessOrEqual => by(">="),
        TokenKind::GreaterOrEqual => by("<="),
        TokenKind::Number => next_number(own).map_or(Vec::new(), |next| by(&next)),
        TokenKind::Superscript => by(&next_power(own)),
        TokenKind::Primes if own.chars().count() == 1 && own != "″" => [by(""), by("″")].concat(),
        TokenKind::Primes => by("′"),
        // What stands before an equality sign is named, and not used.
        TokenKind::Name if behind == Some(TokenKind::Equals) => Vec::new(),
        TokenKind::Name => {
            let mut found = names(own, statement, scope).map_or(Vec::new(), |name| by(&name));
            let takes_prime = !matches!(behind, Some(TokenKind::Primes | TokenKind::OpenRound));
            if takes_prime && is_function(own, scope) {
                found.push((token.span.end..token.span.end, "′".to_string()));
            }
            found
        }
        _ => Vec::new(),
    }
}

/// A number that is larger by 1; nothing for one of very many digits.
fn next_number(text: &str) -> Option<String> {
    let (whole, rest) = text.split_once('.').unwrap_or((text, ""));
    let next = whole.parse::<u64>().ok()?.checked_add(1)?;
    let point = if rest.is_empty() { "" } else { "." };
    Some(format!("{next}{point}{rest}"))
}

/// A power that is larger by 1, as far as its last digit.
fn next_power(text: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let mut letters: Vec<char> = text.chars().collect();
    let place = letters
        .last()
        .and_then(|last| DIGITS.iter().position(|own| own == last));
    if let (Some(place), Some(last)) = (place, letters.last_mut()) {
        *last = DIGITS[(place + 1) % DIGITS.len()];
    }
    letters.into_iter().collect()
}

/// A name in place of a name: the other of sine and cosine, or the next that is like it, and an output for an output.
fn names(own: &str, statement: &Statement, scope: &Scope) -> Option<String> {
    match own {
        "sin" => return Some("cos".to_string()),
        "cos" => return Some("sin".to_string()),
        _ => {}
    }
    let entry = scope.get(&name(own))?;
    let is_output = |own: &Entry| own.name.of_output().is_some();
    let is_known = |other: &&Entry| {
        let span = other.span.as_ref();
        span.is_none_or(|span| span.start < statement.span.start)
    };
    let others = || {
        scope
            .entries()
            .filter(is_known)
            .filter(|other| is_output(other) == is_output(entry))
            .filter(|other| alike(&entry.meaning, &other.meaning))
    };
    let behind = others().find(|other| other.name.ascii > entry.name.ascii);
    let next = behind.or_else(|| others().next())?;
    (next.name != entry.name).then(|| next.name.unicode.clone())
}

fn is_function(own: &str, scope: &Scope) -> bool {
    let entry = scope.get(&Name::new(own));
    entry.is_some_and(|own| matches!(own.meaning, Meaning::Function { .. }))
}
