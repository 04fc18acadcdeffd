//! Systems that documents derive, as a user computes them.

use serde_json::Value;

use super::{folder, run};

const PENDULUM: &str = "derivations/pendulum.md";
const BRIDGE: [&str; 23] = [
    "tests/data/systems/bridge.md",
    "--system",
    "bridge",
    "--set",
    "m=10000",
    "--set",
    "J=1000000",
    "--set",
    "e=1",
    "--set",
    "k_h=10000",
    "--set",
    "k_a=4000000",
    "--set",
    "k_j=2000",
    "--set",
    "zeta=0.005",
    "--set",
    "rho=1.2",
    "--set",
    "B=30",
    "--set",
    "L=4",
];

fn json(arguments: &[&str]) -> Value {
    let (status, out, err) = run(&[arguments, &["--format", "json"]].concat());
    assert_eq!((status, err.as_str()), (Some(0), ""));
    serde_json::from_str(&out).expect("JSON")
}

/// With the load P of Ziegler's pendulum, over k/l.
fn pendulum(damping: &str) -> Value {
    json(&[
        "speeds", PENDULUM, "--set", "m=1", "--set", "l=1", "--set", "k=1", "--set", damping,
        "--over", "P=0:4",
    ])
}

#[test]
fn ziegler_s_pendulum_flutters_at_the_loads_known_by_hand() {
    let undamped = pendulum("c=0");
    let critical = undamped["critical"].as_array().expect("critical values");
    // Without damping it flutters between 7/2 − √2 and 7/2 + √2, and is neutral below.
    let (value, error) = (&critical[0]["value"], &critical[0]["error"]);
    let (value, error) = (value.as_f64().unwrap(), error.as_f64().unwrap());
    assert!(
        (value - (3.5 - 2_f64.sqrt())).abs() <= error && error < 1e-8,
        "{undamped}"
    );
    assert_eq!(undamped["ranges"][0]["verdict"], "neutral");

    // A little damping lowers the load: 41/28 + c²/(2 m k l²).
    let damped = pendulum("c=0.01");
    let critical = damped["critical"].as_array().expect("critical values");
    let value = critical[0]["value"].as_f64().unwrap();
    assert!((value - (41.0 / 28.0 + 0.5e-4)).abs() < 1e-8, "{damped}");
    assert_eq!(damped["ranges"][0]["verdict"], "stable");
}

/// Nothing linear about these: what lies between the ends of a part is enclosed, or nothing is certain of it.
#[test]
fn ranges_are_those_known_by_hand() {
    let pi = std::f64::consts::PI;
    for (system, over, critical, verdicts) in [
        ("power", "U=0:10", vec![1.0], vec!["unstable", "stable"]),
        ("high_power", "U=0:2", vec![1.0], vec!["unstable", "stable"]),
        ("quotient", "U=0:10", vec![1.0], vec!["unstable", "stable"]),
        ("turn", "beta=1:4", vec![pi], vec!["stable", "divergent"]),
        (
            "swing",
            "beta=0:6",
            vec![0.5 * pi, 1.5 * pi],
            vec!["stable", "unstable", "stable"],
        ),
        ("pole", "U=0:2", vec![], vec!["divergent"]),
        ("root", "U=0:10", vec![1.0], vec!["unstable", "stable"]),
    ] {
        let found = json(&[
            "speeds",
            "tests/data/systems/ranges.md",
            "--system",
            system,
            "--set",
            "w=1",
            "--over",
            over,
        ]);
        let values: Vec<f64> = found["critical"]
            .as_array()
            .unwrap()
            .iter()
            .map(|own| own["value"].as_f64().unwrap())
            .collect();
        assert_eq!(values.len(), critical.len(), "{system}: {found}");
        for (own, by_hand) in values.iter().zip(&critical) {
            assert!((own - by_hand).abs() < 1e-8, "{system}: {found}");
        }
        // A real eigenvalue above 0 is told from other growth as far as that is certain.
        let merged = |name: &str| {
            if name == "divergent" && system != "turn" && system != "pole" {
                "unstable"
            } else {
                name
            }
            .to_string()
        };
        let mut names: Vec<String> = found["ranges"]
            .as_array()
            .unwrap()
            .iter()
            .map(|own| merged(own["verdict"].as_str().unwrap()))
            .collect();
        names.retain(|own| own != "undecided");
        names.dedup();
        assert_eq!(names, verdicts, "{system}: {found}");
    }
}

