//! Whatever a document calls its quantities, its angles and its evaluators, the emitted text compiles.
//!
//! Every word of an emitted file becomes the name of an input, of an output, of a fixed input, of an angle
//! and of an evaluator. With `SEXTIC_ALL_NAMES=1` so do all words that the compilers themselves know.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use sextic_codegen::evaluator::{Angle, Circular, Evaluator, Fixed, Function, Origin, Quantity};
use sextic_codegen::language::{File, Language, emit, renamed, taken_names};
use sextic_codegen::program::{Operation, Program, Rational};

use crate::consumer;

/// What is asked of each word.
const ROLES: [Role; 4] = [Role::Input, Role::Output, Role::Fixed, Role::Angle];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    Input,
    Output,
    Fixed,
    Angle,
}

/// An evaluator in which every word has a role: 1·a + 2·b + …, times √2.
fn evaluator(name: &str, role: Role, words: &BTreeSet<String>) -> Evaluator {
    let inputs = words.iter().map(|word| match role {
        Role::Angle => format!("cos_{word}"),
        Role::Output => format!("of_{word}"),
        Role::Input | Role::Fixed => word.clone(),
    });
    // One input is free, whatever the role.
    let mut program = Program::new(inputs.chain(["free_of_all".to_owned()]));
    let two = program.constant(Rational::from(2));
    let root = program.push(Operation::SquareRoot(two));
    let mut sum = root;
    for place in 0..=words.len() {
        let input = program.input(&program.inputs()[place].clone()).unwrap();
        let factor = program.constant(Rational::from(place as u64 + 1));
        let term = program.push(Operation::Multiply(factor, input));
        sum = program.push(Operation::Add(sum, term));
        if let (Role::Output, Some(word)) = (role, words.iter().nth(place)) {
            program.output(word.clone(), sum);
        }
    }
    program.output("in_all", sum);
    let mut evaluator = Evaluator::plain(name, program);
    for (word, input) in words.iter().zip(&mut evaluator.inputs) {
        match role {
            Role::Input | Role::Output => {}
            Role::Fixed => {
                let (value, text) = (Rational::ONE, format!("{word} = 1"));
                input.origin = Origin::Fixed(Fixed { value, text });
            }
            Role::Angle => {
                input.origin = Origin::Circular(Circular {
                    function: Function::Cosine,
                    angle: vec![(1, word.clone())],
                });
                evaluator.angles.push(Angle {
                    quantity: Quantity::plain(word.clone()),
                    fixed: None,
                });
            }
        }
    }
    evaluator
}

/// The words of a text that are no comments, up to what each language has for them.
fn words_of(text: &str) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    let mut rest = text.to_owned();
    for (start, end) in [("\"\"\"", "\"\"\""), ("/*", "*/"), ("//", "\n")] {
        let mut bare = String::new();
        let mut from = rest.as_str();
        while let Some((before, comment)) = from.split_once(start) {
            bare.push_str(before);
            bare.push('\n');
            from = comment.split_once(end).map_or("", |(_, behind)| behind);
        }
        rest = bare + from;
    }
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    for word in rest.split(|letter| !is_part(letter)) {
        if word.starts_with(|first: char| first.is_ascii_alphabetic()) {
            words.insert(word.to_owned());
        }
    }
    words
}

/// The words of a file; the messages of Octave are none.
fn words_of_file(file: &File) -> BTreeSet<String> {
    if !file.path.ends_with(".m") {
        return words_of(&file.text);
    }
    let lines = file.text.lines().filter(|line| !line.starts_with('%'));
    let code: String = lines.map(|line| format!("{line}\n")).collect();
    let outside: Vec<&str> = code.split('"').step_by(2).collect();
    words_of(&outside.join(" "))
}

fn is_main(file: &File) -> bool {
    file.path.starts_with("probe")
}

/// The quantities of a sample.
const OWN: [&str; 5] = ["q", "cos_q", "of_q", "in_all", "free_of_all"];

