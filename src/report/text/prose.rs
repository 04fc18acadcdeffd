//! Filling lines with words.

use super::expression;
use super::run::{Run, spaces, width as width_of};

/// Breaks runs at their spaces into lines of so many columns, with the codes of their styles.
pub fn lines(runs: &[Run], width: usize) -> Vec<String> {
    let mut lines: Vec<Vec<Run>> = Vec::new();
    for word in words(runs, width) {
        match lines.last_mut() {
            Some(line) if width_of(line) + 1 + width_of(&word) <= width => append(line, word),
            _ => lines.push(word),
        }
    }
    let styled = |line: Vec<Run>| line.iter().map(Run::styled).collect();
    lines.into_iter().map(styled).collect()
}

/// Adds a word to a line; a style goes on over the space between two words that have it.
fn append(line: &mut Vec<Run>, word: Vec<Run>) {
    let space = match (line.last(), word.first()) {
        (Some(last), Some(first)) if last.has_style_of(first) => first.part(" ".to_owned()),
        _ => spaces(1),
    };
    for run in std::iter::once(space).chain(word) {
        match line.last_mut() {
            Some(last) if last.has_style_of(&run) => last.append(&run),
            _ => line.push(run),
        }
    }
}

/// What stands between spaces; a word may change its style within. None is wider than a line.
fn words(runs: &[Run], width: usize) -> Vec<Vec<Run>> {
    let mut words: Vec<Vec<Run>> = vec![Vec::new()];
    for run in runs {
        for (index, part) in run.breakable_parts().into_iter().enumerate() {
            if index > 0 {
                words.push(Vec::new());
            }
            for (piece, text) in expression::lines(part, width).into_iter().enumerate() {
                if piece > 0 {
                    words.push(Vec::new());
                }
                if let Some(word) = words.last_mut() {
                    word.push(run.part(text));
                }
            }
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::super::palette::{PLAIN, STRONG};
    use super::*;

    #[test]
    fn lines_break_at_spaces_and_keep_formulas_together() {
        let runs = [
            Run::words("where ", PLAIN),
            Run::formula("a = 2", PLAIN),
            Run::words(", and so on", PLAIN),
        ];
        assert_eq!(lines(&runs, 8), ["where", "a = 2,", "and so", "on"]);
        assert_eq!(lines(&runs, 80), ["where a = 2, and so on"]);
        assert!(lines(&[], 10).is_empty());
    }

    #[test]
    fn styles_take_no_room() {
        let runs = [Run::words("bold", STRONG), Run::words(" thin", PLAIN)];
        let lines = lines(&runs, 9);
        assert_eq!(lines.len(), 1);
        let plain = anstream::adapter::strip_str(&lines[0]).to_string();
        assert_eq!(plain, "bold thin");
    }

    #[test]
    fn a_style_goes_on_from_word_to_word() {
        let run = Run::words("three bold words", STRONG);
        assert_eq!(lines(std::slice::from_ref(&run), 20), [run.styled()]);
    }
}
