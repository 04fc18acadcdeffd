//! Blanks in a block: what stands behind many of them is out of a reader's sight.

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::syntax::Span;

/// How many columns of a line may be blank in a row: renderers scroll a longer line sideways, and a
/// reader takes it for ended.
const MOST_COLUMNS: usize = 80;

/// How many empty lines may follow each other: a reader takes the statement above them for ended.
const MOST_LINES: usize = 8;

/// How wide a tab is at most.
const TAB: usize = 8;

/// Whatever stands in a block behind so many blanks that a reader does not look for it.
pub(crate) fn gaps(text: &str, block: &Span) -> Vec<Diagnostic> {
    let is_seen = |letter: char| !letter.is_whitespace();
    let mut end = block.start;
    let runs = text.get(block.clone()).unwrap_or_default();
    let runs = runs.split_inclusive(is_seen).filter_map(|run| {
        end += run.len();
        let blank = run.trim_end_matches(is_seen);
        gap(blank, end - (run.len() - blank.len())..end)
    });
    runs.collect()
}

/// What is wrong with some blanks before something that is seen; behind the last there is nothing.
fn gap(blank: &str, behind: Span) -> Option<Diagnostic> {
    let columns = blank.split('\n').map(width).max().unwrap_or_default();
    // Between two line ends a line is empty.
    let empty = blank.matches('\n').count().saturating_sub(1);
    let gap = match (columns > MOST_COLUMNS, empty > MOST_LINES) {
        _ if behind.is_empty() => return None,
        (true, _) => format!("{columns} columns"),
        (false, true) => format!("{empty} lines"),
        (false, false) => return None,
    };
    let message = format!("{gap} in a row are blank before this");
    let help = format!(
        "leave no more than {MOST_COLUMNS} columns and {MOST_LINES} lines of a block blank in a row"
    );
    let error = Diagnostic::new(DiagnosticKind::Hidden, behind, message);
    let label = "who reads the page may not see what begins here";
    Some(error.with_label(label).with_help(help))
}

/// How many columns some blanks take.
fn width(blanks: &str) -> usize {
    let columns = blanks.chars().map(|blank| match blank {
        '\r' => 0,
        '\t' => TAB,
        _ => 1,
    });
    columns.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_page_shows_together_has_no_gap() {
        let wide = format!("a{}b\r\n{}c", " ".repeat(80), "\t".repeat(10));
        let high = format!("a\n{}  b\n", " \r\n".repeat(8));
        let last = format!("a{}\n", " ".repeat(81));
        for text in ["", "a", "\n\n", &wide, &high, &last] {
            assert_eq!(gaps(text, &(0..text.len())), [], "{text:?}");
        }
    }

    #[test]
    fn what_is_far_away_has_a_gap_before_it() {
        for (text, place) in [
            (format!("αβ{}γ ", " ".repeat(81)), 85..87),
            (format!("a{}b", "\u{2003}".repeat(81)), 244..245),
            (format!("a\n{}b", "\t".repeat(11)), 13..14),
            (format!("a\n{}b", "\r\n".repeat(9)), 20..21),
        ] {
            let gaps = gaps(&text, &(0..text.len()));
            let places: Vec<Span> = gaps.into_iter().map(|gap| gap.span).collect();
            assert_eq!(places, [place], "{text:?}");
        }
    }
}
