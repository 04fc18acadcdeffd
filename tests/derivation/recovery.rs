//! A mistake costs the statement in which it is, and what builds on that; all else is judged as alone.

use std::path::PathBuf;

use sextic::language::diagnostic::SourceFile;
use sextic::language::notation::Notation;
use sextic::report::premises;
use sextic::verdict::audit::{Audit, audit};
use sextic::verdict::claim::{Claim, Verdict};

use super::{Folder, block, data};

/// What stands around every mistake.
const BEFORE: &str = "parameter a, b : m > 0
parameter n, p, p1, y, z : 1
s := a + b
d1 := a
claim [before]: s^2 == a^2 + 2*a*b + b^2
refute [before, false]: n == 2*n";
const AFTER: &str = "claim [after]: s - b == a
claim [after, with a condition]: n/n == 1
refute [after, false]: n + 1 == n*n
approximate [after, small]: (1 + n)^3 ≈ 1 + 3*n to order 1 in n
ill-formed [after, unit]: a == n
evaluator (after) after: sum = s";

fn audited(text: &str) -> Audit {
    let source = SourceFile::new("document.md", text);
    let found = audit(&source, &Folder(PathBuf::new()));
    found.unwrap_or_else(|rejected| panic!("{:?}", rejected.diagnostics))
}

/// A claim but for its place.
fn judged(claim: &Claim) -> String {
    format!(
        "{}: {} {:?} {:?} {:?} {:?}",
        claim.label.id,
        claim.verdict.text(),
        claim.conditions.len(),
        claim.witness,
        claim.reason,
        claim.neglected
    )
}

/// The claims that are those of the document around the mistake.
fn around(audit: &Audit) -> Vec<String> {
    let is_around = |claim: &&Claim| {
        let id = &claim.label.id;
        id.starts_with("before") || id.starts_with("after")
    };
    audit.claims.iter().filter(is_around).map(judged).collect()
}

#[test]
fn a_mistake_costs_what_builds_on_it() {
    let alone = around(&audited(&block(&format!("{BEFORE}\n{AFTER}"))));
    assert_eq!(alone.len(), 7);
    let text = std::fs::read_to_string(data("recovery/mistakes.txt")).expect("the mistakes");
    let mut count = 0;
    for section in text.split("\n## ").skip(1) {
        let (code, statements) = section.split_once('\n').expect("a code and statements");
        let audit = audited(&block(&format!("{BEFORE}\n{statements}\n{AFTER}")));
        let codes: Vec<&str> = audit
            .mistakes
            .iter()
            .map(|mistake| mistake.diagnostic.kind.code())
            .collect();
        assert_eq!(codes, [code.trim()], "{section}");
        assert_eq!(around(&audit), alone, "{section}");
        assert!(!audit.as_expected());
        for claim in &audit.claims {
            let is_skipped = claim.verdict == Verdict::Skipped;
            let label = &claim.label.text;
            assert_eq!(
                is_skipped,
                label.starts_with("skipped"),
                "{label} of {section}"
            );
            assert!(is_skipped || claim.as_expected(), "{label} of {section}");
            assert!(!is_skipped || claim.reason.is_some() && claim.witness.is_none());
        }
        let evaluators: Vec<&str> = audit
            .evaluators
            .iter()
            .map(|evaluator| evaluator.name.ascii.as_str())
            .collect();
        assert_eq!(evaluators, ["after"], "{section}");
        assert!(audit.matchings.is_empty(), "{section}");
        count += 1;
    }
    assert!(count > 30, "{count}");
}

/// Premises, mistakes, skipped statements and claims, a line each.
fn lines(audit: &Audit) -> String {
    let premises = premises::lines(audit, Notation::Unicode).into_iter();
    let premises = premises.map(|(keyword, phrase)| format!("{keyword} {}", phrase.plain()));
    let mut lines: Vec<String> = premises.collect();
    for mistake in &audit.mistakes {
        let source = audit.source_of(mistake).expect("a source");
        let (line, column) = source.line_and_column(&mistake.diagnostic.span);
        let (kind, message) = (mistake.diagnostic.kind.code(), &mistake.diagnostic.message);
        lines.push(format!(
            "{}:{line}:{column}: {kind}: {message}",
            mistake.path
        ));
    }
    for skipped in &audit.skipped {
        let (line, what, reason) = (skipped.line, &skipped.what, &skipped.basis.reason);
        lines.push(format!("line {line}: {what} {reason}"));
    }
    for claim in &audit.claims {
        let reason = claim.reason.as_deref().unwrap_or_default();
        lines.push(format!(
            "{}: {} {reason}",
            claim.label.text,
            claim.verdict.text()
        ));
    }
    lines.join("\n")
}

#[test]
fn documents_with_mistakes_are_judged() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/recovery"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!("../data/recovery", "*.md", |path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = std::fs::read_to_string(path).expect("the document can be read");
            let source = SourceFile::new(name.clone(), text);
            let found = audit(&source, &Folder(data("recovery")));
            let audit = found.unwrap_or_else(|own| panic!("{name}: {:?}", own.diagnostics));
            assert!(!audit.mistakes.is_empty(), "{name} has no mistake");
            insta::assert_snapshot!(lines(&audit));
        });
    });
}

#[test]
fn what_is_refused_in_an_import_is_refused_in_an_earlier_audit_too() {
    let folder = Folder(data("recovery"));
    let read = |name: &str| {
        let text = std::fs::read_to_string(data("recovery").join(name)).expect("a document");
        SourceFile::new(name, text)
    };
    let earlier = audit(&read("parts/library.md"), &folder).expect("a library");
    let (source, earlier) = (read("imports.md"), [earlier]);
    let after = sextic::verdict::audit::audit_after(&earlier, &source, &folder);
    let alone = audit(&source, &folder).expect("a document");
    assert_eq!(lines(&after.expect("a document")), lines(&alone));
}

#[test]
fn ten_thousand_mistakes_are_read() {
    let statements: Vec<String> = (0..10_000)
        .map(|number| {
            format!("q{number} := q{number}x\nassume a <\nclaim [{number}]: q{number} == a")
        })
        .collect();
    let audit = audited(&block(&format!(
        "{BEFORE}\n{}\n{AFTER}",
        statements.join("\n")
    )));
    assert_eq!(audit.mistakes.len(), 20_000);
    let skipped = |claim: &&Claim| claim.verdict == Verdict::Skipped;
    assert_eq!(audit.claims.iter().filter(skipped).count(), 10_000);
}
