//! What the audit of the shipped documents finds: locked line by line, and checked where it can be
//! said in a few words.

use std::fmt::Write;

use insta::Settings;
use sextic::documents::{ShippedLibrary, shipped};
use sextic::language::notation::Notation;
use sextic::report::details::neglected;
use sextic::report::refusals::Messages;
use sextic::report::{json, words};
use sextic::verdict::audit::{Audit, audit, audit_after};
use sextic::verdict::claim::{Claim, Verdict};

fn audits() -> Vec<Audit> {
    let read = shipped().map(|source| audit(&source, &ShippedLibrary));
    read.map(|audit| audit.unwrap_or_else(|rejected| panic!("{:?}", rejected.diagnostics)))
        .collect()
}

fn paper() -> Audit {
    let found = audits()
        .into_iter()
        .find(|audit| audit.path.ends_with("he-macdonald-2017.md"));
    found.expect("the paper is shipped")
}

fn lock(name: &str, text: &str) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../../snapshots/paper");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

fn verdict_lines(claim: &Claim) -> String {
    let mut text = format!(
        "{} · {}\n",
        words::label(&claim.label),
        claim.verdict.text()
    );
    for condition in &claim.conditions {
        let _ = writeln!(
            text,
            "    where {}",
            words::condition(condition, Notation::Ascii)
        );
    }
    if let Some(neglected) = neglected(claim, Notation::Ascii) {
        let _ = writeln!(text, "    neglects {}", neglected.plain());
    }
    if let Some(reason) = &claim.reason {
        let _ = writeln!(text, "    because {reason}");
    }
    if let Some(witness) = &claim.witness {
        let point = witness.point.iter().map(|one| {
            format!(
                "{}={}",
                Notation::Ascii.expression(&one.name),
                words::assigned(one, Notation::Ascii)
            )
        });
        let point: Vec<String> = point.collect();
        let entry = witness
            .entry
            .map(|entry| format!(" entry {entry:?}"))
            .unwrap_or_default();
        let (left, right) = (&witness.left, &witness.right);
        let _ = writeln!(
            text,
            "    at {}:{entry} {left} against {right}",
            point.join(" ")
        );
    }
    text
}

#[test]
fn every_verdict_is_locked() {
    for audit in audits() {
        let name = audit
            .path
            .rsplit('/')
            .next()
            .unwrap_or_default()
            .trim_end_matches(".md");
        let lines: String = audit.claims.iter().map(verdict_lines).collect();
        lock(&format!("verdicts-{name}"), &lines);
    }
}

#[test]
fn what_was_audited_before_changes_nothing() {
    let alone = audits();
    let mut earlier: Vec<Audit> = Vec::new();
    for source in shipped() {
        let next = audit_after(&earlier, &source, &ShippedLibrary);
        earlier.push(next.unwrap_or_else(|rejected| panic!("{:?}", rejected.diagnostics)));
    }
    let none = Messages::default();
    assert_eq!(json::audits(&alone, &none), json::audits(&earlier, &none));
    for (alone, after) in alone.iter().zip(&earlier) {
        assert_eq!(alone.sources, after.sources);
        for (claim, same) in alone.claims.iter().zip(&after.claims) {
            let steps =
                [alone.explain(claim), after.explain(same)].map(|steps| format!("{steps:?}"));
            assert_eq!(steps[0], steps[1]);
        }
    }
}

#[test]
fn every_verdict_is_as_the_documents_expect() {
    for audit in audits() {
        let surprises: Vec<&str> = audit
            .claims
            .iter()
            .filter(|claim| !claim.as_expected())
            .map(|claim| claim.label.id.as_str())
            .collect();
        assert!(surprises.is_empty(), "{}: {surprises:?}", audit.path);
    }
}

#[test]
fn the_matching_is_locked() {
    for audit in audits() {
        for matched in &audit.matchings {
            let ascii = |expression| Notation::Ascii.expression(expression);
            let mut text = String::new();
            for (name, value) in &matched.solution {
                let _ = writeln!(text, "{name} = {}", ascii(value));
            }
            let _ = writeln!(text, "\ndeterminant = {}", ascii(&matched.determinant));
            for singularity in &matched.singular_where {
                let finite = if singularity.is_finite() {
                    "finite"
                } else {
                    "infinite"
                };
                let factor = words::singularity(singularity, Notation::Ascii);
                let _ = writeln!(
                    text,
                    "singular where {factor}; the solution is {finite} there"
                );
            }
            for neglected in &matched.neglected {
                let (what, factor) = (ascii(&neglected.expression), ascii(&neglected.factor));
                let _ = writeln!(text, "neglects {factor} * {what} at {}", neglected.power);
            }
            for row in &matched.table {
                let order = row.order.map_or("none".into(), |order| order.to_string());
                let used = if row.used { "used" } else { "not used" };
                let _ = writeln!(
                    text,
                    "\npower {}, {used}, order of the residual: {order}",
                    row.power
                );
                let _ = writeln!(text, "exact    {}", ascii(&row.exact));
                let _ = writeln!(text, "assumed  {}", ascii(&row.assumed));
                let _ = writeln!(text, "residual {}", ascii(&row.residual));
            }
            lock(&format!("matching-{}", matched.name.ascii), &text);
        }
    }
}

/// The equations that (21)–(23) rest on, and what the paper gets wrong: not only that nothing has
/// changed, but what it must be.
#[test]
fn the_paper_is_judged() {
    let audit = paper();
    let verdict = |id: &str| {
        let claim = audit.claims.iter().find(|claim| claim.label.id == id);
        claim
            .unwrap_or_else(|| panic!("no assertion is called {id}"))
            .verdict
    };
    for number in 1..=23 {
        let about = |claim: &&Claim| claim.label.equation.as_deref() == Some(&number.to_string());
        assert!(
            audit.claims.iter().any(|claim| about(&claim)),
            "equation ({number}) has no verdict"
        );
    }
    for id in ["21", "22", "23"] {
        assert_eq!(verdict(id), Verdict::HoldsWhere);
        assert_eq!(verdict(&format!("{id}-from-the-mode")), Verdict::Holds);
    }
    for id in ["8-printed", "9-printed", "10-printed", "18-printed"] {
        assert_eq!(verdict(id), Verdict::IllFormed);
    }
    for id in [
        "5-printed",
        "12-printed",
        "20-exact",
        "asymmetric-mass-matrix-stated",
        "centre-of-mode-1-lies-between-o-and-g-stated",
        "structural-damping-always-helps-stated",
    ] {
        assert_eq!(verdict(id), Verdict::Refuted);
    }
}

#[test]
fn the_matching_is_singular_without_eccentricity_and_its_solution_is_not() {
    let audit = paper();
    let [matched] = audit.matchings.as_slice() else {
        panic!("one matching")
    };
    let [singularity] = matched.singular_where.as_slice() else {
        panic!("one singularity")
    };
    assert_eq!(Notation::Ascii.expression(&singularity.factor), "L_g");
    assert!(singularity.is_finite());
    let orders: Vec<Option<u32>> = matched.table.iter().map(|row| row.order).collect();
    assert_eq!(orders, [None, None, Some(2), Some(3), Some(2), None, None]);
}
