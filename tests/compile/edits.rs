//! Small changes of an emitted text, each of which makes it wrong.

use std::ops::Range;

use sextic_codegen::language::{File, Language};

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Operator,
    Sign,
    Name,
    Literal,
    Parentheses,
    Arguments,
    Order,
    Wiring,
    Outputs,
    Token,
    Line,
}

impl Kind {
    pub const ALL: [Kind; 11] = [
        Kind::Operator,
        Kind::Sign,
        Kind::Name,
        Kind::Literal,
        Kind::Parentheses,
        Kind::Arguments,
        Kind::Order,
        Kind::Wiring,
        Kind::Outputs,
        Kind::Token,
        Kind::Line,
    ];

    pub fn title(self) -> &'static str {
        match self {
            Kind::Operator => "an operator is another one",
            Kind::Sign => "a sign is added or left out",
            Kind::Name => "a variable is another one",
            Kind::Literal => "a number is another one",
            Kind::Parentheses => "parentheses are left out",
            Kind::Arguments => "arguments are exchanged",
            Kind::Order => "two factors or summands are exchanged",
            Kind::Wiring => "a field is another one",
            Kind::Outputs => "outputs are exchanged",
            Kind::Token => "a word or sign is left out",
            Kind::Line => "a line is left out",
        }
    }
}

/// Replacements in the text of a file, which do not overlap.
#[derive(Clone, Debug)]
pub struct Edit {
    pub kind: Kind,
    replacements: Vec<(Range<usize>, String)>,
}

impl Edit {
    fn one(kind: Kind, range: &Range<usize>, text: impl Into<String>) -> Self {
        Edit {
            kind,
            replacements: vec![(range.clone(), text.into())],
        }
    }

    fn exchange(kind: Kind, text: &str, a: &Range<usize>, b: &Range<usize>) -> Self {
        let (at_a, at_b) = (text[a.clone()].to_owned(), text[b.clone()].to_owned());
        Edit {
            kind,
            replacements: vec![(a.clone(), at_b), (b.clone(), at_a)],
        }
    }

    fn changes(&self, text: &str) -> bool {
        let mut replacements = self.replacements.iter();
        let is_new = replacements.any(|(range, replacement)| text[range.clone()] != **replacement);
        is_new && self.apply(text) != text
    }

    pub fn apply(&self, text: &str) -> String {
        let mut replacements = self.replacements.clone();
        replacements.sort_by_key(|(range, _)| range.start);
        let mut corrupt = text.to_owned();
        for (range, replacement) in replacements.iter().rev() {
            corrupt.replace_range(range.clone(), replacement);
        }
        corrupt
    }

    /// The line as it was and as it became.
    pub fn shown(&self, text: &str) -> String {
        let line = |text: &str, place: usize| {
            let start = text[..place].rfind('\n').map_or(0, |end| end + 1);
            let line = text[start..].lines().next().unwrap_or("").trim();
            line.to_owned()
        };
        let start = self.replacements.iter().map(|(range, _)| range.start).min();
        let start = start.unwrap_or(0);
        format!(
            "`{}` as `{}`",
            line(text, start),
            line(&self.apply(text), start)
        )
    }
}

/// A file with its words, numbers and signs outside of comments.
struct Text<'a> {
    text: &'a str,
    language: Language,
    tokens: Vec<Range<usize>>,
    /// The bodies with the usual signs, and the one with calls.
    bodies: Vec<(Range<usize>, bool)>,
    /// Inputs, outputs, angles.
    fields: [Vec<String>; 3],
}

