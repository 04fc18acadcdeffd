//! The command as a user runs it: what it prints where, and its exit status.

mod documents;
#[cfg(feature = "stability")]
mod figures;
#[cfg(feature = "stability")]
mod files;
mod generation;
#[cfg(feature = "stability")]
mod held;
mod input;
#[cfg(feature = "stability")]
mod mean_twist;
#[cfg(feature = "stability")]
mod modes;
mod mutate;
mod new;
#[cfg(feature = "stability")]
mod report;
#[cfg(feature = "stability")]
mod set;
mod show;
#[cfg(feature = "stability")]
mod speeds;
#[cfg(feature = "stability")]
mod stability;
#[cfg(feature = "stability")]
mod sweep;
#[cfg(feature = "stability")]
mod systems;
#[cfg(feature = "stability")]
mod validity;

use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::Value;

fn sextic(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(arguments)
        .env_remove("NO_COLOR")
        .output()
        .expect("the command runs")
}

/// A folder of this test's own with the cases that come with the project.
#[cfg(feature = "stability")]
fn folder(name: &str) -> PathBuf {
    let from = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("derivations/cases");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    for file in ["tuned.toml", "detuned.toml", "light.toml", "formulas.csv"] {
        std::fs::copy(from.join(file), folder.join(file)).expect("a copy");
    }
    folder
}

#[cfg(feature = "stability")]
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = sextic(arguments);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

/// What is said on standard error beside what is read of a table.
fn warnings(err: &str) -> String {
    let is_echo = |line: &&str| line.starts_with("Table ") || line.starts_with("Columns ");
    let others = err.lines().filter(|line| !is_echo(line));
    others.map(|line| format!("{line}\n")).collect()
}

/// What a figure says; it is well formed and has more than axes.
#[cfg(feature = "stability")]
fn texts(path: &str) -> Vec<String> {
    let svg = std::fs::read_to_string(path).expect("a figure");
    let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
    let elements = || drawing.descendants().filter(|node| node.is_element());
    let lines = elements().filter(|node| node.has_tag_name("polyline"));
    assert!(lines.count() > 20, "{path}");
    let own = elements().filter_map(|node| node.text());
    own.map(|text| text.trim().to_owned()).collect()
}

/// A document of a test's own, in a folder of its own.
fn document(name: &str, text: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("documents");
    std::fs::create_dir_all(&folder).expect("a folder for documents");
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a document");
    path
}

fn block(statements: &str) -> String {
    format!("# A document\n\n```sextic\nparameter a, b : m\n{statements}\n```\n")
}

