//! `sextic stability` and `sextic modes` as a user runs them.

use std::path::PathBuf;

use serde_json::Value;

use super::sextic;

/// A folder of this test's own with the cases that come with the project.
pub fn folder(name: &str) -> PathBuf {
    let from = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("derivations/cases");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    for file in ["tuned.toml", "detuned.toml", "light.toml", "formulas.csv"] {
        std::fs::copy(from.join(file), folder.join(file)).expect("a copy");
    }
    folder
}

pub fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = sextic(arguments);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

#[test]
fn a_case_is_written_in_every_format_and_drawn() {
    let folder = folder("stability");
    let case = folder.join("tuned.toml");
    let (case, plot) = (case.to_str().expect("a path"), folder.join("plot.svg"));
    let plot_path = plot.to_str().expect("a path");
    let (status, out, err) = run(&["stability", case, "--plot", plot_path]);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    assert!(
        out.contains("Unstable ranges, in steps of 0.5°") && out.contains("Methods"),
        "{out}"
    );
    assert!(
        std::fs::read_to_string(&plot)
            .expect("a figure")
            .starts_with("<svg")
    );

    let (status, out, _) = run(&["stability", case, "--format", "csv"]);
    assert_eq!(status, Some(0));
    assert!(
        out.starts_with("alpha_deg,s3d_exact,s3d_companion,s3d_closed,s3d_uniform,"),
        "{out}"
    );
    assert_eq!(out.lines().count(), 362);

    let (status, out, _) = run(&["stability", case, "--format", "json"]);
    assert_eq!(status, Some(0));
    let json: Value = serde_json::from_str(&out).expect("JSON");
    let point = &json["points"][0];
    assert!(point["s3d"]["exact"]["value"].is_f64() && point["s3d"]["exact"]["error"].is_f64());
    assert!(point["s3d"]["closed"].is_f64() && point["s3d"]["uniform"].is_f64());
    assert_eq!(point["modes"].as_array().map(Vec::len), Some(3));
    assert!(json["unstable"][0]["worst_deg"].is_f64());
    assert_eq!(json["methods"][1]["method"], "closed");
}

#[test]
fn wrong_cases_end_with_status_2_and_leave_no_file() {
    let folder = folder("wrong_stability");
    let text = std::fs::read_to_string(folder.join("tuned.toml")).expect("a case");
    let plot = folder.join("plot.svg");
    for (name, old, new, message) in [
        ("key.toml", "alpha_g_deg", "alpha_g", "write alpha_g_deg"),
        (
            "mass.toml",
            "m = 3.5",
            "m = 0",
            "mass.toml:5: m = 0 must be above 0",
        ),
        (
            "table.toml",
            "formulas.csv",
            "none.csv",
            "there is no such file",
        ),
        ("wind.toml", "U = 9 ", "U = 0 ", "there is no wind"),
    ] {
        let path = folder.join(name);
        std::fs::write(&path, text.replace(old, new)).expect("a case");
        let arguments = ["stability", path.to_str().expect("a path"), "--plot"];
        let (status, out, err) = run(&[&arguments[..], &[plot.to_str().expect("a path")]].concat());
        assert_eq!((status, out.as_str()), (Some(2), ""), "{err}");
        assert!(err.contains(message), "{err}");
        assert!(!plot.exists());
    }
    let short = "alpha_deg,CL,CD,CM\n0,0,1,0\n1,0,1,0\n2,0,1,0\n3,0,1,0\n";
    std::fs::write(folder.join("formulas.csv"), short).expect("a table");
    let case = folder.join("tuned.toml");
    let case = case.to_str().expect("a path");
    let (status, _, err) = run(&["stability", case]);
    assert_eq!(status, Some(2));
    assert!(
        err.contains("the angle 3.5° is outside of the table"),
        "{err}"
    );
    let (status, _, err) = run(&["stability", folder.to_str().expect("a path")]);
    assert_eq!(status, Some(2));
    assert!(err.contains("it is a folder"), "{err}");
}

