//! Any text in the place of an emitted file: it is refused, or is what was derived.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sextic::compile::reading::read;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{File, Language, emit};
use sextic_codegen::program::{Operation, Program};

/// b = a + √(2·a)
fn sample() -> Evaluator {
    let mut program = Program::new(["a".to_owned()]);
    let two = program.constant(2.into());
    if let Some(a) = program.input("a") {
        let twice = program.push(Operation::Multiply(two, a));
        let root = program.push(Operation::SquareRoot(twice));
        let sum = program.push(Operation::Add(a, root));
        program.output("b", sum);
    }
    Evaluator::plain("sample", program)
}

/// The first byte chooses the language, and whether the rest is a file or stands in the middle of one.
fn files(data: &[u8]) -> Option<(Language, Vec<File>)> {
    let (choice, text) = data.split_first()?;
    let text = std::str::from_utf8(text).ok()?;
    let language = Language::ALL[usize::from(choice % 3)];
    let mut files = emit(&[sample()], language).ok()?;
    for file in &mut files {
        if !file.path.starts_with("sample.") {
            continue;
        }
        match choice / 3 % 4 {
            0 => file.text = text.to_owned(),
            place => {
                let lines: Vec<&str> = file.text.lines().collect();
                let at = lines.len() * usize::from(place) / 4;
                file.text = [&lines[..at].join("\n"), text, &lines[at..].join("\n")].join("\n");
            }
        }
    }
    Some((language, files))
}

fuzz_target!(|data: &[u8]| {
    if let Some((language, files)) = files(data) {
        // Whether it is refused is no matter: that it ends is.
        let _ = read(&files, &sample(), language);
    }
});