#[test]
fn a_bridge_has_its_critical_speeds_after_one_command() {
    let found = json(
        &[
            &["speeds"],
            &BRIDGE[..],
            &["--set", "N=1", "--over", "U=0:200"],
        ]
        .concat(),
    );
    let critical = found["critical"].as_array().expect("critical values");
    assert!(!critical.is_empty(), "{found}");
    for own in critical {
        let speed = own["value"].as_f64().unwrap();
        let verdict = |at: f64| {
            let speed = format!("U={at}");
            let found =
                json(&[&["modes"], &BRIDGE[..], &["--set", "N=1", "--set", &speed]].concat());
            found["verdict"].as_str().unwrap().to_string()
        };
        assert_ne!(verdict(speed - 0.01), verdict(speed + 0.01), "{found}");
    }
}

#[test]
fn rows_of_a_sweep_are_those_of_single_modes() {
    let arguments = [
        &["sweep"],
        &BRIDGE[..],
        &["--vary", "N=-1:1:3", "--vary", "U=5:80:4"],
    ]
    .concat();
    let (status, out, err) = run(&arguments);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    let rows: Vec<Vec<&str>> = out.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(
        rows[0],
        ["N", "U", "growth", "error", "frequency_hz", "verdict"]
    );
    assert_eq!(rows.len(), 13);
    for row in &rows[1..] {
        let (slope, speed) = (format!("N={}", row[0]), format!("U={}", row[1]));
        let found = json(&[&["modes"], &BRIDGE[..], &["--set", &slope, "--set", &speed]].concat());
        let values = found["eigenvalues"].as_array().unwrap().iter();
        let largest = values
            .map(|own| own["re"].as_f64().unwrap())
            .fold(f64::MIN, f64::max);
        let growth: f64 = row[2].parse().unwrap();
        let error: f64 = row[3].parse().unwrap();
        assert!(
            (growth - largest).abs() <= 2.0 * error + 1e-12,
            "{row:?}: {found}"
        );
        assert_eq!(found["verdict"], row[5]);
    }
    let folder = folder("system-sweep");
    let out = folder.join("map.csv");
    let out = out.to_str().expect("a path");
    let (status, shown, err) = run(&[&arguments[..], &["--out", out]].concat());
    assert_eq!((status, err.as_str()), (Some(0), ""));
    assert!(shown.ends_with("map.csv: 12 rows\n"), "{shown}");
}

#[test]
fn modes_of_a_document_have_shapes_in_its_own_names() {
    let base = [
        "modes", PENDULUM, "--set", "m=1", "--set", "l=1", "--set", "k=1", "--set", "P=0", "--set",
        "c=0",
    ];
    let (status, out, err) = run(&[&base[..], &["--shapes"]].concat());
    assert_eq!((status, err.as_str()), (Some(0), ""));
    // λ² = −7/2 ± √(41)/2: 2.5886 and 0.3863 rad/s.
    assert!(out.contains("φ_1 ") && out.contains("φ_2 1"), "{out}");
    assert!(
        out.contains("The system is undecided: a real part is exactly 0"),
        "{out}"
    );
    let companion = json(&[&base[..], &["--method", "companion"]].concat());
    let state = json(&base);
    for (a, b) in [0, 1].map(|place| {
        (
            &companion["eigenvalues"][place],
            &state["eigenvalues"][place],
        )
    }) {
        let difference = a["im"].as_f64().unwrap() - b["im"].as_f64().unwrap();
        assert!(difference.abs() <= a["error"].as_f64().unwrap() + b["error"].as_f64().unwrap());
    }
}

