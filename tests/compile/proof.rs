//! What is emitted is proven, and what a proof asks of a text.

use proptest::prelude::*;
use sextic::algebra::arithmetic::Arithmetic;
use sextic::algebra::budget::Budget;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::Rational;
use sextic::compile::constant::Constant;
use sextic::compile::proof::prove_files;
use sextic::compile::reading::read;
use sextic::compile::specification::Specification;
use sextic::derivation::elaboration::Elaborator;
use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::audit;
use sextic_codegen::evaluator::{Evaluator, Fixed, Origin};
use sextic_codegen::language::{File, Language, emit, taken_names};
use sextic_codegen::program::{Operation, Program};

use super::{assert_locked, audits, files_of, specifications};

#[test]
fn every_emitted_file_is_proven() {
    let mut statements = Vec::new();
    for audit in audits() {
        for specification in specifications(&audit) {
            for language in Language::ALL {
                let files = files_of(&specification, language);
                let name = &specification.evaluator.name;
                match prove_files(&files, &specification, language) {
                    Ok(proof) => statements.push(format!("{name}: {proof}")),
                    Err(doubt) => panic!("{name}: {doubt}"),
                }
            }
        }
    }
    assert_locked("proofs", &statements.join("\n"));
}

/// An evaluator of a + λ + b², whose names are free in no language, and its files.
struct Sample {
    specification: Specification,
}

impl Sample {
    fn new() -> Self {
        let mut program = Program::new(["a", "lambda", "b"].map(String::from));
        let [a, lambda, b] = ["a", "lambda", "b"].map(|name| program.input(name).unwrap());
        let sum = program.push(Operation::Add(a, lambda));
        let square = program.push(Operation::Multiply(b, b));
        let result = program.push(Operation::Add(sum, square));
        program.output("I", result);
        let mut elaborator = Elaborator::new(Budget::unlimited());
        let ring = &mut elaborator.ring;
        let inputs = ["a", "lambda", "b"].map(|name| {
            let generator = Generator::Constant {
                name: name.to_owned(),
            };
            let symbol = ring.symbol(generator).unwrap();
            (name.to_owned(), ring.element(symbol))
        });
        let square = ring.product(&inputs[2].1, &inputs[2].1).unwrap();
        let sum = ring.sum(&inputs[0].1, &inputs[1].1).unwrap();
        let result = ring.sum(&sum, &square).unwrap();
        let specification = Specification::new(
            Evaluator::plain("match", program),
            inputs.to_vec(),
            vec![("I".to_owned(), result)],
            elaborator,
        );
        Sample { specification }
    }

    fn files(&self, language: Language) -> Vec<File> {
        emit(
            std::slice::from_ref(&self.specification.evaluator),
            language,
        )
        .unwrap()
    }

    /// What is said of the files after some replacements in them, each of which must change something.
    fn judged(&self, language: Language, replacements: &[(&str, &str)]) -> Result<(), String> {
        let mut files = self.files(language);
        files.retain(|file| file.path.starts_with("match"));
        for (old, new) in replacements {
            assert!(
                files.iter().any(|file| file.text.contains(old)),
                "{language}: {old}"
            );
            for file in &mut files {
                file.text = file.text.replace(old, new);
            }
        }
        let proof = prove_files(&files, &self.specification, language);
        proof.map(|_| ()).map_err(|doubt| doubt.to_string())
    }
}

#[test]
fn renamed_quantities_are_followed() {
    for language in Language::ALL {
        assert_eq!(Sample::new().judged(language, &[]), Ok(()), "{language}");
    }
}

/// An evaluator `e` whose input and output have this name.
fn called(name: &str) -> Specification {
    let mut program = Program::new([name.to_owned()]);
    let input = program.input(name).unwrap();
    let square = program.push(Operation::Multiply(input, input));
    program.output(name, square);
    let mut elaborator = Elaborator::new(Budget::unlimited());
    let ring = &mut elaborator.ring;
    let generator = Generator::Constant {
        name: name.to_owned(),
    };
    let symbol = ring.symbol(generator).unwrap();
    let element = ring.element(symbol);
    let square = ring.product(&element, &element).unwrap();
    Specification::new(
        Evaluator::plain("e", program),
        vec![(name.to_owned(), element)],
        vec![(name.to_owned(), square)],
        elaborator,
    )
}

