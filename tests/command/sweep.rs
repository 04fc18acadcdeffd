//! `sextic sweep` as a user runs it: order, interruptions, what is wrong.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use super::{folder, run, warnings};

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file")
}

fn path(path: &Path) -> &str {
    path.to_str().expect("a path")
}

/// The files in a folder that were not finished.
fn parts(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .filter(|path| path.extension().is_some_and(|own| own == "part"))
        .collect()
}

#[test]
fn rows_are_those_of_stability_in_a_fixed_order() {
    let folder = folder("sweep");
    let case = folder.join("detuned.toml");
    let (status, out, err) = run(&["sweep", path(&case), "--vary", "U=9"]);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    let (_, curves, _) = run(&["stability", path(&case), "--format", "csv"]);
    assert_eq!(out.lines().count(), curves.lines().count());
    assert!(
        out.starts_with("U,alpha_deg,s3d_exact,s3d_companion,s3d_closed,s3d_uniform,error_exact,"),
        "{out}"
    );
    for (own, other) in out.lines().zip(curves.lines()).skip(1) {
        let (own, other): (Vec<&str>, Vec<&str>) =
            (own.split(',').collect(), other.split(',').collect());
        assert_eq!(own[1..8], other[..7]);
    }
    let vary = [
        "--vary",
        "L_g=0:0.01:5",
        "--vary",
        "alpha_deg=0:90:11",
        "--vary",
        "U=2:40:20",
    ];
    let arguments = [&["sweep", path(&case)], vary.as_slice()].concat();
    let one = Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(&arguments)
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .expect("it runs");
    let (_, all, _) = run(&arguments);
    assert_eq!(String::from_utf8_lossy(&one.stdout), all);
    let rows: Vec<&str> = all.lines().collect();
    assert_eq!(rows.len(), 1 + 5 * 20 * 11);
    assert!(
        rows[1].starts_with("0,2,0,") && rows[12].starts_with("0,4,0,"),
        "{}",
        rows[12]
    );
    assert!(rows[1100].starts_with("0.01,40,90,"));

    let worst = run(&[&arguments[..], &["--worst"]].concat()).1;
    assert_eq!(worst.lines().count(), 1 + 5 * 20);
    for (place, row) in worst.lines().skip(1).enumerate() {
        assert!(rows[1 + 11 * place..][..11].contains(&row));
        let value = |row: &str| {
            row.split(',')
                .nth(3)
                .and_then(|cell| cell.parse::<f64>().ok())
        };
        let values = rows[1 + 11 * place..][..11]
            .iter()
            .filter_map(|row| value(row));
        assert_eq!(value(row), values.reduce(f64::min));
    }
}

#[test]
fn methods_that_do_not_apply_leave_empty_cells() {
    let folder = folder("sweep_empty");
    let detuned = folder.join("detuned.toml");
    let of = |case: &Path, vary: &str, method: &str| {
        let (status, out, err) = run(&[
            "sweep",
            path(case),
            "--vary",
            "alpha_deg=30",
            "--vary",
            vary,
            "--method",
            method,
        ]);
        assert_eq!(status, Some(0), "{err}");
        out
    };
    assert_eq!(
        of(&detuned, "f_x=1", "closed"),
        "f_x,alpha_deg,s3d_closed,closed_limits\n1,30,,detuned\n"
    );
    let tuned = of(&detuned, "f=1:1.2:2", "closed");
    assert!(
        tuned
            .lines()
            .skip(1)
            .all(|row| row.ends_with(",damped") && !row.contains(",,")),
        "{tuned}"
    );
    let worst = run(&[
        "sweep",
        path(&detuned),
        "--vary",
        "U=9",
        "--method",
        "closed",
        "--worst",
    ])
    .1;
    assert_eq!(worst, "U,alpha_deg,s3d_closed,closed_limits\n9,,,detuned\n");
}

/// As a user does it at a terminal, where that is possible.
fn interrupt(child: &mut Child) {
    let is_asked = cfg!(unix)
        && Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status()
            .is_ok_and(|status| status.success());
    if !is_asked {
        child.kill().expect("it is stopped");
    }
}

/// Runs a command, and interrupts it as soon as something is begun.
fn interrupted(arguments: &[&str], is_begun: impl Fn() -> bool) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let started = Instant::now();
    while !is_begun() && started.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(1));
    }
    interrupt(&mut child);
    let ended = child.wait_with_output().expect("it is gone");
    if cfg!(unix) {
        assert_eq!(ended.status.code(), Some(2), "{ended:?}");
    }
    ended
}