#[test]
fn what_is_wrong_with_a_system_is_told() {
    let set = ["--set", "m=1", "--set", "l=1"];
    let (status, out, err) = run(&[&["modes", PENDULUM], &set[..]].concat());
    assert_eq!((status, out.as_str()), (Some(2), ""));
    for name in ["k=…", "P=…", "c=…"] {
        assert!(err.contains(name), "{name}: {err}");
    }
    for (arguments, message) in [
        (
            vec!["modes", PENDULUM, "--system", "pendulom"],
            "did you mean `pendulum`?",
        ),
        (
            vec!["modes", PENDULUM, "--set", "m=1", "--set", "m=2"],
            "`m` is set twice",
        ),
        (
            vec!["modes", "--system", "nothing"],
            "there is no system `nothing`",
        ),
        (
            vec!["modes", "tests/data/verdicts/angles.md"],
            "has no system",
        ),
        (vec!["speeds", PENDULUM], "`--over U=0:100`"),
        (
            vec![
                "speeds", PENDULUM, "--over", "P=3:1", "--set", "m=1", "--set", "l=1", "--set",
                "k=1", "--set", "c=0",
            ],
            "width",
        ),
        (
            vec![
                "sweep", PENDULUM, "--vary", "q=1:2:3", "--set", "m=1", "--set", "l=1", "--set",
                "k=1", "--set", "c=0", "--set", "P=0",
            ],
            "q",
        ),
        (
            vec!["modes", PENDULUM, "--method", "closed"],
            "`--method state`",
        ),
        (
            vec!["compare", PENDULUM],
            "no evaluator approximates a system",
        ),
        (
            vec![
                "modes",
                "tests/data/systems/bridge.md",
                "--set",
                "m=1",
                "--set",
                "J=1",
                "--set",
                "e=1",
                "--set",
                "k_h=1",
                "--set",
                "k_a=1",
                "--set",
                "k_j=0",
                "--set",
                "zeta=0",
                "--set",
                "rho=1",
                "--set",
                "B=1",
                "--set",
                "U=0",
                "--set",
                "L=0",
                "--set",
                "N=0",
            ],
            "determinant",
        ),
        (
            vec![
                "modes", PENDULUM, "--set", "m=-1", "--set", "l=1", "--set", "k=1", "--set", "c=0",
                "--set", "P=0",
            ],
            "contradicts the assumption m > 0",
        ),
        (
            vec![
                "speeds", PENDULUM, "--set", "m=1", "--set", "l=1", "--set", "k=1", "--set", "P=0",
                "--over", "c=-1:1",
            ],
            "contradicts the assumption c ≥ 0",
        ),
        (
            vec!["sweep", PENDULUM, "--set", "P=1", "--vary", "P=0:1:2"],
            "`P` has a value by `--set`, and moves",
        ),
        (
            vec![
                "sweep",
                PENDULUM,
                "--vary",
                "P=0:1:100000",
                "--vary",
                "c=0:1:100000",
            ],
            "more than 1000000000 points",
        ),
    ] {
        let (status, out, err) = run(&arguments);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(err.contains(message), "{arguments:?}: {err}");
    }
}

/// The closed forms of the documents, at 200 points of their domains.
#[test]
fn closed_forms_are_compared_with_their_systems() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/closeness"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for document in ["he-macdonald-2017", "uniform", "two-degrees"] {
            let path = format!("derivations/{document}.md");
            let (status, out, err) = run(&["compare", &path, "--points", "200"]);
            assert_eq!((status, err.as_str()), (Some(0), ""));
            insta::assert_snapshot!(document, out);
        }
    });
}

#[test]
fn a_form_that_is_exact_is_told_from_one_that_is_wrong() {
    let found = json(&[
        "compare",
        "tests/data/systems/eigenvalues.md",
        "--points",
        "50",
    ]);
    let [known, wrong] = [0, 1].map(|place| &found["forms"][place]);
    assert_eq!(known["approximates"], "eigenvalues");
    assert!(known["errors"]["largest"].as_f64() < Some(1e-14), "{known}");
    assert_eq!(
        (&known["decided"], &known["wrong_signs"]),
        (&50.into(), &0.into())
    );
    // The real part is that of the system, but for its sign.
    assert_eq!(wrong["errors"]["median"], 2.0, "{wrong}");
    assert_eq!(wrong["wrong_signs"], 50);
    assert!(wrong["first_wrong"].is_object());
}

/// The roots of a polynomial stand for numbers of a system.
#[test]
fn a_polynomial_is_compared_by_its_roots() {
    let path = "tests/data/systems/roots.md";
    let found = json(&["compare", path, "--points", "50"]);
    for (place, (name, approximates, error, wrong_signs)) in [
        ("known", "eigenvalues", 0.0, 0),
        ("known_parts", "real parts", 0.0, 0),
        ("shifted", "real parts", 0.0, 0),
        // Conjugates are twice an imaginary part apart, and that is nearly the eigenvalue.
        ("lower", "eigenvalues", 2.0, 0),
        ("growing", "real parts", 2.0, 50),
    ]
    .into_iter()
    .enumerate()
    {
        let form = &found["forms"][place];
        assert_eq!(form["evaluator"], name);
        assert_eq!(form["approximates"], approximates);
        assert_eq!(form["by_roots"], true);
        assert_eq!(form["wrong_signs"], wrong_signs, "{form}");
        let largest = form["errors"]["largest"].as_f64().expect("an error");
        let bound = if error == 0.0 { 1e-13 } else { 0.5 };
        assert!((largest - error).abs() < bound, "{form}");
    }
}

#[test]
fn what_is_wrong_with_an_imported_system_is_told_where_it_is_asked_for() {
    let (status, out, err) = run(&["compare", "tests/data/systems/importing.md"]);
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert!(err.contains("importing.md:5:61"), "{err}");
}
