//! `sextic validity` as a user runs it.

use super::{folder, run, texts, warnings};

#[test]
fn the_validity_of_a_case_is_shown_in_every_format() {
    let folder = folder("validity");
    let (case, plot) = (folder.join("light.toml"), folder.join("map.svg"));
    let text = std::fs::read_to_string(&case).expect("a case");
    std::fs::write(&case, text.replace("step = 0.5", "step = 10")).expect("a case");
    let path = case.to_str().expect("a path");
    let (status, out, err) = run(&["validity", path, "--plot", plot.to_str().expect("a path")]);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    assert!(out.contains("uniform form, second order"), "{out}");
    let labels = texts(plot.to_str().expect("a path"));
    for label in ["wrong sign of stability", "the case", "10"] {
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
fn a_case_with_aerodynamic_stiffness_has_no_map() {
    let (status, _, err) = run(&["validity", "derivations/cases/stiff.toml"]);
    assert!(
        status == Some(2) && err.contains("aerodynamic_stiffness"),
        "{err}"
    );
}

#[test]
fn coefficients_that_are_set_count_everywhere_on_the_map() {
    let folder = folder("validity_set");
    let (case, table) = (folder.join("detuned.toml"), folder.join("formulas.csv"));
    let text = std::fs::read_to_string(&case).expect("a case");
    std::fs::write(&case, text.replace("step = 0.5", "step = 20")).expect("a case");
    let set = [
        "C_D=1", "C_L=0.2", "C_M=0.1", "dC_D=0", "dC_L=-3", "dC_M=0.2",
    ];
    let set: Vec<&str> = set.iter().flat_map(|own| ["--set", own]).collect();
    let map = || {
        let first = ["validity", case.to_str().unwrap(), "--format", "json"];
        let (status, out, err) = run(&[&first[..], &set].concat());
        assert_eq!(status, Some(0), "{err}");
        out
    };
    let before = map();
    // Nothing is left of the table but its angles.
    let text = std::fs::read_to_string(&table).expect("a table");
    let other = text
        .lines()
        .enumerate()
        .map(|(line, own)| match own.split_once(',') {
            Some((angle, _)) if line > 1 => format!("{angle},0.5,1.5,{}\n", line % 7),
            _ => format!("{own}\n"),
        });
    std::fs::write(&table, other.collect::<String>()).expect("a table");
    assert_eq!(map(), before);
}
