//! Numbers in the prose of the documents are those of a claim.

use std::collections::BTreeSet;

use sextic::documents::shipped;
use sextic::language::diagnostic::SourceFile;
use sextic::language::document::parse_document;
use sextic::language::syntax::StatementKind;

/// The text between the blocks, tables included.
fn prose(text: &str) -> String {
    let mut is_prose = true;
    let outside = text.lines().filter(|line| {
        let is_fence = line.trim_start().starts_with("```");
        is_prose ^= is_fence;
        is_prose && !is_fence
    });
    outside.collect::<Vec<_>>().join("\n")
}

/// The decimal numbers of a text, but for those of sections, `§4.2`, and what has more points, `1.2.3`.
fn decimals(text: &str) -> BTreeSet<String> {
    let is_part = |letter: char| letter.is_ascii_digit() || letter == '.';
    let words = text.split(|letter: char| !(is_part(letter) || letter == '§'));
    let words = words.map(|word| word.trim_end_matches('.'));
    let is_decimal = |word: &&str| {
        let parts: Vec<&str> = word.split('.').collect();
        let is_digits = |part: &&str| !part.is_empty() && !part.contains('§');
        parts.len() == 2 && parts.iter().all(is_digits)
    };
    words.filter(is_decimal).map(str::to_owned).collect()
}

/// The decimal numbers in what a document asserts.
fn asserted(source: &SourceFile) -> BTreeSet<String> {
    let document = parse_document(source).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    let statements = document.statements.iter();
    let texts = statements.filter_map(|own| match &own.kind {
        StatementKind::Assertion { relation, .. } => {
            Some(&source.text[relation.left.span.start..relation.right.span.end])
        }
        _ => None,
    });
    texts.flat_map(decimals).collect()
}

/// The decimal numbers in the prose of a document that it does not assert.
fn open(source: &SourceFile) -> BTreeSet<String> {
    let numbers = decimals(&prose(&source.text));
    numbers.difference(&asserted(source)).cloned().collect()
}

/// `path | number` of numbers that no claim judges; behind them stands the reason.
fn listed() -> BTreeSet<String> {
    let lines = include_str!("../data/numbers.txt").lines();
    lines
        .map(|line| match line.split(" | ").collect::<Vec<_>>()[..] {
            [path, number, _reason] => format!("{path} | {number}"),
            _ => panic!("path | number | reason: {line}"),
        })
        .collect()
}

#[test]
fn numbers_in_prose_are_those_of_claims() {
    let found = shipped().flat_map(|source| {
        let numbers = open(&source).into_iter();
        numbers.map(move |number| format!("{} | {number}", source.path))
    });
    assert_eq!(found.collect::<BTreeSet<_>>(), listed());
}

#[test]
fn numbers_are_found_in_tables_and_sentences() {
    let block = "```sextic\nparameter a : 1\nclaim (1): a == 2.5 \"or 4.5\"\n```";
    let text = format!("It is 2.5, or 0.5.\n\n| a | 1.25 % |\n\n{block}\n\n§4.2, 1.2.3 and 4.5.");
    let found = open(&SourceFile::new("a.md", text));
    assert_eq!(
        found.into_iter().collect::<Vec<_>>(),
        ["0.5", "1.25", "4.5"]
    );
}
