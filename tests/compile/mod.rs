//! Evaluators of documents: translated, emitted, read back and proven.

mod arithmetics;
mod corruption;
mod edits;
mod fixing;
mod freshness;
mod octave;
mod proof;
mod translation;

use sextic::compile::specification::Specification;
use sextic::documents::{ShippedLibrary, shipped};
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::{Audit, audit};
use sextic_codegen::language::{File, Language, emit};

/// The documents that come with the command.
fn audits() -> Vec<Audit> {
    let read = shipped().map(|source| audit(&source, &ShippedLibrary));
    read.map(|audit| audit.unwrap_or_else(|error| panic!("{:?}", error.diagnostics)))
        .collect()
}

fn paper() -> Audit {
    let found = audits()
        .into_iter()
        .find(|audit| audit.path.ends_with("he-macdonald-2017.md"));
    found.expect("the paper's document is shipped")
}

/// The emitted files of an evaluator, without those that all evaluators share.
fn files_of(specification: &Specification, language: Language) -> Vec<File> {
    let evaluator = &specification.evaluator;
    let files = emit(std::slice::from_ref(evaluator), language).expect("it can be emitted");
    let is_own = |file: &File| file.path.starts_with(&evaluator.name);
    files.into_iter().filter(is_own).collect()
}

fn specifications(audit: &Audit) -> Vec<Specification> {
    let specify = |evaluator| {
        Specification::of(evaluator, audit, &[])
            .unwrap_or_else(|refusal| panic!("{}: {refusal:?}", evaluator.name.ascii))
    };
    audit.evaluators.iter().map(specify).collect()
}

fn assert_locked(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/compile"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

#[test]
fn inputs_say_which_angles_they_are_made_of() {
    let text = "# Angles\n\n```sextic\nangle α \"angle of the rod\"\nangle β, γ\n\
        function C at γ : 1 \"lift\"\n\
        evaluator [f] f: a = cos(2*α - β), b = sin(γ - α), c = C + C'\n```\n";
    let source = SourceFile::new("angles.md", text);
    let audit = audit(&source, &ShippedLibrary).unwrap_or_else(|e| panic!("{:?}", e.diagnostics));
    let evaluator = &specifications(&audit)[0].evaluator;
    let inputs = evaluator.inputs.iter();
    let inputs: Vec<String> = inputs
        .map(|input| {
            let what = &input.quantity;
            let mut line = format!("{} {} {}", what.name, what.symbol, what.description);
            for (count, angle) in input.circular().iter().flat_map(|sum| &sum.angle) {
                line.push_str(&format!("{count} {angle}, "));
            }
            line
        })
        .collect();
    let expected = [
        "cos_2_alpha_minus_beta cos(2·α − β) 2 alpha, -1 beta, ",
        // sin(γ − α) is its negative.
        "sin_alpha_minus_gamma sin(α − γ) 1 alpha, -1 gamma, ",
        "C C lift",
        "dC C′ derivative of C by its angle in radians; lift",
    ];
    assert_eq!(inputs, expected);
    let angles = evaluator.angles.iter();
    let angles: Vec<String> = angles
        .map(|angle| {
            format!(
                "{} {} {}",
                angle.quantity.name, angle.quantity.symbol, angle.quantity.unit
            )
        })
        .collect();
    assert_eq!(angles, ["alpha α rad", "beta β rad", "gamma γ rad"]);
    assert_eq!(evaluator.angles[0].quantity.description, "angle of the rod");
}

#[test]
fn operation_counts_are_locked() {
    let audits = audits();
    let all = audits.iter().flat_map(specifications);
    let counts = all.map(|specification| {
        let evaluator = &specification.evaluator;
        format!("{}: {}", evaluator.name, evaluator.cost())
    });
    let counts: Vec<String> = counts.collect();
    assert_locked("operation-counts", &counts.join("\n"));
}