fn status_of(name: &str, statements: &str) -> (Option<i32>, String, String) {
    let path = document(name, &block(statements));
    let output = sextic(&["audit", path.to_str().expect("a path")]);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

#[test]
fn status_is_0_where_all_is_as_expected() {
    let (status, out, err) = status_of("expected.md", "claim [one]: a + b == b + a");
    assert_eq!(status, Some(0));
    assert!(
        out.ends_with("The one verdict is as the document expects.\n"),
        "{out}"
    );
    assert_eq!(err, "");
}

#[test]
fn status_is_1_where_a_verdict_differs() {
    for (name, statement) in [
        ("false.md", "claim [one]: a == b"),
        ("true.md", "refute [one]: a == a"),
        ("units.md", "claim [one]: a == a^2"),
        ("exact.md", "approximate [one]: a == a to order 1 in a"),
        ("undecided.md", "claim [one]: a^4 - 2*a*b^3 + 3*b^4 >= 0"),
    ] {
        assert_eq!(status_of(name, statement).0, Some(1), "{statement}");
    }
}

#[test]
fn status_is_2_where_the_input_is_wrong() {
    let (status, out, err) = status_of("unknown.md", "claim [one]: a == c");
    assert_eq!(status, Some(2));
    assert!(
        out.ends_with("There is 1 mistake. No assertion was judged.\n"),
        "{out}"
    );
    assert!(err.contains("unknown.md:5:"), "{err}");
    assert_eq!(
        sextic(&["audit", "no-such-document.md"]).status.code(),
        Some(2)
    );
    assert_eq!(
        sextic(&["audit", env!("CARGO_MANIFEST_DIR")]).status.code(),
        Some(2)
    );
    assert_eq!(
        sextic(&["audit", "--explain", "no-such-claim"])
            .status
            .code(),
        Some(2)
    );
    assert_eq!(sextic(&["no-such-command"]).status.code(), Some(2));
}

/// A mistake in the middle, and what it costs.
const MISTAKE: &str = "assume a < 2*b \"not too long\"\nclaim [before]: a + b == b + a\n\
    q := a + a^2\nr := 2*q\nclaim [on r]: r == 2*q\nclaim [after]: 2*a == a + a";

#[test]
fn a_mistake_costs_what_builds_on_it() {
    let (status, out, err) = status_of("mistake.md", MISTAKE);
    assert_eq!(status, Some(2));
    assert_eq!(out.matches("✓ holds  ").count(), 2, "{out}");
    for part in [
        "  assumes   a < 2·b: not too long",
        "– skipped      [on r]",
        "because it builds on `r`, and so on `q`, which line 7 would declare",
        "line 8: the definition of `r` builds on `q`",
    ] {
        assert!(out.contains(part), "{part}: {out}");
    }
    assert!(out.contains("1 mistake; 2 statements are skipped"), "{out}");
    assert_eq!(err.matches("Error").count(), 1, "{err}");
    let path = document("mistake.md", &block(MISTAKE));
    let path = path.to_str().expect("a path");
    for (format, skipped) in [("markdown", "| – skipped |"), ("latex", "{-- skipped}")] {
        let output = sextic(&["audit", path, "--format", format]);
        let page = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(output.status.code(), Some(2), "{format}");
        assert!(page.contains(skipped), "{page}");
        assert!(page.contains("not too long"), "{page}");
    }
}

#[test]
fn mistakes_are_json_too() {
    let path = document("mistake-json.md", &block(MISTAKE));
    let path = path.to_str().expect("a path");
    let output = sextic(&["audit", path, "no-such.md", "--format", "json"]);
    assert_eq!(output.status.code(), Some(2));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let [first, second] = [0, 1].map(|place| &json["diagnostics"][place]);
    assert_eq!((&first["line"], &first["column"]), (&7.into(), &6.into()));
    assert_eq!(first["kind"], "unit");
    assert!(
        first["path"]
            .as_str()
            .is_some_and(|own| own.ends_with("mistake-json.md"))
    );
    assert!(first["message"].is_string() && first["help"].is_string());
    assert_eq!(second["kind"], "missing-file");
    let document = &json["documents"][0];
    assert_eq!(document["as_expected"], false);
    assert_eq!(document["assumptions"][0]["statement"], "a < 2*b");
    let claim = &document["claims"][1];
    assert_eq!(claim["verdict"], "skipped");
    assert!(
        claim["reason"]
            .as_str()
            .is_some_and(|own| own.contains("`q`"))
    );
    assert_eq!(document["skipped"][0]["rests_on"]["name"], "q");
    assert_eq!(document["skipped"][0]["rests_on"]["line"], 7);
}

#[test]
fn of_many_mistakes_the_first_are_told() {
    let lines: Vec<String> = (0..10_000)
        .map(|number| format!("q{number} := x{number}"))
        .collect();
    let path = document("many.md", &block(&lines.join("\n")));
    let output = sextic(&["audit", path.to_str().expect("a path"), "--format", "json"]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(told.matches("Error").count(), 50);
    assert!(told.ends_with("… and 9950 more mistakes\n"));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["diagnostics"].as_array().map(Vec::len), Some(50));
    assert_eq!(json["diagnostics_left_out"], 9950);
}

#[test]
fn nothing_is_compiled_from_a_document_with_a_mistake() {
    let path = document(
        "compiled.md",
        &block("evaluator (1) sum: s = a + b\nq := a + a^2"),
    );
    let path = path.to_str().expect("a path");
    for arguments in [
        [
            "evaluate",
            "sum",
            "--document",
            path,
            "--set",
            "a=1",
            "--set",
            "b=2",
        ]
        .as_slice(),
        &["generate", path, "--out", "nowhere", "--language", "c"],
    ] {
        let output = sextic(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty());
        assert!(String::from_utf8_lossy(&output.stderr).contains("Nothing is compiled"));
    }
}

#[test]
fn a_document_without_a_block_is_wrong_input() {
    for (name, text) in [
        ("prose.md", "# Prose\n"),
        ("nothing.md", ""),
        ("plain.md", "```\nparameter a : m\n```\n"),
        ("misspelt.md", "```sextix\nparameter a : m\n```\n"),
    ] {
        let path = document(name, text);
        let output = sextic(&["audit", path.to_str().expect("a path")]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(String::from_utf8_lossy(&output.stderr).contains(name));
    }
    let (status, out, _) = status_of("declares.md", "area := a*b");
    assert_eq!(status, Some(0));
    assert!(out.contains("Nothing was checked"), "{out}");
}

/// A matching whose residual is no small quantity.
const OFF: &str = "parameter s, t : 1\n\
    match (1) same: s^2 + t*s + 1 with s^2 + c*s + 2 in s unknown c at s";

#[test]
fn matchings_are_part_of_the_audit() {
    let statements = format!("parameter c : 1\n{OFF}\nclaim [one]: a + b == b + a");
    let (status, out, _) = status_of("off.md", &statements);
    assert_eq!(status, Some(0));
    assert!(
        out.contains("(1) same: 2 of 3 powers matched exactly; WARNING"),
        "{out}"
    );
    let path = document("off.md", &block(&statements));
    let path = path.to_str().expect("a path");
    let output = sextic(&["audit", path, "--format", "json"]);
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["documents"][0]["matchings"][0], "1");
    let output = sextic(&["audit", path, "--explain", "1"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("(1) is a matching") && message.contains("sextic match"));
}

#[test]
fn an_explanation_shows_definitions_both_sides_and_their_unit() {
    let statements = "f := a + b\nclaim [square]: f^2 == a*a + 2*a*b + b*b";
    let path = document("explained.md", &block(statements));
    let path = path.to_str().expect("a path");
    let output = sextic(&["audit", path, "--explain", "square"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for part in [
        "Rests on\n  f := a + b\n",
        "Both sides in normal form\n  (a + b)²\n",
        "Unit\n  m²\n",
    ] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn a_verdict_that_differs_names_its_place() {
    let (_, out, _) = status_of("place.md", "claim [one]: a == b");
    assert_eq!(out.matches("place.md:5").count(), 2, "{out}");
}

#[test]
fn json_is_that_of_the_design() {
    let output = sextic(&["audit", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let document = &json["documents"][0];
    assert_eq!(document["as_expected"], Value::Bool(true));
    for claim in document["claims"].as_array().expect("claims") {
        for key in ["id", "statement", "expected", "verdict"] {
            assert!(claim[key].is_string(), "{key} of {claim}");
        }
        assert!(claim["line"].is_u64());
        assert!(claim["conditions"].is_array() && claim["neglected"].is_array());
        let refuted = claim["verdict"] == "refuted";
        assert_eq!(claim["witness"].is_object(), refuted, "{claim}");
        assert!(!refuted || claim["witness"]["left"].is_string());
    }
    let output = sextic(&["match", "--format", "json"]);
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let matching = &json["matchings"][0];
    assert!(matching["solution"]["b_1"].is_string());
    assert_eq!(matching["singular_where"][0], "L_g == 0");
    assert_eq!(matching["table"].as_array().map(Vec::len), Some(7));
    for row in matching["table"].as_array().expect("rows") {
        assert!(row["power"].is_u64() && row["used"].is_boolean());
        assert!(
            row["exact"].is_string() && row["assumed"].is_string() && row["residual"].is_string()
        );
    }
}

#[test]
fn every_format_is_written_twice_the_same() {
    for format in ["text", "json", "markdown", "latex"] {
        for command in ["audit", "match"] {
            let (first, second) = (
                sextic(&[command, "--format", format]),
                sextic(&[command, "--format", format]),
            );
            assert_eq!(first.status.code(), Some(0), "{command} {format}");
            assert!(!first.stdout.is_empty());
            assert_eq!(first.stdout, second.stdout, "{command} {format}");
        }
    }
}

#[test]
fn a_pipe_gets_no_colours() {
    assert!(!sextic(&["audit"]).stdout.contains(&0x1b));
}