/// Words that the texts use themselves: a printer that did not rename them would be refused by a reader.
#[test]
fn quantities_may_be_called_as_anything_in_a_text() {
    let plain = called("a");
    for language in Language::ALL {
        let taken = taken_names(&plain.evaluator, language).unwrap();
        let more = [
            "angles", "outputs", "at", "points", "start", "self", "in_", "in_e", "in_in_", "e",
            "len", "t1", "t1_",
        ];
        for name in taken.iter().map(String::as_str).chain(more) {
            if !name.starts_with(|first: char| first.is_ascii_alphabetic()) {
                continue;
            }
            let specification = called(name);
            let files = files_of(&specification, language);
            let proof = prove_files(&files, &specification, language);
            assert!(proof.is_ok(), "{language}, {name}: {proof:?}");
        }
    }
}

/// What a printer might write that took too few names for taken: it would not compile, or mean something
/// else.
#[test]
fn variables_with_another_meaning_are_refused() {
    for (language, name) in [
        (Language::Rust, "Lanes"),
        (Language::Rust, "MatchOutputs"),
        (Language::Rust, "Ok"),
        (Language::Rust, "inputs"),
        (Language::C, "match_outputs"),
        (Language::C, "match_body"),
        (Language::C, "sqrt"),
        (Language::Python, "MatchOutputs"),
        (Language::Python, "np"),
        (Language::Python, "shape"),
        (Language::Octave, "given"),
        (Language::Octave, "square_root"),
        (Language::Octave, "double"),
        (Language::Octave, "end"),
    ] {
        let replacements = match language {
            Language::Rust => [("let a = ", "let NAME = "), ("a + lambda", "NAME + lambda")],
            Language::C => [
                ("double a = ", "double NAME = "),
                ("a + lambda", "NAME + lambda"),
            ],
            Language::Octave => [
                ("    a = double", "    NAME = double"),
                ("a + lambda", "NAME + lambda"),
            ],
            Language::Python => [
                ("    a = np", "    NAME = np"),
                ("a + lambda", "NAME + lambda"),
            ],
        };
        let judge = |name: &str| {
            let own: Vec<(&str, String)> = replacements
                .iter()
                .map(|(old, new)| (*old, new.replace("NAME", name)))
                .collect();
            let own: Vec<(&str, &str)> =
                own.iter().map(|(old, new)| (*old, new.as_str())).collect();
            Sample::new().judged(language, &own)
        };
        assert_eq!(judge("anything"), Ok(()), "{language}");
        assert!(judge(name).is_err(), "{language}, {name}");
    }
}

#[test]
fn what_is_asked_for_nothing_is_proven() {
    let text =
        "# Numbers\n\n```sextic\nevaluator (1) numbers: c = 7/2 - sqrt(2), d = 3, e = -1/3\n```\n";
    let source = SourceFile::new("numbers.md", text);
    let audit =
        audit(&source, &ShippedLibrary).unwrap_or_else(|error| panic!("{:?}", error.diagnostics));
    let specification = specifications(&audit).remove(0);
    for language in Language::ALL {
        let files = files_of(&specification, language);
        let proof = prove_files(&files, &specification, language);
        assert!(proof.is_ok(), "{language}: {proof:?}");
        // Another number is found.
        let mut files = files;
        for file in &mut files {
            file.text = file.text.replace("3.5", "2.5");
        }
        let proof = prove_files(&files, &specification, language);
        assert!(proof.is_err(), "{language}");
    }
}

#[test]
fn a_doubt_says_where_and_what() {
    let sample = Sample::new();
    for (language, old, new, expected) in [
        (
            Language::C,
            "a + lambda + b * b",
            "a + lambda - b * b",
            "match.c, `match_body`: the output `I` is computed by other operations than those of the program",
        ),
        (
            Language::C,
            "return match_body(inputs);",
            "return match_body(0);",
            "match.c, line LINE: `0` stands where `inputs` is expected",
        ),
        (
            Language::C,
            "    double lambda;",
            "    float lambda;",
            "match.h, line LINE: `float` stands where the declaration of `lambda` is expected",
        ),
        (
            Language::Python,
            "I = a + lambda_ + b * b",
            "I = a + lambda_ + b ** b",
            "match_.py, line LINE: `**` stands where the end of the line is expected",
        ),
        (
            Language::Octave,
            "I = a + lambda + b .* b",
            "I = a + lambda + b * b",
            "match.m, line LINE: `*` stands where `;` is expected",
        ),
        (
            Language::Rust,
            "b.multiply_add(b, a + lambda)",
            "b.multiply_add(c, a + lambda)",
            "match_.rs, `match__body`: `c` is not assigned before",
        ),
        (
            Language::Rust,
            "b.multiply_add(b, a + lambda)",
            "b.multiply_add(b, a + 0.1)",
            "match_.rs, `match__body`: 1/10 is no double",
        ),
    ] {
        let files = sample.files(language);
        let file = files.iter().find(|file| file.text.contains(old)).unwrap();
        let before = &file.text[..file.text.find(old).unwrap()];
        let line = before.matches('\n').count() + 1;
        let expected = expected.replace("LINE", &line.to_string());
        assert_eq!(
            sample.judged(language, &[(old, new)]),
            Err(expected),
            "{new}"
        );
    }
    let missing = prove_files(&[], &sample.specification, Language::C);
    let doubt = missing.unwrap_err().to_string();
    assert_eq!(doubt, "match.c, line 1: the file is missing");
}

