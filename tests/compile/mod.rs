//! Evaluators of documents: translated, emitted, read back and proven.

mod translation;

use sextic::compile::proof::prove;
use sextic::compile::reading::rust::read;
use sextic::compile::specification::Specification;
use sextic::derivation::audit::{Audit, audit};
use sextic::documents::{ShippedLibrary, shipped};
use sextic_codegen::language::{Language, emit};

fn paper() -> Audit {
    let paper = shipped()
        .find(|document| document.path.ends_with("he-macdonald-2017.md"))
        .expect("the paper's document is shipped");
    audit(&paper, &ShippedLibrary).unwrap_or_else(|error| panic!("{:?}", error.diagnostics))
}

/// The emitted Rust of an evaluator.
fn text_of(specification: &Specification) -> String {
    let evaluator = &specification.evaluator;
    let files = emit(std::slice::from_ref(evaluator), Language::Rust).expect("it can be emitted");
    let path = format!("{}.rs", evaluator.name);
    let file = files.into_iter().find(|file| file.path == path);
    file.expect("a module of its name").text
}

fn specifications(audit: &mut Audit) -> Vec<Specification> {
    let evaluators = audit.evaluators.clone();
    let specify = |evaluator| {
        Specification::of(evaluator, audit, "0", "sextic generate")
            .unwrap_or_else(|refusal| panic!("{}: {refusal:?}", evaluator.name.ascii))
    };
    evaluators.iter().map(specify).collect()
}

#[test]
fn emitted_rust_computes_what_was_derived() {
    let mut audit = paper();
    let specifications = specifications(&mut audit);
    assert_eq!(specifications.len(), 10);
    for specification in specifications {
        let name = &specification.evaluator.name;
        let reading = read(&text_of(&specification), name).expect("it can be read");
        audit.elaborator.fresh();
        let proof = prove(&reading, &specification, &mut audit.elaborator.ring);
        assert!(proof.is_ok(), "{name}: {proof:?}");
    }
}

#[test]
fn a_text_with_another_operator_is_refused() {
    let mut audit = paper();
    for specification in specifications(&mut audit) {
        let name = specification.evaluator.name.clone();
        if !["closed_form", "no_wind_modes", "hurwitz_determinants"].contains(&name.as_str()) {
            continue;
        }
        let text = text_of(&specification);
        let start = text
            .find(&format!("{name}_body<"))
            .expect("the body begins");
        let end = start + text[start..].find("\n}\n").expect("the body ends");
        let mut count = 0;
        for (place, sign) in text[start..end].char_indices() {
            for other in "+-*/"
                .chars()
                .filter(|other| "+-*/".contains(sign) && *other != sign)
            {
                let mut corrupt = text.clone();
                corrupt.replace_range(start + place..start + place + 1, &other.to_string());
                audit.elaborator.fresh();
                let is_proven = read(&corrupt, &name).is_ok_and(|reading| {
                    prove(&reading, &specification, &mut audit.elaborator.ring).is_ok()
                });
                assert!(!is_proven, "{name}: `{sign}` became `{other}`: {corrupt}");
                count += 1;
            }
        }
        assert!(count > 20, "{name} has {count} operators only");
    }
}

#[test]
fn operation_counts_are_locked() {
    let mut audit = paper();
    let counts = specifications(&mut audit).into_iter().map(|specification| {
        let evaluator = &specification.evaluator;
        format!("{}: {}", evaluator.name, evaluator.cost())
    });
    let counts: Vec<String> = counts.collect();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/compile"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("operation-counts", counts.join("\n")));
}
