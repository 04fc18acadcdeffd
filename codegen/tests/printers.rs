//! What is printed, locked.

use std::path::Path;

use insta::assert_snapshot;
use sextic_codegen::evaluator::{Evaluator, Origin, Quantity, Rounding};
use sextic_codegen::language::{Error, Language, MARK, emit};
use sextic_codegen::program::{Operation, Program, Rational};

use crate::samples;

fn text(language: Language, path: &str) -> String {
    let files = emit(&samples::all(), language).unwrap();
    let file = files.into_iter().find(|file| file.path == path);
    file.expect("the file is emitted").text
}

fn locked(name: &str, text: String) {
    insta::with_settings!({
        snapshot_path => Path::new(env!("CARGO_MANIFEST_DIR")).join("../snapshots/codegen"),
        prepend_module_to_snapshot => false,
        omit_expression => true,
    }, { assert_snapshot!(name, text) });
}

#[test]
fn one_file_a_language() {
    for (language, path) in [
        (Language::Rust, "lib.rs"),
        (Language::Rust, "match_.rs"),
        (Language::Rust, "quadratic_form.rs"),
        (Language::Rust, "rod.rs"),
        (Language::C, "match.c"),
        (Language::C, "quadratic_form.h"),
        (Language::C, "rod.h"),
        (Language::C, "rod.c"),
        (Language::Python, "match_.py"),
        (Language::Python, "rod.py"),
        (Language::Python, "__init__.py"),
        (Language::Octave, "match.m"),
        (Language::Octave, "quadratic_form.m"),
        (Language::Octave, "rod.m"),
    ] {
        locked(&format!("{language}-{path}"), text(language, path));
    }
}

#[test]
fn every_file_says_near_its_beginning_that_it_is_generated() {
    for language in Language::ALL {
        for file in emit(&samples::all(), language).unwrap() {
            let place = file.text.find(MARK);
            assert!(place.is_some_and(|place| place < 2000), "{}", file.path);
        }
    }
}

#[test]
fn the_same_evaluators_give_the_same_bytes_in_the_order_of_paths() {
    for language in Language::ALL {
        let files = emit(&samples::all(), language).unwrap();
        assert_eq!(files, emit(&samples::all(), language).unwrap());
        assert!(files.is_sorted_by(|a, b| a.path < b.path));
        assert_eq!(language.name().parse(), Ok(language));
    }
    assert!("fortran".parse::<Language>().is_err());
}

#[test]
fn nothing_that_a_document_says_leaves_its_comment() {
    let mut evaluator = samples::rod();
    let nasty = "{ end */ \"\"\" \\ \n%{\n}\r\u{2028}mod x; /* ??/ ` -*- texinfo -*- <html";
    evaluator.title = nasty.into();
    evaluator.description = nasty.into();
    evaluator.source = nasty.into();
    evaluator.formula = vec![nasty.into()];
    evaluator.equations = vec![nasty.into()];
    evaluator.conditions = vec![nasty.into()];
    evaluator.command = nasty.into();
    evaluator.document = nasty.into();
    evaluator.hash = nasty.into();
    evaluator.proof = Some(nasty.into());
    evaluator.assumptions = vec![nasty.into()];
    evaluator.rounding = Some(Rounding {
        points: 1,
        domain: nasty.into(),
        largest: vec![f64::INFINITY; 4],
        percentile_99: vec![1e300; 4],
    });
    let mut quantities: Vec<&mut Quantity> = Vec::new();
    for input in &mut evaluator.inputs {
        if let Origin::Fixed(fixed) = &mut input.origin {
            fixed.text = nasty.into();
        }
        quantities.push(&mut input.quantity);
    }
    for angle in &mut evaluator.angles {
        if let Some(fixed) = &mut angle.fixed {
            fixed.text = nasty.into();
        }
        quantities.push(&mut angle.quantity);
    }
    for quantity in quantities.into_iter().chain(&mut evaluator.outputs) {
        quantity.unit = nasty.into();
        quantity.symbol = nasty.into();
        quantity.description = nasty.into();
    }
    let evaluators = [evaluator];
    for file in emit(&evaluators, Language::Rust).unwrap() {
        let outside = file
            .text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        assert!(
            outside.clone().all(|line| !line.contains("mod x;")),
            "{}",
            file.path
        );
    }
    for file in emit(&evaluators, Language::C).unwrap() {
        let mut rest = file.text.as_str();
        while let Some((outside, inside)) = rest.split_once("/*") {
            assert!(!outside.contains("mod x"), "{}", file.path);
            let (comment, after) = inside.split_once("*/").expect("a comment ends");
            assert!(!comment.contains("/*") && !comment.contains("??"));
            rest = after;
        }
        assert!(!rest.contains("mod x"), "{}", file.path);
    }
    for file in emit(&evaluators, Language::Python).unwrap() {
        let plain = file.text.replace("\\\\", "").replace("\\\"", "");
        let outside = plain.split("\"\"\"").step_by(2);
        assert!(
            outside.clone().all(|text| !text.contains("mod x")),
            "{}",
            file.path
        );
    }
    for file in emit(&evaluators, Language::Octave).unwrap() {
        let mut outside = file.text.lines().filter(|line| !line.starts_with('%'));
        assert!(outside.all(|line| !line.contains("mod x") && line.is_ascii()));
        // A block of comments, or a help text of another kind.
        let marks = ["\n%{", "-*-", "<html"];
        assert!(marks.iter().all(|mark| !file.text.contains(mark)));
    }
}

