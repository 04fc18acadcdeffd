//! A page of text for the terminal, written from top to bottom.

use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column, spaces, width};
use super::{expression, prose};
use crate::report::phrase::{Phrase, Piece};

/// Narrower pages cannot be read.
const LEAST_WIDTH: usize = 40;
/// What stands for the rest of an expression.
const DOTS: &str = " …";

/// A page that is being written; colours are ANSI codes, which the terminal's stream may strip.
#[derive(Clone, Debug)]
pub struct Page {
    width: usize,
    text: String,
}

impl Page {
    /// An empty page of so many columns, but at least 40.
    pub fn new(width: usize) -> Self {
        Page {
            width: width.max(LEAST_WIDTH),
            text: String::new(),
        }
    }

    /// Its columns.
    #[cfg(feature = "stability")]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The page as it is written.
    pub fn finish(self) -> String {
        self.text
    }

    /// An empty line, unless the page is empty or there is one already.
    pub fn gap(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    /// A title with a line of its own, after a gap.
    pub fn heading(&mut self, text: &str) {
        self.gap();
        self.prose(&[], &[Run::words(text, STRONG)]);
    }

    /// A path and a line in it.
    pub fn place(&mut self, path: &str, line: usize) {
        self.prose(&[], &[Run::words(format!("{path}:{line}"), FAINT)]);
    }

    /// Words behind a prefix, below which their later lines are aligned.
    pub fn prose(&mut self, prefix: &[Run], runs: &[Run]) {
        let room = self.room(prefix);
        let column = width(prefix);
        self.lines(prefix, column, prose::lines(runs, room));
    }

    /// A phrase behind a keyword.
    pub fn phrase(&mut self, indent: usize, keyword: &str, phrase: &Phrase) {
        let mut runs = vec![Run::words(keyword, FAINT), spaces(1)];
        runs.extend(phrase.pieces().iter().map(run_of));
        self.prose(&[spaces(indent)], &runs);
    }

    /// A phrase behind a keyword in a column of the given width, below which its later lines are aligned.
    pub fn column(&mut self, width: usize, keyword: &str, phrase: &Phrase) {
        let keyword = column(&format!("  {keyword}"), width, FAINT);
        let pieces = phrase.pieces().iter();
        let runs: Vec<Run> = pieces.map(run_of).collect();
        self.prose(&keyword, &runs);
    }

    /// An expression behind a prefix, its later lines below the given column, of so many lines at
    /// most: whether it had to be shortened.
    pub fn expression(
        &mut self,
        prefix: &[Run],
        column: usize,
        text: &str,
        most_lines: usize,
    ) -> bool {
        let room = self
            .room(prefix)
            .min(self.width.saturating_sub(column))
            .max(1);
        // The last line may have to end in a space and dots.
        let mut lines = expression::lines(text, room.saturating_sub(DOTS.chars().count()));
        let is_shortened = lines.len() > most_lines;
        if is_shortened {
            lines.truncate(most_lines);
            if let Some(last) = lines.last_mut() {
                last.push_str(DOTS);
            }
        }
        let lines = lines
            .into_iter()
            .map(|line| Run::words(line, PLAIN).styled());
        self.lines(prefix, column, lines.collect());
        is_shortened
    }

    /// A faint remark, such as where to read more.
    pub fn hint(&mut self, indent: usize, text: &str) {
        self.prose(&[spaces(indent)], &[Run::words(text, FAINT)]);
    }

    fn room(&self, prefix: &[Run]) -> usize {
        self.width.saturating_sub(width(prefix)).max(1)
    }

    fn lines(&mut self, prefix: &[Run], column: usize, lines: Vec<String>) {
        let mut lines = lines.into_iter();
        let first: String = prefix.iter().map(Run::styled).collect();
        let first = first + &lines.next().unwrap_or_default();
        self.text.push_str(first.trim_end());
        self.text.push('\n');
        for line in lines {
            self.text.push_str(&" ".repeat(column));
            self.text.push_str(&line);
            self.text.push('\n');
        }
    }
}

/// A part of a phrase.
fn run_of(piece: &Piece) -> Run {
    match piece {
        Piece::Words(text) => Run::words(text, PLAIN),
        Piece::Mathematics(formula) => Run::formula(formula, PLAIN),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_expressions_end_in_dots() {
        let mut page = Page::new(40);
        let text = "a + b + c + d + e + f + ".repeat(5);
        assert!(page.expression(&[spaces(2)], 4, &text, 2));
        assert!(!page.expression(&[spaces(2)], 4, "a + b", 2));
        let text = page.finish();
        assert_eq!(text.lines().count(), 3);
        assert!(text.lines().nth(1).is_some_and(|line| line.ends_with('…')));
        assert!(
            text.lines()
                .nth(1)
                .is_some_and(|line| line.starts_with("    "))
        );
    }

    #[test]
    fn gaps_do_not_add_up() {
        let mut page = Page::new(40);
        page.gap();
        page.hint(0, "a");
        page.gap();
        page.gap();
        page.hint(0, "b");
        let text = anstream::adapter::strip_str(&page.finish()).to_string();
        assert_eq!(text, "a\n\nb\n");
    }
}