#[test]
fn operations_are_the_same_to_the_bit() {
    let sample = Sample::new();
    let own = "a + lambda_ + b * b";
    for (text, is_same) in [
        ("b * b + (lambda_ + a)", true),
        ("a + lambda_ - -b * b", true),
        ("-(-a - lambda_ - b * b)", false),
        ("a - -lambda_ - -(b * b)", true),
        ("a + (lambda_ + b * b)", false),
        ("a + b * b + lambda_", false),
        ("(a + lambda_) * 1.0 + b * b", false),
        ("a + lambda_ + b * b + 0.0", false),
    ] {
        let verdict = sample.judged(Language::Python, &[(own, text)]);
        assert_eq!(verdict.is_ok(), is_same, "{text}: {verdict:?}");
    }
}

/// Texts that read as something else than they are, and others that no body is.
#[test]
fn nothing_is_hidden_from_a_reader() {
    let sample = Sample::new();
    for (language, old, new) in [
        (
            Language::C,
            "/* No two of them overlap. */",
            "// No two of them overlap.",
        ),
        (
            Language::C,
            "/* No two of them overlap. */",
            "/* *\\\n/ inputs = 0; /* */",
        ),
        (
            Language::C,
            "/* No two of them overlap. */",
            "/* *??/\n/ inputs = 0; /* */",
        ),
        (
            Language::C,
            "/* No two of them overlap. */",
            "/* *\\\r/ inputs = 0; /* */",
        ),
        (
            Language::C,
            "#include <math.h>",
            "#include <math.h>\n#define a b",
        ),
        (
            Language::C,
            "#include <math.h>",
            "#include <math.h> /*\n#define a b */",
        ),
        (
            Language::C,
            "#include <math.h>",
            "#include <math.h>\n%:define a b",
        ),
        (
            Language::C,
            "double lambda;",
            "double b;\n    double lambda;",
        ),
        (Language::C, "b * b", "b * b, 0.0"),
        (Language::C, "b * b", "b * b; a"),
        (Language::C, "b * b", "1 / 3"),
        (Language::C, "b * b", "(b * b)(a)"),
        (
            Language::C,
            "sextic_exact(inputs->b)",
            "sextic_exact(inputs->a)",
        ),
        (Language::C, "sextic_exact(inputs->b)", "sextic_exact(2.0)"),
        (Language::C, "extern \"C\" {", "extern \"C\" { int x;"),
        (
            Language::Python,
            "import numpy as np",
            "# coding: utf-7\nimport numpy as np",
        ),
        (Language::Python, "import numpy as np", "import cupy as np"),
        (Language::Python, "b * b", "b * b; a = b"),
        (Language::Python, "    I = a", "    if a: I = a"),
        (Language::Python, "    I = a", "        I = a"),
        (Language::Python, "    I = a", "    I += a"),
        (Language::Python, "    I = a", "    np = a\n    I = a"),
        (
            Language::Python,
            "dtype=np.float64)\n    I",
            "dtype=np.float32)\n    I",
        ),
        (Language::Python, "b * b", "(b * b\n    )"),
        (
            Language::Python,
            "        np.shape(inputs.a),\n",
            "        np.shape(inputs.a),\n        \"\"\"x\"\"\"\n",
        ),
        (Language::Octave, "b .* b;", "b .* b; a = b;"),
        (Language::Octave, "b .* b;", "b .* b,"),
        (Language::Octave, "b .* b;", "b .* b\n;"),
        (Language::Octave, "b .* b;", "b ...\n    .* b;"),
        (Language::Octave, "b .* b;", "b .* b';"),
        (Language::Octave, "b .* b;", "b .* b; # no comment"),
        (Language::Octave, "a + lambda", "a\n    + lambda"),
        (Language::Octave, "    I = a", "    I += a"),
        (Language::Octave, "    I = a", "    %{\n    I = a"),
        (
            Language::Octave,
            "    I = a",
            "    % x\r    b = a;\n    I = a",
        ),
        (Language::Octave, "double(given.b)", "single(given.b)"),
        (Language::Octave, "double(given.b)", "double(given.a)"),
        (
            Language::Octave,
            "spread(values.I, shape)",
            "spread(values.I, [1, 1])",
        ),
        (
            Language::Rust,
            "use super::lanes::Lanes;",
            "use super::lanes::Lanes; use super::bounded::*;",
        ),
        (
            Language::Rust,
            "use super::lanes::Lanes;",
            "/* use super::lanes::Lanes; */",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    #[cfg(any())]\n    let b = inputs.b;",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let b = inputs.b;\n    let b = a;",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let b = { inputs.b };",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let b = inputs.b; return;",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let b: T = inputs.b;",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let mut b = inputs.b;",
        ),
        (
            Language::Rust,
            "    let b = inputs.b;",
            "    let b = dbg!(inputs.b);",
        ),
        (Language::Rust, "multiply_add(b,", "multiply_add::<T>(b,"),
        (Language::Rust, "MatchOutputs {", "Other {"),
        (
            Language::Rust,
            "make(\"b\", &inputs.b)",
            "make(\"b\", &inputs.a)",
        ),
        (
            Language::Rust,
            "make(\"b\", &inputs.b)",
            "make(\"a\", &inputs.b)",
        ),
        (
            Language::Rust,
            "batch::run::<Batch>(level,",
            "batch::run::<Batch>(Level::best(),",
        ),
    ] {
        let verdict = sample.judged(language, &[(old, new)]);
        assert!(verdict.is_err(), "{language}: {new}");
    }
}