#[test]
fn what_cannot_be_written_is_an_error() {
    let program = |inputs: &[&str], outputs: &[&str]| {
        let mut program = Program::new(inputs.iter().map(|name| (*name).to_owned()));
        let one = program.constant(Rational::ONE);
        for output in outputs {
            program.output(*output, one);
        }
        Evaluator::plain("f", program)
    };
    let huge = {
        let mut program = Program::new(["a".to_owned()]);
        let value = program.constant(Rational::from(10).pow(400));
        let value = program.push(Operation::Multiply(value, program.input("a").unwrap()));
        program.output("b", value);
        Evaluator::plain("f", program)
    };
    let mut other = program(&["a"], &["b"]);
    other.inputs[0].quantity.name = "c".into();
    let mut named = program(&["a"], &["b"]);
    named.name = "../f".into();
    for language in Language::ALL {
        let error = |evaluators: &[Evaluator]| emit(evaluators, language).unwrap_err();
        assert_eq!(error(&[program(&["ω"], &["b"])]), Error::Name("ω".into()));
        assert_eq!(
            error(&[program(&["a b"], &["b"])]),
            Error::Name("a b".into())
        );
        assert_eq!(
            error(&[program(&["a", "a"], &["b"])]),
            Error::Twice("a".into())
        );
        assert_eq!(
            error(&[program(&["a"], &["b", "b"])]),
            Error::Twice("b".into())
        );
        assert_eq!(error(&[program(&["a"], &[])]), Error::Nothing("f".into()));
        assert_eq!(
            error(std::slice::from_ref(&named)),
            Error::Name("../f".into())
        );
        assert_eq!(
            error(std::slice::from_ref(&other)),
            Error::Quantities("f".into())
        );
        assert!(matches!(
            error(std::slice::from_ref(&huge)),
            Error::Constant(_)
        ));
        let twice = [program(&["a"], &["b"]), program(&["a"], &["b"])];
        assert_eq!(error(&twice), Error::Twice("f".into()));
    }
    // MATLAB would cut it off, without a word.
    let long = "a".repeat(64);
    let found = emit(&[program(&[&long], &["b"])], Language::Octave);
    assert_eq!(found.err(), Some(Error::Long(long.clone(), 63)));
    assert!(emit(&[program(&[&long[1..]], &["b"])], Language::Octave).is_ok());
}

#[test]
fn what_is_renamed_never_takes_the_name_of_another() {
    let mut program = Program::new(["double", "double_"].map(str::to_owned));
    let [a, b] = ["double", "double_"].map(|name| program.input(name).unwrap());
    let sum = program.push(Operation::Add(a, b));
    program.output("y", sum);
    let files = emit(&[Evaluator::plain("f", program)], Language::C).unwrap();
    let header = files.into_iter().find(|file| file.path == "f.h").unwrap();
    for name in ["double_;", "double__;"] {
        let field = format!("    double {name}");
        assert_eq!(header.text.matches(&field).count(), 1, "{name}");
    }
}

#[test]
fn unsafe_names_are_renamed_and_say_so() {
    for (language, path, names) in [
        (Language::Rust, "match_.rs", ["match_", "fn_"]),
        (Language::C, "match.h", ["I_", "double_"]),
        (Language::Python, "match_.py", ["lambda_", "t1_"]),
    ] {
        let text = text(language, path);
        for name in names {
            let before = name.trim_end_matches('_');
            assert!(
                text.contains(&format!("alled `{before}` in the document")),
                "{name}"
            );
        }
    }
}
