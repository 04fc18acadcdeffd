//! Some text in one style.

use anstyle::Style;
use unicode_width::UnicodeWidthStr;

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
        let text = printable(&text.into());
        Run {
            text,
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

    /// A part of it that is not broken again.
    pub fn part(&self, text: String) -> Self {
        Run {
            text,
            style: self.style,
            is_unbroken: true,
        }
    }

    /// Whether it looks like another.
    pub fn has_style_of(&self, other: &Run) -> bool {
        self.style == other.style
    }

    /// Adds the text of another.
    pub fn append(&mut self, other: &Run) {
        self.text.push_str(&other.text);
    }

    /// What may stand on different lines.
    pub fn breakable_parts(&self) -> Vec<&str> {
        if self.is_unbroken {
            vec![&self.text]
        } else {
            self.text.split(' ').collect()
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

/// How many columns runs take side by side.
pub fn width(runs: &[Run]) -> usize {
    runs.iter().map(Run::width).sum()
}

/// So many spaces.
pub fn spaces(count: usize) -> Run {
    Run::words(" ".repeat(count), Style::new())
}

/// Some text in a column of the given width.
pub fn column(text: &str, width: usize, style: Style) -> [Run; 2] {
    let run = Run::words(text, style);
    let rest = width.saturating_sub(run.width());
    [run, spaces(rest)]
}

/// A document must not send codes to the terminal.
fn printable(text: &str) -> String {
    let characters = text.chars();
    characters
        .map(|character| {
            if character.is_control() {
                ' '
            } else {
                character
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documents_send_no_codes_to_the_terminal() {
        assert_eq!(Run::words("a\u{1b}[31mb", Style::new()).styled(), "a [31mb");
    }

    #[test]
    fn columns_are_filled_up() {
        assert_eq!(width(&column("θ̇", 4, Style::new())), 4);
        assert_eq!(width(&column("longer", 4, Style::new())), 6);
    }
}
