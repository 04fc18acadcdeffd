//! The adversary in Python, which shares no code with the engine: its oracle must tell known
//! verdicts apart, and find no wrong one among random claims. The long run is one command; see
//! `CONTRIBUTING.md`.

use std::path::PathBuf;
use std::process::{Command, Output};

/// A script of this folder, or nothing where there is no Python with mpmath.
fn python(script: &str, arguments: &[&str]) -> Option<Output> {
    let probe = Command::new("python3")
        .args(["-c", "import mpmath, resource"])
        .output();
    if !probe.is_ok_and(|output| output.status.success()) {
        eprintln!("skipped: there is no python3 with mpmath");
        return None;
    }
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/adversary");
    let output = Command::new("python3")
        .arg("-B")
        .arg(folder.join(script))
        .args(arguments)
        .output();
    Some(output.expect("Python runs"))
}

fn assert_success(output: &Output) {
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{out}\n{err}");
}

#[test]
fn the_oracle_tells_known_verdicts_apart() {
    if let Some(output) = python("known.py", &[]) {
        assert_success(&output);
    }
}

/// Conditions, witnesses and orders of the documents that come with the project.
#[test]
fn the_oracle_agrees_with_the_verdicts_of_the_examples() {
    let derivations = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let path = derivations.join("README.md");
    let path = path.to_str().expect("a path");
    let arguments = ["--command", env!("CARGO_BIN_EXE_sextic"), path];
    if let Some(output) = python("check.py", &arguments) {
        assert_success(&output);
    }
}

#[test]
fn no_wrong_verdict_is_found_in_random_documents() {
    let command = env!("CARGO_BIN_EXE_sextic");
    let arguments = ["--seed", "14", "--count", "240", "--command", command];
    if let Some(output) = python("adversary.py", &arguments) {
        assert_success(&output);
    }
}
