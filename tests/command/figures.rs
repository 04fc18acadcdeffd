//! `sextic figures` as a user runs it.

use super::{folder, run, texts, warnings};

#[test]
fn all_figures_of_a_case_are_drawn() {
    let folder = folder("figures");
    let (case, out) = (folder.join("detuned.toml"), folder.join("drawn"));
    let out_path = out.to_str().expect("a path");
    let arguments = ["figures", case.to_str().expect("a path"), "--out", out_path];
    let (status, list, err) = run(&arguments);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
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

#[test]
fn what_a_case_has_nothing_to_show_for_is_left_out() {
    let out = folder("few_figures").join("drawn");
    let out = out.to_str().expect("a path");
    let arguments = ["figures", "derivations/cases/square.toml", "--out", out];
    let (status, list, err) = run(&arguments);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    assert_eq!(list.lines().count(), 7, "{list}");
    for name in ["inertial", "offset", "closed"] {
        assert!(!list.contains(name), "{list}");
    }
    let (status, _, err) = run(&[
        "figures",
        "derivations/cases/square.toml",
        "--out",
        "Cargo.toml",
    ]);
    assert!(status == Some(2) && err.contains("it is a file"), "{err}");
}
