//! Files that are read and files that are written: none is both, and messages quote little of them.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::{folder, run, warnings};

fn path(path: &Path) -> &str {
    path.to_str().expect("a path")
}

/// No command writes over a file that it reads, by whatever name it is called.
#[test]
fn outputs_spare_what_is_read() {
    let folder = folder("spared");
    let (case, table) = (folder.join("case.svg"), folder.join("stability.svg"));
    let text = std::fs::read_to_string(folder.join("tuned.toml")).expect("a case");
    std::fs::write(&case, text.replace("formulas.csv", "stability.svg")).expect("a case");
    std::fs::copy(folder.join("formulas.csv"), &table).expect("a table");
    let read = [&case, &table].map(|own| std::fs::read(own).expect("a file"));
    let detour = folder.join("../spared/case.svg");
    let linked = folder.join("linked.svg");
    std::fs::hard_link(&table, &linked).expect("a link");
    let mut outputs = vec![case.clone(), table.clone(), detour];
    if cfg!(unix) {
        outputs.push(linked);
    }
    let own = path(&case);
    for output in &outputs {
        let output = path(output);
        for command in ["stability", "speeds", "validity"] {
            let (status, out, err) = run(&[command, own, "--plot", output]);
            assert_eq!((status, out.as_str()), (Some(2), ""), "{command} {output}");
            assert!(err.contains("which is read"), "{command} {output}: {err}");
        }
    }
    let (status, _, err) = run(&["figures", own, "--out", path(&folder)]);
    assert!(status == Some(2) && err.contains("which is read"), "{err}");

    let text = text.replace("formulas.csv", "table.csv");
    let (case, table) = (folder.join("plain"), folder.join("table.csv"));
    std::fs::write(&case, text).expect("a case");
    std::fs::copy(folder.join("formulas.csv"), &table).expect("a table");
    for output in [&case, &table] {
        let vary = [
            "sweep",
            path(&case),
            "--vary",
            "U=2:3:2",
            "--out",
            path(output),
        ];
        let (status, _, err) = run(&vary);
        assert!(status == Some(2) && err.contains("which is read"), "{err}");
    }
    let (status, _, err) = run(&["report", "--case", path(&case), "--out", path(&case)]);
    assert!(status == Some(2) && err.contains("which is read"), "{err}");
    let document = folder.join("document.html");
    std::fs::write(
        &document,
        "# A document\n\n```sextic\nparameter a : 1\nclaim [one]: a == a\n```\n",
    )
    .expect("a document");
    let (status, _, err) = run(&["report", path(&document), "--out", path(&document)]);
    assert!(status == Some(2) && err.contains("which is read"), "{err}");
    for (file, bytes) in [folder.join("case.svg"), folder.join("stability.svg")]
        .iter()
        .zip(read)
    {
        assert_eq!(std::fs::read(file).expect("a file"), bytes);
    }
}

/// However long an input is, a message quotes a part of a line, and is there soon.
#[test]
fn messages_quote_a_line_at_most() {
    let folder = folder("long");
    let long = "7".repeat(5_000_000);
    let case = std::fs::read_to_string(folder.join("tuned.toml")).expect("a case");
    let table = std::fs::read_to_string(folder.join("formulas.csv")).expect("a table");
    let own = folder.join("tuned.toml");
    let refused = |what: &str, said: &str| {
        let started = Instant::now();
        let (status, out, err) = run(&["stability", path(&own)]);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{what}");
        assert!(
            err.contains(said),
            "{what}: {}",
            &err[..err.len().min(2000)]
        );
        assert!(
            err.lines().all(|line| line.chars().count() < 1000),
            "{what}"
        );
        assert!(started.elapsed() < Duration::from_secs(20), "{what}");
    };
    for (old, new, said) in [
        ("alpha_g_deg", long.clone(), "there is no key"),
        ("[wind]", format!("[a{long}]"), "there is no table"),
        ("\"section\"", format!("\"{long}\""), "unknown variant"),
        ("formulas.csv", long.clone(), "cannot be read"),
        (
            "[structure]",
            format!("[structure]\nfree = [\"{long}\"]"),
            "there is no coordinate",
        ),
        ("L_a", "L\u{1b}[31m\u{202e}".to_string(), ""),
    ] {
        let text = case.replacen(old, &new, 1);
        assert_ne!(text, case, "{old}");
        std::fs::write(&own, text).expect("a case");
        refused(old, said);
    }
    std::fs::write(&own, &case).expect("a case");
    for (old, new, said) in [
        ("alpha_deg", format!("a{long}"), "no column means alpha_deg"),
        ("\n2,", format!("\n{long}x,"), "is no number"),
        ("\n2,", format!("\n{long},"), "is no number"),
    ] {
        std::fs::write(folder.join("formulas.csv"), table.replacen(old, &new, 1)).expect("a table");
        refused(old, said);
    }
    // What would change the look of a message is written as its code.
    let strange = table.replacen("\n2,", "\n\u{1b}[2J\u{202e},", 1);
    std::fs::write(folder.join("formulas.csv"), strange).expect("a table");
    let (_, _, err) = run(&["stability", path(&own)]);
    assert!(
        err.contains("`\\u{1b}[2J\\u{202e}`") && !err.contains('\u{202e}'),
        "{err}"
    );
}

