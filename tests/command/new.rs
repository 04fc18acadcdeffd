//! `sextic new` as a user runs it: what it writes runs, and nothing is overwritten.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use super::warnings;

/// A folder of this test's own, which is empty.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("new")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn sextic(folder: &PathBuf, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(arguments.split(' '))
        .current_dir(folder)
        .output()
        .expect("the command runs")
}

fn runs(folder: &PathBuf, arguments: &str) -> String {
    let output = sextic(folder, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {errors}");
    assert_eq!(warnings(&errors), "", "{arguments}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Runs the commands that an answer recommends.
#[cfg(feature = "stability")]
fn follow(folder: &PathBuf, answer: &str) {
    let lines = answer.lines();
    let commands: Vec<&str> = lines
        .filter_map(|line| line.strip_prefix("  sextic "))
        .collect();
    assert!(!commands.is_empty(), "{answer}");
    for command in commands {
        runs(folder, command);
    }
}

#[test]
fn a_new_document_runs() {
    let folder = folder("document");
    let answer = runs(&folder, "new document bridge");
    assert!(answer.starts_with("bridge.md\n"), "{answer}");
    let audit = runs(&folder, "audit bridge.md");
    assert!(
        audit.contains("verdicts are as the document expects"),
        "{audit}"
    );
    #[cfg(feature = "stability")]
    follow(&folder, &answer);
}

#[cfg(feature = "stability")]
#[test]
fn a_new_case_runs() {
    let folder = folder("case");
    let answer = runs(&folder, "new case cable");
    assert!(answer.starts_with("cable.toml\ncable.csv\n"), "{answer}");
    follow(&folder, &answer);
    let text = runs(&folder, "stability cable.toml");
    assert!(!text.contains("coarse"), "{text}");
    // A table that is there is read, and stays as it is.
    fs::write(
        folder.join("other.csv"),
        "alpha_deg,CL,CD,CM\n0,0,1,0\n90,0,1,0\n180,0,1,0\n",
    )
    .expect("a table");
    let answer = runs(&folder, "new case other");
    assert!(answer.contains("`other.csv` is there already"), "{answer}");
    let table = fs::read_to_string(folder.join("other.csv")).expect("a table");
    assert_eq!(table.lines().count(), 4);
}

#[test]
fn nothing_is_overwritten() {
    let folder = folder("twice");
    for (kind, file) in [
        ("document", "document.md"),
        ("case", "case.toml"),
        ("table", "table.csv"),
    ] {
        fs::write(folder.join(file), "mine").expect("a file");
        let output = sextic(&folder, &format!("new {kind}"));
        assert_eq!(output.status.code(), Some(2));
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(
            errors.contains("is there already, and is not overwritten"),
            "{errors}"
        );
        let kept = fs::read_to_string(folder.join(file)).expect("the file");
        assert_eq!(kept, "mine", "{file}");
    }
    let output = sextic(&folder, "new document nowhere/mine");
    assert_eq!(output.status.code(), Some(2));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        errors.contains("there is no such file or folder"),
        "{errors}"
    );
}