#[test]
fn an_interrupted_sweep_goes_on() {
    let folder = folder("sweep_interrupted");
    let (case, out) = (folder.join("tuned.toml"), folder.join("sweep.csv"));
    let arguments = [
        "sweep",
        path(&case),
        "--vary",
        "L_g=0:0.01:1000",
        "--vary",
        "U=1:40:1000",
        "--vary",
        "alpha_deg=30",
        "--method",
        "closed",
        "--out",
        path(&out),
    ];
    let has_rows = |part: &PathBuf| part.metadata().is_ok_and(|known| known.len() > 300_000);
    let ended = interrupted(&arguments, || parts(&folder).iter().any(has_rows));
    if cfg!(unix) {
        let err = String::from_utf8_lossy(&ended.stderr);
        assert!(err.contains("the sweep was interrupted"), "{err}");
    }
    let part = parts(&folder).pop().expect("it was not done yet");
    let rows = text(&part);
    let rows = rows.lines().take(5001).map(|row| format!("{row}\n"));
    let whole: String = rows.collect();
    assert!(!out.exists());

    // Two at once would spoil each other's rows.
    let locked = std::fs::File::open(&part).expect("a file");
    locked.lock().expect("nobody else has it");
    let (status, _, err) = run(&arguments);
    assert_eq!(status, Some(2));
    assert!(err.contains("another process is writing it"), "{err}");
    drop(locked);

    // A row that was not whole is written again, and the rest is not computed twice.
    std::fs::write(&part, format!("{whole}0.0001,2")).expect("a torn row");
    let (status, _, err) = run(&arguments);
    assert_eq!(
        (status, warnings(&err)),
        (Some(0), "5000 rows are there already\n".to_owned())
    );
    assert_eq!(parts(&folder), Vec::<PathBuf>::new());
    let all = text(&out);
    assert_eq!(all.lines().count(), 1_000_001);
    let arguments_to_output: Vec<&str> = arguments[..arguments.len() - 2].to_vec();
    assert_eq!(run(&arguments_to_output).1, all);

    // What is of another computation is not gone on with.
    std::fs::write(&part, whole.replace(",30,", ",31,")).expect("wrong rows");
    let (status, _, err) = run(&arguments);
    assert_eq!(status, Some(0));
    assert!(
        err.contains("5000 rows that are there are not as this program computes them"),
        "{err}"
    );
    assert!(text(&out) == all);

    // What is left of other inputs is named.
    std::fs::write(folder.join("sweep.csv.0123.part"), "").expect("a file");
    let few = [
        "sweep",
        path(&case),
        "--vary",
        "alpha_deg=30",
        "--out",
        path(&out),
    ];
    let (status, _, err) = run(&few);
    assert!(
        status == Some(0) && err.contains("sweep.csv.0123.part is left"),
        "{err}"
    );
}

