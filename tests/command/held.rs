//! Coordinates that are held, any of them, in every command that takes a case.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;

use super::{folder, run};

/// All that may be free.
const SUBSETS: [&[&str]; 7] = [
    &["x"],
    &["y"],
    &["theta"],
    &["x", "y"],
    &["x", "theta"],
    &["y", "theta"],
    &["x", "y", "theta"],
];

/// A case with these coordinates free and no numbers of the others; with stiffness of the wind or without.
fn held(folder: &Path, free: &[&str], is_stiffened: bool) -> String {
    let text = std::fs::read_to_string(folder.join("detuned.toml")).expect("a case");
    let turns = free.contains(&"theta");
    let is_needed = |line: &&str| {
        let key = line.split(' ').next().unwrap_or_default();
        match key.split_once('_') {
            Some(("f" | "zeta", name)) => free.contains(&name),
            Some(("L" | "alpha" | "gamma", "a" | "g" | "g_deg" | "r_deg")) => turns,
            None if key == "r" => turns,
            _ => key != "free",
        }
    };
    let lines: Vec<&str> = text.lines().filter(is_needed).collect();
    let stiffness = format!("[wind]\naerodynamic_stiffness = {is_stiffened}");
    let text = lines.join("\n");
    let text = text
        .replace("[structure]", &format!("[structure]\nfree = {free:?}"))
        .replace("[wind]", &stiffness)
        .replace("step = 0.5", "step = 30");
    let path = folder.join("held.toml");
    std::fs::write(&path, text).expect("a case");
    path.to_str().expect("a path").to_owned()
}

/// What a command says: its status, and why it refuses.
fn said(status: Option<i32>, err: &str) -> String {
    let error = err.lines().find(|line| line.starts_with("Error"));
    match (status, error) {
        (Some(0), None) => "done".into(),
        (Some(2), Some(error)) => {
            let rest = err.lines().skip_while(|line| *line != error);
            rest.map(str::trim).collect::<Vec<_>>().join(" ")
        }
        other => panic!("{other:?}: {err}"),
    }
}

const COMMANDS: &[(&str, &[&str])] = &[
    ("stability", &["--width", "100"]),
    ("stability", &["--format", "csv"]),
    ("stability", &["--format", "json"]),
    ("speeds", &["--width", "100"]),
    ("speeds", &["--format", "csv"]),
    ("speeds", &["--format", "json"]),
    ("modes", &["--alpha", "60", "--method", "state", "--shapes"]),
    ("modes", &["--alpha", "60", "--method", "exact", "--shapes"]),
    (
        "modes",
        &["--alpha", "60", "--method", "companion", "--shapes"],
    ),
    ("modes", &["--alpha", "60", "--method", "uniform"]),
    ("modes", &["--alpha", "60", "--method", "closed"]),
    ("sweep", &["--vary", "U=2:20:3"]),
    ("sweep", &["--vary", "U=2:20:3", "--worst"]),
    ("sweep", &["--vary", "U=9", "--method", "companion"]),
    ("sweep", &["--vary", "U=9", "--method", "closed"]),
    ("sweep", &["--vary", "U=9", "--method", "uniform"]),
    (
        "sweep",
        &["--vary", "U=9", "--method", "state,closed,uniform"],
    ),
    ("sweep", &["--vary", "L_g=0:0.001:2"]),
    ("sweep", &["--vary", "C_M=0:0.1:2"]),
    ("sweep", &["--vary", "f_x=1:2:2"]),
    ("sweep", &["--vary", "f=1:2:2"]),
    ("sweep", &["--vary", "zeta_theta=0:0.1:2"]),
    ("validity", &["--width", "100"]),
    ("figures", &["--out", "FIGURES"]),
    ("report", &["--only-case", "--out", "PAGE"]),
];