/// The words that the files of an evaluator of this name contain, without those of quantities.
fn words(language: Language, name: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for role in ROLES {
        let sample = evaluator(name, role, &BTreeSet::from(["q".to_owned()]));
        for file in emit(&[sample], language)
            .unwrap()
            .iter()
            .filter(|file| is_main(file))
        {
            found.extend(words_of_file(file));
        }
    }
    found.retain(|word| !OWN.contains(&word.as_str()));
    found
}

/// Evaluators in whose roles all these words are, and evaluators that are called like them.
fn probes(language: Language, more: &BTreeSet<String>) -> Vec<Evaluator> {
    let mut evaluators = Vec::new();
    for role in ROLES {
        let name = format!("probe_{role:?}").to_ascii_lowercase();
        let mut all = words(language, &name);
        all.extend(more.iter().cloned());
        evaluators.push(evaluator(&name, role, &all));
    }
    let mut plain: BTreeSet<String> = BTreeSet::new();
    for name in words(language, "probe").iter().chain(more) {
        let key = name.replace('_', "").to_ascii_lowercase();
        if plain.insert(key) {
            evaluators.push(evaluator(
                name,
                Role::Input,
                &BTreeSet::from([name.clone()]),
            ));
        }
    }
    // An evaluator whose names another one would make.
    evaluators.push(evaluator(
        "probe",
        Role::Output,
        &BTreeSet::from(["probe".to_owned()]),
    ));
    let mut names = BTreeSet::new();
    evaluators.retain(|own| names.insert(own.name.replace('_', "").to_ascii_lowercase()));
    // Nothing is asked for.
    let mut none = evaluator(
        "nothing",
        Role::Fixed,
        &BTreeSet::from(["outputs".to_owned()]),
    );
    none.inputs[1].origin = none.inputs[0].origin.clone();
    evaluators.push(none);
    evaluators
}

/// Whether all words are to be tried that compilers know.
fn tries_all() -> bool {
    std::env::var_os("SEXTIC_ALL_NAMES").is_some()
}

fn write(folder: &Path, files: &[File]) {
    fs::create_dir_all(folder).unwrap();
    for file in files {
        fs::write(folder.join(&file.path), &file.text).unwrap();
    }
}

