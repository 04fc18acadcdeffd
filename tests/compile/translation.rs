//! Documents whose evaluators are translated, or refused.

use sextic::compile::specification::{Refusal, Specification};
use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::audit;
use sextic_codegen::arithmetic::doubles::evaluate;

/// The last evaluator of a document with these statements.
fn specify(statements: &str) -> Result<Specification, Refusal> {
    let text = format!("# A document\n\n```sextic\n{statements}\n```\n");
    let source = SourceFile::new("document.md", text);
    let audit =
        audit(&source, &ShippedLibrary).unwrap_or_else(|error| panic!("{:?}", error.diagnostics));
    if let Some(mistake) = audit.mistakes.first() {
        return Err(Refusal::Document(Box::new(mistake.diagnostic.clone())));
    }
    let evaluator = audit.evaluators.last().expect("an evaluator");
    Specification::of(evaluator, &audit, &[])
}

/// The outputs at the inputs 2, 3, 5, … in their order.
fn outputs(statements: &str) -> Vec<f64> {
    let specification =
        specify(statements).unwrap_or_else(|refusal| panic!("{statements}: {refusal:?}"));
    let program = &specification.evaluator.program;
    let primes = [2.0, 3.0, 5.0, 7.0, 11.0];
    evaluate(program, &primes[..program.inputs().len()]).expect("the constants are doubles")
}

#[test]
fn the_meaning_is_kept() {
    for (statements, expected) in [
        // Inputs come in the order in which they are declared.
        ("parameter b, a : 1\nevaluator (1) e: y = a - b", vec![1.0]),
        (
            "parameter a, b : 1\nevaluator (1) e: y = [a, b; b, a]",
            vec![2.0, 3.0, 3.0, 2.0],
        ),
        (
            "parameter a, b : 1\nf(x) := x*b\nevaluator (1) e: y = f(f(a + b))",
            vec![45.0],
        ),
        (
            "parameter a, b : 1\nf(x) := x at (b = 2)\nevaluator (1) e: y = f(a + b)",
            vec![4.0],
        ),
        (
            "parameter a, b, c : 1\nevaluator (1) e: y = (a - b) at (a = b, b = c)",
            vec![-1.0],
        ),
        (
            "parameter a, b, c : 1\nevaluator (1) e: y = ((a - b) at (b = a*c)) at (a = 7)",
            vec![-7.0],
        ),
        (
            "parameter a, b : 1\nevaluator (1) e: y = d(a^3*b, a) at (a = b)",
            vec![24.0],
        ),
        (
            "parameter a : 1 > 0\nevaluator (1) e: y = sqrt(a + 2)",
            vec![2.0],
        ),
        (
            "parameter a, b : 1\nevaluator (1) e: y = a^(-2) + b",
            vec![3.25],
        ),
        (
            "parameter a, b, z : 1\nevaluator (1) e: y = coefficient((a*z + b)^2, z, 1)",
            vec![12.0],
        ),
        // What a call passes on may be a power, a place or the variable itself.
        (
            "parameter a, b, z : 1\nc(p, x, n) := coefficient(p, x, n)\nf(n) := c(z^(n + 1)*a + b*z, z, n)\nevaluator (1) e: y = f(1)",
            vec![2.0],
        ),
        (
            "parameter a, b : 1\nf(n) := [a; b][n]^n\nevaluator (1) e: y = f(2)",
            vec![4.0],
        ),
        (
            "parameter a, b, z : 1\nevaluator (1) e: y = det([a, b; 1, a])*trace([a, 1; 1, b])",
            vec![5.0],
        ),
        // A root that stands below the line.
        (
            "parameter a : 1 > 0\nevaluator (1) e: y = 1/sqrt(2*a)",
            vec![0.5],
        ),
        (
            "parameter a, b : 1\nangle q\nevaluator (1) general: y = a*cos(q) + b*sin(q)\nevaluator (2) e: general at (q = 0)",
            vec![2.0],
        ),
        // Real and imaginary parts, written with i.
        (
            "parameter x, y : 1\nimaginary i\nz(j) := (x + j*y)^2\nre := (z(i) + z(-i))/2\nim := (z(i) - z(-i))/(2*i)\nevaluator (1) e: re = re, im = im",
            vec![-5.0, 12.0],
        ),
        (
            "parameter x, y : 1 > 0\nimaginary i\nsize(j) := (x + j*y)*(x - j*y)\nevaluator (1) e: y = x + 1/(size(i) - 9), z = sqrt(size(i) + 3) - y",
            vec![2.25, 1.0],
        ),
        (
            "parameter x, y : 1\nimaginary i\nM := [x, i*y; -i*y, x]\nevaluator (1) e: d = det(M), t = trace(M), e = M[1,1]",
            vec![-5.0, 4.0, 2.0],
        ),
        (
            "parameter a, b, λ : 1\nimaginary i\nevaluator (1) e: y = (λ^2 + a*λ + b at (λ = 2*i)) - 2*i*a",
            vec![-2.0],
        ),
        // What is no input cancels.
        (
            "coordinate q : 1\nparameter a : 1\nevaluator (1) e: y = (q + a)*(q - a) - q^2",
            vec![-4.0],
        ),
        // Nothing is asked for.
        ("evaluator (1) e: y = 7/2 - 2, z = sqrt(4)", vec![1.5, 2.0]),
        ("parameter a : 1\nevaluator (1) e: y = a - a + 3", vec![3.0]),
    ] {
        assert_eq!(outputs(statements), expected, "{statements}");
    }
}

#[test]
fn what_cannot_be_compiled_is_refused_with_the_reason() {
    let doubled: Vec<String> = (1..=30)
        .map(|n| format!("f{n}(x) := f{}(x) + f{}(x)", n - 1, n - 1))
        .collect();
    let doubled = doubled.join("\n");
    for (statements, reason) in [
        (
            "parameter a : 1\nimaginary i\nevaluator (1) e: y = a + i".to_owned(),
            "contains i",
        ),
        (
            "parameter a, b : 1\nimaginary i\nz := (a + i)^2\nevaluator (1) e: y = (z + b)/2"
                .to_owned(),
            "contains i",
        ),
        (
            "coordinate x : m\nevaluator (1) e: y = x^2".to_owned(),
            "a coordinate",
        ),
        (
            format!("parameter a : 1\nf0(x) := x\n{doubled}\nevaluator (1) e: y = f30(a)"),
            "",
        ),
    ] {
        match specify(&statements) {
            Err(Refusal::Program(found)) => assert!(found.contains(reason), "{found}"),
            Err(Refusal::Document(_)) if reason.is_empty() => {}
            other => panic!("{statements}: {other:?}"),
        }
    }
}
