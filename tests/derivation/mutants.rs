//! No false variant of an assertion of the paper's document holds.
//!
//! Every claimed equation is changed in one place: a sign, an exponent, a factor, a name, a function.
//! The changed claims are audited within the document, right behind the original.

use sextic::language::diagnostic::SourceFile;
use sextic::language::document::parse_document;
use sextic::language::syntax::{Comparison, Expectation, Span, StatementKind};
use sextic::verdict::audit::audit;
use sextic::verdict::claim::Verdict;

use super::Folder;

const DOCUMENT: &str = include_str!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/derivations/he-macdonald-2017.md"
));

/// One changed claim.
struct Mutant {
    /// Where the original ends.
    behind: usize,
    /// The label of the original.
    original: String,
    /// Everything behind the label.
    text: String,
    /// How it begins.
    keyword: &'static str,
}

/// Variants that are true, with the reason; they are told by what the changed text contains.
const IDENTITIES: [(&str, &str, &str); 9] = [
    ("the scaled matrix", "S_a == S_a", "a matrix is itself"),
    ("the scaled matrix", "S_w == S_w", "a matrix is itself"),
    (
        "terms in the square of the rate",
        "== [0; 0]",
        "every term of order 2 or more in the motion is dropped, whatever the angles are",
    ),
    (
        "the constant term is exact",
        "coefficient(assumed, λ, 0) == coefficient(assumed, λ, 0)",
        "both sides are the same",
    ),
    (
        "the constant term is exact",
        "coefficient(p, λ, 0) == coefficient(p, λ, 0)",
        "both sides are the same",
    ),
    (
        "the nine numbers of a section",
        "C_a at quasi_steady == C_a",
        "C_a contains none of the nine numbers that are replaced",
    ),
    (
        "mode 1 solves the characteristic equation",
        "λ = i*ω_1 + λ_1",
        "μ is replaced by the same closed form, only earlier",
    ),
    (
        "mode 2 solves the characteristic equation",
        "λ = i*ω_2 + λ_2",
        "μ is replaced by the same closed form, only earlier",
    ),
    (
        "mode 3 solves the characteristic equation",
        "λ = i*ω_3 + λ_3",
        "μ is replaced by the same closed form, only earlier",
    ),
];

fn is_word(character: char) -> bool {
    character.is_alphanumeric() || character == '_' || character == '\''
}

/// The names in a text and their places.
fn names(text: &str) -> Vec<Span> {
    let mut found: Vec<Span> = Vec::new();
    let mut inside = false;
    for (place, character) in text.char_indices() {
        let end = place + character.len_utf8();
        match found.last_mut() {
            Some(last) if inside && is_word(character) => last.end = end,
            _ if is_word(character) => {
                inside = true;
                found.push(place..end);
            }
            _ => inside = false,
        }
    }
    found
}

/// The variants of a text that differ from it in one place.
fn variants(text: &str) -> Vec<String> {
    let mut variants = Vec::new();
    let mut replace = |span: Span, by: &str| {
        let variant = format!("{}{by}{}", &text[..span.start], &text[span.end..]);
        if variant != text && !variants.contains(&variant) {
            variants.push(variant);
        }
    };
    for (from, to) in [
        (" + ", " - "),
        (" - ", " + "),
        ("(-", "("),
        ("[-", "["),
        (" -", " "),
        ("2*", ""),
        ("/2", ""),
        ("4*", "2*"),
        ("8*", "4*"),
        ("^2", "^3"),
        ("^2", ""),
        ("sin(", "cos("),
        ("cos(", "sin("),
    ] {
        for (place, _) in text.match_indices(from) {
            replace(place..place + from.len(), to);
        }
    }
    let found = names(text);
    for (index, span) in found.iter().enumerate() {
        let name = &text[span.clone()];
        if name.chars().all(|c| c.is_ascii_digit()) || text[span.end..].starts_with('(') {
            continue;
        }
        // The next two different names of the same assertion, which may have the same unit.
        let others = found.iter().cycle().skip(index + 1).take(found.len() - 1);
        let mut others: Vec<&str> = others.map(|other| &text[other.clone()]).collect();
        others.dedup();
        let usable = |other: &&str| {
            *other != name
                && !other.starts_with(|c: char| c.is_ascii_digit())
                && !text.contains(&format!("{other}("))
                && ![
                    "at",
                    "value",
                    "vector",
                    "of",
                    "rest",
                    "section",
                    "closed_form",
                ]
                .contains(other)
        };
        for other in others.into_iter().filter(usable).take(2) {
            replace(span.clone(), other);
        }
    }
    variants
}

