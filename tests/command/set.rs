//! `--set` in the commands that take a case, and the modes of a case.

use std::path::Path;

use serde_json::{Value, json};

use super::{folder, run, warnings};

/// The path of a case in a folder of this test's own.
fn case(name: &str) -> String {
    let path = folder(name).join("detuned.toml");
    path.to_str().expect("a path").to_owned()
}

fn read(arguments: &[&str]) -> Value {
    let (status, out, errors) = run(&[arguments, &["--format", "json"]].concat());
    assert_eq!(
        (status, warnings(&errors)),
        (Some(0), String::new()),
        "{arguments:?}"
    );
    serde_json::from_str(&out).expect("JSON")
}

#[test]
fn what_is_set_is_as_if_the_file_said_so() {
    let path = case("set");
    let text = std::fs::read_to_string(&path).expect("a case");
    let other = path.replace("detuned", "other");
    let lines = text.lines().map(|line| match line.split(' ').next() {
        Some("U") => "U = 4",
        Some("L_g") => "L_g = 0.002",
        Some("alpha_deg") => "alpha_deg = { from = 40, to = 40, step = 1 }",
        _ => line,
    });
    std::fs::write(&other, lines.collect::<Vec<_>>().join("\n")).expect("a case");
    let set = [
        "--set",
        "U=4",
        "--set",
        "L_g=0.002",
        "--set",
        "alpha_deg=40",
    ];
    for command in ["stability", "speeds", "validity"] {
        let mut found = read(&[&[command, &path], &set[..]].concat());
        let mut wanted = read(&[command, &other]);
        assert_eq!(
            found["set"],
            json!({"U": 4.0, "L_g": 0.002, "alpha_deg": 40.0})
        );
        assert_eq!(wanted.get("set"), None, "{command}");
        for value in [&mut found, &mut wanted] {
            let members = value.as_object_mut().expect("an object");
            members.remove("case");
            members.remove("set");
        }
        assert_eq!(found, wanted, "{command}");
    }
    let (_, out, _) = run(&[&["stability", &path], &set[..]].concat());
    assert!(out.contains("with U = 4, L_g = 0.002"), "{out}");

    let vary = ["--vary", "L_g=0.002:0.004:3", "--method", "state,closed"];
    let set = ["--set", "U=4", "--set", "alpha_deg=40"];
    let found = run(&[&["sweep", &path], &vary[..], &set[..]].concat());
    let wanted = run(&[&["sweep", &other], &vary[..]].concat());
    assert!(
        found.0 == Some(0) && found.1.lines().count() == 4,
        "{found:?}"
    );
    assert_eq!(found.1, wanted.1);
    let (status, _, err) = run(&["sweep", &path, "--vary", "U=4:5:2", "--set", "U=4"]);
    assert_eq!(status, Some(2));
    assert!(err.contains("U is varied, and U is set"), "{err}");
}

#[test]
fn coefficients_and_several_names_may_be_set() {
    let path = case("set-coefficients");
    let modes = |more: &[&str]| read(&[&["modes", &path, "--alpha", "30"], more].concat());
    let (own, other) = (modes(&[]), modes(&["--set", "dC_L=3", "--set", "f=1"]));
    assert_ne!(own["eigenvalues"], other["eigenvalues"]);
    assert_eq!(other, modes(&["--set", "f=1", "--set", "dC_L=3"]));
}

#[test]
fn a_page_says_what_was_set() {
    let path = case("set-page");
    let page = path.replace("detuned.toml", "page.html");
    let (status, _, errors) = run(&[
        "report",
        "--case",
        &path,
        "--set",
        "alpha_deg=30",
        "--set",
        "U=4",
        "--out",
        &page,
    ]);
    assert_eq!(status, Some(0), "{errors}");
    let page = std::fs::read_to_string(page).expect("a page");
    assert!(page.contains("--set alpha_deg=30 --set U=4"));
    assert!(page.contains("with alpha_deg = 30, U = 4"));
}

#[test]
fn figures_are_drawn_of_what_is_set() {
    let path = case("set-figures");
    let out = path.replace("detuned.toml", "figures");
    let (status, _, errors) = run(&["figures", &path, "--set", "L_g=0.001", "--out", &out]);
    assert_eq!(status, Some(0), "{errors}");
}

