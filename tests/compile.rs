use sextic::compile::specification::Specification;
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
    let mut all = Vec::new();
    for evaluator in audit.evaluators.clone() {
        let t0 = std::time::Instant::now();
        match Specification::of(&evaluator, &mut audit, "00", "sextic generate") {
            Ok(t) => {
                println!(
                    "{}: {} inputs, {} ({:?})",
                    evaluator.name.ascii,
                    t.inputs.len(),
                    t.evaluator.cost(),
                    t0.elapsed()
                );
                all.push(t.evaluator);
            }
            Err(e) => println!("{}: {e:?}", evaluator.name.ascii),
        }
    }
    for language in sextic_codegen::language::Language::ALL {
        for file in sextic_codegen::language::emit(&all, language).unwrap() {
            let path = std::path::Path::new("/tmp/emitted")
                .join(language.name())
                .join(&file.path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, file.text).unwrap();
        }
    }
}
