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
        (
            "trajectory_of_mode_1",
            ["path of O", "C, centre of rotation"],
        ),
        ("trajectory_of_mode_2", ["path of O", "G, mass centre"]),
        (
            "trajectory_of_mode_3",
            ["path of O", "C, centre of rotation"],
        ),
        ("stability", ["uniform form", "unstable"]),
        ("coefficients", ["C", "rows of the table"]),
        ("slopes", ["C", "slope of a coefficient (1/rad)"]),
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
        // The title for who does not see it, and the one that is drawn.
        let title = texts.iter().find(|own| !own.is_empty());
        let title = title.expect("a title");
        assert!(title.ends_with(": detuned.toml"), "{name}: {title}");
        assert!(
            texts.iter().filter(|own| *own == title).count() == 2,
            "{name}: {texts:?}"
        );
        assert!(!texts.iter().any(|own| own.contains("NaN")), "{name}");
    }
    let (status, _, err) = run(&["figures", "none.toml", "--out", out_path]);
    assert_eq!(status, Some(2));
    assert!(err.contains("there is no such file"), "{err}");
}

/// What is said to be left out.
fn left_out(err: &str) -> Vec<&str> {
    let lines = err
        .lines()
        .filter_map(|line| line.strip_prefix("Left out: "));
    lines
        .filter_map(|line| line.split(", since ").next())
        .collect()
}

#[test]
fn what_a_case_has_nothing_to_show_for_is_left_out() {
    let out = folder("few_figures").join("drawn");
    let out = out.to_str().expect("a path");
    let arguments = ["figures", "derivations/cases/square.toml", "--out", out];
    let (status, list, err) = run(&arguments);
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(list.lines().count(), 4, "{list}");
    assert!(
        list.contains("stability.svg") && list.contains("frequencies_of_modes.svg"),
        "{list}"
    );
    assert_eq!(left_out(&err).len(), 9, "{err}");
    let (status, _, err) = run(&[
        "figures",
        "derivations/cases/square.toml",
        "--out",
        "Cargo.toml",
    ]);
    assert!(status == Some(2) && err.contains("it is a file"), "{err}");
}

#[test]
fn what_would_draw_the_same_is_left_out() {
    let folder = folder("same_figures");
    let (case, out) = (folder.join("light.toml"), folder.join("drawn"));
    let (case, out) = (
        case.to_str().expect("a path"),
        out.to_str().expect("a path"),
    );
    let (status, list, err) = run(&["figures", case, "--out", out]);
    assert_eq!((status, list.lines().count()), (Some(0), 12), "{err}");
    assert!(
        err.contains("Left out: closed_form, since it would draw the same as stability"),
        "{err}"
    );
    let (status, list, err) = run(&["figures", case, "--out", out, "--set", "L_g=0"]);
    assert_eq!((status, list.lines().count()), (Some(0), 8), "{err}");
    let expected = [
        "trajectory_of_mode_1",
        "trajectory_of_mode_2",
        "trajectory_of_mode_3",
        "inertial_coupling",
        "closed_form",
    ];
    assert_eq!(left_out(&err), expected, "{err}");
}

#[cfg(not(feature = "pictures"))]
#[test]
fn a_build_without_pictures_says_how_to_get_them() {
    let out = folder("no_pictures").join("drawn");
    let out_path = out.to_str().expect("a path");
    let case = "derivations/cases/square.toml";
    let (status, list, err) = run(&["figures", case, "--out", out_path, "--format", "pdf"]);
    assert_eq!((status, list.as_str()), (Some(2), ""), "{err}");
    assert!(
        err.contains("--features pictures") && !out.exists(),
        "{err}"
    );
    let plot = out.with_extension("png");
    let (status, _, err) = run(&["stability", case, "--plot", plot.to_str().expect("a path")]);
    assert!(
        status == Some(2) && err.contains("--features pictures"),
        "{err}"
    );
    assert!(!plot.exists());
}

#[cfg(feature = "pictures")]
#[test]
fn pictures_are_made_of_the_drawings() {
    let folder = folder("pictures");
    let case = folder.join("light.toml");
    let case = case.to_str().expect("a path");
    let out = folder.join("drawn");
    let out_path = out.to_str().expect("a path");
    let draw = |format: &str| {
        let (status, list, err) = run(&["figures", case, "--out", out_path, "--format", format]);
        assert_eq!(status, Some(0), "{err}");
        let files = list
            .lines()
            .map(|path| std::fs::read(path).expect("a picture"));
        files.collect::<Vec<Vec<u8>>>()
    };
    for (format, head) in [("png", &b"\x89PNG\r\n"[..]), ("pdf", b"%PDF-")] {
        let (pictures, again) = (draw(format), draw(format));
        assert!(pictures.len() == 12 && pictures == again, "{format}");
        assert!(
            pictures
                .iter()
                .all(|own| own.starts_with(head) && own.len() > 5000)
        );
    }
    let size = std::fs::read(out.join("stability.png")).expect("a picture");
    // Width in a PNG: bytes 16 to 19.
    assert_eq!(size[16..20], 1800_u32.to_be_bytes());
    let map = folder.join("map.png");
    let map = map.to_str().expect("a path");
    let (status, _, err) = run(&["validity", case, "--plot", map, "--set", "alpha_deg=30"]);
    assert!(status == Some(0) && std::fs::metadata(map).is_ok(), "{err}");
    // The text of a PDF is text: its fonts are in it.
    let pdf = std::fs::read(out.join("stability.pdf")).expect("a picture");
    let text = String::from_utf8_lossy(&pdf);
    assert!(text.contains("/FontDescriptor") || text.contains("/ObjStm"));
}
