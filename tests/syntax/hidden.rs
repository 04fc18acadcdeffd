//! What is executed is what a reader of the rendered page sees; anything else is an error with its place.

use proptest::prelude::*;
use proptest::sample::select;
use sextic::language::diagnostic::{SourceFile, render};
use sextic::language::document::{Document, parse_document};

/// A document that is well, in prose, names, strings, comments and labels.
const WELL: &str = "# Größe\n\nProse of *a* paper, `code`.\n\n```sextic\nparameter a : 1 > 0 \"words\"\n\
                    claim (1): a == a  # well\n```\n\nA note.\n\n```sextic\nangle θ\n\
                    claim [two]: sin(θ) ==\n  sin(θ) \"more\"\n```\n";

fn read(text: &str) -> Result<Document, String> {
    let source = SourceFile::new("document.md", text);
    let message = |error| render(&error, &source, false);
    parse_document(&source).map_err(|errors| errors.into_iter().map(message).collect())
}

/// The character behind `\u{`, and how many characters it takes.
fn escape(text: &str) -> (char, usize) {
    let digits = text.split('}').next().unwrap_or_default();
    let code = u32::from_str_radix(digits, 16).expect("hexadecimal digits");
    (char::from_u32(code).expect("a character"), digits.len() + 1)
}

/// A text with its escapes `\n`, `\r` and `\u{…}` replaced.
fn unescaped(text: &str) -> String {
    let mut parts = text.split('\\');
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (character, length) = match part.strip_prefix("u{") {
            Some(rest) => {
                let (character, length) = escape(rest);
                (character, length + 2)
            }
            None if part.starts_with('n') => ('\n', 1),
            None if part.starts_with('r') => ('\r', 1),
            None => panic!("no escape: \\{part}"),
        };
        plain.push(character);
        plain += &part[length..];
    }
    plain
}

#[test]
fn every_message_is_as_agreed() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/bad/hidden"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!("../data/bad/hidden", "*.txt", |path| {
            let file = std::fs::read_to_string(path).expect("the documents can be read");
            let messages = file.split("\n=====\n").map(|escaped| {
                let message = read(&unescaped(escaped.trim_end_matches('\n')));
                let message = message.err().unwrap_or_else(|| panic!("{escaped} is well"));
                format!("{}\n\n{message}", escaped.trim_end())
            });
            insta::assert_snapshot!(messages.collect::<Vec<_>>().join("\n=====\n"));
        });
    });
}

#[test]
fn what_a_paper_holds_is_read() {
    for text in [
        WELL,
        "A table:\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n***\n\n```sextic\nclaim (1): 1 == 1\n```\n",
        "H<sub>2</sub>O<br>\n\n<!-- a note -->\n\n```sextic\nclaim (1): 1 == 1\n```\n",
        "> <https://a.b>\n> x<sup>a<sub>1</sub></sup>\n\n```rust\nmatch (a, b) { _ => c::d }\n```\n\n```sextic\nclaim (1): 1 == 1\n```\n",
        "````markdown\n```sextic\nclaim (1): 1 == 2\n```\n````\n\n    claims (1): many\n\n```sextic\nclaim (1): 1 == 1\n```\n",
        "A note.[^1]\n\n```sextic\nclaim (1): 1 == 1\n```\n\n[^1]: Below.\n",
        "> [!NOTE]\n> Look.\n\n---\n\n```sextic\nclaim (1): 1 == 1\n```\n",
        "```sextic\nparameter ω_n, S_xθ, C_D, α_g, ρ, p, ΔT : 1 \"Ж 中 é\" # Ж\nclaim [§ 2 — Größe]: 1 == 1\n```\n",
    ] {
        read(text).unwrap_or_else(|message| panic!("{message}"));
    }
}

/// The places of a text between two characters.
fn places(text: &str) -> Vec<usize> {
    let starts = text.char_indices().map(|(start, _)| start);
    starts.chain([text.len()]).collect()
}

fn hidden_character() -> impl Strategy<Value = char> {
    let ranges = [
        '\0'..='\u{8}',
        '\u{B}'..='\u{C}',
        '\u{E}'..='\u{1F}',
        '\u{7F}'..='\u{9F}',
        '\u{AD}'..='\u{AD}',
        '\u{34F}'..='\u{34F}',
        '\u{61C}'..='\u{61C}',
        '\u{115F}'..='\u{1160}',
        '\u{17B4}'..='\u{17B5}',
        '\u{180B}'..='\u{180F}',
        '\u{200B}'..='\u{200F}',
        '\u{2028}'..='\u{202E}',
        '\u{2060}'..='\u{206F}',
        '\u{2800}'..='\u{2800}',
        '\u{3164}'..='\u{3164}',
        '\u{E000}'..='\u{F8FF}',
        '\u{FE00}'..='\u{FE0F}',
        '\u{FEFF}'..='\u{FEFF}',
        '\u{FFA0}'..='\u{FFA0}',
        '\u{FFF0}'..='\u{FFFC}',
        '\u{1D173}'..='\u{1D17A}',
        '\u{E0000}'..='\u{E0FFF}',
        '\u{F0000}'..='\u{10FFFF}',
    ];
    select(ranges.to_vec())
        .prop_flat_map(|range| proptest::char::range(*range.start(), *range.end()))
}

