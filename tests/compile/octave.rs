//! The evaluators that come with the command, in Octave.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use sextic::compile::specification::Specification;
use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{Language, renamed};

use super::{audits, files_of, specifications};

/// So many points of each evaluator are compared.
const POINTS: usize = 200;

fn is_there() -> bool {
    let found = Command::new("octave-cli").arg("--version").output();
    let is_there = found.is_ok_and(|output| output.status.success());
    if !is_there {
        eprintln!("SKIPPED: octave-cli --version does not run here");
    }
    is_there
}

/// A point for each line, each input in -2..2.
fn points(evaluator: &Evaluator) -> Vec<Vec<f64>> {
    let mut state = 18_u64;
    let mut next = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 51) as f64 - 2.0
    };
    let count = evaluator.inputs.len();
    (0..POINTS)
        .map(|_| (0..count).map(|_| next()).collect())
        .collect()
}

/// A script that calls a function with columns, and prints the bits of its outputs, column by column.
fn script(evaluator: &Evaluator, points: &[Vec<f64>]) -> String {
    let mut script = String::from("1;\n");
    for (place, input) in evaluator.inputs.iter().enumerate() {
        let bits = points
            .iter()
            .map(|point| format!("'{:016x}'", point[place].to_bits()));
        let bits: Vec<String> = bits.collect();
        let name = &input.quantity.name;
        let _ = writeln!(script, "given.{name} = hex2num([{}]);", bits.join(";"));
    }
    let _ = writeln!(script, "result = {}(given);", evaluator.name);
    script + "for value = struct2cell(result)'\n    disp(num2hex(value{1}));\nend\n"
}

/// What Octave answers, output by output.
fn answers(specification: &Specification, points: &[Vec<f64>]) -> Vec<f64> {
    let evaluator = &specification.evaluator;
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("octave");
    fs::create_dir_all(&folder).expect("a folder");
    for file in files_of(specification, Language::Octave) {
        fs::write(folder.join(&file.path), &file.text).expect("a file");
    }
    let program = folder.join(format!("call_{}.m", evaluator.name));
    fs::write(&program, script(evaluator, points)).expect("a script");
    let mut octave = Command::new("octave-cli");
    octave.args(["--quiet", "--norc", "--path"]);
    let output = octave.arg(&folder).arg(program).output().expect("it runs");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {messages}", evaluator.name);
    let lines = String::from_utf8(output.stdout).expect("digits");
    let bits = lines.lines().map(|line| u64::from_str_radix(line, 16));
    bits.map(|bits| f64::from_bits(bits.expect("a number")))
        .collect()
}

/// Rust is tested against the same numbers where it is emitted.
#[test]
fn all_that_is_shipped_gives_the_same_bits_in_octave() {
    if !is_there() {
        return;
    }
    for specification in audits().iter().flat_map(specifications) {
        let evaluator = &specification.evaluator;
        let all = std::slice::from_ref(evaluator);
        assert_eq!(renamed(all, Language::Octave), Ok(Vec::new()));
        let points = points(evaluator);
        let found = answers(&specification, &points);
        assert_eq!(found.len(), evaluator.outputs.len() * POINTS);
        for (place, point) in points.iter().enumerate() {
            let expected = evaluate(&evaluator.program, point).expect("as many numbers as inputs");
            for (output, expected) in expected.iter().enumerate() {
                let found = found[output * POINTS + place];
                let is_same = found.to_bits() == expected.to_bits();
                let name = &evaluator.outputs[output].name;
                assert!(
                    is_same || found.is_nan() && expected.is_nan(),
                    "{}.{name} at {point:?}: {found:e} is not {expected:e}",
                    evaluator.name
                );
            }
        }
    }
}