#[test]
fn the_modes_of_a_case_are_those_of_its_comparison() {
    let path = case("modes-of-case");
    let compared = read(&["stability", &path, "--set", "alpha_deg=68.5"]);
    let found = read(&["modes", &path, "--alpha", "68.5", "--shapes"]);
    let exact = read(&["modes", &path, "--alpha", "68.5", "--method", "exact"]);
    let point = &compared["points"][0];
    assert_eq!(exact["s3d"], point["s3d"]["exact"]["value"]);
    let [one, other] = [&found["s3d"], &exact["s3d"]].map(|own| own.as_f64().expect("a number"));
    assert!((one - other).abs() < 1e-9, "{one} {other}");
    assert_eq!(
        found["verdict"]["name"]
            .as_str()
            .or(found["verdict"].as_str()),
        point["verdict"].as_str()
    );
    assert_eq!(found["eigenvalues"].as_array().map(Vec::len), Some(3));
    assert!(found["eigenvalues"][0]["shape"]["x"]["re"].is_f64());
    for method in ["uniform", "companion", "exact"] {
        let other = read(&["modes", &path, "--alpha", "68.5", "--method", method]);
        assert_eq!(other["verdict"], found["verdict"], "{method}");
    }
    // Aerodynamic stiffness may be added.
    let stiff = read(&["modes", &path, "--alpha", "68.5", "--aerodynamic-stiffness"]);
    assert_ne!(stiff["eigenvalues"], found["eigenvalues"]);
}

/// The same case with a table that does not go round.
fn narrow(path: &str) -> String {
    let path = Path::new(path);
    let table = std::fs::read_to_string(path.with_file_name("formulas.csv")).expect("a table");
    let rows: Vec<&str> = table.lines().take(60).collect();
    std::fs::write(path.with_file_name("narrow.csv"), rows.join("\n")).expect("a table");
    let case = std::fs::read_to_string(path).expect("a case");
    let narrow = path.with_file_name("narrow.toml");
    std::fs::write(&narrow, case.replace("formulas", "narrow")).expect("a case");
    narrow.to_str().expect("a path").to_owned()
}

#[test]
fn what_cannot_be_set_is_said() {
    let path = case("set-wrong");
    let narrow = narrow(&path);
    for (arguments, message) in [
        (
            &["stability", &path, "--set", "L_q=1"][..],
            "a case has no quantity `L_q`",
        ),
        (
            &["stability", &path, "--set", "L_q=1"],
            "did you mean `L_g`?",
        ),
        (
            &["speeds", &path, "--set", "U=1", "--set", "U=2"],
            "U is set twice",
        ),
        (
            &["validity", &path, "--set", "f=1", "--set", "f_x=2"],
            "f and f_x set the same quantity",
        ),
        (
            &["stability", &path, "--set", "m=-1"],
            "--set m = -1: m = -1 must be above 0",
        ),
        (&["stability", &path, "--set", "r=0.001"], "--set r = 0.001"),
        (&["stability", &narrow, "--set", "alpha_deg=300"], "outside"),
        (&["stability", &path, "--set", "U=1e999"], "U=1e999"),
        (
            &["modes", &path],
            "name one of them in degrees: `--alpha 90`",
        ),
        (&["modes", &narrow, "--alpha", "300"], "outside"),
        (
            &["modes", &path, "--alpha", "1", "--set", "alpha_deg=2"],
            "alpha_deg is set twice",
        ),
        (
            &["modes", &path, "--alpha", "x"],
            "an angle is a number of degrees",
        ),
        (&["modes", "--alpha", "1"], "no case is named"),
        (
            &["modes", &path, "--alpha", "1", "--system", "s"],
            "a case has no system",
        ),
        (&["report", "--set", "U=1", "--out", "x.html"], "--case"),
    ] {
        let (status, out, errors) = run(arguments);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(errors.contains(message), "{arguments:?}: {errors}");
    }
}