fn mutants() -> Vec<Mutant> {
    let source = SourceFile::new("paper.md", DOCUMENT);
    let document = parse_document(&source).expect("the paper's document is well-formed");
    let mut mutants = Vec::new();
    for statement in &document.statements {
        let (label, keyword) = match &statement.kind {
            StatementKind::Assertion {
                label,
                expectation: Expectation::Holds,
                relation,
                ..
            } if relation.comparison == Comparison::Equal => (label, "claim"),
            StatementKind::Eigenpair { label, .. } => (label, "eigenpair"),
            _ => continue,
        };
        let text = &DOCUMENT[label.span.end..statement.span.end];
        let text = text.split('"').next().unwrap_or(text).trim_end();
        for text in variants(text) {
            let (behind, original) = (statement.span.end, label.text.clone());
            mutants.push(Mutant {
                behind,
                original,
                text,
                keyword,
            });
        }
    }
    mutants
}

/// The document with the mutants in it, and where each of them stands.
fn document_with(mutants: &[Mutant], left_out: &[bool]) -> (String, Vec<Span>) {
    let (mut text, mut places, mut copied) = (String::new(), Vec::new(), 0);
    for (number, mutant) in mutants.iter().enumerate() {
        text += &DOCUMENT[copied..mutant.behind];
        copied = mutant.behind;
        let start = text.len();
        if !left_out[number] {
            text += &format!("\n{} [mutant {number}]{}", mutant.keyword, mutant.text);
        }
        places.push(start..text.len());
    }
    text += &DOCUMENT[copied..];
    (text, places)
}

/// Fisher and Yates' shuffle with a fixed seed, so that a part of it is a fair sample.
fn shuffled(count: usize) -> Vec<usize> {
    let mut state = 2017_u64;
    let mut order: Vec<usize> = (0..count).collect();
    for place in (1..count).rev() {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        order.swap(place, (state >> 33) as usize % (place + 1));
    }
    order
}

/// How many variants the ordinary test judges; the environment variable `SEXTIC_ALL_MUTANTS` asks
/// for all.
const SAMPLE: usize = 250;

#[test]
fn no_false_variant_of_the_paper_holds() {
    let all = std::env::var_os("SEXTIC_ALL_MUTANTS").is_some();
    let mutants = mutants();
    let mut left_out = vec![false; mutants.len()];
    if !all {
        shuffled(mutants.len())
            .into_iter()
            .skip(SAMPLE)
            .for_each(|place| left_out[place] = true);
    }
    let judged = left_out.iter().filter(|out| !**out).count();
    let mut rejected = 0;
    let audit = loop {
        let (text, places) = document_with(&mutants, &left_out);
        match audit(
            &SourceFile::new("paper.md", text),
            &Folder(Default::default()),
        ) {
            Ok(audit) => break audit,
            // A variant that makes no sense at all is left out and the rest judged again.
            Err(error) => {
                for diagnostic in &error.diagnostics {
                    assert_ne!(diagnostic.kind.code(), "disagreement", "{diagnostic:?}");
                    let marks = diagnostic.secondary.iter().map(|(span, _)| span);
                    let marks: Vec<usize> = marks
                        .chain([&diagnostic.span])
                        .map(|span| span.start)
                        .collect();
                    let inside = |place: &Span| marks.iter().any(|at| place.contains(at));
                    let place = places.iter().position(inside);
                    let place = place.unwrap_or_else(|| panic!("{diagnostic:?}"));
                    left_out[place] = true;
                    rejected += 1;
                }
            }
        }
    };
    let mut count = std::collections::BTreeMap::from([("rejected", rejected)]);
    let mut survivors = Vec::new();
    for claim in &audit.claims {
        let Some(number) = claim.label.text.strip_prefix("mutant ") else {
            continue;
        };
        let mutant = &mutants[number.parse::<usize>().expect("a number")];
        *count.entry(claim.verdict.text()).or_default() += 1;
        if matches!(claim.verdict, Verdict::Holds | Verdict::HoldsWhere) {
            let text = mutant.text.split_whitespace().collect::<Vec<_>>().join(" ");
            let known = IDENTITIES
                .iter()
                .any(|(label, part, _)| *label == mutant.original && text.contains(part));
            // Everything is itself.
            let statement = text.rsplit(": ").next().unwrap_or_default();
            let sides = statement
                .split('"')
                .next()
                .and_then(|sides| sides.split_once(" == "));
            let is_same = sides.is_some_and(|(left, right)| left.trim() == right.trim());
            if !known && !is_same {
                survivors.push(format!("({}){text}", mutant.original));
            }
        }
    }
    println!("{judged} of {} variants: {count:?}", mutants.len());
    assert!(
        survivors.is_empty(),
        "these hold:\n{}",
        survivors.join("\n")
    );
}