/// All changes of a file that are tried.
pub fn edits(file: &File, language: Language, fields: &[Vec<String>; 3]) -> Vec<Edit> {
    let text = Text {
        text: &file.text,
        language,
        tokens: tokens(&file.text, language),
        bodies: bodies(file, language),
        fields: fields.clone(),
    };
    let mut edits = Vec::new();
    for (body, is_calls) in &text.bodies {
        text.of_body(body, *is_calls, &mut edits);
    }
    if let Some(door) = door(&file.text, language) {
        text.of_body(&door, false, &mut edits);
    }
    text.of_wiring(&mut edits);
    for pair in text.tokens.windows(2) {
        // The comma behind the last of some fields says nothing.
        if text.at(&pair[0]) != "," || text.at(&pair[1]) != "}" {
            edits.push(Edit::one(Kind::Token, &pair[0], ""));
        }
    }
    let mut last = 0;
    for token in &text.tokens {
        let start = text.text[..token.start]
            .rfind('\n')
            .map_or(0, |end| end + 1);
        let end = text.text[start..]
            .find('\n')
            .map_or(text.text.len(), |end| start + end + 1);
        if end > last {
            edits.push(Edit::one(Kind::Line, &(start..end), ""));
            last = end;
        }
    }
    // A product with itself is the same either way.
    edits.retain(|edit| edit.changes(&file.text));
    edits
}