#[test]
fn what_is_wrong_is_said_before_anything_is_computed() {
    let folder = folder("sweep_wrong");
    let case = folder.join("tuned.toml");
    for (two, message) in [
        (
            ["alpha_g=1", "alpha_g_deg=3"],
            "alpha_g and alpha_g_deg set the same quantity",
        ),
        (["f_x=1", "f=2"], "f_x and f set the same quantity"),
        (
            ["zeta=0", "zeta_y=0.1"],
            "zeta and zeta_y set the same quantity",
        ),
    ] {
        let arguments = ["sweep", path(&case), "--vary", two[0], "--vary", two[1]];
        let (status, _, err) = run(&arguments);
        assert!(status == Some(2) && err.contains(message), "{err}");
    }
    for axis in ["U=0:9:4", "U=0"] {
        let arguments = ["sweep", path(&case), "--vary", "L_g=0.001", "--vary", axis];
        let (status, out, err) = run(&arguments);
        assert_eq!((status, out.as_str()), (Some(2), ""));
        assert!(
            err.contains("with L_g = 0.001, U = 0: there is no wind"),
            "{err}"
        );
    }
    let calm = text(&case).replace("U = 9 ", "U = 0 ");
    std::fs::write(folder.join("calm.toml"), calm).expect("a case");
    let (status, _, err) = run(&[
        "sweep",
        path(&folder.join("calm.toml")),
        "--vary",
        "alpha_deg=3",
    ]);
    assert!(
        status == Some(2) && err.contains("calm.toml: the case as it is: there is no wind"),
        "{err}"
    );
    let held = text(&case).replace(
        "zeta_theta = 0\n",
        "zeta_theta = 0\nfree = [\"y\", \"theta\"]\n",
    );
    std::fs::write(folder.join("held.toml"), held).expect("a case");
    let (status, _, err) = run(&["sweep", path(&folder.join("held.toml")), "--vary", "f_x=1"]);
    assert!(
        status == Some(2) && err.contains("its coordinate is held"),
        "{err}"
    );
    let (status, _, err) = run(&[
        "sweep",
        path(&case),
        "--vary",
        "U=1",
        "--out",
        path(&folder.join("a.txt")),
    ]);
    assert!(
        status == Some(2) && err.contains("not written as .txt"),
        "{err}"
    );
    for (vary, message) in [
        ("L_q=0:1:2", "did you mean `L_g`?"),
        ("theta_0=0:1:2", "vary alpha_deg"),
        ("U=2:40", "NAME=FROM:TO:COUNT"),
        ("U=2:40:0", "U has 0 values"),
        ("U=2:40:1", "one value but two ends"),
        ("U=2:inf:3", "is not finite"),
        ("U=2,5:40:3", "`2,5` is no decimal number"),
        ("U=2:40:1000001", "1 to 1000000 are possible"),
        (
            "L_g=0:0.02:3",
            "with L_g = 0.02: L_g = 0.02 must be below r",
        ),
        ("m=-1:1:3", "with m = -1: m = -1 must be above 0"),
        ("alpha_deg=0:400:3", ""),
    ] {
        let out = folder.join("sweep.csv");
        let (status, shown, err) =
            run(&["sweep", path(&case), "--vary", vary, "--out", path(&out)]);
        if message.is_empty() {
            assert_eq!(status, Some(0), "the table goes round the circle: {err}");
            continue;
        }
        assert_eq!((status, shown.as_str()), (Some(2), ""), "{vary}");
        assert!(err.contains(message), "{vary}: {err}");
        assert!(!out.exists() && parts(&folder).is_empty());
    }
    let twice = ["--vary", "U=1:2:2", "--vary", "U=3"];
    let (status, _, err) = run(&[&["sweep", path(&case)], twice.as_slice()].concat());
    assert!(
        status == Some(2) && err.contains("U is varied twice"),
        "{err}"
    );
    let many = ["--vary", "U=1:2:100000", "--vary", "m=1:2:100000"];
    let (status, _, err) = run(&[&["sweep", path(&case)], many.as_slice()].concat());
    assert!(
        status == Some(2) && err.contains("more than 1000000000 points"),
        "{err}"
    );
    let nowhere = folder.join("nowhere/sweep.csv");
    let (status, _, err) = run(&[
        "sweep",
        path(&case),
        "--vary",
        "U=1",
        "--out",
        path(&nowhere),
    ]);
    assert!(
        status == Some(2) && err.contains("there is no such file or folder"),
        "{err}"
    );
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_holds_the_rows_of_the_csv() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    let folder = folder("sweep_parquet");
    let case = folder.join("detuned.toml");
    let files = [folder.join("sweep.csv"), folder.join("sweep.parquet")];
    for file in &files {
        let (status, _, err) = run(&[
            "sweep",
            path(&case),
            "--vary",
            "U=1:9:4",
            "--out",
            path(file),
        ]);
        assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    }
    assert_eq!(parts(&folder), Vec::<PathBuf>::new());
    let file = std::fs::File::open(&files[1]).expect("a file");
    let reader = SerializedFileReader::new(file).expect("Parquet");
    let rows = text(&files[0]);
    let heading: Vec<&str> = rows.lines().next().expect("a heading").split(',').collect();
    let mut count = 0;
    for (row, line) in reader
        .get_row_iter(None)
        .expect("rows")
        .zip(rows.lines().skip(1))
    {
        let row = row.expect("a row");
        for ((name, field), (own, cell)) in row
            .get_column_iter()
            .zip(heading.iter().zip(line.split(',')))
        {
            assert_eq!(name, own);
            match field {
                Field::Null => assert_eq!(cell, ""),
                Field::Str(word) => assert_eq!(word, cell),
                // Text has fewer digits, and bounds count what they leave.
                Field::Double(value) if name.starts_with("error") => {
                    assert!(*value <= cell.parse().expect("a bound"), "{value} {cell}");
                }
                Field::Double(value) => {
                    let decimals = cell.split_once('.').map_or(0, |(_, own)| own.len() as i32);
                    let half = 0.51 * 10_f64.powi(-decimals);
                    let cell: f64 = cell.parse().expect("a number");
                    assert!((value - cell).abs() <= half, "{name}: {value} {cell}");
                }
                other => panic!("{other:?}"),
            }
        }
        count += 1;
    }
    assert_eq!(count, rows.lines().count() - 1);
}