#[test]
fn angles_are_given_in_degrees_and_frequencies_in_hertz_to_documents_too() {
    let folder = folder("vocabulary");
    let document = folder.join("oscillator.md");
    let text = "# An oscillator\n\n```sextic\nparameter m : kg > 0\nparameter omega_x : rad/s > 0\n\
        parameter c : kg/s\nangle alpha\ncoordinate x : m\n\
        system (1) oscillator: mass [m] damping [c*cos(alpha)] stiffness [m*omega_x^2] in x\n\
        evaluator (2) part: k = m*omega_x^2*cos(alpha)\nclaim (1): m == m\n```\n";
    std::fs::write(&document, text).expect("a document");
    let document = document.to_str().expect("a path");
    let lines = |arguments: &[&str]| {
        let (status, out, err) = run(arguments);
        assert_eq!(status, Some(0), "{err}");
        out
    };
    // π/3, and 2π.
    let radians = [
        "--set",
        "alpha=1.0471975511965976",
        "--set",
        "omega_x=6.283185307179586",
    ];
    let degrees = ["--set", "alpha_deg=60", "--set", "f_x=1"];
    let own = ["--set", "m=2", "--set", "c=1"];
    for command in ["modes", "evaluate"] {
        let first: &[&str] = match command {
            "modes" => &["modes", document],
            _ => &["evaluate", "--document", document, "part"],
        };
        let both = [&radians, &degrees].map(|angles| {
            let set: &[&str] = if command == "modes" { &own } else { &own[..2] };
            lines(&[first, set, &angles[..]].concat())
        });
        assert_eq!(both[0], both[1], "{command}");
    }
    let over = |over: &str, set: &[&str]| {
        let first = ["speeds", document, "--over", over];
        lines(&[&first[..], &own, set].concat())
    };
    assert_eq!(
        over("alpha_deg=0:180", &degrees[2..]),
        over("alpha=0:3.141592653589793", &radians[2..])
    );
    let sweep = |vary: &str, set: &[&str]| {
        let first = ["sweep", document, "--vary", vary];
        lines(&[&first[..], &own, set].concat())
    };
    // 60° is a decimal here and a double there, which the bounds of the errors tell apart.
    let without_errors = |text: String| -> Vec<Vec<String>> {
        let cells = |line: &str| line.split(',').map(str::to_string).collect();
        let rows = text.lines().map(cells).map(|mut row: Vec<String>| {
            row.remove(2);
            row
        });
        rows.collect()
    };
    assert_eq!(
        without_errors(sweep("f_x=1:2:2", &degrees[..2])),
        without_errors(sweep(
            "omega_x=6.283185307179586:12.566370614359172:2",
            &radians[..2]
        ))
    );
}

#[test]
fn a_section_without_a_case_takes_degrees_and_hertz() {
    let common = "m=3.5 r=0.0178 L_g=0.004 rho=1.25 D=0.05 U=9 L_a=0.03 gamma_r=0 alpha_0=0 theta_0=0.5 zeta_x=0 \
        zeta_y=0 zeta_theta=0 C_D=1 C_L=0 C_M=0 dC_D=0 dC_L=-3 dC_M=0";
    let modes = |own: &str| {
        let set = common
            .split(' ')
            .chain(own.split(' '))
            .flat_map(|own| ["--set", own]);
        let arguments: Vec<&str> = std::iter::once("modes").chain(set).collect();
        let (status, out, err) = run(&arguments);
        assert_eq!(status, Some(0), "{err}");
        out
    };
    let pi = "3.141592653589793";
    let omega = "6.283185307179586";
    let radians = format!("omega_x={omega} omega_y={omega} omega_theta={omega} alpha_g={pi}");
    assert_eq!(
        modes("f_x=1 f_y=1 f_theta=1 alpha_g_deg=180"),
        modes(&radians)
    );
}

