//! What a document says, as sentences on lines that are not too long.

/// Lines are no longer than this, before the marks of a comment.
const WIDTH: usize = 92;

/// A text as one line without control characters: what a document says never ends a comment by a line
/// break.
pub fn flat(text: &str) -> String {
    let words: Vec<&str> = text
        .split(|letter: char| letter.is_whitespace() || letter.is_control())
        .filter(|word| !word.is_empty())
        .collect();
    words.join(" ")
}

/// A text in one line that begins with a capital letter, unless it begins with a symbol: ρ, c_0, x axis
/// and cos(α) stay.
pub fn capital(text: &str) -> String {
    let text = flat(text);
    let word = text.split([' ', ',', ';', ':', '-', '.', '’', '\'']).next();
    let word = word.unwrap_or_default();
    let is_word = word.bytes().all(|letter| letter.is_ascii_lowercase());
    match is_word && (word.len() > 1 || word == "a") {
        true => text[..1].to_ascii_uppercase() + &text[1..],
        false => text,
    }
}

/// A text in one line as a sentence; nothing if there is none.
pub fn sentence(text: &str) -> String {
    let text = capital(text);
    match text.is_empty() || text.ends_with(['.', '!', '?', ':']) {
        true => text,
        false => text + ".",
    }
}

/// Words on lines that are not too long.
pub fn wrapped(text: &str, first: &str, next: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = first.to_owned();
    let mut empty = true;
    for word in flat(text).split(' ').filter(|word| !word.is_empty()) {
        let long = line.chars().count() + 1 + word.chars().count() > WIDTH;
        if long && !empty {
            lines.push(std::mem::replace(&mut line, next.to_owned()));
            empty = true;
        }
        if !empty {
            line.push(' ');
        }
        line.push_str(word);
        empty = false;
    }
    if !empty {
        lines.push(line);
    }
    lines
}

/// Items of a list.
pub fn listed(items: impl IntoIterator<Item = String>) -> Vec<String> {
    let lines = |item: String| wrapped(&item, "- ", "  ");
    items.into_iter().flat_map(lines).collect()
}
