//! Breaking lines: prose at spaces, expressions at operators.

use anstyle::Style;
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// Formulas up to this width are not broken within prose.
const UNBROKEN_FORMULA: usize = 28;

/// Some text in one style.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    text: String,
    style: Style,
    is_unbroken: bool,
}

impl Run {
    /// Prose.
    pub fn words(text: impl Into<String>, style: Style) -> Self {
        Run {
            text: printable(&text.into()),
            style,
            is_unbroken: false,
        }
    }

    /// A formula within prose, broken only if it is long.
    pub fn formula(text: impl Into<String>, style: Style) -> Self {
        let text = printable(&text.into());
        let is_unbroken = text.width() <= UNBROKEN_FORMULA;
        Run {
            text,
            style,
            is_unbroken,
        }
    }

    /// How many columns it takes.
    pub fn width(&self) -> usize {
        self.text.width()
    }

    /// The text with the codes of its style.
    pub fn styled(&self) -> String {
        let style = self.style;
        format!("{style}{}{style:#}", self.text)
    }
}

/// A document must not send codes to the terminal.
fn printable(text: &str) -> String {
    text.chars()
        .map(|character| {
            if character.is_control() {
                ' '
            } else {
                character
            }
        })
        .collect()
}

/// Fills lines with words.
pub fn prose(runs: &[Run], width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    let mut filled = 0;
    for word in words(runs, width) {
        let length: usize = word.iter().map(Run::width).sum();
        if filled > 0 && filled + 1 + length > width {
            lines.push(std::mem::take(&mut line));
            filled = 0;
        }
        if filled > 0 {
            line.push(' ');
            filled += 1;
        }
        line.extend(word.iter().map(Run::styled));
        filled += length;
    }
    if filled > 0 {
        lines.push(line);
    }
    lines
}

/// What stands between spaces; a word may change its style within. None is wider than a line.
fn words(runs: &[Run], width: usize) -> Vec<Vec<Run>> {
    let mut words: Vec<Vec<Run>> = vec![Vec::new()];
    for run in runs {
        let parts: Vec<&str> = if run.is_unbroken {
            vec![&run.text]
        } else {
            run.text.split(' ').collect()
        };
        for (index, part) in parts.into_iter().enumerate() {
            if index > 0 {
                words.push(Vec::new());
            }
            for (piece, text) in expression(part, width).into_iter().enumerate() {
                if piece > 0 {
                    words.push(Vec::new());
                }
                if let Some(word) = words.last_mut() {
                    word.push(Run {
                        text,
                        style: run.style,
                        is_unbroken: true,
                    });
                }
            }
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Breaks an expression into lines, at the operator that binds loosest if that does not leave most of
/// the line empty.
pub fn expression(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    let mut rest = text.trim();
    while exceeds(rest, width) {
        let at = break_at(rest, width);
        lines.push(rest[..at].trim_end().to_owned());
        rest = rest[at..].trim_start();
    }
    if !rest.is_empty() {
        lines.push(rest.to_owned());
    }
    lines
}

/// Whether a text is wider than a line; of a long one, only the beginning is looked at.
fn exceeds(text: &str, width: usize) -> bool {
    let mut column = 0;
    text.chars().any(|character| {
        column += character.width().unwrap_or(0);
        column > width
    })
}

/// The byte before which a line that is too long is best broken; never 0.
fn break_at(text: &str, width: usize) -> usize {
    let (mut column, mut depth) = (0, 0_usize);
    let (mut best, mut forced): (Option<(usize, usize)>, usize) = (None, 0);
    let mut before = ' ';
    let mut characters = text.char_indices().peekable();
    while let Some((at, character)) = characters.next() {
        let after = characters.peek().map_or(' ', |(_, next)| *next);
        let looseness = match character {
            _ if at == 0 => None,
            '+' | '−' | '-' | '=' | '<' | '>' | '≤' | '≥' if before == ' ' => {
                matches!(after, ' ' | '=').then_some(2 * depth)
            }
            'a' if text[at..].starts_with("at ") && before == ' ' => Some(2 * depth),
            _ if before == ' ' && text[..at].ends_with([',', ';', ' ']) => text[..at]
                .trim_end()
                .ends_with([',', ';'])
                .then_some(2 * depth),
            '·' => Some(2 * depth + 1),
            '/' if after == '(' => Some(2 * depth + 1),
            _ => None,
        };
        // Most of a line is better filled with a tighter part than left empty.
        if let Some(strength) = looseness
            && column <= width
            && best
                .is_none_or(|(least, place)| strength <= least || text[..place].width() * 3 < width)
        {
            best = Some((strength, at));
        }
        column += character.width().unwrap_or(0);
        if column <= width {
            forced = at + character.len_utf8();
        } else {
            break;
        }
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        before = character;
    }
    let first = text.chars().next().map_or(1, char::len_utf8);
    best.map_or(forced.max(first), |(_, at)| at)
}

#[cfg(test)]
mod tests {
    use super::super::palette::{PLAIN, STRONG};
    use super::*;

    #[test]
    fn prose_breaks_at_spaces_and_keeps_formulas_together() {
        let runs = [
            Run::words("where ", PLAIN),
            Run::formula("a = 2", PLAIN),
            Run::words(", and so on", PLAIN),
        ];
        assert_eq!(prose(&runs, 8), ["where", "a = 2,", "and so", "on"]);
        assert_eq!(prose(&runs, 80), ["where a = 2, and so on"]);
        assert!(prose(&[], 10).is_empty());
    }

    #[test]
    fn styles_take_no_room() {
        let runs = [Run::words("bold", STRONG), Run::words(" thin", PLAIN)];
        let lines = prose(&runs, 9);
        assert_eq!(lines.len(), 1);
        assert_eq!(
            anstream::adapter::strip_str(&lines[0]).to_string(),
            "bold thin"
        );
    }

    #[test]
    fn expressions_break_before_the_loosest_operator() {
        let text = "F_x = m·ẍ + 2·(k_x + k_y)·x";
        assert_eq!(expression(text, 20), ["F_x = m·ẍ", "+ 2·(k_x + k_y)·x"]);
        assert_eq!(
            expression("[alpha, beta; gamma]", 13),
            ["[alpha, beta;", "gamma]"]
        );
        assert_eq!(expression("a = −b", 4), ["a", "= −b"]);
    }

    #[test]
    fn no_line_is_too_wide_and_nothing_is_lost() {
        let text = "θ̈_d + abcdefghijklmnopqrstuvwxyz·(1 − x)/(ω_n² + longer_name) at rest";
        for width in 1..60 {
            let lines = expression(text, width);
            assert!(
                lines.iter().all(|line| line.width() <= width),
                "{width}: {lines:?}"
            );
            let joined: String = lines.concat().split(' ').collect();
            assert_eq!(joined, text.split(' ').collect::<String>());
        }
    }

    #[test]
    fn documents_send_no_codes_to_the_terminal() {
        assert_eq!(Run::words("a\u{1b}[31mb", PLAIN).styled(), "a [31mb");
    }
}
