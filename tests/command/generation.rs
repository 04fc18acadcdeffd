//! `sextic generate` and `sextic evaluate` as a user runs them.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use serde_json::{Value, json};

use super::{document, sextic};

const PLATE: &str = "# A plate

```sextic
parameter w, h : m > 0 \"sides\"
angle β \"turn\"
function C at β : 1
assume h < w
ratio := (w + h)/(w - h)
evaluator (1) ratios: ratio = ratio, inverse = 1/ratio \"how flat the plate is\"
evaluator (2) turned: x = w*(cos(β) + C), y = h*sin(β) where w < 10 \"a corner\"
domain w = [2, 3], h = [0.1, 1], C = [-1, 1]
```
";

/// The path of a document of one test.
fn plate(name: &str) -> String {
    let path = document(name, PLATE);
    path.to_str().expect("a path in UTF-8").to_owned()
}

/// An empty folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("generated")
        .join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("an old folder goes");
    }
    folder
}

struct Run {
    status: Option<i32>,
    out: String,
    err: String,
}

fn run(arguments: &[&str]) -> Run {
    let output = sextic(arguments);
    Run {
        status: output.status.code(),
        out: String::from_utf8(output.stdout).expect("results are UTF-8"),
        err: String::from_utf8(output.stderr).expect("diagnostics are UTF-8"),
    }
}

fn generate(plate: &str, out: &Path, more: &[&str]) -> Run {
    let out = out.to_str().expect("a path in UTF-8");
    let mut arguments = vec!["generate", plate, "--out", out, "--points", "100"];
    arguments.extend(more);
    run(&arguments)
}

#[test]
fn what_is_generated_is_proven_and_stays_so() {
    let plate = plate("plate-fresh.md");
    for (language, file) in [
        ("rust", "turned.rs"),
        ("c", "turned.c"),
        ("python", "turned.py"),
        ("octave", "turned.m"),
    ] {
        let out = folder(&format!("fresh-{language}"));
        let made = generate(&plate, &out, &["--language", language]);
        assert_eq!(made.status, Some(0), "{}", made.err);
        assert!(
            made.out.contains("ratios") && made.out.contains("proven"),
            "{}",
            made.out
        );
        let again = generate(&plate, &out, &["--language", language]);
        assert!(again.out.contains("were up to date"), "{}", again.out);
        let checked = generate(&plate, &out, &["--language", language, "--check"]);
        assert_eq!(checked.status, Some(0), "{}{}", checked.out, checked.err);

        let text = fs::read_to_string(out.join(file)).expect("a file of its name");
        let wrong = text.replacen("h * sin_beta", "h / sin_beta", 1);
        let wrong = wrong.replacen("h .* sin_beta", "h ./ sin_beta", 1);
        assert_ne!(wrong, text);
        fs::write(out.join(file), &wrong).expect("a corrupt file");
        let checked = generate(&plate, &out, &["--language", language, "--check"]);
        assert_eq!(checked.status, Some(1));
        assert!(checked.out.contains("NOT proven"), "{}", checked.out);
        assert_eq!(
            fs::read_to_string(out.join(file)).expect("it is there"),
            wrong
        );
        let mended = generate(&plate, &out, &["--language", language]);
        assert_eq!(mended.status, Some(0), "{}", mended.err);
        assert_eq!(
            fs::read_to_string(out.join(file)).expect("it is there"),
            text
        );
    }
}

#[test]
fn what_evaluators_rest_on_has_to_be_there_too() {
    let plate = plate("plate-shared.md");
    for (language, shared) in [
        ("rust", "lanes.rs"),
        ("c", "sextic_bounded.h"),
        ("python", "__init__.py"),
    ] {
        let out = folder(&format!("shared-{language}"));
        let check = || generate(&plate, &out, &["--language", language, "--check"]);
        assert_eq!(
            generate(&plate, &out, &["--language", language]).status,
            Some(0)
        );
        let text = fs::read_to_string(out.join(shared)).expect("a file of its name");
        fs::write(out.join(shared), text.clone() + "\n").expect("another text");
        let needle = format!("NOT proven: it rests on {shared}");
        let checked = check();
        assert_eq!(checked.status, Some(1));
        assert!(checked.out.contains(&needle), "{}", checked.out);
        fs::remove_file(out.join(shared)).expect("it goes");
        let checked = check();
        assert!(checked.out.contains(&needle), "{}", checked.out);
        fs::write(out.join(shared), text).expect("the old text");
        assert_eq!(check().status, Some(0));
        // Python prefers a folder to a file of its name.
        fs::create_dir(out.join("turned")).expect("a folder");
        let checked = check();
        assert_eq!(checked.status, Some(1), "{}", checked.out);
        assert!(
            checked.out.contains("turned may be taken"),
            "{}",
            checked.out
        );
    }
}

