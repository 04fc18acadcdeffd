//! The names that an emitted file has whatever its document says.
//!
//! They are gathered from the templates and from what the printers write, so that a name which is added
//! there is taken from then on.

use std::collections::BTreeSet;

use super::names::{camel_case, is_temporary};

/// What stands for the evaluator in a word of a template: its function, its types, its macro.
const MADE: [(&str, &str); 3] = [
    ("{{ function }}", "\u{1}"),
    ("{{ camel }}", "\u{2}"),
    ("{{ guard }}", "\u{3}"),
];

/// What stands for anything else that is placed in a template.
const PLACED: &str = "\u{4}";

/// Where comments and texts begin, and where they end; of two that begin at one place the first.
const COMMENTS: [(&str, &str); 5] = [
    ("\"\"\"", "\"\"\""),
    ("/*", "*/"),
    ("//", "\n"),
    ("%", "\n"),
    ("\"", "\""),
];

/// What a language has taken.
#[derive(Clone, Copy, Debug)]
pub struct Taken {
    /// What nothing may be called: keywords, macros.
    pub words: &'static [&'static str],
    /// Files that are there already, which no evaluator may be called in any letters: on some disks
    /// `Lanes.rs` is `lanes.rs`.
    pub files: &'static [&'static str],
    /// What no evaluator may be called besides: functions that are there already.
    pub functions: &'static [&'static str],
    /// What may stand behind the name of a function that is there already.
    pub endings: &'static [&'static str],
    /// The templates of the files of an evaluator.
    pub templates: &'static [&'static str],
    /// What bodies contain that stands in no template.
    pub printed: &'static [&'static str],
    /// Whether fields are apart from variables: where they are arguments too, they are not.
    pub has_fields: bool,
    /// Whether all evaluators are in one space of names.
    pub is_shared: bool,
}

/// What a language has taken, with the words of its templates.
#[derive(Clone, Debug)]
pub struct Vocabulary {
    taken: Taken,
    /// Those that are made from the name of an evaluator have marks in them.
    words: BTreeSet<String>,
    macros: BTreeSet<String>,
}

impl Vocabulary {
    /// Of a language.
    pub fn of(taken: Taken) -> Self {
        let texts = taken.templates.iter();
        Vocabulary {
            words: texts.clone().flat_map(|text| words(text)).collect(),
            macros: texts.flat_map(|text| macros(text)).collect(),
            taken,
        }
    }

    /// Whether all evaluators are in one space of names.
    pub fn is_shared(&self) -> bool {
        self.taken.is_shared
    }

    /// Whether a file of this name is there already.
    pub fn has_file(&self, function: &str) -> bool {
        let mut files = self.taken.files.iter();
        files.any(|file| file.eq_ignore_ascii_case(function))
    }

    /// What no evaluator may be called.
    pub fn without_evaluator(&self) -> BTreeSet<String> {
        let taken = &self.taken;
        let functions = taken.functions.iter().flat_map(|function| {
            let endings = taken.endings.iter();
            endings.map(move |ending| format!("{function}{ending}"))
        });
        let fixed = self.words.iter().filter(|word| !word.contains(is_mark));
        let fixed = fixed.cloned().chain(functions);
        fixed
            .chain(listed(taken.words))
            .chain(listed(taken.printed))
            .collect()
    }

    /// That name itself, and what is made from it in its own letters.
    pub fn made(&self, function: &str) -> Vec<String> {
        let is_made = |word: &&String| word.contains(['\u{1}', '\u{3}']);
        let made = self.words.iter().filter(is_made);
        made.map(|word| filled(word, function)).collect()
    }

    /// The types, which are the same with underscores behind the name.
    pub fn types(&self, function: &str) -> Vec<String> {
        let types = self.words.iter().filter(|word| word.contains('\u{2}'));
        types.map(|word| filled(word, function)).collect()
    }

    /// What no variable of this function may be called. One of the name of the function hides what it
    /// does not need.
    pub fn variables(&self, function: &str) -> BTreeSet<String> {
        let words = self.words.iter().filter(|word| *word != "\u{1}");
        let words = words.map(|word| filled(word, function));
        words
            .chain(listed(self.taken.words))
            .chain(listed(self.taken.printed))
            .collect()
    }

    /// What no field of this function's structures may be called.
    pub fn fields(&self, function: &str) -> BTreeSet<String> {
        if !self.taken.has_fields {
            return self.variables(function);
        }
        let macros = self.macros.iter().map(|word| filled(word, function));
        macros.chain(listed(self.taken.words)).collect()
    }