#[test]
fn the_modes_of_a_case_show_its_coefficients_and_what_its_errors_leave_open() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/derivations/cases/scattered.toml"
    );
    let read = |arguments: &[&str]| -> Value {
        let (status, out, errors) = run(&[arguments, &["--format", "json"]].concat());
        assert_eq!(status, Some(0), "{arguments:?}: {errors}");
        serde_json::from_str(&out).expect("JSON")
    };
    let all = read(&["stability", path]);
    let points = all["points"].as_array().expect("points");
    let point = points
        .iter()
        .find(|own| own["within_errors"]["verdict"] == "stable")
        .expect("an angle at which all are stable");
    let angle = point["alpha_deg"].as_f64().expect("an angle").to_string();
    let found = read(&["modes", path, "--alpha", &angle]);
    assert_eq!(found["coefficients"], point["coefficients"]);
    assert_eq!(found["within_errors"], point["within_errors"]);
    let (_, out, _) = run(&["modes", path, "--alpha", &angle]);
    let line = "For all coefficients within their errors: it is stable for all of them";
    assert!(out.contains(line), "{out}");
    assert!(out.starts_with(&format!("At {angle}°: C_D ")), "{out}");
    // What is set has no error.
    let set = "C_D=1 C_L=0 C_M=0 dC_D=0 dC_L=0 dC_M=0";
    let set: Vec<&str> = set.split(' ').flat_map(|own| ["--set", own]).collect();
    let found = read(&[&["modes", path, "--alpha", &angle], &set[..]].concat());
    assert_eq!(found["coefficients"]["C_D"], 1.0);
    assert_eq!(found["within_errors"]["verdict"], "stable");
}

#[test]
fn every_report_says_what_coefficients_stand_over() {
    let path = case("reference");
    let text = std::fs::read_to_string(&path).expect("a case");
    let text = text.replace(
        "interpolation =",
        "reference = { CD = 0.1, CM = [0.1, 0.05] }\ninterpolation =",
    );
    std::fs::write(&path, text).expect("a case");
    let words = "CD over 0.1 m, CM over 0.1 m × 0.05 m, converted to D = 0.05 m";
    let (page, figures) = (
        path.replace("detuned.toml", "page.html"),
        path.replace("detuned.toml", "figures"),
    );
    for command in [
        "stability",
        "speeds",
        "validity",
        "modes",
        "sweep",
        "figures",
        "report",
    ] {
        let more: &[&str] = match command {
            "modes" => &["--alpha", "30"],
            "sweep" => &["--vary", "U=4:5:2", "--set", "alpha_deg=30"],
            "figures" => &["--set", "alpha_deg=30", "--out", &figures],
            "report" => &["--only-case", "--set", "alpha_deg=30", "--out", &page],
            _ => &["--set", "alpha_deg=30", "--width", "200"],
        };
        let case: &[&str] = if command == "report" {
            &["--case", &path]
        } else {
            &[&path]
        };
        let (status, out, err) = run(&[&[command], case, more].concat());
        assert_eq!(status, Some(0), "{command}: {err}");
        assert!(err.contains(words), "{command}: {err}");
        if ["stability", "speeds", "validity"].contains(&command) {
            // A long path of the case breaks its line elsewhere.
            assert!(out.replace('\n', " ").contains(words), "{command}: {out}");
            let found = read(&[&[command, &path], &more[..2]].concat());
            assert_eq!(found["reference"], json!({"CD": 0.1, "CM": [0.1, 0.05]}));
        }
    }
    assert!(
        std::fs::read_to_string(page)
            .expect("a page")
            .contains(words)
    );
    // The table is converted to the D that is set.
    let (_, _, err) = run(&["stability", &path, "--set", "D=0.1"]);
    assert!(err.contains("converted to D = 0.1 m"), "{err}");
    let (status, _, err) = run(&["sweep", &path, "--vary", "D=0.05:0.1:2"]);
    assert_eq!(status, Some(2));
    assert!(
        err.contains("D is varied, and `reference` converts"),
        "{err}"
    );
}

#[test]
fn a_quantity_that_is_given_as_an_option_is_shown_as_a_setting() {
    let path = case("option");
    for (arguments, cure) in [
        (
            &["stability", &path, "--alpha", "30"][..],
            "--set alpha_deg=30",
        ),
        (&["speeds", &path, "--alpha=30"], "--set alpha_deg=VALUE"),
        (&["validity", &path, "--U", "12"], "--set U=12"),
        (&["sweep", &path, "--alpha_deg", "3"], "--set alpha_deg=3"),
    ] {
        let (status, _, err) = run(arguments);
        let is_told = err.contains(&format!("a quantity of a case is set by `{cure}`"));
        assert!(status == Some(2) && is_told, "{arguments:?}: {err}");
    }
    // What sets nothing, or is no quantity, has the usual message.
    for arguments in [
        &["audit", "--alpha", "30"][..],
        &["stability", &path, "--beta", "3"],
    ] {
        let (status, _, err) = run(arguments);
        assert!(status == Some(2) && !err.contains("is set by"), "{err}");
    }
}