#[test]
fn what_an_interrupted_run_left_is_cleared() {
    let plate = plate("plate-interrupted.md");
    let out = folder("interrupted");
    fs::create_dir_all(&out).expect("a folder");
    let (old, new) = (out.join(".sextic-old"), out.join(".sextic-new"));
    fs::write(&new, "").expect("of a run at the same time");
    let file = fs::File::create(&old).expect("of one that is over");
    let before = SystemTime::now() - Duration::from_secs(2 * 3600);
    file.set_modified(before).expect("a time of its own");
    assert_eq!(
        generate(&plate, &out, &["--language", "rust"]).status,
        Some(0)
    );
    assert!(!old.exists() && new.exists());
}

#[cfg(unix)]
#[test]
fn a_link_to_nowhere_is_no_missing_file() {
    let plate = plate("plate-link.md");
    let out = folder("link");
    fs::create_dir_all(&out).expect("a folder");
    let link = out.join("ratios.rs");
    std::os::unix::fs::symlink("nowhere", &link).expect("a link");
    let refused = generate(&plate, &out, &["--language", "rust"]);
    assert_eq!(refused.status, Some(2), "{}", refused.err);
    assert!(link.is_symlink() && !out.join("lib.rs").exists());
}

#[test]
fn nothing_of_the_users_is_overwritten() {
    let plate = plate("plate-foreign.md");
    let out = folder("foreign");
    fs::create_dir_all(&out).expect("a folder");
    fs::write(out.join("ratios.rs"), "// mine\n").expect("a file");
    let refused = generate(&plate, &out, &["--language", "rust"]);
    assert_eq!(refused.status, Some(2));
    assert!(
        refused.err.contains("ratios.rs") && refused.err.contains("--force"),
        "{}",
        refused.err
    );
    assert_eq!(
        fs::read_to_string(out.join("ratios.rs")).expect("it is there"),
        "// mine\n"
    );
    assert_eq!(
        fs::read_dir(&out).expect("a folder").count(),
        1,
        "nothing else was written"
    );
    assert_eq!(
        generate(&plate, &out, &["--language", "rust", "--force"]).status,
        Some(0)
    );
}

/// A file is generated if a comment begins with the mark, not if it quotes it.
#[test]
fn a_quoted_mark_makes_no_file_a_generated_one() {
    let plate = plate("plate-quoted.md");
    let out = folder("quoted");
    fs::create_dir_all(&out).expect("a folder");
    let own = "// Not: Generated by sextic.\n";
    fs::write(out.join("ratios.rs"), own).expect("a file");
    let refused = generate(&plate, &out, &["--language", "rust"]);
    assert_eq!(refused.status, Some(2));
    assert_eq!(
        fs::read_to_string(out.join("ratios.rs")).expect("it is there"),
        own
    );
}

/// What another run has not named yet is no generated file that is left over.
#[test]
fn files_without_a_name_yet_are_not_reported() {
    let plate = plate("plate-staged.md");
    let out = folder("staged");
    assert_eq!(
        generate(&plate, &out, &["--language", "rust"]).status,
        Some(0)
    );
    fs::write(out.join(".sextic-abc"), "//! Generated by sextic: x\n").expect("a file");
    let checked = generate(&plate, &out, &["--language", "rust", "--check"]);
    assert_eq!(checked.status, Some(0), "{}", checked.out);
}