impl Text<'_> {
    fn at(&self, token: &Range<usize>) -> &str {
        &self.text[token.clone()]
    }

    /// The signs of operations; in Octave those of matrices are others.
    fn operators(&self) -> &'static [&'static str] {
        match self.language {
            Language::Octave => &["+", "-", ".*", "./", "*", "/"],
            _ => &["+", "-", "*", "/"],
        }
    }

    fn of_body(&self, body: &Range<usize>, is_calls: bool, edits: &mut Vec<Edit>) {
        let inside = |token: &&Range<usize>| body.contains(&token.start);
        let tokens: Vec<&Range<usize>> = self.tokens.iter().filter(inside).collect();
        let mut variables: Vec<&str> = Vec::new();
        let mut open: Vec<usize> = Vec::new();
        let mut results: Vec<Range<usize>> = Vec::new();
        for (place, token) in tokens.iter().enumerate() {
            let word = self.at(token);
            let before = place
                .checked_sub(1)
                .map_or("", |before| self.at(tokens[before]));
            let after = tokens.get(place + 1).map_or("", |after| self.at(after));
            let is_declared = after == "=" && self.outputs_begin(&tokens) > place;
            if is_declared {
                variables.push(word);
                continue;
            }
            if self.operators().contains(&word) {
                let others = self.operators().iter().filter(|other| **other != word);
                edits.extend(others.map(|other| Edit::one(Kind::Operator, token, *other)));
                let is_behind = ["(", ",", "=", ":"].contains(&before);
                if word == "-" && (is_behind || self.operators().contains(&before)) {
                    edits.push(Edit::one(Kind::Sign, token, ""));
                }
            }
            let calls = [
                "sextic_add",
                "sextic_subtract",
                "sextic_multiply",
                "sextic_divide",
            ];
            if calls.contains(&word) {
                let others = calls.into_iter().filter(|other| *other != word);
                edits.extend(others.map(|other| Edit::one(Kind::Operator, token, other)));
            }
            let is_operand = variables.contains(&word) && ![".", "->"].contains(&before);
            if is_operand {
                let negative = match is_calls {
                    true => format!("sextic_negative({word})"),
                    false => format!("-{word}"),
                };
                edits.push(Edit::one(Kind::Sign, token, negative));
                let others: Vec<&&str> = variables.iter().filter(|other| **other != word).collect();
                for step in [7, 13] {
                    if let Some(other) = others.get((place * step) % others.len().max(1)) {
                        edits.push(Edit::one(Kind::Name, token, **other));
                    }
                }
            }
            if word.starts_with(|first: char| first.is_ascii_digit()) {
                for other in [
                    format!("1{word}"),
                    format!("{word}1"),
                    word.replace(".0", ""),
                ] {
                    edits.extend((other != word).then(|| Edit::one(Kind::Literal, token, other)));
                }
                edits.push(Edit::one(Kind::Sign, token, format!("-{word}")));
            }
            match word {
                "(" => open.push(place),
                ")" => {
                    if let Some(start) = open.pop() {
                        self.of_pair(&tokens, start, place, edits);
                    }
                }
                _ => {}
            }
            let is_result = match self.language {
                Language::Rust => ["{", ",", ":"].contains(&before) && after == ",",
                Language::C => before == "=" && after == ",",
                Language::Python => before == "(" && after == ",",
                Language::Octave => before == "=" && after == ";",
            };
            if place >= self.outputs_begin(&tokens) && is_result {
                results.push((*token).clone());
            }
        }
        for pair in results.windows(2) {
            let (a, b) = (self.at(&pair[0]), self.at(&pair[1]));
            // A field of Rust that is called as its value has no colon.
            let value = |place: &Range<usize>, own: &str, other: &str| match self.text
                [..place.start]
                .trim_end()
                .ends_with(['{', ','])
            {
                true if self.language == Language::Rust => format!("{own}: {other}"),
                _ => other.to_owned(),
            };
            edits.push(Edit {
                kind: Kind::Outputs,
                replacements: vec![
                    (pair[0].clone(), value(&pair[0], a, b)),
                    (pair[1].clone(), value(&pair[1], b, a)),
                ],
            });
        }
    }

    /// The token at which the outputs of a body begin.
    fn outputs_begin(&self, tokens: &[&Range<usize>]) -> usize {
        let is_begin = |token: &&Range<usize>| match self.language {
            Language::Rust => ["Inputs", "Outputs"]
                .iter()
                .any(|end| self.at(token).ends_with(end)),
            Language::C => self.at(token) == "return",
            Language::Python => ["shape", "return"].contains(&self.at(token)),
            Language::Octave => ["values", "inputs"].contains(&self.at(token)),
        };
        let found = tokens.iter().position(is_begin);
        found.unwrap_or(tokens.len())
    }

    /// Parentheses are left out; the two arguments of a call are exchanged.
    fn of_pair(&self, tokens: &[&Range<usize>], start: usize, end: usize, edits: &mut Vec<Edit>) {
        let (left, right) = (tokens[start].clone(), tokens[end].clone());
        edits.push(Edit {
            kind: Kind::Parentheses,
            replacements: vec![
                (left.clone(), String::new()),
                (right.clone(), String::new()),
            ],
        });
        let mut depth = 0;
        let mut commas = Vec::new();
        for token in &tokens[start + 1..end] {
            match self.at(token) {
                "(" => depth += 1,
                ")" => depth -= 1,
                "," if depth == 0 => commas.push((*token).clone()),
                _ => {}
            }
        }
        let function = start
            .checked_sub(1)
            .map_or("", |before| self.at(tokens[before]));
        if let ([comma], true) = (
            commas.as_slice(),
            function.starts_with("sextic_") || function == "multiply_add",
        ) {
            let (first, second) = (left.end..comma.start, comma.end + 1..right.start);
            let kind = match function {
                "sextic_add" | "sextic_multiply" => Kind::Order,
                _ => Kind::Arguments,
            };
            edits.push(Edit::exchange(kind, self.text, &first, &second));
        }
    }

    /// Every name of a field outside of the values of the bodies is exchanged with another one.
    fn of_wiring(&self, edits: &mut Vec<Edit>) {
        for (place, token) in self.tokens.iter().enumerate() {
            let word = self.at(token);
            let before = place
                .checked_sub(1)
                .map_or("", |before| self.at(&self.tokens[before]));
            let is_inside = self
                .bodies
                .iter()
                .any(|(body, _)| body.contains(&token.start));
            if is_inside && ![".", "->"].contains(&before) {
                continue;
            }
            let [inputs, outputs, angles] = &self.fields;
            for (prefix, names) in [
                ("", inputs),
                ("", outputs),
                ("", angles),
                ("in_", inputs),
                ("out_", outputs),
            ] {
                let Some(name) = word.strip_prefix(prefix) else {
                    continue;
                };
                let Some(own) = names.iter().position(|other| other == name) else {
                    continue;
                };
                let other = &names[(own + 1) % names.len()];
                if other != name {
                    edits.push(Edit::one(Kind::Wiring, token, format!("{prefix}{other}")));
                }
            }
        }
    }
}

