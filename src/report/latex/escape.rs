//! Prose for LaTeX: what it would take for commands, and the mathematics that people write in words.

use unicode_normalization::UnicodeNormalization;

use crate::derivation::name::DottedName;
use crate::derivation::notation::Notation;
use crate::derivation::syntax::{Expression, Name};

/// The text, with `λ_R`, `ẋ` and their like set as mathematics.
pub fn escape(text: &str) -> String {
    let composed: String = text.nfc().collect();
    let mut escaped = String::with_capacity(composed.len());
    let mut rest = composed.as_str();
    while let Some(first) = rest.chars().next() {
        let length = rest
            .find(|letter| !is_of_word(letter))
            .unwrap_or(rest.len());
        let (part, after) = rest.split_at(length.max(first.len_utf8()));
        if length > 0 {
            escaped.push_str(&word(part));
        } else {
            escaped.push_str(&sign(first));
        }
        rest = after;
    }
    escaped
}

/// A word: a name where it has an index, dots or Greek letters.
fn word(word: &str) -> String {
    if word.is_ascii() && !word.contains('_') {
        return word.to_owned();
    }
    match DottedName::read(word) {
        Ok(dotted) if word.contains('_') || word.chars().any(|letter| !is_latin(letter)) => {
            let name = Expression::name(dotted.name);
            let rate = (0..dotted.dots).fold(name, |inner, _| rate(inner));
            format!("${}$", Notation::Latex.expression(&rate))
        }
        _ => word.chars().map(sign).collect(),
    }
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
        for (text, expected) in [
            (
                "100 % & more_or #1",
                r"100 \% \& $\mathit{more}_{\mathrm{or}}$ \#1",
            ),
            (r"a\b{c}", r"a\textbackslash{}b\{c\}"),
            ("λ_R = −b/2", r"$\lambda_{R}$ = $-$b/2"),
            ("[a] < b", r"{[}a{]} \textless{} b"),
            ("θ̇² of ẋ", r"$\dot{\theta}$$^{2}$ of $\dot{x}$"),
            ("§4.2: C_D′ ≥ 0", r"\S{}4.2: $C_{D}$$'$ $\ge$ 0"),
            ("été", "été"),
        ] {
            assert_eq!(escape(text), expected);
        }
    }
}
