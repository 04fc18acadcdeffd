//! The mean twist in every command that takes a case.

use serde_json::Value;

use super::{folder, run};

/// The path of `detuned.toml` with a mean twist, and with edits.
fn twisted(name: &str, edits: &[(&str, &str)]) -> String {
    let path = folder(name).join("detuned.toml");
    let text = std::fs::read_to_string(&path).expect("a case");
    let on = [
        ("rho = 1.25", "rho = 1.25\nmean_twist = true"),
        ("U = 9", "U = 6"),
        ("step = 0.5", "step = 30"),
    ];
    let text = on
        .iter()
        .chain(edits)
        .fold(text, |text, (old, new)| text.replace(old, new));
    std::fs::write(&path, text).expect("a case");
    path.to_str().expect("a path").to_owned()
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

#[test]
fn every_view_has_the_same_twist() {
    let case = twisted("twist_views", &[]);
    let compared = json(&["stability", &case]);
    let (_, text, _) = run(&["stability", &case, "--width", "200"]);
    assert!(
        text.contains("; with mean twist") && text.contains("Mean twist\n"),
        "{text}"
    );
    let (_, csv, _) = run(&["stability", &case, "--format", "csv"]);
    let (_, sweep, _) = run(&["sweep", &case, "--vary", "U=6"]);
    let column = |table: &str, name: &str| -> Vec<String> {
        let mut lines = table
            .lines()
            .map(|line| line.split(',').collect::<Vec<_>>());
        let heading = lines.next().expect("a heading");
        let place = heading
            .iter()
            .position(|own| *own == name)
            .expect("a column");
        lines.map(|cells| cells[place].to_owned()).collect()
    };
    let points = compared["points"].as_array().expect("points");
    for (place, point) in points.iter().enumerate() {
        let alpha = point["alpha_deg"].to_string();
        let twist = number(&point["twist"]["deg"]);
        for table in [&csv, &sweep] {
            let other: f64 = column(table, "twist_deg")[place].parse().expect("a number");
            assert!((twist - other).abs() < 1e-9, "{alpha}: {twist} {other}");
            assert_eq!(
                column(table, "balance")[place],
                point["twist"]["balance"].as_str().expect("a word")
            );
        }
        for method in ["state", "exact", "companion", "uniform"] {
            let modes = json(&["modes", &case, "--alpha", &alpha, "--method", method]);
            assert_eq!(modes["twist"], point["twist"]);
            let apart = (number(&modes["s3d"]) - number(&point["s3d"]["exact"]["value"])).abs();
            assert!(
                apart < if method == "uniform" { 0.1 } else { 1e-7 },
                "{alpha} {method}: {apart}"
            );
        }
    }
    assert!(
        points
            .iter()
            .any(|own| number(&own["twist"]["deg"]).abs() > 1.0)
    );
    let (_, modes, _) = run(&["modes", &case, "--alpha", "30"]);
    assert!(modes.contains("Mean twist "), "{modes}");
}

#[test]
fn what_cannot_follow_a_twist_says_what_can() {
    let case = twisted("twist_refused", &[]);
    for (command, words) in [
        ("speeds", "sextic sweep CASE --vary U=2:40:77"),
        ("validity", "leave `mean_twist` out of the case"),
    ] {
        let (status, _, err) = run(&[command, &case]);
        assert!(status == Some(2) && err.contains(words), "{command}: {err}");
    }
    let alone = ["stability", &case, "--set", "U=40", "--set", "alpha_deg=0"];
    let (status, _, err) = run(&alone);
    assert!(
        status == Some(2) && err.contains("at 0°: without mean moment there is no mean twist"),
        "{err}"
    );
    let (status, out, err) = run(&["sweep", &case, "--vary", "U=6:400:2", "--worst"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains(",none,"), "{out}");
    for (command, set, value) in [
        ("stability", "--set", "C_M=0.1"),
        ("stability", "--set", "dC_M=0.1"),
        ("sweep", "--vary", "C_M=0.1"),
        ("sweep", "--vary", "dC_M=0.1"),
    ] {
        let (status, _, err) = run(&[command, &case, set, value]);
        assert!(
            status == Some(2) && err.contains("the mean twist follows the curve of the table"),
            "{err}"
        );
    }
    let errors = twisted(
        "twist_errors",
        &[("L_a = 0.03", "L_a = 0.03\nerrors = { CL = 0.1 }")],
    );
    let (status, _, err) = run(&["stability", &errors]);
    assert!(
        status == Some(2) && err.contains("leave out `mean_twist`, or the errors"),
        "{err}"
    );
}

#[test]
fn figures_and_the_page_are_those_of_the_twisted_section() {
    let case = twisted("twist_page", &[]);
    let page = case.replace("detuned.toml", "page.html");
    let (status, _, err) = run(&["report", "--case", &case, "--only-case", "--out", &page]);
    assert_eq!(status, Some(0), "{err}");
    let page = std::fs::read_to_string(page).expect("a page");
    for words in [
        "Mean twist: from ",
        "No critical wind speeds: the mean twist goes with the wind speed",
        "No map of the errors of the closed forms: each wind of the map",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("sextic speeds"));
    let out = case.replace("detuned.toml", "figures");
    let (status, _, err) = run(&["figures", &case, "--out", &out]);
    assert_eq!(status, Some(0), "{err}");
    for name in ["stability", "coefficients", "frequencies_of_modes"] {
        let path = std::path::Path::new(&out).join(format!("{name}.svg"));
        let figure = std::fs::read_to_string(path).expect("a figure");
        assert!(figure.contains("before the mean twist"), "{name}");
    }
}

#[test]
fn a_turn_that_is_held_has_no_twist_and_says_so() {
    let case = twisted("twist_held", &[("\"x\", \"y\", \"theta\"", "\"x\", \"y\"")]);
    let (status, out, err) = run(&["stability", &case, "--width", "200"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(
        out.contains("with mean twist, which is 0 as theta is held"),
        "{out}"
    );
    let (status, out, _) = run(&["speeds", &case, "--width", "200"]);
    assert!(
        status == Some(0) && out.contains("which is 0 as theta is held"),
        "{out}"
    );
}

#[test]
fn what_is_odd_about_balances_is_said() {
    // Close to divergence.
    let case = twisted(
        "twist_odd",
        &[
            ("U = 6", "U = 12"),
            (
                "from = 0, to = 180, step = 30",
                "from = 2, to = 178, step = 8",
            ),
        ],
    );
    let (status, out, err) = run(&["stability", &case, "--width", "200"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(
        out.contains("in balance at more than one mean twist"),
        "{out}"
    );
}

/// An angle at which nothing is in balance has its reason, and no number, in every view.
#[test]
fn an_angle_without_a_balance_does_not_stop_the_others() {
    let case = twisted("twist_none", &[("U = 6", "U = 40")]);
    let (status, out, err) = run(&["stability", &case, "--width", "400"]);
    assert_eq!(status, Some(0), "{err}");
    for words in [
        "7 angles from 0° to 180°",
        "no verdict at 2 of 7 angles, which have no certain mean twist",
        "at 2 of 7 angles (at 0°, at 180°) there is no verdict: without mean moment",
        "at 5 of 7 angles (30° to 150°): springs and wind are in balance at more",
    ] {
        assert!(out.contains(words), "{words}: {out}");
    }
    let compared = json(&["stability", &case]);
    let count = |key: &str| compared[key].as_array().map(Vec::len);
    assert_eq!(
        [count("points"), count("without_balance")],
        [Some(5), Some(2)]
    );
    assert_eq!(compared["without_balance"][1]["alpha_deg"], 180.0);
    let (_, csv, err) = run(&["stability", &case, "--format", "csv"]);
    assert!(err.contains("there is no verdict"), "{err}");
    let rows: Vec<&str> = csv.lines().skip(1).collect();
    let cells = |place: usize| rows[place].split(',').collect::<Vec<_>>();
    assert_eq!(rows.len(), 7);
    for (place, alpha) in [(0, "0"), (6, "180")] {
        let empty = cells(place).iter().filter(|own| own.is_empty()).count();
        assert_eq!(
            (cells(place)[0], cells(place).last()),
            (alpha, Some(&"none"))
        );
        assert_eq!(
            (empty, cells(place).len()),
            (cells(1).len() - 2, cells(1).len())
        );
    }
    let page = case.replace("detuned.toml", "page.html");
    let (status, _, err) = run(&["report", "--case", &case, "--only-case", "--out", &page]);
    assert_eq!(status, Some(0), "{err}");
    let page = std::fs::read_to_string(page).expect("a page");
    assert!(page.contains("which have no certain mean twist"));
}
