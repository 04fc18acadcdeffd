//! What the documentation says is so: its blocks and commands run, its tables are complete, the output
//! that it shows is the command's.

mod architecture;
mod guides;
mod imports;
mod numbers;
mod page;
mod sources;
mod steps;

use std::collections::BTreeSet;

use sextic::language::built_in::names;
use sextic::language::diagnostic::SourceFile;
use sextic::language::document::parse_document;
use sextic::language::expression_parser::parse_expression;
use sextic::language::syntax::{Expectation, StatementKind};

use super::derivation::{Folder, audit_in, block};
use page::{Page, read, root};

/// The pages, beside those under `docs`, whose links and blocks are checked.
const PAGES: [&str; 6] = [
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    LANGUAGE_PAGE,
    "derivations/cases/README.md",
    "benches/README.md",
];

/// The page about the language.
const LANGUAGE_PAGE: &str = "derivations/README.md";

/// The guide to writing a document.
const DOCUMENT_GUIDE: &str = "docs/document.md";

/// All pages.
fn pages() -> Vec<String> {
    let mut pages: Vec<String> = PAGES.map(str::to_owned).into();
    pages.extend(guides::docs());
    pages
}

/// Audits a text as a document of a folder: every verdict must be as expected, and there must be some.
fn runs(path: &str, text: String) {
    let audit = audit_in(&SourceFile::new(path, text), &Folder(root()));
    let audit = audit.unwrap_or_else(|messages| panic!("{messages}"));
    assert!(!audit.claims.is_empty(), "{path} asserts nothing");
    let surprises = audit.claims.iter().filter(|claim| !claim.as_expected());
    let surprises: Vec<String> = surprises
        .map(|claim| format!("{} {:?}", claim.label.text, claim.verdict))
        .collect();
    assert_eq!(surprises, [""; 0], "{path}");
}

#[test]
fn blocks_of_the_documentation_run() {
    for path in pages() {
        if Page::of(&path).blocks_in("sextic").next().is_some() {
            runs(&path, read(&path));
        }
    }
    for path in ["README.md", DOCUMENT_GUIDE, LANGUAGE_PAGE] {
        assert!(
            Page::of(path).blocks_in("sextic").next().is_some(),
            "{path}"
        );
    }
}

#[test]
fn the_worked_document_is_shown_in_full() {
    let page = Page::of(LANGUAGE_PAGE);
    let shown: Vec<&str> = page
        .blocks_in("markdown")
        .map(|block| &*block.text)
        .collect();
    assert_eq!(shown, [read("derivations/two-degrees.md")]);
}

/// The sorts of statements; a new one does not compile until it is named here.
fn sort(statement: &StatementKind) -> &'static str {
    match statement {
        StatementKind::Import { .. } => "import",
        StatementKind::Parameter { .. } => "parameter",
        StatementKind::Complex { .. } => "complex",
        StatementKind::Angle { .. } => "angle",
        StatementKind::Coordinate { .. } => "coordinate",
        StatementKind::Function { .. } => "function",
        StatementKind::Imaginary { .. } => "imaginary",
        StatementKind::Assume { .. } => "assume",
        StatementKind::Definition { .. } => "definition",
        StatementKind::Substitution { .. } => "substitution",
        StatementKind::Assertion { expectation, .. } => match expectation {
            Expectation::Holds => "claim",
            Expectation::Refuted => "refute",
            Expectation::Approximate => "approximate",
            Expectation::IllFormed => "ill-formed",
        },
        StatementKind::Eigenpair { .. } => "eigenpair",
        StatementKind::Match(_) => "match",
        StatementKind::System(_) => "system",
        StatementKind::Evaluator { .. } => "evaluator",
        StatementKind::Domain(_) => "domain",
        StatementKind::Show { .. } => "show",
    }
}

#[test]
fn the_table_of_statements_is_a_document() {
    let page = Page::of(LANGUAGE_PAGE);
    let statements = page.table(&["statement", "what it does"]).iter();
    let statements: Vec<&str> = statements.map(|row| row[0].text.as_str()).collect();
    let text = block(&statements.join("\n"));
    let source = SourceFile::new("derivations/table.md", text.clone());
    let document = parse_document(&source).unwrap_or_else(|errors| panic!("{errors:?}"));
    assert_eq!(document.statements.len(), statements.len());
    let sorts: BTreeSet<&str> = document.statements.iter().map(|s| sort(&s.kind)).collect();
    assert_eq!(sorts.len(), 20, "a sort of statement is missing: {sorts:?}");
    runs("derivations/table.md", text);
}

#[test]
fn the_table_of_functions_names_all() {
    let page = Page::of(LANGUAGE_PAGE);
    let calls = page.code(&["function", "gives"], 0);
    let mut named: Vec<&str> = calls
        .iter()
        .map(|call| call.split('(').next().unwrap_or_default())
        .collect();
    let mut all: Vec<&str> = names().collect();
    named.sort_unstable();
    all.sort_unstable();
    assert_eq!(named, all);
}

#[test]
fn what_is_written_in_the_tables_is_read() {
    let page = Page::of(LANGUAGE_PAGE);
    let mut examples = page.code(&["function", "gives"], 0);
    // The second column has other spellings of operators in it, which are no expressions.
    examples.extend(page.code(&["written", "means"], 0));
    for example in examples {
        // `…` stands for more of the same.
        let example = example.replace('…', "c");
        assert!(parse_expression(&example).is_ok(), "{example}");
    }
}

#[test]
fn links_lead_somewhere() {
    for path in pages() {
        let folder = root().join(&path);
        let folder = folder.parent().expect("a page is in a folder");
        let page = Page::of(&path);
        for link in page.links.iter().chain(&page.pictures) {
            if link.starts_with("https://") {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = match file {
                "" => root().join(&path),
                file => folder.join(file),
            };
            assert!(target.exists(), "{path} leads to {link}");
            if !anchor.is_empty() {
                let text = std::fs::read_to_string(&target).expect("a page");
                let anchors = Page::parse(&text).anchors();
                assert!(
                    anchors.iter().any(|own| own == anchor),
                    "{path} leads to {link}, and there is {anchors:?}"
                );
            }
        }
    }
}
