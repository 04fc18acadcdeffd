//! The emitted Octave, run with Octave.

use std::path::{Path, PathBuf};
use std::process::Command;

use sextic_codegen::language::Language;

use crate::consumer;

/// A folder with the samples, if Octave is there.
fn samples(name: &str) -> Option<PathBuf> {
    if !consumer::present("octave-cli", &["--version"]) {
        return None;
    }
    let folder = consumer::folder(name);
    consumer::write(&folder, Language::Octave);
    Some(folder)
}

/// What Octave prints in a folder.
fn run(folder: &Path, arguments: &[&str], input: &str) -> String {
    let mut octave = Command::new("octave-cli");
    octave.args(["--quiet", "--norc", "--path"]).arg(folder);
    consumer::run(octave.args(arguments), input)
}

#[test]
fn scalars_and_arrays_give_the_same_bits() {
    let Some(folder) = samples("octave") else {
        return;
    };
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/consumer.m");
    let program = program.to_str().unwrap();
    consumer::check(&run(&folder, &[program], &consumer::questions()), false);
}

/// Angles are taken for their sines and cosines, with the digits of the library.
#[test]
fn angles_are_as_good_as_their_sines_and_cosines() {
    let Some(folder) = samples("octave-angles") else {
        return;
    };
    let calls = "theta = [0; 0.5; -3; 40]; beta = [0, -2, 7];\n\
        a = rod(struct('L', 2, 'theta_0', theta, 'beta', beta));\n\
        b = rod(struct('L', single(2), 'cos_alpha_g_plus_theta_0', cos(0.3 + theta), ...\n\
        'sin_alpha_g_plus_theta_0', sin(0.3 + theta), 'cos_2_beta_minus_theta_0', cos(2*beta - theta)));\n\
        disp(isequal(a, b)); disp(size(a.ratio));";
    let found = run(&folder, &["--eval", calls], "");
    let found: Vec<&str> = found.split_whitespace().collect();
    assert_eq!(found, ["1", "4", "3"]);
}

#[test]
fn help_shows_what_a_function_says() {
    let Some(folder) = samples("octave-help") else {
        return;
    };
    let calls = "[text, kind] = get_help_text('rod'); disp(kind); disp(text);";
    let found = run(&folder, &["--eval", calls], "");
    for line in [
        "plain text",
        " Where a turned rod ends.",
        "     result = rod(given)",
        " - `L`: In `m`.",
        " - `reach`: No unit.",
        " - `theta_0`: Turn of the section at rest (θ_0), in `rad`.",
        " Nothing is proven of this text.",
    ] {
        assert!(found.lines().any(|own| own == line), "{line}: {found}");
    }
}

#[test]
fn what_is_not_given_well_is_refused_with_what_to_do() {
    let Some(folder) = samples("octave-errors") else {
        return;
    };
    let whole = "'a', 1, 'b', 2, 'c', 3, 'x', 4";
    for (call, message) in [
        (
            "quadratic_form()".to_owned(),
            "quadratic_form needs its inputs: see help quadratic_form",
        ),
        (
            "quadratic_form(7)".to_owned(),
            "quadratic_form needs one structure whose fields are arrays, or a table",
        ),
        (
            format!("quadratic_form(struct({whole}, 'y', {{{{}}}}))"),
            "quadratic_form needs real numbers in y: convert it",
        ),
        (
            format!("quadratic_form(struct({whole}, 'y', {{1, 2}}))"),
            "quadratic_form needs one structure whose fields are arrays, or a table",
        ),
        (
            format!("quadratic_form(struct({whole}))"),
            "quadratic_form needs y: add a field or column of this name",
        ),
        (
            format!("quadratic_form(struct({whole}, 'y', 'text'))"),
            "quadratic_form needs real numbers in y: convert it",
        ),
        (
            format!("quadratic_form(struct({whole}, 'y', 2i))"),
            "quadratic_form needs real numbers in y: convert it",
        ),
        (
            "quadratic_form(struct('a', [1 2 3], 'b', ones(4, 1), 'c', 1, 'x', 2, 'y', ones(2, 3)))".to_owned(),
            "quadratic_form: y has size [2 3], the inputs before it [4 3]; make them equal, or 1",
        ),
        (
            "rod(struct('L', 2, 'theta_0', 1))".to_owned(),
            "rod needs beta: add a field or column of this name",
        ),
    ] {
        let calls = format!("try, {call}; catch e, disp(e.message); disp(e.identifier); end");
        let found = run(&folder, &["--eval", &calls], "");
        let (first, identifier) = found.split_once('\n').unwrap();
        assert_eq!(first, message, "{call}");
        assert!(identifier.starts_with("sextic:"), "{identifier}");
    }
    // Nothing is an array, too, and whole numbers and truth are numbers.
    let calls = format!(
        "disp(size(quadratic_form(struct({whole}, 'y', zeros(0, 1))).slope)); \
         disp(quadratic_form(struct('a', int8(3), 'b', true, 'c', 0, 'x', 1, 'y', 1)).value)"
    );
    let found = run(&folder, &["--eval", &calls], "");
    let found: Vec<&str> = found.split_whitespace().collect();
    assert_eq!(found, ["0", "1", "2"]);
}