    /// Whether a name is that of a temporary value, and would be one for a field.
    pub fn is_temporary_field(&self, name: &str) -> bool {
        !self.taken.has_fields && is_temporary(name)
    }
}

fn listed(words: &'static [&'static str]) -> impl Iterator<Item = String> {
    words.iter().map(|word| (*word).to_owned())
}

/// Whether a letter stands for the name of the evaluator in some spelling.
fn is_mark(letter: char) -> bool {
    matches!(letter, '\u{1}'..='\u{3}')
}

/// A word with the names of an evaluator for the marks.
fn filled(word: &str, function: &str) -> String {
    word.replace('\u{1}', function)
        .replace('\u{2}', &camel_case(function))
        .replace('\u{3}', &guard(function))
}

/// The macro of a header of C.
pub fn guard(function: &str) -> String {
    format!("SEXTIC_{}_H", function.to_ascii_uppercase())
}

/// A template without comments and texts, with marks for what is placed.
fn bare(template: &str) -> String {
    let mut text = template.to_owned();
    for (tag, mark) in MADE {
        text = text.replace(tag, mark);
    }
    text = without(&text, &[("{%", "%}")], "");
    text = without(&text, &[("{{", "}}")], PLACED);
    without(&text, &COMMENTS, "\n")
}

/// A text with something else for each part from the start to the end of a pair.
fn without(text: &str, pairs: &[(&str, &str)], instead: &str) -> String {
    let (mut bare, mut rest) = (String::new(), text);
    loop {
        let starts = pairs.iter();
        let first = starts
            .filter_map(|(start, end)| Some((rest.find(start)?, start.len(), end)))
            .min_by_key(|(place, ..)| *place);
        let Some((place, length, end)) = first else {
            return bare + rest;
        };
        bare.push_str(&rest[..place]);
        bare.push_str(instead);
        let behind = &rest[place + length..];
        let end = behind.find(end).map_or(behind.len(), |at| at + end.len());
        rest = &behind[end..];
    }
}

/// The words of a template that may be names: none of members, lifetimes, attributes and directives.
fn words(template: &str) -> BTreeSet<String> {
    let mut found = macros(template);
    for line in bare(template).lines() {
        if !line.trim_start().starts_with('#') {
            found.extend(words_of(line).map(str::to_owned));
        }
    }
    found
}

/// The macros that a template defines.
fn macros(template: &str) -> BTreeSet<String> {
    let bare = bare(template);
    let defined = bare
        .lines()
        .filter_map(|line| line.strip_prefix("#define "));
    let first = defined.filter_map(|line| line.split(' ').next());
    first.map(str::to_owned).collect()
}

/// The words of a line that are no members and no lifetimes.
fn words_of(line: &str) -> impl Iterator<Item = &str> {
    let is_part = |letter: char| {
        letter.is_ascii_alphanumeric() || letter == '_' || ('\u{1}'..='\u{4}').contains(&letter)
    };
    let mut before = ' ';
    let pieces = line.split_inclusive(move |letter| !is_part(letter));
    let pieces = pieces.map(move |piece| {
        let word = piece.trim_end_matches(|letter| !is_part(letter));
        let last = piece.chars().next_back().filter(|last| !is_part(*last));
        (word, std::mem::replace(&mut before, last.unwrap_or(' ')))
    });
    pieces
        .filter(|(word, before)| {
            let is_number = word.starts_with(|first: char| first.is_ascii_digit());
            !word.is_empty()
                && !is_number
                && !matches!(before, '.' | '\'')
                && !word.contains(PLACED)
        })
        .map(|(word, _)| word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_names_and_neither_comments_nor_members() {
        let template = "/* of */ // no\n#include <math.h>\n#define {{ guard }}\n\"\"\"a\ntext\"\"\"\n\
            {%- for field in inputs %}\nlet in_{{ field.name }} = at->{{ function }}.len(2e3, \"b\");\n\
            fn {{ function }}_body<'c, T>(inputs: &{{ camel }}Inputs<T>)\n";
        let found: Vec<String> = words(template).into_iter().collect();
        let expected = [
            "\u{1}",
            "\u{1}_body",
            "\u{2}Inputs",
            "\u{3}",
            "T",
            "at",
            "fn",
            "inputs",
            "let",
        ];
        assert_eq!(found, expected);
    }
}
