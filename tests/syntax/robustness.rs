//! No text can make the parser panic, overflow its stack or hang.

use proptest::prelude::*;
use sextic::language::diagnostic::{SourceFile, render};
use sextic::language::document::parse_document;
use sextic::language::expression_parser::parse_expression;
use sextic::language::notation::Notation;

/// What the language is made of, and what people paste into it.
#[rustfmt::skip]
const PIECES: &[&str] = &[
    "parameter ", "angle ", "coordinate ", "function ", "imaginary ", "assume ", "substitution ",
    "claim ", "refute ", "approximate ", "ill-formed ", "eigenpair ", "match ", "show ", "import ", " as ",
    " at ", " to order 1 in ", " of ", " value ", " vector ", " with ", " in ", " unknown ",
    " neglect ", " small ", "(", ")", "[", "]", "|", "√(", "√", ",", ";", ":", ":=", "=", "==", "≈",
    "!=", "<", "<=", "≤", ">", ">=", "≥", "+", "-", "−", "*", "**", "·", "/", "^", "²", "⁻¹", "'",
    "″", "\"", "\"words\"", "# ", "\n", "\n  ", "\r\n", "\t", " ", "1", "0", "0.25", ".", "x", "ẋ",
    "θ̈_d", "L_ẋ", "é", "ж", "λ", "lambda", "ω_n", "S_xθ", "C_D", "$", "{", "\\", "–", "“", "₁", "\u{307}",
    "\r", "<br>", "<!--", "-->", "<div>", "[^1]:", "[^1]", "---\n", "$$", "| a |\n|---|\n", "Α", "&shy;",
    "\u{feff}", "\0", "\u{2028}", "```\n", "```sextic\n", "> ", "- ", "\n# Title\n",
];

fn soup() -> impl Strategy<Value = String> {
    let piece = proptest::sample::select(PIECES.to_vec());
    proptest::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat())
}

fn read(text: &str) {
    let source = SourceFile::new("document.md", text);
    match parse_document(&source) {
        Ok(document) => {
            for statement in &document.statements {
                assert!(
                    text.get(statement.span.clone())
                        .is_some_and(|said| !said.is_empty())
                );
            }
        }
        Err(errors) => {
            assert!(!errors.is_empty());
            for error in &errors {
                assert!(text.get(error.span.clone()).is_some(), "{error:?}");
                assert!(render(error, &source, false).contains("document.md:"));
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn any_text_is_read(text in any::<String>()) {
        read(&text);
        read(&format!("```sextic\n{text}\n```\n"));
        let _ = parse_expression(&text);
    }

    #[test]
    fn any_tokens_are_read(text in soup()) {
        read(&text);
        read(&format!("```sextic\n{text}\n```\n"));
        let _ = parse_expression(&text);
    }

    #[test]
    fn any_bytes_are_read(bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
        if let Err(error) = SourceFile::from_bytes("document.md", &bytes) {
            let source = SourceFile::from_bytes_lossy("document.md", &bytes);
            prop_assert!(render(&error, &source, true).contains("document.md"));
        }
    }
}

/// The code of the error for an expression, on a stack as small as a thread's.
fn code(text: &str) -> &'static str {
    parse_expression(text).map_or_else(|error| error.kind.code(), |_| "none")
}

#[test]
fn depth_is_limited() {
    for (open, close) in [
        ("(", ")"),
        ("[", "]"),
        ("|", "|"),
        ("√(", ")"),
        ("f(", ")"),
        ("-", ""),
        ("a^", ""),
        ("a[", "]"),
        ("a at (x=", ")"),
    ] {
        let nested = |depth: usize| format!("{}a{}", open.repeat(depth), close.repeat(depth));
        assert_eq!(code(&nested(150)), "none", "{open}");
        assert_eq!(code(&nested(300)), "budget", "{open}");
        assert_eq!(code(&nested(100_000)), "budget", "{open}");
    }
}

#[test]
fn deep_expressions_are_written_at_once() {
    for open in ["a*(", "-(", "a + (", "a^(", "f(", "|", "(1 - "] {
        let close = if open == "|" { "|" } else { ")" };
        let text = format!("{}a{}", open.repeat(90), close.repeat(90));
        let expression = parse_expression(&text).unwrap();
        for notation in [Notation::Unicode, Notation::Ascii, Notation::Latex] {
            assert!(notation.expression(&expression).len() < 10_000);
        }
    }
}

#[test]
fn height_is_limited() {
    for link in [" + a", "*a", "[1]", " at a"] {
        assert_eq!(code(&format!("a{}", link.repeat(400))), "none", "{link}");
        assert_eq!(code(&format!("a{}", link.repeat(600))), "budget", "{link}");
        assert_eq!(
            code(&format!("a{}", link.repeat(100_000))),
            "budget",
            "{link}"
        );
    }
    let sum = format!("a{}", " + a".repeat(300));
    assert_eq!(code(&format!("({sum}){}", "*a".repeat(300))), "budget");
}

#[test]
fn sizes_are_limited() {
    assert_eq!(code(&"7".repeat(1000)), "none");
    assert_eq!(code(&"7".repeat(1001)), "budget");
    assert_eq!(code(&format!("a{}", "²".repeat(1001))), "budget");
    assert_eq!(code(&format!("0.{}", "7".repeat(1000))), "budget");
    let errors = parse_document(&SourceFile::new("large.md", "a".repeat(5 << 20))).unwrap_err();
    assert_eq!(errors[0].kind.code(), "budget");
    let lines = format!("```sextic\n{}```\n", "x\n".repeat(1 << 20));
    let errors = parse_document(&SourceFile::new("many.md", lines)).unwrap_err();
    assert_eq!(errors.len(), 100);
}
