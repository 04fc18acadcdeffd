//! Prose for LaTeX: what it would take for commands, and the mathematics that people write in words.

use std::collections::BTreeSet;

use unicode_normalization::UnicodeNormalization;

use crate::language::name::DottedName;
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Name};
use crate::verdict::audit::Audit;

/// How a document's prose is written: the names that it declares are mathematics.
pub struct Prose {
    names: BTreeSet<String>,
}

impl Prose {
    /// The prose about a document.
    pub fn of(audit: &Audit) -> Self {
        let names = audit.names().map(|name| name.unicode.clone()).collect();
        Prose { names }
    }

    /// The text, with declared names such as `λ_R` and `ẋ` set as mathematics.
    pub fn escape(&self, text: &str) -> String {
        let composed: String = text.nfc().collect();
        let mut escaped = String::with_capacity(composed.len());
        let mut rest = composed.as_str();
        while let Some(first) = rest.chars().next() {
            let length = rest
                .find(|letter| !is_of_word(letter))
                .unwrap_or(rest.len());
            let (part, after) = rest.split_at(length.max(first.len_utf8()));
            if length > 0 {
                escaped.push_str(&self.word(part));
            } else {
                escaped.push_str(&sign(first));
            }
            rest = after;
        }
        escaped
    }

    /// A word: a name if it is declared and has an index, dots or Greek letters; an article is no `a`.
    fn word(&self, word: &str) -> String {
        let is_like_a_name = word.contains('_') || word.chars().any(|letter| !is_latin(letter));
        match DottedName::read(word) {
            Ok(dotted) if is_like_a_name && self.names.contains(&dotted.name.unicode) => {
                mathematics(dotted)
            }
            _ => literal(word),
        }
    }
}

/// A text in which nothing is a name, such as a path; letters that T1-encoded text lacks are set alone.
pub fn literal(text: &str) -> String {
    let composed: String = text.nfc().collect();
    let mut rest = composed.as_str();
    let mut escaped = String::with_capacity(rest.len());
    while let Some(first) = rest.chars().next() {
        let marks = rest[first.len_utf8()..].find(|letter| !is_combining(letter));
        let length = marks.map_or(rest.len(), |marks| first.len_utf8() + marks);
        let (letter, after) = rest.split_at(length);
        escaped.push_str(&match DottedName::read(letter) {
            Ok(dotted) if first.is_alphabetic() && !is_latin(first) => mathematics(dotted),
            _ => letter.chars().map(sign).collect(),
        });
        rest = after;
    }
    escaped
}

fn mathematics(dotted: DottedName) -> String {
    let name = Expression::name(dotted.name);
    let rate = (0..dotted.dots).fold(name, |inner, _| rate(inner));
    format!("${}$", Notation::Latex.expression(&rate))
}

fn rate(inner: Expression) -> Expression {
    Expression::call(Name::new("dt"), 0, vec![inner])
}

fn is_of_word(letter: char) -> bool {
    // Superscript digits count as numeric, but belong to no name.
    letter.is_alphabetic() || letter.is_ascii_digit() || letter == '_' || is_combining(letter)
}

fn is_combining(letter: char) -> bool {
    matches!(letter, '\u{300}'..='\u{36F}')
}

/// Whether T1-encoded text has the letter.
fn is_latin(letter: char) -> bool {
    letter < '\u{180}'
}

/// A character of prose.
fn sign(character: char) -> String {
    let command = match character {
        '\\' => r"\textbackslash{}",
        '~' => r"\textasciitilde{}",
        '^' => r"\textasciicircum{}",
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => return format!("\\{character}"),
        // A bracket behind `\item` or `\\` would begin an argument.
        '[' | ']' => return format!("{{{character}}}"),
        '<' => r"\textless{}",
        '>' => r"\textgreater{}",
        '|' => r"\textbar{}",
        '−' => "$-$",
        '·' => r"$\cdot$",
        '×' => r"$\times$",
        '≠' => r"$\ne$",
        '≤' => r"$\le$",
        '≥' => r"$\ge$",
        '≈' => r"$\approx$",
        '√' => r"$\surd$",
        '∂' => r"$\partial$",
        '∞' => r"$\infty$",
        '→' => r"$\to$",
        '′' => "$'$",
        '″' => "$''$",
        '…' => r"\ldots{}",
        '§' => r"\S{}",
        '“' => "``",
        '”' => "''",
        '’' => "'",
        '–' => "--",
        '—' => "---",
        _ => return other(character),
    };
    command.to_owned()
}

/// Raised and lowered digits; what else there is stays as it is.
fn other(character: char) -> String {
    if character.is_control() {
        return " ".to_owned();
    }
    let decomposed: String = character.nfkd().collect();
    match character {
        '²' | '³' | '¹' | '⁰'..='⁹' => format!("$^{{{decomposed}}}$"),
        '₀'..='₉' => format!("$_{{{decomposed}}}$"),
        _ => character.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prose_is_no_command() {
        let names = ["λ_R", "θ", "x", "C_D", "a", "x_1"].map(String::from);
        let prose = Prose {
            names: BTreeSet::from(names),
        };
        for (text, expected) in [
            ("100 % & more_or #1", r"100 \% \& more\_or \#1"),
            (r"a\b{c}", r"a\textbackslash{}b\{c\}"),
            ("λ_R = −b/2", r"$\lambda_{R}$ = $-$b/2"),
            ("[a] < b", r"{[}a{]} \textless{} b"),
            ("θ̇² of ẋ", r"$\dot{\theta}$$^{2}$ of $\dot{x}$"),
            ("§4.2: C_D′ ≥ 0", r"\S{}4.2: $C_{D}$$'$ $\ge$ 0"),
            ("été", "été"),
            ("T _ T $ ^", r"T \_ T \$ \textasciicircum{}"),
            ("__init__ foo_ _x", r"\_\_init\_\_ foo\_ \_x"),
            ("λ_S by ω̇", r"$\lambda$\_S by $\dot{\omega}$"),
            ("x_1, x_1_b", r"$x_{1}$, x\_1\_b"),
        ] {
            assert_eq!(prose.escape(text), expected);
        }
        assert_eq!(literal("x_1.md"), r"x\_1.md");
    }
}
