//! What the documentation says is so: its blocks run, its tables are complete, the output that it
//! quotes is the command's.

mod architecture;
mod page;
mod sources;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use sextic::language::built_in::names;
use sextic::language::diagnostic::SourceFile;
use sextic::language::document::parse_document;
use sextic::language::expression_parser::parse_expression;
use sextic::language::syntax::{Expectation, StatementKind};

use super::derivation::{Folder, audit_in, block};
use page::{Page, read, root};

/// The pages whose links and blocks are checked.
const PAGES: [&str; 5] = [
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    LANGUAGE_PAGE,
    "derivations/cases/README.md",
];

/// The page about the language.
const LANGUAGE_PAGE: &str = "derivations/README.md";

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
    for path in PAGES {
        if Page::of(path).blocks_in("sextic").next().is_some() {
            runs(path, read(path));
        }
    }
    for path in ["README.md", LANGUAGE_PAGE] {
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
fn the_quoted_output_is_that_of_the_command() {
    let page = Page::of("README.md");
    let mut commands = Vec::new();
    for block in page.blocks_in("text") {
        let command = block
            .before
            .iter()
            .find_map(|code| code.strip_prefix("sextic "));
        let command =
            command.unwrap_or_else(|| panic!("of no command is this output:\n{}", block.text));
        let output = Command::new(env!("CARGO_BIN_EXE_sextic"))
            .args(command.split_whitespace())
            .current_dir(root())
            .output()
            .expect("the command runs");
        let printed = format!("\n{}", String::from_utf8_lossy(&output.stdout));
        let mut rest = printed.as_str();
        for chunk in format!("\n{}", block.text).split("\n⋮") {
            assert!(!chunk.trim().is_empty(), "nothing between two ⋮");
            let chunk = format!("\n{}\n", chunk.trim_matches('\n'));
            let place = rest.find(&chunk);
            let place = place.unwrap_or_else(|| {
                panic!("`sextic {command}` does not print, or not there:{chunk}")
            });
            // The line break behind a chunk may be the one before the next.
            rest = &rest[place + chunk.len() - 1..];
        }
        commands.push(command.split(' ').next().unwrap_or_default());
    }
    let all = [
        "audit",
        "match",
        "stability",
        "validity",
        "evaluate",
        "stability",
        "speeds",
        "speeds",
        "speeds",
    ];
    assert_eq!(commands, all);
}

/// The evaluators of the README are generated, compiled and run as it says.
#[test]
fn the_section_of_the_readme_compiles() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("readme");
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("an old folder goes");
    }
    fs::create_dir_all(&folder).expect("a folder");
    let page = Page::of("README.md");
    let program = page.blocks_in("c").next().expect("a program in C");
    fs::write(folder.join("main.c"), &program.text).expect("a file");
    let text = read("README.md");
    let commands = text
        .lines()
        .skip_while(|line| !line.starts_with("    SECTION="));
    let commands = commands.take_while(|line| line.starts_with("    "));
    let mut script = String::from("set -e\n");
    commands.for_each(|line| script.push_str(&format!("{}\n", line.trim_start())));
    script.push_str(
        "gcc -std=c99 -Wall -Wextra -Werror main.c section.o -I section_c -lm -o main\n./main\n",
    );
    let command = Path::new(env!("CARGO_BIN_EXE_sextic"));
    let path = std::env::var("PATH").unwrap_or_default();
    let own = command
        .parent()
        .expect("the command is in a folder")
        .display();
    let output = Command::new("bash")
        .args(["-c", &script])
        .env("PATH", format!("{own}:{path}"))
        .current_dir(&folder)
        .output()
        .expect("a shell");
    let (out, err) = (
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    assert!(output.status.success(), "{script}{out}{err}");
    assert!(out.contains("within"), "{out}");
}

/// What the README quotes of a generated file stands there.
#[test]
fn the_quoted_head_is_that_of_the_file() {
    let page = Page::of("README.md");
    let head = page.blocks_in("rust").next().expect("the head of a file");
    let file = read("codegen/evaluators/src/closed_form.rs");
    assert!(file.contains(head.text.trim()), "{}", head.text);
}

#[test]
fn links_lead_somewhere() {
    for path in PAGES {
        let folder = root().join(path);
        let folder = folder.parent().expect("a page is in a folder");
        for link in Page::of(path).links {
            let (file, _) = link.split_once('#').unwrap_or((&link, ""));
            let known = link.starts_with("https://") || folder.join(file).exists();
            assert!(known, "{path} links to {link}");
        }
    }
}
