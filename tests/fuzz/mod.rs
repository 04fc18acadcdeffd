//! A small fuzzer without tools: texts of `fuzz/corpus`, and changes of them, the same ones every time.
//!
//! `SEXTIC_FUZZ_ROUNDS` says how many changes are made of each text, and `SEXTIC_FUZZ_SEED` where they
//! begin; the targets of `fuzz/` find more.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use sextic::compile::generation::{Failure, Order, generate};
use sextic::compile::reading::read;
use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::audit;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{File, Language, emit};
use sextic_codegen::program::{Operation, Program};

/// What is put into a text in the place of something.
const WORDS: [&str; 44] = [
    "", " ", "\n", "\t", "\r", "\u{feff}", "\u{202e}", "ω", "ẋ", "′", "0", "1", "-1", "1/0",
    "1e999", "99999999", "(", ")", "[", "]", "{", "}", "\"", "'", "`", "```", "/*", "*/", "//",
    "#", "\\", ",", ";", "=", ":=", "^", "^(-1)", "sqrt(", "i", "at (", "d(", "return", "let ",
    "nan",
];

/// Numbers that look random, the same on every machine (SplitMix64).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ mixed >> 31) % end.max(1) as u64) as usize
    }

    /// A part of some letters.
    fn part<'l>(&mut self, letters: &'l [char]) -> &'l [char] {
        let start = self.below(letters.len() + 1);
        let length = self.below(12).min(letters.len() - start);
        &letters[start..start + length]
    }
}

/// A text with a few changes.
fn changed(text: &str, others: &[(String, String)], random: &mut Random) -> String {
    let mut letters: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(3) {
        let word: Vec<char> = match random.below(3) {
            0 => WORDS[random.below(WORDS.len())].chars().collect(),
            1 => random.part(&letters.clone()).to_vec(),
            _ => {
                let other: Vec<char> = others[random.below(others.len())].1.chars().collect();
                random.part(&other).to_vec()
            }
        };
        let start = random.below(letters.len() + 1);
        let gone = random.below(6).min(letters.len() - start);
        letters.splice(start..start + gone, word);
    }
    letters.into_iter().collect()
}

fn number(name: &str, usual: usize) -> usize {
    let set = std::env::var(name).ok();
    set.and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// Tries the texts of a folder, and changes of them.
fn try_all(folder: &str, rounds: usize, run: impl Fn(&str)) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fuzz/corpus")
        .join(folder);
    let mut texts: Vec<(String, String)> = Vec::new();
    for entry in fs::read_dir(&path).expect("a corpus") {
        let path = entry.expect("a file").path();
        let text = fs::read_to_string(&path).expect("a text");
        texts.push((path.display().to_string(), text));
    }
    texts.sort();
    let mut random = Random(number("SEXTIC_FUZZ_SEED", 14) as u64);
    let rounds = number("SEXTIC_FUZZ_ROUNDS", rounds);
    for (path, text) in &texts {
        for round in 0..=rounds {
            let tried = match round {
                0 => text.clone(),
                _ => changed(text, &texts, &mut random),
            };
            let outcome = catch_unwind(AssertUnwindSafe(|| run(&tried)));
            assert!(
                outcome.is_ok(),
                "{path}, round {round}:\n{tried}\n{tried:?}"
            );
        }
    }
}

#[test]
fn documents_are_judged_and_what_they_compile_is_proven() {
    try_all("document", 40, |text| {
        let text = format!("# A document\n\n```sextic\n{text}\n```\n");
        let Ok(audit) = audit(&SourceFile::new("document.md", text), &ShippedLibrary) else {
            return;
        };
        let audits = [audit];
        for language in Language::ALL {
            let order = Order {
                points: 0,
                ..Order::of_all(language)
            };
            if let Err(Failure::Doubted(evaluator, doubt)) = generate(&audits, &order, &mut |_| {})
            {
                panic!("{language}, {evaluator}: {doubt}");
            }
        }
    });
}

/// b = a + √(2·a)
fn sample() -> Evaluator {
    let mut program = Program::new(["a".to_owned()]);
    let a = program.input("a").expect("an input");
    let two = program.constant(2.into());
    let twice = program.push(Operation::Multiply(two, a));
    let root = program.push(Operation::SquareRoot(twice));
    let sum = program.push(Operation::Add(a, root));
    program.output("b", sum);
    Evaluator::plain("sample", program)
}

#[test]
fn emitted_files_are_read_or_refused() {
    let sample = sample();
    for language in Language::ALL {
        let files = emit(std::slice::from_ref(&sample), language).expect("files");
        let is_own = |file: &&File| file.path.starts_with("sample.");
        let own: Vec<&File> = files.iter().filter(is_own).collect();
        try_all("emitted", 8, |text| {
            for file in &own {
                // Somewhere in the file, by what is put there.
                let places: Vec<usize> = file.text.char_indices().map(|(at, _)| at).collect();
                let mut random = Random(text.bytes().map(u64::from).sum());
                for _ in 0..20 {
                    let at = places[random.below(places.len())];
                    let text = [&file.text[..at], text, &file.text[at..]].concat();
                    let path = file.path.clone();
                    let others = own.iter().filter(|other| other.path != file.path);
                    let mut files: Vec<File> = others.map(|other| (*other).clone()).collect();
                    files.push(File { path, text });
                    let _ = read(&files, &sample, language);
                }
            }
        });
    }
}

#[cfg(feature = "stability")]
#[test]
fn cases_and_tables_are_read_or_refused() {
    use sextic::stability::case::Case;
    use sextic::stability::coefficient_table::{CoefficientTable, remarks};

    try_all("case", 1000, |text| {
        if let Ok(case) = Case::read("case.toml", text) {
            case.remarks();
        }
    });
    try_all("table", 1000, |text| {
        if let Ok(table) = CoefficientTable::read("table.csv", text) {
            remarks::remarks(&table);
        }
    });
}
