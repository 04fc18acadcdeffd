//! Standard input, colours, and what a shell is given.

use std::io::Write;
use std::process::{Command, Stdio};

use super::{block, sextic};

/// What the command prints on a document in its standard input.
fn audited(text: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(arguments)
        .env_remove("NO_COLOR")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut input = command.stdin.take().expect("standard input");
    input.write_all(text.as_bytes()).expect("it is read");
    drop(input);
    let output = command.wait_with_output().expect("it ends");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

#[test]
fn a_document_is_read_from_standard_input() {
    let text = block("claim [one]: a + b == b + a");
    let (status, out, errors) = audited(&text, &["audit", "-"]);
    assert_eq!((status, errors.as_str()), (Some(0), ""));
    assert!(out.contains("standard input"), "{out}");
    let (status, out, _) = audited(&text, &["show", "a + b", "--document", "-"]);
    assert_eq!(status, Some(0));
    assert!(out.contains("standard input"), "{out}");
    let (status, _, errors) = audited(&block("claim [one]: a == c"), &["audit", "-"]);
    assert_eq!(status, Some(2));
    assert!(errors.contains("standard input:5:19"), "{errors}");
    assert_eq!(audited("", &["audit", "-"]).0, Some(2));
}

#[test]
fn colours_are_where_they_are_asked_for() {
    let text = block("claim [one]: a == a");
    for (when, are_there) in [("auto", false), ("always", true), ("never", false)] {
        for arguments in [
            ["audit", "-", "--color", when],
            ["--color", when, "audit", "-"],
        ] {
            let (_, out, _) = audited(&text, &arguments);
            assert_eq!(out.contains('\u{1b}'), are_there, "{when}");
        }
    }
}

#[test]
fn a_shell_is_told_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = sextic(&["completions", shell]);
        assert_eq!(output.status.code(), Some(0));
        let script = String::from_utf8(output.stdout).expect("UTF-8");
        for command in ["audit", "show", "new", "evaluate"] {
            assert!(script.contains(command), "{shell}: {command}");
        }
    }
    let manual = sextic(&["man"]);
    let manual = String::from_utf8(manual.stdout).expect("UTF-8");
    assert!(manual.contains(".TH sextic 1"), "{manual}");
}