#[test]
fn every_command_takes_any_free_coordinates_or_says_why_not() {
    let folder = folder("held");
    let place = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let (figures, page) = (place("figures"), place("page.html"));
    let mut all = String::new();
    for is_stiffened in [false, true] {
        for free in SUBSETS {
            let case = held(&folder, free, is_stiffened);
            let stiffness = if is_stiffened {
                ", with aerodynamic stiffness"
            } else {
                ""
            };
            writeln!(all, "{}{stiffness}", free.join(" ")).expect("a string");
            for (command, options) in COMMANDS {
                let options = options.iter().map(|own| match *own {
                    "FIGURES" => figures.as_str(),
                    "PAGE" => page.as_str(),
                    other => other,
                });
                let case = if *command == "report" {
                    vec!["--case", &case]
                } else {
                    vec![case.as_str()]
                };
                let arguments: Vec<&str> = std::iter::once(*command)
                    .chain(case)
                    .chain(options.clone())
                    .collect();
                let (status, out, err) = run(&arguments);
                let said = said(status, &err).replace(folder.to_str().expect("a path"), "…");
                for wrong in ["NaN", "panicked"] {
                    assert!(
                        !out.contains(wrong) && !err.contains(wrong),
                        "{arguments:?}: {out}{err}"
                    );
                }
                let shown: Vec<&str> = options.filter(|own| !own.contains('/')).collect();
                writeln!(all, "  {command} {}: {said}", shown.join(" ")).expect("a string");
            }
        }
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/command"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("held", all));
}

fn json(arguments: &[&str]) -> Value {
    let (status, out, err) = run(&[arguments, &["--format", "json"]].concat());
    assert_eq!(status, Some(0), "{arguments:?}: {err}");
    serde_json::from_str(&out).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

/// Every command says the same of a section with held coordinates.
#[test]
fn commands_agree_where_coordinates_are_held() {
    let folder = folder("held_agree");
    for is_stiffened in [false, true] {
        for free in SUBSETS {
            let case = held(&folder, free, is_stiffened);
            let compared = json(&["stability", &case]);
            let speeds = json(&["speeds", &case]);
            let (_, rows, _) = run(&[
                "sweep",
                &case,
                "--vary",
                "U=9",
                "--method",
                "state,companion",
            ]);
            let rows: Vec<&str> = rows.lines().skip(1).collect();
            let points = compared["points"].as_array().expect("points");
            assert_eq!((rows.len(), points.len()), (7, 7));
            for (place, point) in points.iter().enumerate() {
                let alpha = point["alpha_deg"].to_string();
                let own = number(&point["s3d"]["exact"]["value"]);
                for method in ["state", "exact", "companion"] {
                    let modes = json(&["modes", &case, "--alpha", &alpha, "--method", method]);
                    let other = number(&modes["s3d"]);
                    assert!(
                        (own - other).abs() < 1e-7,
                        "{free:?} {alpha} {method}: {own} {other}"
                    );
                    let verdict = modes["verdict"]["name"]
                        .as_str()
                        .or(modes["verdict"].as_str());
                    assert_eq!(verdict, point["verdict"].as_str(), "{free:?} {alpha}");
                }
                let cells = rows[place]
                    .split(',')
                    .filter_map(|own| own.parse::<f64>().ok());
                let near = cells.filter(|other| (own - other).abs() < 1e-7).count();
                assert!(near >= 2, "{free:?} {alpha}: {own} {}", rows[place]);
                let ranges = speeds["points"][place]["ranges"]
                    .as_array()
                    .expect("ranges");
                let range = ranges
                    .iter()
                    .find(|own| number(&own["from"]) <= 9.0 && 9.0 <= number(&own["to"]));
                let verdict = range.expect("a range")["verdict"]
                    .as_str()
                    .expect("a verdict");
                let verdict = if verdict == "divergent" {
                    "unstable"
                } else {
                    verdict
                };
                assert_eq!(Some(verdict), point["verdict"].as_str(), "{free:?} {alpha}");
            }
        }
    }
}

/// What is held is what springs of any stiffness hold.
#[test]
fn held_coordinates_are_very_stiff_ones() {
    let folder = folder("held_stiff");
    let all = folder.join("detuned.toml");
    let all = all.to_str().expect("a path");
    for is_stiffened in [false, true] {
        for free in &SUBSETS[..6] {
            let case = held(&folder, free, is_stiffened);
            let mut stiff = vec!["modes", all, "--alpha", "60"];
            for (name, set) in [("x", "f_x=1e4"), ("y", "f_y=1e4"), ("theta", "f_theta=1e4")] {
                if !free.contains(&name) {
                    stiff.extend(["--set", set]);
                }
            }
            if is_stiffened {
                stiff.push("--aerodynamic-stiffness");
            }
            let stiff = json(&stiff);
            let own = json(&["modes", &case, "--alpha", "60"]);
            let parts = |own: &Value| [number(&own["re"]), number(&own["im"])];
            let values = |own: &Value| -> Vec<[f64; 2]> {
                own["eigenvalues"]
                    .as_array()
                    .expect("eigenvalues")
                    .iter()
                    .map(parts)
                    .collect()
            };
            let stiff = values(&stiff);
            for [re, im] in values(&own) {
                let near = stiff.iter().map(|[a, b]| (a - re).hypot(b - im));
                let near = near.fold(f64::INFINITY, f64::min);
                assert!(near < 1e-5, "{free:?}: {re} {im} is {near} away");
            }
        }
    }
}