#[test]
fn a_plot_that_cannot_be_written_is_wrong_input() {
    let folder = folder("no_plot");
    let case = folder.join("tuned.toml");
    let plot = folder.join("none").join("plot.svg");
    let arguments = [
        case.to_str().expect("a path"),
        "--plot",
        plot.to_str().expect("a path"),
    ];
    let (status, _, err) = run(&[&["stability"], &arguments[..]].concat());
    assert_eq!(status, Some(2));
    assert!(err.contains("cannot be written"), "{err}");
}

const SECTION: [&str; 12] = [
    "m=3.5",
    "r=0.0178",
    "L_g=0.004",
    "alpha_g=1/2",
    "theta_0=0",
    "omega_x=6",
    "omega_y=6",
    "omega_theta=6",
    "U=0",
    "zeta_x=0",
    "zeta_y=0",
    "zeta_theta=0",
];

fn modes(section: &[&str], more: &[&str]) -> (Option<i32>, String, String) {
    let set = section.iter().flat_map(|own| ["--set", own]);
    let arguments: Vec<&str> = ["modes"]
        .into_iter()
        .chain(set)
        .chain(more.iter().copied())
        .collect();
    run(&arguments)
}

#[test]
fn all_methods_find_the_modes_without_wind() {
    let e = 0.004 / 0.0178_f64;
    let exact = [6.0 / (1.0 - e).sqrt(), 6.0, 6.0 / (1.0 + e).sqrt()];
    for method in ["closed", "uniform", "exact", "companion", "state"] {
        let (status, out, err) = modes(&SECTION, &["--method", method, "--format", "json"]);
        assert_eq!((status, err.as_str()), (Some(0), ""), "{method}");
        let json: Value = serde_json::from_str(&out).expect("JSON");
        assert_eq!(json["method"], method);
        assert!(json["s3d"].is_null());
        for (place, exact) in exact.iter().enumerate() {
            let own = json["eigenvalues"][place]["im"].as_f64().expect("a number");
            assert!((own - exact).abs() < 1e-9, "{method}: {out}");
        }
    }
}

#[test]
fn what_modes_cannot_do_is_said() {
    for (section, more, message) in [
        (
            &SECTION[..],
            &["--method", "exakt"][..],
            "possible values: closed, uniform",
        ),
        (&SECTION[1..], &[], "the modes need m too"),
        (&SECTION[..], &["--set", "L_G=1"], "did you mean `L_g`?"),
        (&SECTION[..], &["--set", "m=1"], "set twice"),
    ] {
        let (status, out, err) = modes(section, more);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{more:?}");
        assert!(err.contains(message), "{err}");
    }
    let detuned: Vec<&str> = SECTION
        .iter()
        .map(|own| own.strip_prefix("omega_x=6").map_or(*own, |_| "omega_x=5"))
        .collect();
    let (status, _, err) = modes(&detuned, &["--method", "closed"]);
    assert_eq!(status, Some(2));
    assert!(err.contains("perfect tuning"), "{err}");
    let (_, out, _) = modes(&SECTION, &["--method", "closed"]);
    assert!(!out.contains("did not matter"), "{out}");
    let (_, out, _) = modes(&SECTION, &["--set", "C_D=1"]);
    assert!(out.contains("C_D did not matter"), "{out}");
}

