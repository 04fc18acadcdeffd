//! A document's lines as messages quote them: none is too long to read.

use crate::language::character::visible;
use crate::language::syntax::Span;

/// How many characters of a line are shown.
const MOST_SHOWN: usize = 160;
/// How many of them stand before the first mark.
const BEFORE: usize = 40;
/// What stands for the rest.
const DOTS: char = '…';

/// A text with as many lines as the document, the long ones cut to what is near the marks.
pub(super) struct Excerpt {
    /// The lines.
    pub(super) text: String,
    pieces: Vec<Piece>,
}

/// What is shown of a line, and where.
struct Piece {
    window: Span,
    line_end: usize,
    shown_at: usize,
}

impl Excerpt {
    /// What to show of a text with marks at these places.
    pub(super) fn new(text: &str, marks: &[Span]) -> Self {
        let mut excerpt = Excerpt {
            text: String::with_capacity(text.len()),
            pieces: Vec::new(),
        };
        let mut start = 0;
        for line in text.split_inclusive('\n') {
            excerpt.push(text, start..start + line.len(), marks);
            start += line.len();
        }
        excerpt
    }

    fn push(&mut self, text: &str, line: Span, marks: &[Span]) {
        let content = text[line.clone()].trim_end_matches(['\n', '\r']);
        let content = line.start..line.start + content.len();
        let window = window(text, &content, marks);
        if window.start > content.start {
            self.text.push(DOTS);
        }
        let shown_at = self.text.len();
        self.text.push_str(&visible(&text[window.clone()]));
        if window.end < content.end {
            self.text.push(DOTS);
        }
        self.text.push_str(&text[content.end..line.end]);
        self.pieces.push(Piece {
            window,
            line_end: line.end,
            shown_at,
        });
    }

    /// Where a mark stands in what is shown.
    pub(super) fn mark(&self, mark: &Span) -> Span {
        let start = self.place(mark.start);
        start..self.place(mark.end).max(start)
    }

    fn place(&self, offset: usize) -> usize {
        let index = self
            .pieces
            .partition_point(|piece| piece.line_end <= offset);
        match self.pieces.get(index) {
            Some(piece) => {
                let Span { start, end } = piece.window;
                piece.shown_at + offset.clamp(start, end) - start
            }
            None => self.text.len(),
        }
    }
}

/// The part of a line that is shown: all of it, or what begins shortly before its first mark.
fn window(text: &str, line: &Span, marks: &[Span]) -> Span {
    let is_short = |range: &Span| text[range.clone()].chars().nth(MOST_SHOWN).is_none();
    if line.len() <= MOST_SHOWN || is_short(line) {
        return line.clone();
    }
    let ends = marks.iter().flat_map(|mark| [mark.start, mark.end]);
    let first = ends
        .filter(|end| (line.start..=line.end).contains(end))
        .min();
    let first = first.unwrap_or(line.start);
    let before = text[line.start..first].char_indices().rev().take(BEFORE);
    let start = line.start + before.last().map_or(0, |(at, _)| at);
    let mut rest = text[start..line.end].char_indices();
    let end = rest.nth(MOST_SHOWN).map_or(line.end, |(at, _)| start + at);
    start..end
}

/// A text with its end left out if it is long, and a sign for what cannot be seen.
pub(super) fn shortened(text: &str) -> String {
    let text = &visible(text);
    match text.char_indices().nth(3 * MOST_SHOWN) {
        Some((end, _)) => format!("{}{DOTS}", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_cut_around_their_marks() {
        let text = format!("short\n{}αβ{}\nlast", "a".repeat(5000), "b".repeat(5000));
        let at = text.find('α').unwrap();
        let marks = [at..at + 2, 2..4];
        let excerpt = Excerpt::new(&text, &marks);
        assert_eq!(&excerpt.text[excerpt.mark(&marks[0])], "α");
        assert_eq!(&excerpt.text[excerpt.mark(&marks[1])], "or");
        assert_eq!(excerpt.text.lines().count(), 3);
        assert!(excerpt.text.lines().all(|line| line.chars().count() < 170));
        let end = text.len()..text.len();
        assert_eq!(excerpt.mark(&end), excerpt.text.len()..excerpt.text.len());
    }

    #[test]
    fn what_is_short_stays() {
        let text = "αβ\r\n\nc";
        let excerpt = Excerpt::new(text, &[0..2, 2..4]);
        assert_eq!(excerpt.text, text);
        assert_eq!(excerpt.mark(&(2..4)), 2..4);
        assert_eq!(shortened(text), text);
        assert!(shortened(&"a".repeat(10_000)).len() < 500);
    }
}
