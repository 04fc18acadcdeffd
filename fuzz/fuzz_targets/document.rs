//! Any text as a document: it is refused or judged within its budget, and what it has compiled is proven.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sextic::compile::generation::{Failure, Order, generate};
use sextic::verdict::audit::audit;
use sextic::language::diagnostic::SourceFile;
use sextic::documents::ShippedLibrary;
use sextic_codegen::language::Language;

fuzz_target!(|text: &str| {
    // Without a fence there is nothing to read but prose: the text is a block then.
    let text = match text.contains("```") {
        true => text.to_owned(),
        false => format!("# A document\n\n```sextic\n{text}\n```\n"),
    };
    let source = SourceFile::new("document.md", text);
    let Ok(audit) = audit(&source, &ShippedLibrary) else {
        return;
    };
    let audits = [audit];
    for language in Language::ALL {
        let order = Order {
            points: 0,
            ..Order::of_all(language)
        };
        match generate(&audits, &order, &mut |_| {}) {
            Err(Failure::Doubted(evaluator, doubt)) => panic!("{language}, {evaluator}: {doubt}"),
            Ok(_) | Err(_) => {}
        }
    }
});