#[test]
fn modes_show_how_they_move_where_that_is_asked_for() {
    // Without wind the mode of the middle frequency leaves the angle alone.
    for method in ["exact", "companion", "state"] {
        let arguments = ["--method", method, "--shapes"];
        let (status, out, err) = modes(&SECTION, &[&arguments[..], &["--format", "json"]].concat());
        assert_eq!((status, err.as_str()), (Some(0), ""), "{method}");
        let json: Value = serde_json::from_str(&out).expect("JSON");
        let entry = |mode: usize, name: &str| {
            let own = &json["eigenvalues"][mode]["shape"][name];
            let [re, im] = ["re", "im"].map(|part| own[part].as_f64().expect("a number"));
            assert!(im.abs() < 1e-6, "{method}: {out}");
            re
        };
        for (mode, sign) in [(0, -1.0), (2, 1.0)] {
            assert!((entry(mode, "r_theta") - 1.0).abs() < 1e-12);
            assert!(
                (entry(mode, "x") - sign * 0.5_f64.sin()).abs() < 1e-6,
                "{out}"
            );
            assert!(
                (entry(mode, "y") - sign * 0.5_f64.cos()).abs() < 1e-6,
                "{out}"
            );
        }
        assert!((entry(1, "x") - 1.0).abs() < 1e-12 && entry(1, "r_theta").abs() < 1e-6);
        let (_, out, _) = modes(&SECTION, &arguments);
        let expected = "      x 0.4794 at 180.0000°, y 0.8776 at 180.0000°, rθ 1\n";
        assert!(out.contains(expected), "{out}");
    }
    for method in ["closed", "uniform"] {
        let (status, out, err) = modes(&SECTION, &["--method", method, "--shapes"]);
        assert_eq!((status, out.as_str()), (Some(2), ""));
        assert!(err.contains("no mode shapes"), "{err}");
    }
    let (_, out, _) = modes(&SECTION, &["--format", "json"]);
    assert!(!out.contains("shape"), "{out}");
    let centred = SECTION.map(|own| own.replace("L_g=0.004", "L_g=0"));
    let centred: Vec<&str> = centred.iter().map(String::as_str).collect();
    let (_, out, _) = modes(&centred, &["--shapes"]);
    assert!(out.contains("modes coincide"), "{out}");
}

#[test]
fn what_a_formula_gives_is_shown_however_far_it_is_off() {
    let section = SECTION.map(|own| {
        own.replace("L_g=0.004", "L_g=0.00001")
            .replace("U=0", "U=900")
    });
    let wind = "rho=1.25 D=0.05 S_xx=2 S_xy=-3/2 S_yx=1 S_yy=-2 S_tx=0 S_ty=1 S_xt=0 S_yt=0 S_tt=0";
    let section: Vec<&str> = section
        .iter()
        .map(String::as_str)
        .chain(wind.split_whitespace())
        .collect();
    let (status, out, _) = modes(&section, &["--method", "closed"]);
    assert_eq!(status, Some(0));
    let damping = out.lines().find(|line| line.starts_with("S_3D = "));
    let damping = damping.expect("a line").trim_start_matches("S_3D = ");
    let (number, error) = damping.split_once(", off by up to 1e").expect("an error");
    let number: f64 = number.parse().expect("a number");
    let error: i32 = error.parse().expect("a power of ten");
    assert!(number.abs() > 0.1 && error >= 0, "{out}");
    assert!(!out.contains("within") && !out.contains("1e-0"), "{out}");
}

#[test]
fn long_numbers_are_refused_without_repeating_them() {
    let long = format!("theta_0=0.{}", "1".repeat(5000));
    let (status, _, err) = modes(&SECTION[..4], &["--set", &long]);
    assert_eq!(status, Some(2));
    assert!(
        err.contains("at most 400 digits") && err.len() < 500,
        "{err}"
    );
}

#[test]
fn the_scaled_damping_matrix_stands_for_coefficients() {
    let calm = SECTION.iter().filter(|own| **own != "U=0").copied();
    let wind = ["U=9", "rho=1.25", "D=0.05"];
    let section: Vec<&str> = calm.chain(wind).collect();
    let coefficients = [
        "alpha_0=0",
        "L_a=0",
        "gamma_r=0",
        "C_D=1",
        "C_L=1/2",
        "C_M=0",
        "dC_D=-1",
        "dC_L=-3",
        "dC_M=1",
    ];
    // Eq. (18) for wind along x and forces at O: 2 C_D, C_D' - C_L; 2 C_L, C_L' + C_D; and D/r times
    // 2 C_M, C_M'.
    let moment = format!("S_ty={}", 0.05 / 0.0178);
    let matrix = [
        "S_xx=2",
        "S_xy=-3/2",
        "S_yx=1",
        "S_yy=-2",
        "S_tx=0",
        &moment,
        "S_xt=0",
        "S_yt=0",
        "S_tt=0",
    ];
    for method in ["closed", "uniform", "exact", "companion", "state"] {
        let of = |forces: &[&str]| -> Value {
            let section: Vec<&str> = section.iter().chain(forces).copied().collect();
            let (status, out, err) = modes(&section, &["--method", method, "--format", "json"]);
            assert_eq!((status, err.as_str()), (Some(0), ""));
            serde_json::from_str(&out).expect("JSON")
        };
        let (one, other) = (of(&coefficients), of(&matrix));
        let difference =
            one["s3d"].as_f64().expect("a number") - other["s3d"].as_f64().expect("a number");
        assert!(difference.abs() < 1e-9, "{one} {other}");
        assert_eq!(other["warnings"], one["warnings"]);
    }
    let some: Vec<&str> = section.iter().chain(&matrix[..8]).copied().collect();
    let (status, _, err) = modes(&some, &[]);
    assert!(
        status == Some(2) && err.contains("the modes need S_tt too"),
        "{err}"
    );
}

