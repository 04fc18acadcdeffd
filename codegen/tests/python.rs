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
    let mut python = Command::new("python3");
    python
        .args(["-B", "-W", "error"])
        .arg(program)
        .env("PYTHONPATH", &folder);
    let answers = consumer::run(&mut python, &consumer::questions());
    consumer::check(&answers, false);
}