#[cfg(feature = "parquet")]
#[test]
fn an_interrupted_sweep_to_parquet_goes_on() {
    use parquet::file::reader::{FileReader, SerializedFileReader};

    let folder = folder("sweep_parquet_interrupted");
    let (case, out) = (folder.join("tuned.toml"), folder.join("sweep.parquet"));
    let arguments = [
        "sweep",
        path(&case),
        "--vary",
        "L_g=0:0.01:2000",
        "--vary",
        "U=1:40:1000",
        "--vary",
        "alpha_deg=30",
        "--method",
        "closed",
        "--out",
        path(&out),
    ];
    let groups = |path: &Path| {
        let file = std::fs::File::open(path).expect("a file");
        let reader = SerializedFileReader::new(file).expect("Parquet");
        let groups = reader.metadata().row_groups().iter();
        groups.map(|own| own.num_rows()).collect::<Vec<_>>()
    };
    let has_groups = || {
        let entries = std::fs::read_dir(&folder).expect("a folder");
        let mut hidden = entries
            .map(|entry| entry.expect("an entry"))
            .filter(|own| own.file_name().to_string_lossy().starts_with('.'));
        hidden.any(|own| own.metadata().is_ok_and(|known| known.len() > 1000))
    };
    interrupted(&arguments, has_groups);
    if cfg!(unix) {
        let part = parts(&folder).pop().expect("it was not done yet");
        let left = groups(&part);
        assert!(
            !left.is_empty() && left.iter().all(|own| *own == 1 << 16),
            "{left:?}"
        );
        let rows: i64 = left.iter().sum();
        let (status, _, err) = run(&arguments);
        assert_eq!(status, Some(0), "{err}");
        assert_eq!(warnings(&err), format!("{rows} rows are there already\n"));
    }
    assert_eq!(parts(&folder), Vec::<PathBuf>::new());
    assert_eq!(groups(&out).iter().sum::<i64>(), 2_000_000);
    let whole = std::fs::read(&out).expect("a file");
    let (status, _, err) = run(&arguments);
    assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
    let again = std::fs::read(&out).expect("a file");
    assert!(whole == again, "{} {}", whole.len(), again.len());
}

/// Parts hold the rows of the whole, whoever computes them: what is there is kept, and what is of another sweep is
/// refused.
#[cfg(feature = "parquet")]
#[test]
fn parts_hold_the_rows_of_the_whole() {
    use parquet::file::reader::{FileReader, SerializedFileReader};

    let folder = folder("sweep_parts");
    let (case, out) = (folder.join("light.toml"), folder.join("set"));
    let rows = |path: &Path| {
        let file = std::fs::File::open(path).expect("a file");
        let reader = SerializedFileReader::new(file).expect("Parquet");
        let rows = reader.get_row_iter(None).expect("rows");
        rows.map(|row| row.expect("a row").to_string())
            .collect::<Vec<_>>()
    };
    let sweep = |vary: &str, more: &[&str]| {
        let most = [
            "sweep",
            path(&case),
            "--vary",
            vary,
            "--set",
            "alpha_deg=30",
        ];
        run(&[&most, more].concat())
    };
    let (whole, target) = (folder.join("whole.parquet"), path(&out));
    assert_eq!(sweep("U=2:40:10", &["--out", path(&whole)]).0, Some(0));
    let in_parts = ["--parts", "3", "--out", target];
    let (status, out_text, _) = sweep("U=2:40:10", &[&in_parts[..], &["--part", "2"]].concat());
    let second = out.join("part-00002-of-00003.parquet");
    assert_eq!(
        (status, out_text),
        (Some(0), format!("{}: 3 rows\n", second.display()))
    );
    // A killed process leaves no file under the name of a part.
    std::fs::write(out.join(".sextic-killed"), "half").expect("a file");
    let (status, _, err) = sweep("U=2:40:10", &in_parts);
    assert_eq!(status, Some(0), "{err}");
    assert!(
        err.contains(&format!("{} is there already", second.display())),
        "{err}"
    );
    let names = (1..=3).map(|own| out.join(format!("part-{own:05}-of-00003.parquet")));
    assert_eq!(
        names.flat_map(|own| rows(&own)).collect::<Vec<_>>(),
        rows(&whole)
    );
    // The last rows of both sweeps are the same.
    let last = [&in_parts[..], &["--part", "3"]].concat();
    let (status, _, err) = sweep("U=3:40:10", &last);
    assert!(
        status == Some(2) && err.contains("is no part of this sweep"),
        "{err}"
    );
    let (status, _, err) = sweep("U=2:40:10", &["--parts", "11", "--out", target]);
    assert!(
        status == Some(2) && err.contains("10 rows have no 11 parts"),
        "{err}"
    );
}
