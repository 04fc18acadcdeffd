use sextic::compile::translation::translate;
use sextic::derivation::audit::audit;
use sextic::documents::{ShippedLibrary, shipped};
#[test]
fn show() {
    let paper = shipped()
        .find(|d| d.path.ends_with("he-macdonald-2017.md"))
        .unwrap();
    let mut audit = match audit(&paper, &ShippedLibrary) {
        Ok(a) => a,
        Err(e) => panic!("{:?}", e.diagnostics),
    };
    for c in audit.claims.iter().filter(|c| !c.as_expected()) {
        println!("BAD {:?}", c.label.text);
    }
    for evaluator in audit.evaluators.clone() {
        let t0 = std::time::Instant::now();
        match translate(&evaluator, &mut audit.elaborator) {
            Ok(t) => println!(
                "{}: {} inputs, {} ({:?})",
                evaluator.name.ascii,
                t.inputs.len(),
                sextic_codegen::cost::Cost::of(&t.program),
                t0.elapsed()
            ),
            Err(e) => println!("{}: {e}", evaluator.name.ascii),
        }
    }
}
