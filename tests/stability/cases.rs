//! Case files and coefficient tables: what is read, and what is said of the rest.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use sextic::stability::case::Case;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::coefficient_table::reading::Reading;
use sextic::stability::coefficient_table::remarks::remarks;
use sextic::stability::comparison::compare;
use sextic::stability::interpolation::{CoefficientCurves, Interpolation};

/// The folder of the cases that come with the project.
pub fn shipped() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/cases")
}

/// A case that comes with the project, with edits, and its table.
pub fn shipped_case(name: &str, edits: &[(&str, &str)]) -> (Case, CoefficientTable) {
    let text = read(&shipped().join(name));
    let text = edits.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{old} is not in {name}");
        text.replace(old, new)
    });
    let case = Case::read(name, &text).expect("a case");
    let table = read(&shipped().join(&case.coefficients));
    let table = CoefficientTable::read(&case.coefficients, &table).expect("a table");
    (case, table)
}

pub fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file that can be read")
}

/// Snapshots in a folder of their own.
pub fn snapshots(folder: &str, check: impl FnOnce()) {
    let mut settings = insta::Settings::clone_current();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    settings.set_snapshot_path(root.join("snapshots/stability").join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(check);
}

#[test]
fn every_wrong_case_has_a_message_that_helps() {
    let text = read(&shipped().join("detuned.toml"));
    let edits = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/cases/edits.txt"));
    let edits = edits
        .lines()
        .filter(|line| line.contains("=>") && !line.starts_with('#'));
    let mut messages = String::new();
    for edit in edits {
        let (old, new) = edit.split_once("=>").expect("an arrow");
        let (old, new) = (old.trim(), new.trim().replace("\\n", "\n"));
        assert!(text.contains(old), "{old}");
        let message = match Case::read("case.toml", &text.replace(old, &new)) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{edit} is no mistake"),
        };
        writeln!(messages, "{edit}\n    {message}").expect("a string");
    }
    snapshots("cases", || insta::assert_snapshot!("wrong_cases", messages));
}

#[test]
fn every_table_is_read_or_explained() {
    let check = |path: &Path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let bytes = std::fs::read(path).expect("a table");
        // As the command reads what is not in UTF-8.
        let latin = |bytes: &[u8]| bytes.iter().copied().map(char::from).collect();
        let text = String::from_utf8(bytes).unwrap_or_else(|error| latin(error.as_bytes()));
        let said = match CoefficientTable::read(&name, &text) {
            Err(error) => error.to_string(),
            Ok(table) => {
                let mut said =
                    format!("{} rows, circle: {}", table.rows().len(), table.is_circle());
                for remark in remarks(&table) {
                    write!(said, "\n{remark}").expect("a string");
                }
                said
            }
        };
        insta::assert_snapshot!(said);
    };
    snapshots("tables", || {
        insta::glob!(
            concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data"),
            "tables/*.csv",
            check
        );
    });
}

/// What is read of a table, with its remarks, as a case says it in [section].
fn said(lines: &str, name: &str) -> String {
    let text = read(&shipped().join("detuned.toml"));
    let text = text.replace("interpolation =", &format!("{lines}\ninterpolation ="));
    let case = Case::read("case.toml", &text).expect("a case");
    let table = read(
        &Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/data/tables")
            .join(name),
    );
    match case.read_table(name, &table) {
        Err(error) => error.to_string(),
        Ok(table) => {
            let mut said = format!("{}; {}", table.reading(), table.columns().join(", "));
            for remark in remarks(&table) {
                write!(said, "\n    {remark}").expect("a string");
            }
            said
        }
    }
}

#[test]
fn a_table_is_read_as_the_case_says() {
    let readings = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/cases/readings.txt");
    let readings = read(&readings);
    let readings = readings.lines().filter(|line| !line.starts_with('#'));
    let mut all = String::new();
    for reading in readings.filter(|line| !line.is_empty()) {
        let (name, lines) = reading.split_once(": ").expect("a table");
        let said = said(&lines.replace("\\n", "\n"), name);
        writeln!(all, "{reading}\n    {said}").expect("a string");
    }
    snapshots("cases", || insta::assert_snapshot!("readings", all));
}

#[test]
fn all_spellings_of_a_table_are_one_table() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tables");
    let rows = |name: &str| {
        let table = CoefficientTable::read(name, &read(&folder.join(name))).expect("a table");
        let numbers = table.rows().iter();
        let numbers = numbers.map(|row| [row.angle, row.lift, row.drag, row.moment]);
        numbers.collect::<Vec<_>>()
    };
    for name in [
        "windows.csv",
        "semicolons.csv",
        "tabs.csv",
        "quoted_decimal_commas.csv",
        "misleading_comment.csv",
        "scattered.csv",
        "in_a_comment.csv",
    ] {
        assert_eq!(rows(name), rows("good.csv"), "{name}");
    }
}

