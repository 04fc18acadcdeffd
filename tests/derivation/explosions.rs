//! What is too large stops soon, without exhausting memory or the stack.

use std::time::{Duration, Instant};

use super::{audit_text, block};

/// The outcome in a word, found within a time that leaves room for a slow machine and a debug build.
fn outcome(statements: &str) -> String {
    let start = Instant::now();
    let outcome = match audit_text(&block(statements)) {
        Ok(audit) => audit
            .claims
            .last()
            .map_or("read".into(), |claim| claim.verdict.text().to_string()),
        Err(message) => message,
    };
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
    outcome
}

/// The largest resident set of this process so far, in megabytes; 0 where the system does not tell.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let number = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
    number.unwrap_or(0) / 1024
}

#[test]
fn calls_of_calls_are_evaluated_once() {
    let calls = format!("{}x{}", "f(".repeat(60), ")".repeat(60));
    let claim = format!("parameter x : 1\nf(s) := s + s\nclaim (1): {calls} == 2^60*x");
    assert_eq!(outcome(&claim), "holds");
}

#[test]
fn nested_coefficients_are_taken_once() {
    let (calls, ends) = ("coefficient(".repeat(40), ", x, 0)".repeat(40));
    let claim = format!("parameter x : 1\nclaim (1): {calls}x + 1{ends} == 1");
    assert_eq!(outcome(&claim), "holds");
}

#[test]
fn long_chains_of_definitions_do_not_overflow_the_stack() {
    let mut text = "parameter x : 1\na_0 := x\n".to_string();
    for n in 1..3000 {
        text += &format!("a_{n} := a_{} + x\n", n - 1);
    }
    assert_eq!(
        outcome(&format!("{text}claim (1): a_2999 == 3000*x")),
        "undecided"
    );
}

/// Roots or functions r_0, r_1, …, each of the two before it: written in full they grow exponentially.
fn chain(function: &str, length: usize) -> String {
    let mut text = format!(
        "parameter x, y, q : 1 > 0\nfunction f at x : 1\nr_0 := {function}(x + 1)\nr_1 := {function}(r_0 + 1)\n"
    );
    for n in 2..=length {
        text += &format!("r_{n} := {function}(1 + r_{} + r_{})\n", n - 1, n - 2);
    }
    text
}

#[test]
fn what_stands_in_many_places_is_looked_at_once() {
    for function in ["sqrt", "f"] {
        let chain = chain(function, 40);
        for claim in [
            "((r_40 at (x = y)) at (y = x)) == r_40",
            "truncate(r_40*q/(1 + q*y), [q], 1) == r_40*q",
            "d(r_40, y) == 0",
            "dt(r_40) == 0",
        ] {
            assert_eq!(outcome(&format!("{chain}claim (1): {claim}")), "holds");
        }
    }
}

#[test]
fn what_stands_deep_does_not_overflow_the_stack() {
    let mut text = "parameter x, y : 1\nfunction f at x : 1\na_0 := x\n".to_string();
    for n in 1..2000 {
        text += &format!("a_{n} := f(a_{})\n", n - 1);
    }
    let claim = "claim (1): ((a_1999 at (x = y)) at (y = x)) == a_1999";
    assert_ne!(outcome(&format!("{text}{claim}")), "refuted");
}

#[test]
fn long_sums_do_not_overflow_the_stack() {
    let text = "parameter a, b, c, e, λ, u : 1\np := (a + b + c + e + 1)^10\n\
                match (1) s: p*λ with u*λ in λ unknown u at λ\nclaim (2): u at s == p";
    assert_eq!(
        outcome(text),
        "holds",
        "a solution of 1001 terms is read back"
    );
}

#[test]
fn matrices_of_long_sums_are_given_up() {
    let text = "parameter a, b, c, e, f : 1\np := (a + b + c + e + f)^25\nA := identity(64)*p\n\
                B := A + A\nclaim (1): B == 2*A";
    let outcome = outcome(text);
    assert!(outcome.contains("[budget]"), "{outcome}");
}

#[test]
fn expansions_of_high_order_stop() {
    let text = "parameter x, y, z : 1\n\
                claim (1): truncate(1/(1 + x + y + z)/(1 - x*y), [x, y, z], 12) == 0";
    assert!(["refuted", "undecided"].contains(&&*outcome(text)));
}

#[test]
fn numbers_of_a_point_may_not_grow_without_bound() {
    let powers: Vec<String> = ('a'..='z').map(|name| format!("{name}^60000")).collect();
    let names: Vec<String> = ('a'..='z')
        .filter(|name| *name != 'd')
        .map(String::from)
        .collect();
    let powers = powers.join("*").replace("d^60000*", "");
    let text = format!(
        "parameter {} : 1\nclaim (1): {powers} == {powers}",
        names.join(", ")
    );
    assert_eq!(outcome(&text), "holds");
}

#[test]
fn the_arctangent_of_a_wide_enclosure_ends() {
    let text = "parameter x : 1 > 0\nA := 10^83*sqrt(2) - sqrt(2*10^166) + 4194305\n\
                claim (1): angle(x, A) == 1";
    assert!(["refuted", "undecided"].contains(&&*outcome(text)));
}

#[test]
fn sums_of_angles_are_taken_once() {
    let mut text = "angle α\nt_0 := α\n".to_string();
    for n in 1..=150 {
        text += &format!("t_{n} := t_{0} + t_{0}\n", n - 1);
    }
    text += "claim (1): cos(t_150 - 2^150*α + α) == cos(α)";
    assert_eq!(outcome(&text), "holds");
}

#[test]
fn values_at_many_arguments_are_found_soon() {
    let mut text =
        "parameter x : 1 > 0\nfunction f at x : 1\nr := sqrt(2)\nS_0 := 0*x\n".to_string();
    for block in 0..40 {
        let values = (1..=50).map(|k| format!("f({}*r)", 50 * block + k));
        let values: Vec<String> = values.collect();
        text += &format!("S_{} := S_{block} + {}\n", block + 1, values.join(" + "));
    }
    text += "claim (1): S_40 + 10^12 > 0";
    assert_eq!(outcome(&text), "undecided");
}

#[test]
fn memory_is_bounded() {
    let mut text = "parameter x, y, λ : 1\n".to_string();
    for k in 1..=20 {
        let polynomial = format!("(y + {k}*λ + x*λ^2 + λ^3)^40");
        text += &format!("claim ({k}): coefficient({polynomial}, λ, 30) + 10^900 > 0\n");
    }
    assert_eq!(outcome(&text), "undecided");
    assert!(peak_memory() < 512, "{} MB", peak_memory());
    outcome("parameter a, b, c, e, f : 1\np := (a + b + c + e + f)^200");
    assert!(peak_memory() < 1024, "{} MB", peak_memory());
}