#[test]
fn wrong_orders_are_refused_with_what_to_do() {
    let plate = plate("plate-wrong.md");
    let out = folder("wrong");
    for (arguments, needle) in [
        (&["--language", "ruts"][..], "did you mean `rust`?"),
        (
            &["--language", "rust", "--only", "ratio"],
            "did you mean `ratios`?",
        ),
        (
            &["--language", "rust", "--fix", "wide=3"],
            "no evaluator that is generated rests on `wide`",
        ),
        (&["--language", "rust", "--fix", "w"], "write `name=value`"),
        (
            &["--language", "rust", "--fix", "w=1,5"],
            "exact decimal or fraction",
        ),
        (
            &["--language", "rust", "--fix", "w=-1"],
            "contradicts the assumption w > 0",
        ),
        (
            &["--language", "rust", "--fix", "w=10"],
            "only where w < 10",
        ),
        (
            &["--language", "rust", "--fix", "h=1e-320"],
            "beyond the range",
        ),
        // 0 in doubles, though not exactly.
        (
            &[
                "--language",
                "rust",
                "--fix",
                "w=1",
                "--fix",
                "h=0.99999999999999999999",
            ],
            "has no value at any point",
        ),
        (
            &["--language", "rust", "--fix", "w=1", "--fix", "h=1"],
            "w > h",
        ),
        (
            &["--language", "rust", "--fix", "w=1", "--fix", "w=2"],
            "fixed twice",
        ),
        (&["--language", "rust", "--fix", "beta=30"], "radians"),
    ] {
        let refused = generate(&plate, &out, arguments);
        assert_eq!(refused.status, Some(2), "{arguments:?}: {}", refused.err);
        assert!(
            refused.err.contains(needle),
            "{arguments:?}: {}",
            refused.err
        );
        assert!(!out.exists(), "{arguments:?} wrote something");
    }
    let file = document("not-a-folder", "a file\n");
    let refused = generate(&plate, &file, &["--language", "rust"]);
    assert_eq!(refused.status, Some(2));
    assert!(refused.err.contains("not-a-folder"), "{}", refused.err);
}

#[test]
fn a_document_with_another_verdict_generates_nothing() {
    let text = PLATE.replace("ratio := ", "claim [no]: w == h\nratio := ");
    let path = document("plate-false.md", &text);
    let out = folder("false");
    let refused = generate(
        path.to_str().expect("a path"),
        &out,
        &["--language", "rust"],
    );
    assert_eq!(refused.status, Some(1), "{}", refused.err);
    assert!(!out.exists());
}

#[test]
fn fixed_quantities_are_no_inputs() {
    let plate = plate("plate-fixed.md");
    let out = folder("fixed");
    let fix = [
        "--language",
        "rust",
        "--fix",
        "w=2.5",
        "--fix",
        "beta=0.3",
        "--fix",
        "C=0",
    ];
    let made = generate(&plate, &out, &fix);
    assert_eq!(made.status, Some(0), "{}", made.err);
    let text = fs::read_to_string(out.join("turned.rs")).expect("a file");
    let command = "--fix w=2.5 --fix beta=0.3 --fix C=0";
    assert!(text.contains(command), "{text}");
    assert!(text.contains("let w = T::constant(2.5);"), "{text}");
    // cos 0.3, to the last place of a double.
    assert!(text.contains("T::constant(0.955336489125606);"), "{text}");
    assert!(
        !text.contains("inputs.w") && !text.contains("inputs.C;"),
        "{text}"
    );
    assert!(text.contains("inputs.h"), "{text}");
}

#[test]
fn what_is_all_fixed_is_a_function_of_nothing() {
    let plate = plate("plate-all.md");
    for (language, file, line) in [
        (
            "rust",
            "ratios.rs",
            "pub fn ratios() -> RatiosOutputs<f64> {",
        ),
        ("c", "ratios.c", "ratios_outputs ratios(void)"),
        ("python", "ratios.py", "def ratios() -> RatiosOutputs:"),
        ("octave", "ratios.m", "function result = ratios()"),
    ] {
        let out = folder(&format!("all-{language}"));
        let order = [
            "--language",
            language,
            "--only",
            "ratios",
            "--fix",
            "w=2",
            "--fix",
            "h=1",
        ];
        let made = generate(&plate, &out, &order);
        assert_eq!(made.status, Some(0), "{}", made.err);
        assert!(made.out.contains("proven; within"), "{}", made.out);
        let text = fs::read_to_string(out.join(file)).expect("a file");
        assert!(text.contains(line), "{text}");
        let checked = generate(&plate, &out, &[&order[..], &["--check"]].concat());
        assert_eq!(checked.status, Some(0), "{}", checked.out);
    }
}

