//! Programs that use emitted text: they are given points and answer with bits.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use sextic_codegen::arithmetic::doubles::evaluate;
use sextic_codegen::arithmetic::rationals::evaluate_closely;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{Language, emit};
use sextic_codegen::program::Rational;

use crate::samples;

/// A fresh folder for a test.
pub fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// Writes the samples in a language.
pub fn write(folder: &Path, language: Language) {
    fs::create_dir_all(folder).unwrap();
    for file in emit(&samples::all(), language).unwrap() {
        fs::write(folder.join(file.path), file.text).unwrap();
    }
}

/// Whether a tool is there; says so if not.
pub fn present(tool: &str, arguments: &[&str]) -> bool {
    let found = Command::new(tool)
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if !found {
        eprintln!("SKIPPED: {tool} {} does not run here", arguments.join(" "));
    }
    found
}

/// Runs a command and gives what it prints; fails with its messages.
pub fn run(command: &mut Command, input: &str) -> String {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let text = input.to_owned();
    // What is printed may fill a pipe before all points are read.
    let writer = std::thread::spawn(move || {
        let _ = stdin.write_all(text.as_bytes());
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(
        output.status.success(),
        "{command:?}:\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).unwrap()
}

/// Points for an evaluator: plain ones, whole ones, ones that cancel, and ones beyond the range in which
/// products neither overflow nor underflow.
pub fn points(evaluator: &Evaluator) -> Vec<Vec<f64>> {
    let mut state = 1_u64;
    let mut next = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let count = evaluator.free_inputs().count();
    let mut points = vec![vec![0.0; count], vec![1.0; count], vec![-0.0; count]];
    let scales = [
        1.0, 1.0, 1e-3, 1e5, 1e-110, 1e-160, 1e-308, 5e-324, 1e100, 1e160, 4e307,
    ];
    for round in 0..600 {
        let mut point = Vec::new();
        for _ in 0..count {
            let value = 8.0 * next() - 4.0;
            let scale = scales[(next() * scales.len() as f64) as usize];
            point.push(match round % 4 {
                0 => value,
                1 => value.round(),
                2 => 1.0 + value * f64::EPSILON,
                _ => value * scale,
            });
        }
        points.push(point);
    }
    points
}

/// A line for each evaluator and point.
pub fn questions() -> String {
    let mut lines = String::new();
    for evaluator in samples::all() {
        for point in points(&evaluator) {
            lines.push_str(&evaluator.name);
            for value in point {
                lines.push_str(&format!(" {:x}", value.to_bits()));
            }
            lines.push('\n');
        }
    }
    lines
}

/// Angles of the sample that has some: θ_0 and β.
const ANGLES: [(f64, f64); 6] = [
    (0.0, 0.0),
    (0.5, -2.0),
    (-3.0, 1e-9),
    (40.0, 7.0),
    (1e-300, 3.2),
    (-0.3, 0.0),
];

/// A line for each of the angles, with L = 2.
pub fn questions_of_angles() -> String {
    let bits = |value: f64| format!("{:x}", value.to_bits());
    let line = |(theta, beta)| format!("angles {} {} {}\n", bits(2.0), bits(theta), bits(beta));
    ANGLES.into_iter().map(line).collect()
}

/// Compares L, cos(α_g + θ_0), sin(α_g + θ_0) and cos(2·β − θ_0) with what they are.
pub fn check_angles(answers: &str) {
    let lines: Vec<&str> = answers.lines().collect();
    assert_eq!(lines.len(), ANGLES.len());
    for (line, (theta, beta)) in lines.iter().zip(ANGLES) {
        let words = line.split(' ');
        let bits = words.map(|word| u64::from_str_radix(word, 16).unwrap());
        let found: Vec<f64> = bits.map(f64::from_bits).collect();
        let turn = 0.3 + theta;
        let expected = [2.0, turn.cos(), turn.sin(), (2.0 * beta - theta).cos()];
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            // Libraries differ in the last bit.
            let distance: f64 = found - expected;
            assert!(distance.abs() < 4e-16, "{theta} {beta}: {found} {expected}");
        }
    }
}

/// Compares the answers with the same program in doubles, bit for bit, and their bounds with the exact
/// values.
pub fn check(answers: &str, with_bounds: bool) {
    let mut lines = answers.lines();
    let (mut finite, mut all) = (0, 0);
    for evaluator in samples::all() {
        for point in points(&evaluator) {
            let line = lines.next().expect("an answer to each point");
            let words = line
                .split(' ')
                .map(|word| u64::from_str_radix(word, 16).unwrap());
            let numbers: Vec<f64> = words.map(f64::from_bits).collect();
            let answers: Vec<&[f64]> = numbers.chunks(if with_bounds { 2 } else { 1 }).collect();
            let point = samples::with_fixed(&evaluator, &point);
            let expected = evaluate(&evaluator.program, &point).unwrap();
            assert_eq!(answers.len(), expected.len());
            let exact: Vec<Rational> = point
                .iter()
                .map(|value| Rational::try_from(*value).unwrap())
                .collect();
            let exact = evaluate_closely(&evaluator.program, &exact, 1500);
            for ((answer, expected), exact) in answers.iter().zip(expected).zip(exact) {
                let value = answer[0];
                assert!(
                    value.to_bits() == expected.to_bits() || value.is_nan() && expected.is_nan(),
                    "{} at {point:?}: {value:e} is not {expected:e}",
                    evaluator.name
                );
                let Some(error) = answer.get(1) else { continue };
                all += 1;
                if *error == f64::INFINITY {
                    continue;
                }
                finite += 1;
                assert!(*error >= 0.0, "a bound is a number");
                let exact = exact.expect("a finite bound belongs to a value");
                let distance = Rational::try_from(value).unwrap() - exact;
                let bound = Rational::try_from(*error).unwrap();
                assert!(
                    distance <= bound && -distance <= bound,
                    "{} at {point:?}: the bound {error:e} does not hold",
                    evaluator.name
                );
            }
        }
    }
    assert_eq!(lines.next(), None);
    if with_bounds {
        // A bound that is always infinite would be right and of no use.
        assert!(finite * 2 > all, "{finite} of {all} bounds are finite");
    }
}
