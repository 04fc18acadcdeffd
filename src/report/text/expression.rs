//! Breaking expressions at their operators.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// What stands between two sides.
const RELATIONS: [&str; 9] = ["= ", "≈ ", "== ", "< ", "<= ", "> ", ">= ", "≤ ", "≥ "];
/// What stands between the terms of a sum, or behind it.
const SUMS: [&str; 4] = ["+ ", "− ", "- ", "at "];
/// What stands between the factors of a product.
const PRODUCTS: [&str; 2] = ["·", "/("];

/// Breaks an expression into lines of so many columns: before the operator that binds loosest, if that
/// does not leave most of the line empty.
pub fn lines(text: &str, width: usize) -> Vec<String> {
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
    let (mut column, mut depth) = (0_usize, 0);
    let mut best: Option<(usize, usize)> = None;
    // Where there is no operator, the line is filled.
    let mut filled = text.chars().next().map_or(1, char::len_utf8);
    for (at, character) in text.char_indices() {
        let (before, after) = text.split_at(at);
        // A space before the break is not shown.
        if column > width + usize::from(before.ends_with(' ')) {
            break;
        }
        if let Some(strength) = strength(before, after, depth)
            && best
                .is_none_or(|(least, place)| strength <= least || text[..place].width() * 3 < width)
        {
            best = Some((strength, at));
        }
        column += character.width().unwrap_or(0);
        if column <= width {
            filled = filled.max(at + character.len_utf8());
        }
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    best.map_or(filled, |(_, at)| at)
}

/// How tightly what could be broken here holds together, so many brackets deep; nothing where no line
/// should be broken.
fn strength(before: &str, after: &str, depth: usize) -> Option<usize> {
    let trimmed = before.trim_end();
    if trimmed.is_empty() {
        return None;
    }
    let is_behind_space = trimmed.len() < before.len();
    let begins_with = |signs: &[&str]| signs.iter().any(|sign| after.starts_with(sign));
    let within = if is_behind_space && (trimmed.ends_with(';') || begins_with(&RELATIONS)) {
        0
    } else if is_behind_space && trimmed.ends_with(',') {
        1
    } else if is_behind_space && begins_with(&SUMS) {
        2
    } else if begins_with(&PRODUCTS) {
        3
    } else {
        return None;
    };
    Some(4 * depth + within)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_before_the_loosest_operator() {
        let text = "F_x = m·ẍ + 2·(k_x + k_y)·x";
        assert_eq!(lines(text, 20), ["F_x = m·ẍ", "+ 2·(k_x + k_y)·x"]);
        let matrix = "[alpha, beta; gamma]";
        assert_eq!(lines(matrix, 13), ["[alpha, beta;", "gamma]"]);
        assert_eq!(lines("a = −b", 4), ["a", "= −b"]);
        assert_eq!(lines("(a + b)/(c + d)", 10), ["(a + b)", "/(c + d)"]);
    }

    #[test]
    fn no_line_is_too_wide_and_nothing_is_lost() {
        let text = "θ̈_d + abcdefghijklmnopqrstuvwxyz·(1 − x)/(ω_n² + longer_name) at rest";
        for width in 1..60 {
            let lines = lines(text, width);
            assert!(
                lines.iter().all(|line| line.width() <= width),
                "{width}: {lines:?}"
            );
            let joined: String = lines.concat().split(' ').collect();
            assert_eq!(joined, text.split(' ').collect::<String>());
        }
    }
}