/// What another sweep is writing is told from what an interrupted one left.
#[test]
fn rows_that_are_being_written_are_told_from_those_that_were_left() {
    let folder = folder("sweep_beside");
    let (case, out) = (folder.join("tuned.toml"), folder.join("sweep.csv"));
    let mut other = Command::new(env!("CARGO_BIN_EXE_sextic"))
        .args([
            "sweep",
            path(&case),
            "--vary",
            "L_g=0:0.01:1000",
            "--vary",
            "U=1:40:1000",
        ])
        .args(["--out", path(&out)])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    let part = || {
        let entries = std::fs::read_dir(&folder).expect("a folder");
        let mut paths = entries.map(|entry| entry.expect("an entry").path());
        paths.find(|own| own.extension().is_some_and(|own| own == "part"))
    };
    let started = Instant::now();
    while part().is_none() && started.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(1));
    }
    // The lock follows the file at once.
    std::thread::sleep(Duration::from_millis(500));
    let vary = [
        "sweep",
        path(&case),
        "--vary",
        "U=2:3:2",
        "--worst",
        "--out",
        path(&out),
    ];
    let (status, _, beside) = run(&vary);
    other.kill().expect("it is stopped");
    other.wait().expect("it is gone");
    assert_eq!(status, Some(0), "{beside}");
    assert!(
        beside.contains("is being written by another sweep") && !beside.contains("interrupted"),
        "{beside}"
    );
    let (_, _, left) = run(&vary);
    assert!(
        left.contains("is left of a sweep with other inputs that was interrupted"),
        "{left}"
    );
}

/// A table with a hole, by every command that reads one: nothing is known in it, and what is odd is said.
#[test]
fn what_is_odd_about_a_table_is_said_by_every_command() {
    let folder = folder("odd");
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tables");
    let case = std::fs::read_to_string(folder.join("light.toml")).expect("a case");
    let own = folder.join("light.toml");
    let sweep = case
        .lines()
        .find(|line| line.starts_with("alpha_deg = "))
        .expect("a sweep");
    let with = |table: &str, from: f64, to: f64| {
        let steps = format!("alpha_deg = {{ from = {from}, to = {to}, step = 10 }}");
        std::fs::write(&own, case.replace(sweep, &steps)).expect("a case");
        std::fs::copy(tables.join(table), folder.join("formulas.csv")).expect("a table");
    };
    let figures = folder.join("figures");
    let commands = [
        vec!["stability", path(&own), "--format", "csv"],
        vec!["speeds", path(&own)],
        vec!["sweep", path(&own), "--vary", "U=9"],
        vec!["validity", path(&own), "--format", "csv"],
        vec!["figures", path(&own), "--out", path(&figures)],
    ];
    for command in &commands {
        with("hole.csv", 80.0, 280.0);
        let (status, out, err) = run(command);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{command:?}");
        assert!(
            err.contains("100° is in a hole of the table, between 90° and 270°"),
            "{err}"
        );
        with("hole.csv", 270.0, 440.0);
        let (status, _, err) = run(command);
        assert_eq!(status, Some(0), "{command:?} {err}");
        assert!(
            err.contains("Warning: ") && err.contains("has a hole"),
            "{command:?} {err}"
        );
        with("rounded_ends.csv", 170.0, 190.0);
        let (status, _, err) = run(command);
        assert!(
            status == Some(0) && err.contains("read as -180°"),
            "{command:?} {err}"
        );
    }
    let (_, out, err) = run(&["stability", path(&own)]);
    let out = out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        warnings(&err).is_empty() && out.contains("both are read as -180°"),
        "{out} {err}"
    );
}

#[test]
fn every_command_says_what_it_reads_of_a_table() {
    let own = folder("said");
    let case = own.join("detuned.toml");
    let text = std::fs::read_to_string(&case).expect("a case");
    let text = text.replace("from = 0, to = 180", "from = -30, to = -30");
    let table = std::fs::read_to_string(own.join("formulas.csv")).expect("a table");
    let is_half = |line: &&str| {
        let angle = line
            .split(',')
            .next()
            .and_then(|own| own.parse::<f64>().ok());
        angle.is_none_or(|own| own <= 180.0)
    };
    let half: Vec<&str> = table.lines().filter(is_half).collect();
    let half = half.join("\n").replace("alpha_deg,CL", "Winkel,ca");
    std::fs::write(own.join("half.csv"), half).expect("a table");
    let columns = "columns = { alpha_deg = \"Winkel\", CL = \"ca\" }\nmirror = true";
    let mirrored = text.replace("formulas.csv\"", &format!("half.csv\"\n{columns}"));
    let mirrored = mirrored.replace("formulas", "half");
    let (half, whole) = (own.join("half.toml"), own.join("whole.toml"));
    std::fs::write(&half, mirrored).expect("a case");
    std::fs::write(&whole, text).expect("a case");
    let [half, whole] = [&half, &whole].map(|path| path.to_str().expect("a path"));
    let [sweep, figures, report] = ["sweep.csv", "figures", "page.html"]
        .map(|name| own.join(name).to_string_lossy().into_owned());
    let commands: [&[&str]; 7] = [
        &["stability", half],
        &["speeds", half],
        &["validity", half],
        &["modes", half],
        &["figures", half, "--out", &figures],
        &["report", "--case", half, "--out", &report],
        &["sweep", half, "--vary", "U=2:4:2", "--out", &sweep],
    ];
    for command in commands {
        let (status, _, err) = run(command);
        assert_eq!((status, warnings(&err)), (Some(0), String::new()));
        assert_eq!(err.lines().count(), 2, "{err}");
        for part in [
            "half.csv: 91 rows from 0° to 180°, continued by symmetry about 0°, once round the circle; period 360°",
            "; cubic splines between them\n",
            "Columns alpha_deg = `Winkel`, CL = `ca`, CD, CM; derivatives of the curves\n",
        ] {
            assert!(err.contains(part), "{command:?} {err}");
        }
    }
    // The half says what the whole table says.
    let rows = |case: &str| run(&["speeds", case, "--format", "csv"]).1;
    assert_eq!(rows(half), rows(whole));
}