#[test]
fn every_word_of_a_text_is_taken_or_a_quantity() {
    for language in Language::ALL {
        for role in ROLES {
            let sample = evaluator("probe", role, &BTreeSet::from(["q".to_owned()]));
            let taken = taken_names(&sample, language).unwrap();
            let own = ["t1", "t2", "probe"];
            for file in emit(std::slice::from_ref(&sample), language)
                .unwrap()
                .iter()
                .filter(|file| is_main(file))
            {
                for word in words_of_file(file) {
                    let is_member = file.text.contains(&format!(".{word}"))
                        || file.text.contains(&format!("::{word}"))
                        || file.text.contains(&format!("{word}="))
                        || file.text.contains(&format!("'{word}"))
                        || file
                            .text
                            .lines()
                            .any(|line| line.trim_start().starts_with('#') && line.contains(&word))
                        || file.text.contains(&format!("\"{word}"));
                    let made = ["in_", "out_"].iter().any(|start| word.starts_with(start));
                    assert!(
                        taken.contains(&word)
                            || OWN.contains(&word.as_str())
                            || own.contains(&word.as_str())
                            || is_member
                            || made,
                        "{language}, {}: {word}",
                        file.path
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_renamed_is_told() {
    for (language, evaluator_name, word, expected) in [
        (
            Language::Rust,
            "fn",
            "match",
            vec![("fn", "fn_"), ("match", "match_")],
        ),
        (Language::C, "sin", "probe_outputs", vec![("sin", "sin_")]),
        (
            Language::Python,
            "probe",
            "ProbeOutputs",
            vec![("ProbeOutputs", "ProbeOutputs_")],
        ),
        (
            Language::Python,
            "probe",
            "at_angles",
            vec![("at_angles", "at_angles_")],
        ),
        // On some disks these are files that are there already.
        (
            Language::Rust,
            "Dispatch",
            "q",
            vec![("Dispatch", "Dispatch_")],
        ),
        (Language::C, "Math", "q", vec![("Math", "Math_")]),
        (
            Language::Octave,
            "while",
            "end",
            vec![("while", "while_"), ("end", "end_")],
        ),
        // A file of this name would hide the function.
        (Language::Octave, "Plot", "plot", vec![("Plot", "Plot_")]),
        (Language::Rust, "probe", "Lanes", vec![]),
        (Language::Octave, "probe", "values", vec![]),
        (Language::C, "probe", "probe_outputs", vec![]),
    ] {
        let sample = evaluator(
            evaluator_name,
            Role::Angle,
            &BTreeSet::from([word.to_owned()]),
        );
        let found = renamed(std::slice::from_ref(&sample), language).unwrap();
        let found: Vec<(&str, &str)> = found
            .iter()
            .flat_map(|own| {
                let function = (own.evaluator.as_str(), own.function.as_str());
                let names = own.names.iter();
                let names = names.map(|(name, written)| (name.as_str(), written.as_str()));
                let function = (function.0 != function.1).then_some(function);
                function.into_iter().chain(names)
            })
            .collect();
        assert_eq!(found, expected, "{language}");
    }
    // Of two evaluators, one would have a name that is made from the other.
    for (language, first, second, written) in [
        (Language::C, "k", "k_batch", "k_batch_"),
        (Language::Python, "k", "KInputs", "KInputs_"),
    ] {
        let both = [first, second].map(|name| evaluator(name, Role::Input, &BTreeSet::new()));
        let found = renamed(&both, language).unwrap();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].evaluator, second);
        assert_eq!(found[0].function, written);
    }
}

#[test]
fn rust_compiles_under_any_names() {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    if !consumer::present(&rustc, &["--version"]) {
        return;
    }
    let mut more: BTreeSet<String> = BTreeSet::new();
    if tries_all() {
        // What the support files say is in reach of nobody, but might be one day.
        for file in emit(&[], Language::Rust).unwrap() {
            more.extend(words_of(&file.text));
        }
        more.extend(
            [
                "yield",
                "gen",
                "try",
                "async",
                "dyn",
                "union",
                "macro_rules",
                "raw",
                "safe",
                "str",
                "u8",
                "bool",
                "char",
                "Vec",
                "Box",
                "drop",
                "Clone",
                "Drop",
                "From",
                "Into",
                "Iterator",
                "main",
                "test",
                "core",
                "std",
            ]
            .map(str::to_owned),
        );
    }
    let folder = consumer::folder("names-rust");
    write(
        &folder,
        &emit(&probes(Language::Rust, &more), Language::Rust).unwrap(),
    );
    let mut command = Command::new(rustc);
    command
        .args([
            "--edition",
            "2024",
            "--crate-type",
            "lib",
            "--crate-name",
            "names",
            "--emit",
            "metadata",
        ])
        .args([
            "-D",
            "warnings",
            "--cfg",
            "feature=\"std\"",
            "--check-cfg",
            "cfg(feature, values(\"std\"))",
        ])
        .arg("--out-dir")
        .arg(&folder)
        .arg(folder.join("lib.rs"));
    consumer::run(&mut command, "");
}

/// The macros and functions of the headers that are included.
fn known_to_gcc() -> BTreeSet<String> {
    let headers = "#include <math.h>\n#include <stddef.h>\n#include <float.h>\n";
    let mut known = BTreeSet::new();
    for standard in ["-std=c99", "-std=gnu17"] {
        for (option, all) in [("-dM", false), ("-P", true)] {
            let mut gcc = Command::new("gcc");
            let text = consumer::run(gcc.args([standard, "-E", option, "-"]), headers);
            for line in text.lines() {
                let line = line.strip_prefix("#define ").unwrap_or(line);
                match all {
                    true => known.extend(words_of(line)),
                    false => known.extend(words_of(line.split([' ', '(']).next().unwrap_or(""))),
                }
            }
        }
    }
    known
}

#[test]
fn c_compiles_under_any_names() {
    if !consumer::present("gcc", &["--version"]) {
        return;
    }
    let more = match tries_all() {
        true => known_to_gcc(),
        false => BTreeSet::new(),
    };
    let folder = consumer::folder("names-c");
    let files = emit(&probes(Language::C, &more), Language::C).unwrap();
    write(&folder, &files);
    let ending = |ending: &'static str| {
        let paths = files.iter().map(|file| folder.join(&file.path));
        paths.filter(move |path| path.extension().is_some_and(|own| own == ending))
    };
    for standard in ["-std=c99", "-std=gnu17"] {
        let mut gcc = Command::new("gcc");
        gcc.args([
            "-Wall",
            "-Wextra",
            "-Werror",
            "-pedantic",
            "-fsyntax-only",
            standard,
            "-I",
        ])
        .arg(&folder)
        .args(ending("c"));
        consumer::run(&mut gcc, "");
    }
    // All headers in one file: there is one space of names.
    let all = ending("h").map(|path| format!("#include \"{}\"\n", path.display()));
    let all: String = all.collect();
    let languages: &[&str] = match consumer::present("g++", &["--version"]) {
        true => &["c", "c++"],
        false => &["c"],
    };
    for language in languages {
        let mut gcc = Command::new("gcc");
        gcc.args([
            "-Wall",
            "-Wextra",
            "-Werror",
            "-fsyntax-only",
            "-x",
            language,
            "-I",
        ]);
        consumer::run(gcc.arg(&folder).arg("-"), &all);
    }
}

/// Calls every evaluator of a package with numbers, also by its angles; the sums are those of [`evaluator`].
const CALLS: &str = "
import dataclasses, importlib, inspect, math, pkgutil, sys
import evaluators
count = 0
for module in pkgutil.iter_modules(evaluators.__path__):
    module = importlib.import_module('evaluators.' + module.name)
    functions = [f for _, f in inspect.getmembers(module, inspect.isfunction) if f.__module__ == module.__name__]
    [function] = functions
    parameters = inspect.signature(function).parameters
    arguments = []
    if parameters:
        [kind] = [c for _, c in inspect.getmembers(module, inspect.isclass)
                  if c.__module__ == module.__name__ and 'at_angles' in dir(c)
                  or c.__module__ == module.__name__ and c.__name__.endswith('Inputs')]
        names = [field.name for field in dataclasses.fields(kind)]
        inputs = kind(**{name: 1.0 for name in names})
        if 'at_angles' in dir(kind):
            asked = inspect.signature(kind.at_angles).parameters
            assert kind.at_angles(**{name: 1.0 if name.startswith('free') else 0.0 for name in asked}) == inputs
        arguments = [inputs]
    outputs = dataclasses.asdict(function(*arguments))
    terms = round(outputs['in_all'] - math.sqrt(2.0))
    sizes = [n for n in range(1, 2000) if n * (n + 1) // 2 == terms]
    assert len(sizes) == 1, (module.__name__, outputs)
    assert [n for n in dir(evaluators) if n == function.__name__], module.__name__
    count += 1
print(count)
";

/// So much of NumPy that emitted functions of numbers run: names are tried, not arrays.
const NUMPY: &str = "
import math
float64 = float
class _Number(float):
    def __getitem__(self, place):
        return self
def asarray(value, dtype): return dtype(value)
def array(value): return _Number(value)
def broadcast_to(value, shape): return value
def broadcast_shapes(*shapes): return ()
def shape(value): return ()
sqrt, cos, sin = math.sqrt, math.cos, math.sin
";

#[test]
fn python_runs_under_any_names() {
    if !consumer::present("python3", &["--version"]) {
        return;
    }
    let mut more: BTreeSet<String> = BTreeSet::new();
    if tries_all() {
        let known = "import builtins, keyword, sys\nprint(*dir(builtins), *keyword.kwlist, *keyword.softkwlist, *sys.stdlib_module_names)";
        more = words_of(&consumer::run(
            Command::new("python3").args(["-c", known]),
            "",
        ));
        more.extend(words_of(NUMPY));
    }
    let folder: PathBuf = consumer::folder("names-python");
    let evaluators = probes(Language::Python, &more);
    write(
        &folder.join("evaluators"),
        &emit(&evaluators, Language::Python).unwrap(),
    );
    fs::create_dir_all(folder.join("numpy")).unwrap();
    fs::write(folder.join("numpy/__init__.py"), NUMPY).unwrap();
    fs::write(folder.join("numpy/typing.py"), "ArrayLike = float\n").unwrap();
    let mut python = Command::new("python3");
    python
        .args(["-B", "-W", "error", "-c", CALLS])
        .env("PYTHONPATH", &folder);
    let count = consumer::run(&mut python, "");
    assert_eq!(count.trim(), evaluators.len().to_string());
}

/// Calls a function of Octave with numbers, also by its angles; prints the sums.
fn calls_of(file: &File) -> String {
    let function = file.path.trim_end_matches(".m");
    let given = |kind: &str, value: fn(&str) -> u8| {
        let start = format!("fitted(shape, {kind}, \"");
        let fields = file.text.split(&start).skip(1);
        let fields = fields.filter_map(|rest| rest.split_once('"'));
        let fields = fields.map(|(field, _)| format!("s.{field} = {}; ", value(field)));
        fields.collect::<String>()
    };
    let call = |fields: String| {
        let arguments = if fields.is_empty() { "" } else { "s" };
        format!(
            "s = struct(); {fields}printf(\"%.0f \", {function}({arguments}).in_all - sqrt(2));\n"
        )
    };
    let of_angles = given("angles", |name| u8::from(name.starts_with("free")));
    match of_angles.is_empty() {
        true => call(given("given", |_| 1)),
        false => call(given("given", |_| 1)) + &call(of_angles),
    }
}

/// What Octave says of itself.
fn known_to_octave(expression: &str) -> BTreeSet<String> {
    let mut octave = Command::new("octave-cli");
    let known = format!("printf('%s ', {expression}{{:}})");
    let known = consumer::run(octave.args(["--quiet", "--norc", "--eval", &known]), "");
    words_of(&known)
}

#[test]
fn octave_runs_under_any_names() {
    if !consumer::present("octave-cli", &["--version"]) {
        return;
    }
    let mut more = known_to_octave("iskeyword()");
    if tries_all() {
        more.extend(known_to_octave("__builtins__()"));
        more.extend(known_to_octave("__list_functions__()"));
    }
    let folder = consumer::folder("names-octave");
    let files = emit(&probes(Language::Octave, &more), Language::Octave).unwrap();
    write(&folder, &files);
    let calls: String = files.iter().map(calls_of).collect();
    fs::write(folder.join("calls_of_all.m"), format!("1;\n{calls}")).unwrap();
    let mut octave = Command::new("octave-cli");
    octave.args(["--quiet", "--norc", "--path"]).arg(&folder);
    let found = consumer::run(octave.arg(folder.join("calls_of_all.m")), "");
    let sums: Vec<u64> = found
        .split_whitespace()
        .map(|sum| sum.parse().unwrap())
        .collect();
    assert!(sums.len() >= files.len());
    for sum in sums {
        assert!(
            (1..2000).any(|count| count * (count + 1) / 2 == sum),
            "{sum}"
        );
    }
}