#[test]
fn nothing_stands_behind_a_file() {
    let sample = Sample::new();
    for language in Language::ALL {
        for place in 0..sample.files(language).len() {
            let mut files = sample.files(language);
            let is_own = files[place].path.starts_with("match");
            files[place].text.push_str("x = 0;\n");
            let is_read = read(&files, &sample.specification.evaluator, language).is_ok();
            assert_eq!(is_read, !is_own, "{}", files[place].path);
        }
    }
}

#[test]
fn comments_are_free() {
    let sample = Sample::new();
    for (language, old, new) in [
        (
            Language::C,
            "/* No two of them overlap. */",
            "/* a = b; */ /* ' \" # // */",
        ),
        (
            Language::Python,
            "\"\"\"No unit.\"\"\"",
            "\"\"\"a = \\\"\"\" b\"\"\"",
        ),
        (Language::Rust, "/// No unit.", "/// \" /* ' #[cfg(any())]"),
        (
            Language::Octave,
            "% What is derived;",
            "% a = b; %{ ' \" ...",
        ),
    ] {
        assert_eq!(sample.judged(language, &[(old, new)]), Ok(()), "{language}");
    }
}

/// The sample in which b is fixed.
fn fixed(value: &Rational) -> Sample {
    let mut sample = Sample::new();
    let (name, element) = sample.specification.inputs.remove(2);
    sample.specification.constants = vec![Constant {
        name,
        element,
        lower: value.clone(),
        upper: value.clone(),
    }];
    sample.specification.evaluator.inputs[2].origin = Origin::Fixed(Fixed {
        value: value.clone(),
        text: String::new(),
    });
    sample
}

