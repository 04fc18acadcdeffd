//! Evaluators of documents: translated, emitted, read back and proven.

mod corruption;
mod edits;
mod proof;
mod translation;

use sextic::compile::specification::Specification;
use sextic::derivation::audit::{Audit, audit};
use sextic::documents::{ShippedLibrary, shipped};
use sextic_codegen::language::{File, Language, emit};

fn paper() -> Audit {
    let paper = shipped()
        .find(|document| document.path.ends_with("he-macdonald-2017.md"))
        .expect("the paper's document is shipped");
    audit(&paper, &ShippedLibrary).unwrap_or_else(|error| panic!("{:?}", error.diagnostics))
}

/// The emitted files of an evaluator, without those that all evaluators share.
fn files_of(specification: &Specification, language: Language) -> Vec<File> {
    let evaluator = &specification.evaluator;
    let files = emit(std::slice::from_ref(evaluator), language).expect("it can be emitted");
    let is_own = |file: &File| file.path.starts_with(&evaluator.name);
    files.into_iter().filter(is_own).collect()
}

fn specifications(audit: &mut Audit) -> Vec<Specification> {
    let evaluators = audit.evaluators.clone();
    let specify = |evaluator| {
        Specification::of(evaluator, audit, "0", "sextic generate")
            .unwrap_or_else(|refusal| panic!("{}: {refusal:?}", evaluator.name.ascii))
    };
    evaluators.iter().map(specify).collect()
}

fn assert_locked(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/compile"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

#[test]
fn operation_counts_are_locked() {
    let mut audit = paper();
    let counts = specifications(&mut audit).into_iter().map(|specification| {
        let evaluator = &specification.evaluator;
        format!("{}: {}", evaluator.name, evaluator.cost())
    });
    let counts: Vec<String> = counts.collect();
    assert_locked("operation-counts", &counts.join("\n"));
}