#[test]
fn names_that_are_not_free_are_told() {
    let text = "# Names\n\n```sextic\nparameter a, TurnOutputs : 1\nangle at_angles\n\
        evaluator (1) turn: at = a*sin(at_angles) + TurnOutputs\nevaluator (2) class: y = a\n```\n";
    let path = document("names.md", text);
    let out = folder("names");
    let made = generate(
        path.to_str().expect("a path"),
        &out,
        &["--language", "python"],
    );
    assert_eq!(made.status, Some(0), "{}", made.err);
    for line in [
        "turn: `TurnOutputs` is called `TurnOutputs_`, `at_angles` is called `at_angles_`, since",
        "class: `class` is called `class_`, since",
    ] {
        assert!(made.out.contains(line), "{}", made.out);
    }
    let text = fs::read_to_string(out.join("turn.py")).expect("a file");
    assert!(
        text.contains("called `at_angles` in the document"),
        "{text}"
    );
    let text = fs::read_to_string(out.join("class_.py")).expect("a file");
    assert!(text.contains("Called `class` in the document"), "{text}");
}

#[test]
fn an_evaluator_says_where_its_formula_may_be_used() {
    let set = "r=0.0178 L_g=0.004 alpha_g=0.2 theta_0=0 m=3.5 rho=1.25 D=0.05 U=9 S_xx=2 S_xy=0 S_xt=0 S_yx=0 \
               S_yy=1 S_yt=0 S_tx=0 S_ty=0 S_tt=1";
    let set = set.split_whitespace().flat_map(|own| ["--set", own]);
    let arguments: Vec<&str> = ["evaluate", "closed_form"].into_iter().chain(set).collect();
    let found = run(&arguments);
    assert_eq!(found.status, Some(0), "{}", found.err);
    let said = found.out.replace('\n', " ");
    for expected in [
        "(21) (22) (23): ",
        "L_g/r is well above ρDU|S_a|/(2mω_n)",
        "λ_R1 = ",
    ] {
        assert!(said.contains(expected), "{said}");
    }
    let found = run(&[&arguments[..], &["--format", "json"]].concat());
    let json: Value = serde_json::from_str(&found.out).expect("JSON");
    let description = json["description"].as_str().expect("a description");
    assert!(description.contains("perfect tuning"), "{description}");
}

#[test]
fn evaluators_give_numbers() {
    let plate = plate("plate-evaluate.md");
    let evaluate = |more: &[&str]| {
        let mut arguments = vec!["evaluate", "--document", &plate];
        arguments.extend(more);
        run(&arguments)
    };
    let given = [
        "ratios", "--set", "w=3", "--set", "h=1/2", "--set", "beta=0.2",
    ];
    let found = evaluate(&[&given[..], &["--format", "json"]].concat());
    assert_eq!(found.status, Some(0), "{}", found.err);
    let expected = json!({
        "evaluator": "ratios",
        "inputs": {"w": 3.0, "h": 0.5},
        "outputs": {"ratio": 1.4, "inverse": 1.0 / 1.4},
        "unused": ["beta"],
    });
    let found: Value = serde_json::from_str(&found.out).expect("JSON");
    assert_eq!(found["inputs"], expected["inputs"]);
    assert_eq!(found["unused"], expected["unused"]);
    for output in ["ratio", "inverse"] {
        let (found, expected) = (&found["outputs"][output], &expected["outputs"][output]);
        let (found, expected) = (
            found.as_f64().expect("a number"),
            expected.as_f64().expect("one"),
        );
        assert!((found - expected).abs() < 1e-15, "{output}: {found}");
    }
    for (arguments, needle) in [
        (&["ratio"][..], "did you mean `ratios`?"),
        (&["ratios", "--set", "w=3"], "needs h too"),
        (
            &["ratios", "--set", "w=3", "--set", "hh=1"],
            "did you mean `h`?",
        ),
        (&["ratios", "--set", "w=3", "--set", "h=4"], "w > h"),
        (&["ratios", "--set", "w=0", "--set", "h=1"], "w > 0"),
        (
            &["ratios", "--set", "w=3", "--set", "w=3", "--set", "h=1"],
            "twice",
        ),
        (&["ratios", "--set", "w=1e400", "--set", "h=1"], "beyond"),
        (
            &["ratios", "--set", "w=nan", "--set", "h=1"],
            "exact decimal",
        ),
        (
            &[
                "ratios", "--set", "w=1e300", "--set", "h=1e-300", "--format", "jsn",
            ],
            "json",
        ),
    ] {
        let refused = evaluate(arguments);
        assert_eq!(
            refused.status,
            Some(2),
            "{arguments:?}: {}{}",
            refused.out,
            refused.err
        );
        assert!(
            refused.err.contains(needle),
            "{arguments:?}: {}",
            refused.err
        );
        assert_eq!(refused.out, "");
    }
    let listed = evaluate(&["--list"]);
    assert!(
        listed.out.contains("turned (2): a corner"),
        "{}",
        listed.out
    );
}
