//! Documents whose assertions come out as they say: `claim`, `refute`, `approximate` and
//! `ill-formed` as everywhere, and `undecided` where the label begins so.

use sextic::derivation::condition::Requirement;
use sextic::language::diagnostic::SourceFile;
use sextic::language::notation::Notation;
use sextic::report::words;
use sextic::verdict::claim::{Claim, Verdict};

use super::{Folder, audit_in, data};

/// A claim in one line, with its conditions, its counterexample and its reason.
fn line(claim: &Claim) -> String {
    let mut line = format!("{}: {}", claim.label.text, claim.verdict.text());
    for condition in &claim.conditions {
        let relation = match condition.requirement {
            Requirement::NonZero => "≠ 0",
            Requirement::Positive => "> 0",
        };
        line += &format!(
            "; {} {relation}",
            Notation::Unicode.expression(&condition.expression)
        );
    }
    if let Some(residual) = &claim.residual {
        line += &format!("; leading {}", Notation::Unicode.expression(residual));
    }
    if let Some(witness) = &claim.witness {
        let coordinates = witness.point.iter().map(|one| {
            format!(
                "{} = {}",
                Notation::Unicode.expression(&one.name),
                words::assigned(one, Notation::Ascii)
            )
        });
        let coordinates: Vec<String> = coordinates.collect();
        let sides = format!("{} against {}", witness.left, witness.right);
        line += &format!("; {sides} at {}", coordinates.join(", "));
    }
    if let Some(reason) = &claim.reason {
        line += &format!(" ({reason})");
    }
    line
}

#[test]
fn every_verdict_is_as_the_document_says() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/verdicts"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!("../data/verdicts", "*.md", |path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = std::fs::read_to_string(path).expect("the document can be read");
            let source = SourceFile::new(name.clone(), text);
            let audit =
                audit_in(&source, &Folder(data("verdicts"))).unwrap_or_else(|m| panic!("{m}"));
            let mut wrong = Vec::new();
            for claim in &audit.claims {
                let well = match claim.label.text.starts_with("undecided") {
                    true => claim.verdict == Verdict::Undecided,
                    false => claim.as_expected(),
                };
                if !well {
                    wrong.push(line(claim));
                }
            }
            assert!(wrong.is_empty(), "{name}:\n{}", wrong.join("\n"));
            insta::assert_snapshot!(audit.claims.iter().map(line).collect::<Vec<_>>().join("\n"));
        });
    });
}
