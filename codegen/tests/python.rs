//! The emitted Python, run with NumPy.

use std::path::Path;
use std::process::Command;

use sextic_codegen::language::Language;

use crate::consumer;

#[test]
fn scalars_and_arrays_give_the_same_bits() {
    if !consumer::present("python3", &["-c", "import numpy"]) {
        return;
    }
    let folder = consumer::folder("python");
    consumer::write(&folder.join("evaluators"), Language::Python);
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/consumer.py");
    let answer = |questions: &str| {
        let mut python = Command::new("python3");
        python
            .args(["-B", "-W", "error"])
            .arg(&program)
            .env("PYTHONPATH", &folder);
        consumer::run(&mut python, questions)
    };
    consumer::check(&answer(&consumer::questions()), false);
    consumer::check_angles(&answer(&consumer::questions_of_angles()));
}
