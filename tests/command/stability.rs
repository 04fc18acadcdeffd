//! `sextic stability` as a user runs it.

use serde_json::Value;

use super::{folder, run, warnings};

#[test]
fn a_case_is_written_in_every_format_and_drawn() {
    let folder = folder("stability");
    let case = folder.join("tuned.toml");
    let (case, plot) = (case.to_str().expect("a path"), folder.join("plot.svg"));
    let plot_path = plot.to_str().expect("a path");
    let (status, out, err) = run(&["stability", case, "--plot", plot_path]);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
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
fn a_table_in_another_encoding_is_read_and_said() {
    let folder = folder("encodings");
    let case = folder.join("tuned.toml");
    let case = case.to_str().expect("a path");
    let table = folder.join("formulas.csv");
    let text = std::fs::read_to_string(&table).expect("a table");
    let (_, expected, _) = run(&["stability", case, "--format", "csv"]);
    let little = |text: &str| -> Vec<u8> {
        let units = text.encode_utf16().flat_map(u16::to_le_bytes);
        [0xff, 0xfe].into_iter().chain(units).collect()
    };
    let big = |text: &str| -> Vec<u8> {
        let units = text.encode_utf16().flat_map(u16::to_be_bytes);
        [0xfe, 0xff].into_iter().chain(units).collect()
    };
    // A degree sign in Latin-1.
    let latin = [text.replace("alpha_deg", "alpha").as_bytes(), b"# \xb0\n"].concat();
    for (bytes, said) in [
        (little(&text), "UTF-16"),
        (big(&text), "UTF-16"),
        (latin, "Latin-1"),
    ] {
        std::fs::write(&table, bytes).expect("a table");
        let (status, out, err) = run(&["stability", case, "--format", "csv"]);
        assert_eq!((status, &out), (Some(0), &expected), "{err}");
        assert!(err.contains(&format!("is read in {said}")), "{err}");
    }
    std::fs::write(&table, [0xff, 0xfe, 0x00, 0xd8]).expect("a table");
    let (status, _, err) = run(&["stability", case]);
    assert_eq!(status, Some(2));
    assert!(err.contains("it is no text in UTF-16"), "{err}");
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
fn a_name_of_another_format_is_refused() {
    let folder = folder("other_plot");
    let (case, plot) = (folder.join("tuned.toml"), folder.join("plot.gif"));
    for command in ["stability", "speeds", "validity"] {
        let paths = [&case, &plot].map(|path| path.to_str().expect("a path"));
        let (status, out, err) = run(&[command, paths[0], "--plot", paths[1]]);
        assert_eq!((status, out.as_str()), (Some(2), ""));
        assert!(err.contains("ends in .svg"), "{err}");
    }
    assert!(!plot.exists());
    let page = folder.join("page.pdf");
    let paths = [&case, &page].map(|path| path.to_str().expect("a path"));
    let (status, _, err) = run(&["report", "--case", paths[0], "--out", paths[1]]);
    assert!(status == Some(2) && err.contains("ends in .html"), "{err}");
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
fn what_errors_leave_open_is_not_called_certain() {
    let case = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/derivations/cases/scattered.toml"
    );
    let arguments = ["stability", case, "--set", "U=14", "--format"];
    let (status, csv, _) = run(&[&arguments[..], &["csv"]].concat());
    assert_eq!(status, Some(0));
    assert!(
        csv.lines()
            .next()
            .unwrap()
            .ends_with("within_errors,s3d_least,s3d_most"),
        "{csv}"
    );
    let mut certain = 0;
    for line in csv.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [.., within, least, most] = cells[..] else {
            panic!("{line}");
        };
        let number = |cell: &str| cell.parse::<f64>().ok();
        if let (Some(least), Some(most), Some(s)) = (number(least), number(most), number(cells[1]))
        {
            assert!(least <= s && s <= most, "{line}");
            // Parts of the errors may tell more than the bounds of all.
            assert!(least <= 0.0 || within == "stable", "{line}");
        }
        certain += usize::from(within == cells[7]);
    }
    assert!(certain > 60 && csv.contains(",depends,"), "{certain} of 91");
    let (_, json, _) = run(&[&arguments[..], &["json"]].concat());
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["points"][60]["within_errors"]["verdict"], "depends");
    // What is set in place of the table has no error.
    let set = ["C_D=1", "C_L=0", "C_M=0", "dC_D=0", "dC_L=0", "dC_M=0"];
    let set: Vec<&str> = set.iter().flat_map(|own| ["--set", own]).collect();
    let (_, csv, _) = run(&[&arguments[..2], &set, &["--format", "csv"]].concat());
    assert!(
        csv.lines().skip(1).all(|line| line.contains(",stable,")),
        "{csv}"
    );
    let (_, csv, _) = run(&[&arguments[..2], &["--format", "csv"]].concat());
    assert!(csv.contains("within_errors"));
}

#[test]
fn scatter_that_may_turn_a_verdict_is_told() {
    let folder = folder("scattered");
    let cases = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/cases");
    let text = std::fs::read_to_string(cases.join("scattered.toml")).expect("a case");
    let text = text.replace("\"smooth\"", "\"cubic\"");
    let text: Vec<&str> = text
        .lines()
        .filter(|line| !line.starts_with("errors"))
        .collect();
    let case = folder.join("case.toml");
    std::fs::write(&case, text.join("\n")).expect("a case");
    std::fs::copy(cases.join("scattered.csv"), folder.join("scattered.csv")).expect("a table");
    let case = case.to_str().unwrap();
    let (_, out, _) = run(&["stability", case, "--width", "400"]);
    assert!(out.contains("may turn the verdict at 51 of 91 "), "{out}");
    // Angles that depend on the scatter, and those of which that is open, share their ranges.
    assert!(out.contains("(0° to 20°, 88° to 90°, "), "{out}");
    // Where it turns nothing it is not said.
    let calm = ["--set", "U=1", "--set", "alpha_deg=60"];
    let (_, out, _) = run(&[&["stability", case][..], &calm].concat());
    assert!(!out.contains("scatter about"), "{out}");
    // Other commands do not look, and say how much it is.
    let (_, _, err) = run(&["modes", case, "--alpha", "10"]);
    assert!(err.contains("CL by 2.0e-2, dCL by 8.0e-1"), "{err}");
    let (_, out, _) = run(&["stability", folder.join("detuned.toml").to_str().unwrap()]);
    assert!(!out.contains("may turn the verdict"), "{out}");
}

#[test]
fn where_errors_leave_s_without_bounds_is_said() {
    let case = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/derivations/cases/scattered.toml"
    );
    let (_, out, _) = run(&["stability", case, "--width", "200"]);
    assert!(
        out.contains("  no bounds of S    0° to 6°, 176° to 180°"),
        "{out}"
    );
    let (_, out, err) = run(&["modes", case, "--alpha", "0"]);
    assert!(
        out.contains("stable for all of them, and no bounds of S_3D are known"),
        "{out}"
    );
    assert!(!err.contains("not considered"), "{err}");
    let (_, out, _) = run(&["modes", case, "--alpha", "60"]);
    assert!(out.contains("stable for all of them, S_3D from "), "{out}");
}
