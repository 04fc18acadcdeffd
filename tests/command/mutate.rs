//! `sextic mutate` as a user sees it.

use std::process::Command;

use serde_json::{Value, json};

use super::{document, run};

const DOCUMENT: &str = "# Springs

```sextic
parameter k, m : 1 > 0
parameter L, D : m > 0
assume L < D
angle β
sum := k + m
unused := k - m
turned := L*sin(β)
claim (1): sum^2 == k^2 + 2*k*m + m^2
claim (2): turned^2 + (L*cos(β))^2 == L^2
claim (3): D - L > 0
evaluator (4) pair: p = sum, q = k*m
```
";

/// What is found, and the exit status.
fn mutated(name: &str, text: &str) -> (Option<i32>, Value) {
    let path = document(name, text);
    let path = path.to_str().expect("a path");
    let (status, out, errors) = run(&["mutate", path, "--format", "json"]);
    assert_eq!(errors, "");
    (status, serde_json::from_str(&out).expect("JSON"))
}

fn survivors(found: &Value) -> Vec<String> {
    let survivors = found["documents"][0]["survivors"].as_array();
    let line = |own: &Value| {
        let [from, to] = ["from", "to"].map(|key| own[key].as_str().unwrap_or_default());
        format!("{}: {from} → {to}", own["line"])
    };
    survivors.into_iter().flatten().map(line).collect()
}

#[test]
fn what_no_verdict_notices_is_found() {
    let (status, found) = mutated("springs.md", DOCUMENT);
    assert_eq!(status, Some(1));
    // sin and cos are exchanged in one of two squares, or L and D, and (2) says so; `unused` is in no claim, and neither
    // is `pair`.
    assert_eq!(
        survivors(&found),
        [
            "9: k → m",
            "9: - → +",
            "9: m → k",
            "14: sum → unused",
            "14: k → m",
            "14: * → /",
            "14: m → k",
            "14: sum, q = k*m → k*m, q = sum"
        ]
    );
    let own = &found["documents"][0];
    let count = |key: &str| own[key].as_u64().expect("a count");
    // k + k and m + m, - for +; D and cos; > for <, D < D, L < L.
    assert_eq!(count("mutants"), count("noticed") + count("equal") + 8);
}

#[test]
fn outputs_are_pinned_by_claims_that_name_them() {
    let pinned = DOCUMENT.replace(
        "q = k*m\n",
        "q = k*m\nclaim (5): pair.p == m + k and\nclaim (6): unused == -(m - k)\n",
    );
    let pinned = pinned.replace(" and\n", "\nclaim (7): pair.q == m*k\n");
    let (status, found) = mutated("pinned.md", &pinned);
    assert_eq!((status, survivors(&found)), (Some(0), Vec::new()));
}

#[test]
fn what_is_equal_is_told_apart() {
    let text = "```sextic\nparameter a, b : 1\nown := 0*a + b\nclaim (1): own == b\n```\n";
    let (status, found) = mutated("equal.md", text);
    // 0·b is 0 as well; 0/a is so where a is not 0, which (1) then says, and is as expected.
    assert_eq!(survivors(&found), ["3: * → /"]);
    assert_eq!(status, Some(1));
    assert_eq!(found["documents"][0]["equal"], json!(1));
}

/// A terminal is made by `script`; where that is missing, nothing is seen.
#[test]
fn a_terminal_shows_how_far_it_is() {
    let path = document("far.md", DOCUMENT);
    let line = format!("{} mutate {}", env!("CARGO_BIN_EXE_sextic"), path.display());
    let shown = Command::new("script")
        .args(["-qec", &line, "/dev/null"])
        .output();
    let Ok(shown) = shown else {
        return eprintln!("skipped: there is no `script`");
    };
    let text = String::from_utf8_lossy(&shown.stdout);
    assert!(
        text.contains(" edits, ") && text.contains(" left"),
        "{text}"
    );
}

#[test]
fn neighbours_are_exchanged() {
    let text = "```sextic
parameter a, b, c : 1
parameter k : 1/s^2
own := [a, b; c, c]
one, other := a*b, b*c
evaluator (1) pair: p = [one; other], q = one
named := pair.q
coordinate x, y : m
system (2) moved: mass [a, 0; 0, b] stiffness [a, 0; 0, b]*k in x, y
```
";
    let (_, found) = mutated("exchanged.md", text);
    let survivors = survivors(&found);
    let exchanged = [
        "4: a, b → b, a",
        "4: b; c → c; b",
        "5: a*b, b*c → b*c, a*b",
        "6: one; other → other; one",
        "6: [one; other], q = one → one, q = [one; other]",
        "9: a, 0 → 0, a",
    ];
    for edit in exchanged {
        assert!(survivors.contains(&edit.to_string()), "{edit}");
    }
}

#[test]
fn a_name_is_known_where_nothing_else_needs_it() {
    let text = "```sextic
parameter a, b : 1
sum := a + b
turned := b + a
claim (1): turned == sum
evaluator (2) pair: p = sum, q = turned
one := sum
other := pair.p
claim (3): [one; other] == [b + a; a + b]
```
";
    let (_, found) = mutated("known.md", text);
    // Outputs of an evaluator are told apart by claims alone.
    assert_eq!(
        survivors(&found),
        [
            "6: sum → turned",
            "6: turned → sum",
            "6: sum, q = turned → turned, q = sum"
        ]
    );
    assert_eq!(found["documents"][0]["equal"], json!(2));
}

/// Edits that nothing notices in the documents that come with the command, each as often as it is listed, with the
/// reason why that does no harm.
#[test]
fn what_survives_in_the_documents_is_listed() {
    let (_, out, errors) = run(&["mutate", "--format", "json"]);
    assert_eq!(errors, "");
    let found: Value = serde_json::from_str(&out).expect("JSON");
    let mut listed: Vec<[&str; 4]> = include_str!("../data/survivors.txt")
        .lines()
        .map(|line| {
            let parts: Vec<&str> = line.split(" | ").collect();
            parts.try_into().expect("path | statement | edit | reason")
        })
        .collect();
    let mut unlisted = Vec::new();
    for document in found["documents"].as_array().expect("documents") {
        let path = document["path"].as_str().expect("a path");
        for own in document["survivors"].as_array().expect("survivors") {
            let text = |key: &str| own[key].as_str().expect("text");
            let edit = format!("{} → {}", text("from"), text("to"));
            let is_it = |[file, statement, listed, _]: &[&str; 4]| {
                *file == path && text("statement").starts_with(statement) && *listed == edit.trim()
            };
            match listed.iter().position(is_it) {
                Some(place) => drop(listed.remove(place)),
                None => unlisted.push(format!(
                    "{path}:{}: {edit} in {}",
                    own["line"],
                    text("statement")
                )),
            }
        }
    }
    assert!(unlisted.is_empty(), "{}", unlisted.join("\n"));
    assert!(listed.is_empty(), "listed, and noticed: {listed:?}");
}

#[test]
fn nothing_is_edited_before_all_is_as_expected() {
    let text = "```sextic\nparameter a, b : 1\nclaim (1): a == b\n```\n";
    let path = document("unexpected.md", text);
    let (status, out, errors) = run(&["mutate", path.to_str().expect("a path")]);
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert!(
        errors.contains("is not as its author expects before anything is edited"),
        "{errors}"
    );
}
