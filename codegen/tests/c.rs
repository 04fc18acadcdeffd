//! The emitted C, compiled without a warning and run.

use std::path::Path;
use std::process::Command;

use sextic_codegen::language::Language;

use crate::consumer;

#[test]
fn compiles_without_a_warning_and_gives_the_same_bits() {
    if !consumer::present("gcc", &["--version"]) {
        return;
    }
    for level in ["-O0", "-O3"] {
        let folder = consumer::folder(&format!("c{level}"));
        consumer::write(&folder, Language::C);
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        let program = folder.join("consumer");
        let mut gcc = Command::new("gcc");
        gcc.args([
            "-Wall",
            "-Wextra",
            "-Werror",
            "-std=c99",
            "-pedantic",
            level,
        ])
        .arg("-I")
        .arg(&folder)
        .arg(data.join("consumer.c"));
        for name in ["determinant", "match", "quadratic_form", "rod"] {
            gcc.arg(folder.join(format!("{name}.c")));
        }
        consumer::run(gcc.arg("-o").arg(&program).arg("-lm"), "");
        let answers = consumer::run(&mut Command::new(&program), &consumer::questions());
        consumer::check(&answers, true);
        let angles = consumer::questions_of_angles();
        consumer::check_angles(&consumer::run(&mut Command::new(&program), &angles));
    }
}

#[test]
fn the_headers_are_also_cpp() {
    if !consumer::present("g++", &["--version"]) {
        return;
    }
    let folder = consumer::folder("cpp");
    consumer::write(&folder, Language::C);
    for name in ["determinant", "match", "quadratic_form", "rod"] {
        let mut command = Command::new("g++");
        command.args(["-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++"]);
        consumer::run(command.arg(folder.join(format!("{name}.h"))), "");
    }
}
