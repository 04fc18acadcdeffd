//! `sextic modes` as a user runs it.

use serde_json::Value;

use super::{run, warnings};

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
fn s_has_the_name_of_what_is_free() {
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/derivations/cases/square.toml");
    let (status, out, err) = run(&["modes", case, "--alpha", "0"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(out.contains("S_1D = ") && !out.contains("S_3D"), "{out}");
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

/// S_xx = S_yy couples nothing: sway and heave have one eigenvalue and two shapes; the turn is neutral.
#[test]
fn modes_that_coincide_have_shapes_of_their_own() {
    let calm = SECTION.map(|own| match own {
        "L_g=0.004" => "L_g=0",
        "U=0" => "U=9",
        other => other,
    });
    let wind = "rho=1.25 D=0.05 S_xx=2 S_xy=0 S_yx=0 S_yy=2 S_tx=0 S_ty=0 S_xt=0 S_yt=0 S_tt=0";
    let section = [&calm[..], &wind.split_whitespace().collect::<Vec<_>>()].concat();
    let (status, out, _) = modes(&section, &["--shapes"]);
    assert_eq!(status, Some(0));
    for shape in ["x 1, y 0, rθ 0", "x 0, y 1, rθ 0", "x 0, y 0, rθ 1"] {
        assert_eq!(out.matches(shape).count(), 1, "{out}");
    }
    // It is exactly 0, and no doubt is left.
    assert!(
        out.contains("exactly 0") && !out.contains("not certain"),
        "{out}"
    );
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
            assert_eq!((status, warnings(&err)), (Some(0), String::new()), "{err}");
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
    let diverging = ["--set", "dC_M=0.6", on];
    let (_, out, _) = modes(&section, &diverging);
    let lines = |what: &str| out.lines().filter(|line| line.contains(what)).count();
    let counts = ["1/s, within", " Hz", "no oscillation", "it diverges"].map(lines);
    assert_eq!(counts, [5, 1, 4, 1], "{out}");
    // Exactly where it begins to diverge: that it does is not certain, and not said.
    let neutral = "m=1 r=1 L_g=0 alpha_g=0 theta_0=0 omega_x=1 omega_y=0.75 omega_theta=0.35 zeta_x=0 zeta_y=0.1 \
                   zeta_theta=0.1 U=1 rho=1 D=1 alpha_0=0 L_a=0 gamma_r=0 C_D=1 C_L=0 C_M=0 dC_D=0 dC_L=0 dC_M=0.245";
    let neutral: Vec<&str> = neutral.split_whitespace().collect();
    let (_, out, _) = modes(&neutral, &[on]);
    assert!(
        out.contains("no oscillation") && !out.contains("diverges"),
        "{out}"
    );
    assert!(out.contains("undecided"), "{out}");
    let exact = ["--method", "exact", "--format", "json"];
    let (_, out, _) = modes(&section, &[&diverging[..], &exact].concat());
    let json: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(json["method"], "state", "{out}");
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
}

/// The companion matrix loses all digits of three motions that coincide: that is said, and nothing is 0.
#[test]
fn what_is_not_known_is_not_printed_as_0() {
    let section = "m=2 r=1 L_g=0 alpha_g=0 theta_0=0 omega_x=1 omega_y=1 omega_theta=1 zeta_x=0 zeta_y=0 zeta_theta=0 \
                   rho=1 D=1 U=2e-6 S_xx=-2 S_xy=-1 S_xt=0 S_yx=0 S_yy=1 S_yt=-1 S_tx=1 S_ty=0 S_tt=0";
    let section: Vec<&str> = section.split_whitespace().collect();
    let (_, out, _) = modes(&section, &["--method", "companion"]);
    assert!(out.contains(": not a digit of it is certain"), "{out}");
    assert!(!out.contains("S_3D = 0"), "{out}");
    let (_, out, _) = modes(&section, &["--method", "companion", "--format", "json"]);
    let json: Value = serde_json::from_str(&out).expect("JSON");
    let number = |name: &str| json[name].as_f64().expect("a number");
    // A root of λ³ + λ² − 2λ − 1, from long arithmetic.
    assert!(
        (number("s3d") + 1.801_937_735_804_838).abs() <= number("s3d_error"),
        "{out}"
    );
    let (_, out, _) = modes(&section, &["--format", "json"]);
    let json: Value = serde_json::from_str(&out).expect("JSON");
    let [own, error] = ["s3d", "s3d_error"].map(|name| json[name].as_f64().expect("a number"));
    assert!(
        (own + 1.801_937_735_804_838).abs() <= error + 1e-5 && error < 1e-3,
        "{out}"
    );
}

/// Strong negative damping of heave, without an oscillation: it gallops, in every command.
#[test]
fn what_gallops_without_an_oscillation_does_not_diverge() {
    let section = "m=2 r=1 L_g=0 alpha_g=0 theta_0=0 omega_x=1 omega_y=1 omega_theta=1 zeta_x=0 zeta_y=0 zeta_theta=0 \
                   rho=1 D=1 U=20 alpha_0=0 L_a=0 gamma_r=0 C_D=1 C_L=0 C_M=0 dC_D=0 dC_L=-3 dC_M=0";
    let section: Vec<&str> = section.split_whitespace().collect();
    let (_, out, _) = modes(&section, &[]);
    assert!(
        out.contains("no oscillation: it gallops") && !out.contains("diverges"),
        "{out}"
    );
    let folder = super::folder("gallops");
    let case = folder.join("tuned.toml");
    let text = std::fs::read_to_string(&case).expect("a case");
    let text = text
        .replace("U = 9 ", "U = 900 ")
        .replace("step = 0.5", "step = 10")
        .replacen("[structure]", "[structure]\nfree = [\"y\"]", 1);
    std::fs::write(&case, text).expect("a case");
    let case = case.to_str().expect("a path");
    let (_, out, err) = super::run(&["stability", case]);
    assert!(
        out.contains("The section gallops in ") && out.contains("  none "),
        "{out} {err}"
    );
    let (_, speeds, _) = super::run(&["speeds", case, "--to", "1000"]);
    for out in [out, speeds] {
        assert!(
            out.contains("gallops") && !out.contains("diverges"),
            "{out}"
        );
    }
}
