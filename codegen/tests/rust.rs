//! The emitted Rust, compiled and run as a crate of its own.

use std::fs;
use std::path::Path;
use std::process::Command;

use sextic_codegen::language::Language;

use crate::consumer;

fn data(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(folder.join(name)).unwrap()
}

/// The crate as it would be checked in, with a program that uses it.
fn build(name: &str) -> Command {
    let folder = consumer::folder(name);
    consumer::write(&folder.join("src"), Language::Rust);
    fs::write(folder.join("src/main.rs"), data("tests/data/consumer.rs")).unwrap();
    let manifest = data("evaluators/Cargo.toml") + "\n[workspace]\n";
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["run", "--quiet", "--release", "--offline"])
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env("RUSTFLAGS", "-D warnings")
        .current_dir(&folder);
    cargo
}

#[test]
fn scalars_bounds_and_batches_agree_at_every_level() {
    let answers = consumer::run(&mut build("rust-std"), &consumer::questions());
    consumer::check(&answers, true);
    let mut cargo = Command::new(
        Path::new(env!("CARGO_TARGET_TMPDIR")).join("rust-std/target/release/sextic-evaluators"),
    );
    consumer::check_angles(&consumer::run(&mut cargo, &consumer::questions_of_angles()));
}

#[test]
fn without_the_standard_library_the_bits_are_the_same() {
    let mut cargo = build("rust-core");
    cargo.arg("--no-default-features");
    let mut questions = consumer::questions();
    let roots = [
        0.0,
        -0.0,
        1.0,
        2.0,
        3.0,
        0.1,
        1e-300,
        5e-324,
        2.2e-308,
        f64::MAX,
        f64::INFINITY,
        -1.0,
    ];
    let more = (1..2000_u64).map(|n| f64::from_bits(n.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 1));
    let roots: Vec<f64> = roots
        .into_iter()
        .chain(more.filter(|root| root.is_finite()))
        .collect();
    for root in &roots {
        questions.push_str(&format!("root {:x}\n", root.to_bits()));
    }
    let answers = consumer::run(&mut cargo, &questions);
    let lines: Vec<&str> = answers.lines().collect();
    let (plain, rooted) = lines.split_at(lines.len() - roots.len());
    consumer::check(&plain.join("\n"), true);
    for (line, root) in rooted.iter().zip(&roots) {
        let (own, standard) = line.split_once(' ').unwrap();
        assert!(
            own == standard || root.is_sign_negative(),
            "√{root:e}: {line}"
        );
    }
}