/// Words, numbers and signs; comments and documentation are left out.
fn tokens(text: &str, language: Language) -> Vec<Range<usize>> {
    let (mut tokens, mut at) = (Vec::new(), 0);
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let comment = match language {
            Language::Rust if rest.starts_with("//") => rest.find('\n'),
            Language::C if rest.starts_with("/*") => rest.find("*/").map(|end| end + 2),
            Language::Octave if rest.starts_with('%') => rest.find('\n'),
            Language::Python if rest.starts_with("\"\"\"") => {
                rest[3..].find("\"\"\"").map(|end| end + 6)
            }
            _ => None,
        };
        let is_part = |next: char| next.is_ascii_alphanumeric() || next == '_';
        let word = |rest: &str| rest.find(|next| !is_part(next)).unwrap_or(rest.len());
        if let Some(end) = comment {
            at += end;
            continue;
        }
        let length = match first {
            _ if first.is_ascii_digit() => {
                let whole = word(rest);
                let is_decimal = rest[whole..].starts_with('.')
                    && rest[whole + 1..].starts_with(|next: char| next.is_ascii_digit());
                match is_decimal {
                    true => whole + 1 + word(&rest[whole + 1..]),
                    false => whole,
                }
            }
            _ if is_part(first) => word(rest),
            '-' if rest.starts_with("->") => 2,
            '.' if rest.starts_with(".*") || rest.starts_with("./") => 2,
            '"' => rest[1..].find('"').map_or(1, |end| end + 2),
            _ => first.len_utf8(),
        };
        if !first.is_whitespace() {
            tokens.push(at..at + length);
        }
        at += length;
    }
    tokens
}

/// The insides of the functions that compute, and whether they do it by calls.
fn bodies(file: &File, language: Language) -> Vec<(Range<usize>, bool)> {
    let text = &file.text;
    let of = |begin: &str, end: &str, is_calls: bool| {
        let start = text.find(begin).map(|start| start + begin.len())?;
        let end = text[start..]
            .find(end)
            .map_or(text.len(), |end| start + end);
        Some((start..end, is_calls))
    };
    let name = file.path.split('.').next().unwrap_or("");
    let found = match language {
        Language::Rust => vec![of("Outputs<T> {\n    let", "\n}\n", false)],
        Language::C => vec![
            of(
                &format!("{name}_body(const {name}_inputs *inputs)\n{{"),
                "\n}\n",
                false,
            ),
            of(
                &format!("{name}_with_bound(const {name}_inputs *inputs)\n{{"),
                "\n}\n",
                true,
            ),
        ],
        Language::Python => {
            let end = text.rfind("\"\"\"").map_or(0, |end| end + 3);
            vec![Some((end..text.len(), false))]
        }
        Language::Octave => vec![of("= computed(given)\n", "\nend\n", false)],
    };
    found.into_iter().flatten().collect()
}

/// The inside of the function that takes angles.
fn door(text: &str, language: Language) -> Option<Range<usize>> {
    let (begin, end) = match language {
        Language::Rust => ("Self {\n", "\n    }\n}\n"),
        Language::C => ("_angles *angles)\n{", "\n}\n"),
        Language::Python => ("        \"\"\"\n        ", "\n        )\n"),
        Language::Octave => ("inputs = struct();\n", "\nend\n"),
    };
    let start = text.find(begin)? + begin.len();
    Some(start..start + text[start..].find(end)?)
}
