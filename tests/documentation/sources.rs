//! What the sources do not contain.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

use super::page::root;

/// Words that are no part of an exact and quiet computation, and where they may not stand.
const FORBIDDEN: [(&str, &[&str]); 18] = [
    ("f32", &EXACT),
    ("f64", &EXACT),
    ("fs", &QUIET),
    ("env", &QUIET),
    ("io", &QUIET),
    ("net", &QUIET),
    ("process", &QUIET),
    ("time", &EXACT),
    ("Instant", &QUIET),
    ("SystemTime", &QUIET),
    ("HashMap", &QUIET),
    ("HashSet", &QUIET),
    ("print", &QUIET),
    ("println", &QUIET),
    ("eprint", &QUIET),
    ("eprintln", &QUIET),
    ("dbg", &["src"]),
    ("todo", &["src"]),
];

/// Where everything is exact.
const EXACT: [&str; 7] = [
    "src/algebra",
    "src/language",
    "src/derivation",
    "src/points",
    "src/verdict",
    "src/compile",
    "src/certificate",
];

/// Where nothing is read or written, and nothing depends on anything but the documents.
const QUIET: [&str; 9] = [
    "src/algebra",
    "src/language",
    "src/derivation",
    "src/points",
    "src/verdict",
    "src/compile",
    "src/certificate",
    "src/documents.rs",
    "src/report",
];

/// The Rust files in a folder and all folders in it, or the one file, in order.
pub fn rust_files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        let is_rust = path.extension().is_some_and(|extension| extension == "rs");
        return is_rust.then(|| path.to_owned()).into_iter().collect();
    }
    let entries = std::fs::read_dir(path).expect("a folder can be read");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().flat_map(|path| rust_files(path)).collect()
}

/// The names and numbers of a source, without what stands in comments and in quotation marks.
fn words(text: &str) -> Vec<String> {
    fn collect(tokens: TokenStream, words: &mut Vec<String>) {
        let mut points = 0;
        for token in tokens {
            let before = std::mem::take(&mut points);
            match token {
                TokenTree::Group(own) => collect(own.stream(), words),
                TokenTree::Ident(own) => words.push(own.to_string()),
                // Behind one point it is the place of a part: `pair.0.1` has no number 0.1.
                TokenTree::Literal(own) if before != 1 => words.push(own.to_string()),
                TokenTree::Punct(own) if own.as_char() == '.' => points = before + 1,
                TokenTree::Literal(_) | TokenTree::Punct(_) => {}
            }
        }
    }
    let tokens: TokenStream = text.parse().expect("Rust");
    let mut words = Vec::new();
    collect(tokens, &mut words);
    words.retain(|word| !word.contains('"') && !word.starts_with('\''));
    words
}

/// Whether a word is a number with a point or an exponent.
fn is_float(word: &str) -> bool {
    match syn::parse_str(word) {
        Ok(syn::Lit::Float(_)) => true,
        Ok(syn::Lit::Int(own)) => own.suffix().starts_with('f'),
        _ => false,
    }
}

fn floats(text: &str) -> Vec<String> {
    words(text)
        .into_iter()
        .filter(|word| is_float(word))
        .collect()
}

fn contains_word(text: &str, word: &str) -> bool {
    words(text).iter().any(|own| own == word)
}

#[test]
fn computations_are_exact_and_quiet() {
    let mut wrong = Vec::new();
    let mut check = |folder: &str, what: &str, is_in: &dyn Fn(&str) -> bool| {
        let files = rust_files(&root().join(folder));
        assert!(!files.is_empty(), "no sources in {folder}");
        for path in files {
            let text = std::fs::read_to_string(&path).expect("a source can be read");
            if is_in(&text) {
                wrong.push(format!("{what} in {}", path.display()));
            }
        }
    };
    for folder in EXACT {
        check(folder, "a floating-point number", &|text| {
            !floats(text).is_empty()
        });
    }
    for (word, folders) in FORBIDDEN {
        for folder in folders {
            check(folder, word, &|text| contains_word(text, word));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The files that give an emitted function its inputs: of a section, and of its coordinates without wind.
const BINDING: [&str; 2] = ["given.rs", "uniform_form.rs"];

#[test]
fn a_section_meets_what_was_derived_in_one_file() {
    let folders = ["src/stability", "src/report", "src/cli"];
    let files = folders.iter().flat_map(|own| rust_files(&root().join(own)));
    let binds = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).expect("a source can be read");
        let mut lines = text.lines();
        lines.any(|line| line.contains("Inputs {") && !line.trim_start().starts_with("//"))
    };
    let found: BTreeSet<String> = files
        .filter(binds)
        .filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()))
        .collect();
    assert_eq!(found, BINDING.map(String::from).into());
}

#[test]
fn what_is_forbidden_is_found() {
    for (text, found) in [
        ("let x = 1.5;", "1.5"),
        ("f(2.)", "2."),
        ("1e3", "1e3"),
        ("1_000e-3", "1_000e-3"),
        ("7f64", "7f64"),
        ("a\n'\\'' 0.5 // \"", "0.5"),
        ("'\"' + 0.25 + '\"'", "0.25"),
        ("fn f<'a>(x: &'a T) { 3.0 }", "3.0"),
        ("r#\"\"# + 2.5 + \"\"", "2.5"),
        ("// 1.5", ""),
        ("/* 1.5 */ \"\\\"1.5\" r#\"1.5\"1.5\"#", ""),
        ("tuple.0.1 + 1.max(2) + 0..10 + 0x1e3 + 12_u8", ""),
        ("0..1.5 + f(tuple.0)", "1.5"),
    ] {
        assert_eq!(floats(text).join(" "), found, "{text}");
    }
    for (text, word, found) in [
        ("use std::{fs, env};", "fs", true),
        ("std::env::var(name)", "env", true),
        ("dbg!(x)", "dbg", true),
        ("x as f64", "f64", true),
        ("x.env", "env", true),
        ("// dbg!(x)", "dbg", false),
        ("\"fs\" + offs + fs_", "fs", false),
        ("FxHashMap", "HashMap", false),
    ] {
        assert_eq!(contains_word(text, word), found, "{word} in {text}");
    }
}