/// What a figure says; it is well formed and has more than axes.
fn texts(path: &str) -> Vec<String> {
    let svg = std::fs::read_to_string(path).expect("a figure");
    let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
    let elements = || drawing.descendants().filter(|node| node.is_element());
    let lines = elements().filter(|node| node.has_tag_name("polyline"));
    assert!(lines.count() > 20, "{path}");
    let own = elements().filter_map(|node| node.text());
    own.map(|text| text.trim().to_owned()).collect()
}

#[test]
fn all_figures_of_a_case_are_drawn() {
    let folder = folder("figures");
    let (case, out) = (folder.join("detuned.toml"), folder.join("drawn"));
    let out_path = out.to_str().expect("a path");
    let arguments = ["figures", case.to_str().expect("a path"), "--out", out_path];
    let (status, list, err) = run(&arguments);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    let name = |path: &str| {
        let stem = std::path::Path::new(path).file_stem();
        stem.expect("a name").to_string_lossy().into_owned()
    };
    let drawn: Vec<(String, Vec<String>)> =
        list.lines().map(|path| (name(path), texts(path))).collect();
    let expected = [
        ("frequencies_without_wind", ["mode 1", "mode 3"]),
        ("trajectory_of_mode_1", ["x / r", "path of O"]),
        ("trajectory_of_mode_2", ["x / r", "path of O"]),
        ("trajectory_of_mode_3", ["x / r", "path of O"]),
        ("stability", ["uniform form", "unstable"]),
        ("damping_of_modes", ["mode 2", "unstable"]),
        ("frequencies_of_modes", ["mode 2", "frequency (Hz)"]),
        (
            "inertial_coupling",
            ["angle of attack α (degrees)", "unstable"],
        ),
        ("damping_against_offset", ["mode 3", "unstable"]),
        ("frequencies_against_offset", ["mode 3", "frequency (Hz)"]),
        ("closed_form", ["closed form (21)–(23)", "uniform form"]),
    ];
    assert_eq!(drawn.len(), expected.len());
    for ((name, texts), (expected, labels)) in drawn.iter().zip(expected) {
        assert_eq!(name, expected);
        for label in labels {
            assert!(texts.iter().any(|own| own == label), "{name}: {texts:?}");
        }
        assert!(!texts.iter().any(|own| own.contains("NaN")), "{name}");
    }
    let (status, _, err) = run(&["figures", "none.toml", "--out", out_path]);
    assert_eq!(status, Some(2));
    assert!(err.contains("there is no such file"), "{err}");
}

#[cfg(target_os = "linux")]
#[test]
fn results_that_find_no_room_are_an_error() {
    let case = folder("no_room").join("tuned.toml");
    let full = std::fs::File::create("/dev/full").expect("a device");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(["stability", case.to_str().expect("a path")])
        .stdout(full)
        .output()
        .expect("it runs");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("standard output cannot be written"));
}