/// Raw HTML that hides, moves or replaces what stands in it.
#[rustfmt::skip]
const HTML: &[(&str, &str)] = &[
    ("<details>\n\n", "\n</details>\n"), ("<div hidden>\n\n", "\n</div>\n"), ("<!--\n", "\n-->\n"),
    ("<template>\n\n", "\n</template>\n"), ("<script>\n", "\n</script>\n"), ("<pre>\n\n", "\n</pre>\n"),
    ("<textarea>\n\n", "\n</textarea>\n"), ("a <i style=\"x\">\n\n", "\n"), ("<?\n", "\n?>\n"),
    ("<p\nhidden>\n\n", "\n"), ("<![CDATA[\n", "\n]]>\n"), ("<!X\n\n", "\n"), ("<svg/>\n\n", "\n"),
    ("<STYLE>\n\n", "\n"), ("> a\n<br>\n", "\n"), ("a <sub>\n\n", "\nb </sub>\n"), ("<sub>\n\n", "\n</sub>\n"),
    ("</div>\n\n", "\n"), ("- a\n\n  <div>\n\n", "\n"), ("# <del>a\n\n", "\n"),
];

/// Letters that look the same, in pairs.
#[rustfmt::skip]
const PAIRS: &[(char, char)] = &[
    ('A', 'Α'), ('H', 'Η'), ('P', 'Ρ'), ('T', 'Τ'), ('X', 'Χ'), ('o', 'ο'), ('i', 'ι'), ('v', 'ν'),
    ('u', 'υ'), ('x', 'χ'), ('O', '0'), ('l', '1'),
];

/// Two spellings with one look.
fn one_look() -> impl Strategy<Value = (String, String)> {
    let letter = (select(PAIRS.to_vec()), any::<bool>(), any::<bool>());
    let letters = proptest::collection::vec((letter, select(vec!["", "_", "__"])), 1..6);
    letters.prop_map(|letters| {
        let pick =
            |((one, other), is_other): ((char, char), bool)| if is_other { other } else { one };
        let (mut left, mut right) = ("A_".to_owned(), "A_".to_owned());
        for ((pair, first, second), between) in letters {
            left.extend([pick((pair, first))]);
            right.extend([pick((pair, second))]);
            left += between;
            right += if between.is_empty() { "" } else { "_" };
        }
        (left, right)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn what_is_not_seen_stands_nowhere(place in select(places(WELL)), hidden in hidden_character()) {
        let mut text = WELL.to_owned();
        text.insert(place, hidden);
        let code = format!("U+{:04X}", u32::from(hidden));
        prop_assert!(read(&text).is_err_and(|message| message.contains(&code)), "{code} at {place}");
    }

    #[test]
    fn a_line_ends_as_all_others(place in select(places(WELL)), end in select(vec!["\r", "\r\n"])) {
        let mut text = WELL.to_owned();
        text.insert_str(place, end);
        // A carriage return before the end of a line makes one sort of the other.
        prop_assert!(read(&text).is_err());
    }

    #[test]
    fn one_look_is_one_spelling((one, other) in one_look(), split in any::<bool>()) {
        prop_assume!(one != other);
        let between = if split { ":= 1\n" } else { ", " };
        let first = if split { "" } else { "parameter " };
        let last = if split { ":= 2" } else { ": 1" };
        let text = format!("```sextic\n{first}{one}{between}{other} {last}\n```\n");
        prop_assert!(read(&text).is_err(), "{text}");
    }

    #[test]
    fn html_hides_nothing((open, close) in select(HTML.to_vec()), before in any::<bool>()) {
        let block = "```sextic\nclaim (3): 1 == 1\n```\n";
        let inside = format!("{open}{block}{close}");
        let text = if before { format!("{inside}\n{WELL}") } else { format!("{WELL}\n{inside}") };
        prop_assert!(read(&text).is_err_and(|message| message.contains("[hidden]")), "{text}");
    }
}

/// The lines on which the statements of a document begin.
fn lines(text: &str, end: &str) -> Vec<usize> {
    let document = read(text).unwrap_or_else(|message| panic!("{message}"));
    let starts = document.statements.iter().map(|one| one.span.start);
    starts
        .map(|start| text[..start].matches(end).count())
        .collect()
}

#[test]
fn every_sort_of_line_end_is_read_alike() {
    let usual = lines(WELL, "\n");
    assert_eq!(usual, [5, 6, 12, 13]);
    for end in ["\r\n", "\r"] {
        assert_eq!(lines(&WELL.replace('\n', end), end), usual, "{end:?}");
    }
}