/// The texts of a + λ + c in which b stands for a number: each language has its way to write it.
fn written(language: Language, statements: &str, literal: &str) -> Vec<File> {
    let mut program = Program::new(["a", "lambda"].map(String::from));
    let [a, lambda] = ["a", "lambda"].map(|name| program.input(name).unwrap());
    let sum = program.push(Operation::Add(a, lambda));
    program.output("I", sum);
    let files = emit(&[Evaluator::plain("match", program)], language).unwrap();
    let change = |file: File| {
        let replacements: &[(&str, &str)] = match language {
            Language::Rust => &[(
                "let I = a + lambda;",
                "let I = b.multiply_add(b, a + lambda);",
            )],
            Language::Python => &[("I = a + lambda_\n", "I = a + lambda_ + b * b\n")],
            Language::Octave => &[("I = a + lambda;", "I = a + lambda + b .* b;")],
            Language::C => &[
                (
                    "const double I_ = a + lambda;",
                    "const double I_ = a + lambda + b * b;",
                ),
                (
                    "const sextic_bounded I_ = sextic_add(a, lambda);",
                    "const sextic_bounded I_ = sextic_add(sextic_add(a, lambda), sextic_multiply(b, b));",
                ),
            ],
        };
        let mut text = file.text;
        for (old, new) in replacements {
            let fixing: Vec<String> = statements
                .split(';')
                .filter(|statement| !statement.is_empty())
                .map(|name| match (language, new.contains("sextic_")) {
                    (Language::Rust, _) => format!("let {name} = T::constant({literal});\n    "),
                    (Language::Python, _) => format!("{name} = {literal}\n    "),
                    // The usual signs are those of matrices.
                    (Language::Octave, _) => {
                        format!("{name} = {};\n    ", literal.replace(" *", " .*"))
                    }
                    (_, false) => format!("const double {name} = {literal};\n    "),
                    (_, true) => {
                        format!("const sextic_bounded {name} = sextic_exact({literal});\n    ")
                    }
                })
                .collect();
            text = text.replace(old, &format!("{}{new}", fixing.concat()));
        }
        File { text, ..file }
    };
    files.into_iter().map(change).collect()
}

#[test]
fn a_fixed_input_is_the_double_nearest_to_its_value() {
    let value = Rational::from(178) / Rational::from(10_000);
    for language in Language::ALL {
        for (statements, literal, is_proven) in [
            ("b", "0.0178", true),
            // The double itself, digit by digit.
            (
                "b",
                "0.0178000000000000005434541639033341198228299617767333984375",
                true,
            ),
            ("b", "0.01780000000000001", false),
            ("b", "0.0179", false),
            ("b", "-0.0178", false),
            ("b", "0.0", false),
            ("b", "0.0178 * 1.0", false),
            ("b", "a", false),
            ("b;b", "0.0178", false),
            ("", "0.0178", false),
            ("c", "0.0178", false),
        ] {
            let sample = fixed(&value);
            let files = written(language, statements, literal);
            let proof = prove_files(&files, &sample.specification, language);
            assert_eq!(proof.is_ok(), is_proven, "{language}, {literal}: {proof:?}");
        }
    }
    let negative = fixed(&-value);
    let files = written(Language::C, "b", "-0.0178");
    let proof = prove_files(&files, &negative.specification, Language::C);
    assert!(proof.is_ok(), "{proof:?}");
}

#[test]
fn fixed_inputs_are_proven_as_they_are_emitted() {
    for (above, below) in [(89, 5_000), (-1, 3), (1, 10), (7, 1), (-1_000_001, 999_983)] {
        let value = Rational::from(above) / Rational::from(below);
        for language in Language::ALL {
            let sample = fixed(&value);
            assert_eq!(sample.judged(language, &[]), Ok(()), "{language}, {value}");
        }
    }
}

/// An evaluator of a cos(α − 2β + γ), where γ is fixed.
fn turned() -> Sample {
    let text = "# Angles\n\n```sextic\nangle α, β, γ\nparameter a : m > 0\n\
        evaluator [f] matched: x = a*cos(α - 2*β + γ)\n```\n";
    let source = SourceFile::new("angles.md", text);
    let audit = audit(&source, &ShippedLibrary).unwrap_or_else(|e| panic!("{:?}", e.diagnostics));
    let mut specification = specifications(&audit).remove(0);
    let angles = specification.evaluator.angles.iter_mut();
    for angle in angles.filter(|angle| angle.quantity.name == "gamma") {
        angle.fixed = Some(Fixed {
            value: Rational::from(3) / Rational::from(10),
            text: String::new(),
        });
    }
    Sample { specification }
}

