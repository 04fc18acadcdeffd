//! `sextic speeds` as a user runs it.

use std::collections::BTreeSet;

use serde_json::Value;

use super::{folder, run, texts, warnings};

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
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    // Neighbours share a line, with the range of their speeds.
    assert!(out.contains("gallops up to 5.1948–"), "{out}");
    // What is not looked at is not called stable.
    assert!(out.contains("stable at every speed up to 40 m/s"), "{out}");
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
    for label in ["gallops", "critical wind speed", "U = 9 m/s of the case"] {
        assert!(svg.contains(label), "{label}");
    }
    assert!(!svg.contains("not decided") && !svg.contains("NaN"));

    for to in ["0", "-1", "nan", "inf", "1e9", "fast"] {
        let (status, _, err) = run(&["speeds", case, "--to", to]);
        assert!(status == Some(2) && err.contains("--to"), "{to}: {err}");
    }
}

#[test]
fn divergence_is_told_from_galloping() {
    let plot = folder("divergence").join("speeds.svg");
    let plot = plot.to_str().expect("a path");
    let case = "derivations/cases/stiff.toml";
    let (status, out, err) = run(&["speeds", case, "--plot", plot]);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    assert!(out.contains("gallops or diverges at "), "{out}");
    let labels = texts(plot);
    let svg = std::fs::read_to_string(plot).expect("a figure");
    let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
    let shaded = drawing
        .descendants()
        .filter(|own| own.has_tag_name("polygon"));
    let greys: BTreeSet<&str> = shaded.filter_map(|own| own.attribute("fill")).collect();
    assert_eq!(greys.len(), 2, "{greys:?}");
    for label in ["gallops", "diverges"] {
        assert!(labels.iter().any(|own| own == label), "{labels:?}");
    }
    assert!(
        labels
            .iter()
            .any(|own| own.contains("aerodynamic stiffness")),
        "{labels:?}"
    );
    let (_, out, _) = run(&["speeds", case, "--format", "csv"]);
    assert!(
        out.contains(",unstable\n14,9.8433") && out.contains(",divergent\n"),
        "{out}"
    );
}