#[test]
fn the_table_that_is_shipped_is_that_of_its_formulas() {
    let (_, table) = shipped_case("tuned.toml", &[]);
    assert!(remarks(&table).is_empty());
    assert_eq!(table.rows().len(), 180);
    for row in table.rows() {
        let alpha = row.angle.to_radians();
        let lift = alpha.sin() - 0.9 * (3.0 * alpha).sin();
        let drag = 1.1 - 0.4 * (2.0 * alpha).cos();
        let moment = 0.15 * (2.0 * alpha).sin() - 0.05 * alpha.sin();
        for (own, formula) in [(row.lift, lift), (row.drag, drag), (row.moment, moment)] {
            assert!(
                (own - formula).abs() < 6e-7,
                "at {}: {own}, {formula}",
                row.angle
            );
        }
    }
}

proptest::proptest! {
    #[test]
    fn no_numbers_make_the_readers_panic(
        numbers in proptest::collection::vec(proptest::array::uniform4(-4..4_i32), 4..14),
        step in proptest::sample::select(vec![1e-12, 0.5, 30.0, 60.0, 90.0]),
    ) {
        let rows = numbers.iter().map(|[angle, lift, drag, moment]| {
            format!("{},{lift},{drag},{moment}e9\n", f64::from(*angle) * step)
        });
        let text = format!("alpha_deg,CL,CD,CM\n{}", rows.collect::<String>());
        for mirror in [false, true] {
            let reading = Reading { mirror, ..Reading::default() };
            if let Ok(table) = CoefficientTable::read_as("any.csv", &text, &reading) {
                remarks(&table);
                let curves = CoefficientCurves::new(&table, Interpolation::Cubic).expect("curves");
                let _ = curves.at(12.0);
            }
        }
    }

    #[test]
    fn no_text_makes_the_readers_panic(text in "(alpha_deg|AoA|CL|CD|CM|rad|sep=|//|[0-9.,;\t\n\"#!% −°-]){0,80}") {
        for [mirror, slopes] in [[false, false], [true, false], [true, true]] {
            let columns = [("CL".to_string(), "CD".to_string())];
            for columns in [[].into(), columns.into()] {
                let reading = Reading { columns, mirror, slopes };
                let table = CoefficientTable::read_as("any.csv", &text, &reading);
                let _ = table.map(|table| remarks(&table));
            }
        }
        let _ = Case::read("any.toml", &text);
    }
}

#[test]
fn mistaken_units_are_named() {
    let remarks = |old: &str, new: &str| -> String {
        let text = read(&shipped().join("detuned.toml")).replace(old, new);
        let case = Case::read("case.toml", &text).expect("a case");
        case.remarks().iter().map(ToString::to_string).collect()
    };
    assert_eq!(remarks("", ""), "");
    assert!(
        remarks("zeta_x = 0.008", "zeta_x = 0.8").contains("zeta_x = 0.8 is a damping of 80 %")
    );
    let millimetres = remarks("D = 0.05", "D = 50");
    assert!(millimetres.contains("r = 0.0178 m beside D = 50 m"));
    assert!(millimetres.contains("m = 3.5 kg/m beside D = 50 m weighs less than the air"));
    for reference in ["CL = 300", "CM = [0.3, 300]", "CD = 0.002"] {
        let with = format!("D = 0.05\nreference = {{ {reference} }}");
        let said = remarks("D = 0.05", &with);
        assert!(said.contains("a reference length of C"), "{said}");
        assert!(said.contains("all lengths are in m, 50 mm is 0.05"));
    }
    assert_eq!(
        remarks("D = 0.05", "D = 0.05\nreference = { CL = 0.3 }"),
        ""
    );

    // A table in radians ends before the sweep does: that is not what is wrong with it.
    let (case, _) = shipped_case("detuned.toml", &[]);
    let rows =
        (0..40).map(|step| format!("{},0,1,0\n", f64::from(step) * std::f64::consts::PI / 39.0));
    let table = format!("alpha_deg,CL,CD,CM\n{}", rows.collect::<String>());
    let table = CoefficientTable::read("radians.csv", &table).expect("a table");
    let error = compare(&case, &table).expect_err("it is too short");
    assert!(error.help.contains("looks like radians"), "{error:?}");
    // The other way round: the first angle beyond a turn is named, wherever the table is refused for it.
    let table = "alpha_rad,CL,CD,CM\n6,0,1,0\n7,0,1,0\n8,0,1,0\n9,0,1,0\n";
    let table = CoefficientTable::read("degrees.csv", table).expect("a table");
    let error = compare(&case, &table).expect_err("it begins beyond the sweep");
    let words = "degrees.csv:3: the angle is 7 rad by the heading";
    assert!(error.help.contains(words), "{error:?}");
}
