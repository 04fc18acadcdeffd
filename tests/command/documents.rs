//! Documents as a user names them: what is read, and what every report says at its head.

#[cfg(unix)]
use std::io::BufRead;
use std::path::PathBuf;
#[cfg(unix)]
use std::process::{Child, Command, Stdio};
#[cfg(unix)]
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::sextic;

const ASSUMPTIONS: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/data/recovery/assumptions.md"
);

/// What the command prints on the document of which assumptions are refused.
fn printed(format: &str) -> String {
    let output = sextic(&["audit", "--format", format, "--width", "4000", ASSUMPTIONS]);
    assert_eq!(output.status.code(), Some(2), "{format}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn every_report_tells_at_its_head_which_assumptions_are_refused() {
    let views = ["text", "markdown", "latex"].map(printed);
    #[cfg(feature = "stability")]
    let views = views.into_iter().chain([report()]);
    for view in views {
        // One view breaks its lines elsewhere, and another one escapes.
        let words: Vec<&str> = view.split_whitespace().collect();
        let view = words.join(" ");
        for said in [
            "refused what lines 7 and 8 would assume",
            "what line 6 would assume is refused",
        ] {
            assert!(view.contains(said), "{said}: {view}");
        }
        assert!(!view.contains("beside the signs"), "{view}");
    }
    let view: Value = serde_json::from_str(&printed("json")).expect("JSON");
    let document = &view["documents"][0];
    assert_eq!(document["refused_assumptions"], json!([7, 8]));
    assert_eq!(document["imports"][0]["refused_assumptions"], json!([6]));
}

/// The page on the same document.
#[cfg(feature = "stability")]
fn report() -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("assumptions.html");
    let out = path.to_str().expect("a path");
    assert_eq!(
        sextic(&["report", ASSUMPTIONS, "--out", out]).status.code(),
        Some(2)
    );
    std::fs::read_to_string(path).expect("a page")
}

/// Waits for a command, which must not wait for others.
#[cfg(unix)]
fn soon(mut command: Child) {
    let started = Instant::now();
    while command.try_wait().expect("a status").is_none() {
        if started.elapsed() > Duration::from_secs(60) {
            command.kill().expect("it is stopped");
            panic!("it waits for somebody to write to the pipe");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[cfg(unix)]
#[test]
fn only_regular_files_are_read() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("pipes");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let (pipe, own) = (folder.join("pipe.md"), folder.join("own.md"));
    let made = Command::new("mkfifo").arg(&pipe).status().expect("mkfifo");
    assert!(made.success());
    let text = "```sextic\nimport \"pipe.md\"\nimport \"/dev/zero\"\nclaim (1): 1 == 1\n```\n";
    std::fs::write(&own, text).expect("a document");
    for (path, said) in [
        (&own, ["it is a pipe", "it is a device"]),
        (&pipe, ["it is a pipe, and only regular files are read"; 2]),
    ] {
        let errors = folder.join("errors");
        let command = Command::new(env!("CARGO_BIN_EXE_sextic"))
            .arg("audit")
            .arg(path)
            .stdout(Stdio::null())
            .stderr(std::fs::File::create(&errors).expect("a file"))
            .spawn();
        soon(command.expect("it starts"));
        let errors = std::fs::read_to_string(errors).expect("messages");
        assert!(said.iter().all(|own| errors.contains(own)), "{errors}");
    }
}

/// Standard output of a command up to a line that has these words.
#[cfg(unix)]
fn read_up_to(words: &str, lines: &mut impl Iterator<Item = std::io::Result<String>>) -> String {
    let mut text = String::new();
    for line in lines {
        let line = line.expect("a line");
        text += &line;
        text.push('\n');
        if line.contains(words) {
            return text;
        }
    }
    panic!("{words} does not come: {text}");
}

#[cfg(unix)]
#[test]
fn a_document_that_is_watched_is_judged_whenever_it_is_saved() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("watched");
    std::fs::create_dir_all(&folder).expect("a folder");
    let (base, own) = (folder.join("base.md"), folder.join("own.md"));
    let save = |path: &PathBuf, statements: &str| {
        let text = format!("# A document\n\n```sextic\n{statements}\n```\n");
        std::fs::write(path, text).expect("a file");
    };
    save(&base, "parameter a : 1\nb := 2*a");
    save(&own, "import \"base.md\"\nclaim (1): b == a + a");
    let mut child = Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(["audit", own.to_str().unwrap(), "--watch"])
        .stdout(Stdio::piped())
        .spawn()
        .expect("the command runs");
    let mut lines = std::io::BufReader::new(child.stdout.take().unwrap()).lines();
    let first = read_up_to("The one verdict", &mut lines);
    assert!(first.contains("✓ holds"), "{first}");
    // What it imports is watched, too.
    save(&base, "parameter a : 1\nb := 3*a");
    let second = read_up_to("NOT as the document expects.", &mut lines);
    assert!(second.contains("✗ refuted"), "{second}");
    save(&own, "import \"base.md\"\nclaim (1): b == a + a + a");
    let third = read_up_to("The one verdict", &mut lines);
    assert!(third.contains("✓ holds"), "{third}");
    child.kill().expect("it is stopped");
    let _ = child.wait();
    let output = sextic(&["audit", "--watch"]);
    assert_eq!(output.status.code(), Some(2));
}