#[test]
fn angles_are_followed() {
    let sample = turned();
    for language in Language::ALL {
        let files = sample.files(language);
        let text: Vec<&str> = files.iter().map(|file| file.text.as_str()).collect();
        let text = text.join("");
        assert_eq!(sample.judged(language, &[]), Ok(()), "{text}");
        for (old, new, is_proven) in [
            ("2.0 * beta", "beta * 2.0", true),
            ("2.0 * beta", "(beta + beta)", true),
            ("2.0 * beta", "beta", false),
            ("2.0 * beta", "2.0 * alpha", false),
            ("2.0 * beta", "-2.0 * beta", false),
            ("2.0 * beta", "2.0 * beta * beta", false),
            (
                "2.0 * beta",
                "(1.0e300 * beta + 2.0 * beta - 1.0e300 * beta)",
                false,
            ),
            ("2.0 * beta", "(3.0 * beta - beta)", false),
            ("2.0 * beta", "0.5 * (4.0 * beta)", false),
            ("gamma", "gamma - alpha", false),
            ("0.3", "0.4", false),
            ("0.3", "0.30000000000000001", true),
            ("np.cos(", "np.sin(", false),
            (".cos()", ".sin()", false),
            ("= cos(", "= sin(", false),
            ("a=a", "a=beta", false),
            ("angles.a", "angles.beta", false),
            ("angles->a,", "angles->beta,", false),
            ("angles->alpha", "angles->beta", false),
            ("double(angles.alpha)", "double(angles.beta)", false),
            (
                "fitted(shape, angles, \"beta\")",
                "fitted(shape, angles, \"alpha\")",
                false,
            ),
            ("angles.alpha", "angles.beta", false),
            ("np.asarray(alpha,", "np.asarray(beta,", false),
            ("cls(", "RodInputs(", false),
            ("double beta;", "float beta;", false),
            ("pub beta: f64", "pub beta: f32", false),
            ("        *,\n", "", false),
        ] {
            if !text.contains(old) {
                continue;
            }
            let verdict = sample.judged(language, &[(old, new)]);
            assert_eq!(verdict.is_ok(), is_proven, "{language}, {new}: {verdict:?}");
        }
    }
}

proptest! {
    #[test]
    fn any_file_is_read(text in "\\PC{0,200}", place in 0_usize..3_000, length in 0_usize..40) {
        let sample = Sample::new();
        for language in Language::ALL {
            let mut files = sample.files(language);
            for file in &mut files {
                let inside = |place: usize| {
                    (0..=place.min(file.text.len())).rev().find(|place| file.text.is_char_boundary(*place))
                };
                let (start, end) = (inside(place).unwrap(), inside(place + length).unwrap());
                file.text.replace_range(start..end, &text);
            }
            let _ = read(&files, &sample.specification.evaluator, language);
        }
    }

    #[test]
    fn any_body_is_read(words in prop::collection::vec(prop::sample::select(vec![
        "a", "b", "let", "const", "double", "=", ";", "+", "-", "*", "/", "(", ")", "{", "}", ".", ",", "::",
        "1.0", "sqrt", "sextic_add", "sextic_exact", "T", "constant", "multiply_add", "inputs", "\n", "\n    ",
        "return", "np", "shape", "/*", "//", "\"", "\\", "'", "#", ".*", "./", "double", "given", "%", "%{",
        "...", "values",
    ]), 0..60)) {
        let sample = Sample::new();
        for (language, end) in [
            (Language::Rust, "let a = inputs.a;"),
            (Language::C, "const double a = inputs->a;"),
            (Language::Python, "a = np.asarray(inputs.a, dtype=np.float64)"),
            (Language::Octave, "a = double(given.a);"),
        ] {
            let mut files = sample.files(language);
            for file in &mut files {
                file.text = file.text.replace(end, &words.join(" "));
            }
            let _ = read(&files, &sample.specification.evaluator, language);
        }
    }
}

#[test]
fn deep_and_long_texts_are_refused() {
    let sample = Sample::new();
    for (language, own) in [
        (Language::Rust, "b.multiply_add(b, a + lambda)"),
        (Language::C, "a + lambda + b * b"),
        (Language::C, "sextic_multiply(b, b)"),
        (Language::Python, "a + lambda_ + b * b"),
        (Language::Octave, "a + lambda + b .* b"),
    ] {
        for (open, middle, close) in [
            ("(", "a", ")"),
            ("- ", "a", ""),
            ("", "a", " + a"),
            ("sextic_negative(", "a", ")"),
        ] {
            let count = 100_000;
            let text = format!("{}{middle}{}", open.repeat(count), close.repeat(count));
            assert!(
                sample.judged(language, &[(own, &text)]).is_err(),
                "{language}"
            );
        }
    }
}