#[test]
fn the_validity_of_a_case_is_shown_in_every_format() {
    let folder = folder("validity");
    let (case, plot) = (folder.join("light.toml"), folder.join("map.svg"));
    let text = std::fs::read_to_string(&case).expect("a case");
    std::fs::write(&case, text.replace("step = 0.5", "step = 10")).expect("a case");
    let path = case.to_str().expect("a path");
    let (status, out, err) = run(&["validity", path, "--plot", plot.to_str().expect("a path")]);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    assert!(out.contains("uniform form, second order"), "{out}");
    let labels = texts(plot.to_str().expect("a path"));
    for label in ["wrong sign of stability", "the case", "10⁻²"] {
        assert!(labels.iter().any(|own| own == label), "{labels:?}");
    }
    let (_, narrow, _) = run(&["validity", path, "--width", "40"]);
    assert!(
        narrow.lines().all(|line| line.chars().count() <= 40),
        "{narrow}"
    );
    let (_, rows, _) = run(&["validity", path, "--format", "csv"]);
    let (_, json, _) = run(&["validity", path, "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let map = json["map"].as_array().expect("a map");
    assert_eq!(rows.lines().count(), 1 + map.len());
    let cells: Vec<&str> = rows.lines().nth(500).expect("a row").split(',').collect();
    let number = |cell: &str| cell.parse::<f64>().expect("a number");
    let (of_row, of_map) = (number(cells[2]), map[498 + 1]["closed"]["error"].as_f64());
    assert!((of_row / of_map.expect("a number") - 1.0).abs() < 0.01);
    assert_eq!(json["forms"][1]["form"], "uniform_first");
    std::fs::write(&case, text.replace("U = 9 ", "U = 0 ")).expect("a case");
    let (status, out, err) = run(&["validity", path]);
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert!(err.contains("there is no wind"), "{err}");
}

#[test]
fn a_verdict_is_as_exact_as_the_decimals_are_written() {
    let section: Vec<&str> = "m=1 r=1 L_g=0 alpha_g=0 theta_0=0 omega_x=1 omega_y=1 omega_theta=1 zeta_y=0 \
         zeta_theta=0.01 U=2 rho=1 D=1 S_xx=2 S_xy=2 S_xt=0 S_yx=-2 S_yy=-1 S_yt=0 S_tx=0 S_ty=0 S_tt=0"
        .split_whitespace()
        .collect();
    for (ratio, verdict, reason) in [
        (
            "zeta_x=0.999999999999999999999999999999",
            "stable",
            "Hurwitz",
        ),
        ("zeta_x=1", "undecided", "exactly 0"),
        (
            "zeta_x=1.000000000000000000000000000001",
            "unstable",
            "Hurwitz",
        ),
    ] {
        let section: Vec<&str> = section.iter().copied().chain([ratio]).collect();
        let (status, out, err) = modes(&section, &["--format", "json"]);
        assert_eq!(status, Some(0), "{err}");
        let found: Value = serde_json::from_str(&out).expect("JSON");
        assert_eq!(found["verdict"], verdict);
        assert!(
            found["reason"]
                .as_str()
                .is_some_and(|own| own.contains(reason)),
            "{out}"
        );
        let (_, out, _) = modes(&section, &[]);
        assert!(
            out.contains(&format!("The section is {verdict}: ")),
            "{out}"
        );
    }
}

#[test]
fn critical_speeds_are_written_in_every_form() {
    let case = "derivations/cases/light.toml";
    let (status, out, err) = run(&["speeds", case, "--to", "40", "--format", "json"]);
    assert_eq!(status, Some(0), "{err}");
    let found: Value = serde_json::from_str(&out).expect("JSON");
    let points = found["points"].as_array().expect("points");
    assert_eq!(points.len(), 361);
    let critical = &points[16]["critical"][0];
    assert_eq!(points[16]["alpha_deg"], 8.0);
    assert_eq!(critical["becomes"], "stable");
    let speed = critical["speed"].as_f64().expect("a speed");
    assert!((speed - 11.3843).abs() < 1e-4 && critical["error"].as_f64() < Some(1e-9));

    let (_, out, _) = run(&["speeds", case, "--to", "40", "--format", "csv"]);
    assert!(out.starts_with("alpha_deg,from,to,verdict\n0,0.000000000,40.000000000,unstable\n"));
    assert!(out.contains("\n8,0.000000000,11.38"), "{out}");
    assert!(!out.contains("undecided"));

    let plot = folder("speeds").join("speeds.svg");
    let plot = plot.to_str().expect("a path");
    let (status, out, err) = run(&["speeds", case, "--to", "40", "--plot", plot]);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    // Neighbours share a line, with the range of their speeds.
    assert!(out.contains("gallops up to 5.1948–"), "{out}");
    assert!(out.lines().count() < 20, "{out}");
    assert!(
        out.contains("from the lowest wind speeds on: 0° to 8°, 21° to "),
        "{out}"
    );
    let svg = std::fs::read_to_string(plot).expect("a figure");
    let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
    let shaded = drawing
        .descendants()
        .filter(|own| own.has_tag_name("polygon"));
    // Two ranges of angles from 0 on, one from a critical speed on, and the legend.
    assert!(shaded.count() >= 4, "{svg}");
    for label in ["unstable", "critical wind speed", "U = 9 m/s of the case"] {
        assert!(svg.contains(label), "{label}");
    }
    assert!(!svg.contains("not decided") && !svg.contains("NaN"));

    for to in ["0", "-1", "nan", "inf", "1e9", "fast"] {
        let (status, _, err) = run(&["speeds", case, "--to", to]);
        assert!(status == Some(2) && err.contains("--to"), "{to}: {err}");
    }
}

/// The turn alone diverges where m r² ω_θ² = ρD²U²C_M′/2: here with C_M′ = 1/2.
#[test]
fn aerodynamic_stiffness_is_an_option() {
    let section = "m=1 r=1 L_g=0 alpha_g=0 theta_0=0 omega_x=1 omega_y=1 omega_theta=1 zeta_x=0.01 zeta_y=0.01 \
                   zeta_theta=0.01 U=2 rho=1 D=1 alpha_0=0 L_a=0 gamma_r=0 C_D=1 C_L=0 C_M=0 dC_D=0 dC_L=0";
    let section: Vec<&str> = section.split_whitespace().collect();
    let on = "--aerodynamic-stiffness";
    for (moment, option, verdict) in [
        ("dC_M=0.499999999999999999999", &[on][..], "stable"),
        ("dC_M=0.5", &[on], "undecided"),
        ("dC_M=0.500000000000000000001", &[on], "unstable"),
        ("dC_M=0.6", &[], "stable"),
    ] {
        let more = [&["--set", moment, "--format", "json"][..], option].concat();
        let (status, out, err) = modes(&section, &more);
        assert_eq!((status, err.as_str()), (Some(0), ""), "{moment}");
        let json: Value = serde_json::from_str(&out).expect("JSON");
        assert_eq!(json["verdict"], verdict, "{moment}: {out}");
    }
    for (method, warning) in [
        ("exact", "these are the eigenvalues of the state matrix"),
        ("closed", "aerodynamic stiffness is on"),
        ("uniform", "aerodynamic stiffness is on"),
    ] {
        let (_, out, _) = modes(&section, &["--set", "dC_M=0.1", on, "--method", method]);
        let out = out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(out.contains(warning), "{method}: {out}");
    }
    let given = section.iter().filter(|own| !own.contains("C_"));
    let given: Vec<&str> = given.copied().chain(["S_xx=1"]).collect();
    let others = [
        "S_xy=0", "S_xt=0", "S_yx=0", "S_yy=0", "S_yt=0", "S_tx=0", "S_ty=0", "S_tt=0",
    ];
    let given = [given, others.to_vec()].concat();
    let (status, _, err) = modes(&given, &[on]);
    assert!(
        status == Some(2) && err.contains("give force coefficients"),
        "{err}"
    );

    let (_, out, _) = run(&["speeds", "derivations/cases/stiff.toml", "--format", "csv"]);
    assert!(
        out.contains(",unstable\n14,9.8433") && out.contains(",divergent\n"),
        "{out}"
    );
    let (status, _, err) = run(&["validity", "derivations/cases/stiff.toml"]);
    assert!(
        status == Some(2) && err.contains("aerodynamic_stiffness"),
        "{err}"
    );
}
