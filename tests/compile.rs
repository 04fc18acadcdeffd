use sextic::compile::proof::prove;
use sextic::compile::reading::rust::read;
use sextic::compile::specification::Specification;
use sextic::derivation::audit::audit;
use sextic::documents::{ShippedLibrary, shipped};
use sextic_codegen::language::{Language, emit};
#[test]
fn show() {
    let paper = shipped().find(|d| d.path.ends_with("he-macdonald-2017.md")).unwrap();
    let mut audit = audit(&paper, &ShippedLibrary).unwrap_or_else(|e| panic!("{:?}", e.diagnostics));
    for evaluator in audit.evaluators.clone() {
        let t = Specification::of(&evaluator, &mut audit, "00", "sextic generate").unwrap();
        let files = emit(std::slice::from_ref(&t.evaluator), Language::Rust).unwrap();
        let file = files.into_iter().find(|f| f.path.ends_with(&format!("{}.rs", t.evaluator.name))).unwrap();
        let t1 = std::time::Instant::now();
        let reading = read(&file.text, &t.evaluator.name).unwrap();
        audit.elaborator.fresh();
        println!("{} {:?} {:?}", t.evaluator.name, prove(&reading, &t, &mut audit.elaborator.ring), t1.elapsed());
        if t.evaluator.name == "closed_form" {
            let (mut caught, mut all) = (0, 0);
            let start = file.text.find("closed_form_body<").unwrap();
            let end = start + file.text[start..].find("\n}\n").unwrap();
            for (at, c) in file.text[start..end].char_indices().filter(|(_, c)| "+-*/".contains(*c)) {
                for other in ["+", "-", "*", "/"].iter().filter(|o| !o.starts_with(c)) {
                    let mut text = file.text.clone();
                    text.replace_range(start + at..start + at + 1, other);
                    all += 1;
                    audit.elaborator.fresh();
                    if read(&text, "closed_form").map(|r| prove(&r, &t, &mut audit.elaborator.ring).is_err()).unwrap_or(true) { caught += 1; } else { println!("SURVIVED at {}", &file.text[start+at-20..start+at+20]); }
                }
            }
            println!("caught {caught} of {all}");
        }
    }
}
