//! Rust: a module for each evaluator, and a crate around them.

use serde::Serialize;

use super::body::{self, Ingredients};
use super::documentation::{self, Comments};
use super::door::{Door, Source};
use super::literal::Decimal;
use super::names::camel_case;
use super::notation::{Binding, Fused, Notation, Sign, Text, infix, plain_literal, prefix};
use super::printer::Printer;
use super::statements;
use super::taken::{Taken, Vocabulary};
use super::{Error, Field, File, Named, commands, render};
use crate::evaluator::{Evaluator, Function};

const MODULE: &str = include_str!("../../templates/rust/module.rs.tera");
const LIBRARY: &str = include_str!("../../templates/rust/lib.rs.tera");

/// What every evaluator builds on.
const SUPPORT: [(&str, &str); 9] = [
    ("arithmetic", include_str!("../../support/arithmetic.rs")),
    ("batch", include_str!("../../support/batch.rs")),
    ("bounded", include_str!("../../support/bounded.rs")),
    ("comparison", include_str!("../../support/comparison.rs")),
    ("dispatch", include_str!("../../support/dispatch.rs")),
    ("lanes", include_str!("../../support/lanes.rs")),
    ("octet", include_str!("../../support/octet.rs")),
    ("pair", include_str!("../../support/pair.rs")),
    ("quartet", include_str!("../../support/quartet.rs")),
];

/// The iteration that finds exact modes: it builds on the evaluators [`ITERATED`], and is written beside them.
const EXACT_MODES: [(&str, &str); 5] = [
    ("complex", include_str!("../../support/complex.rs")),
    ("exact_modes", include_str!("../../support/exact_modes.rs")),
    (
        "exact_modes_batch",
        include_str!("../../support/exact_modes_batch.rs"),
    ),
    ("reference", include_str!("../../support/reference.rs")),
    (
        "starting_values",
        include_str!("../../support/starting_values.rs"),
    ),
];

/// What [`EXACT_MODES`] iterates, with nothing fixed.
const ITERATED: [&str; 3] = [
    "section_matrices",
    "shifted_determinant",
    "shifted_polynomial",
];

/// Keywords of all editions.
const KEYWORDS: [&str; 53] = [
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Roots of crates, and crates that every other one sees.
const ROOTS: [&str; 5] = ["alloc", "core", "lib", "main", "std"];

/// Modules that an evaluator must not be: those of [`SUPPORT`] and [`EXACT_MODES`], and [`ROOTS`].
const MODULES: [&str; ROOTS.len() + SUPPORT.len() + EXACT_MODES.len()] = {
    let mut modules = [""; ROOTS.len() + SUPPORT.len() + EXACT_MODES.len()];
    let mut place = 0;
    while place < ROOTS.len() {
        modules[place] = ROOTS[place];
        place += 1;
    }
    place = 0;
    while place < SUPPORT.len() {
        modules[ROOTS.len() + place] = SUPPORT[place].0;
        place += 1;
    }
    place = 0;
    while place < EXACT_MODES.len() {
        modules[ROOTS.len() + SUPPORT.len() + place] = EXACT_MODES[place].0;
        place += 1;
    }
    modules
};

/// Each evaluator is in a module of its own.
/// The language.
pub(super) const PRINTER: Printer = Printer {
    name: "rust",
    title: "Rust",
    taken: TAKEN,
    comments: COMMENTS,
    emit,
};

const TAKEN: Taken = Taken {
    words: &KEYWORDS,
    files: &MODULES,
    functions: &[],
    endings: &[],
    templates: &[MODULE],
    // What a name in a pattern would be taken for.
    printed: &["Err", "None", "Ok", "Some"],
    has_fields: true,
    is_shared: false,
};

const COMMENTS: Comments = Comments {
    prose: markdown,
    code: str::to_owned,
    heading: |heading| format!("# {heading}"),
    constants: "which the compiler does once",
    shows_fields: true,
};

/// Nothing becomes a link, a tag or emphasis.
fn markdown(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        if matches!(letter, '\\' | '[' | ']' | '<' | '>' | '*' | '`') {
            escaped.push('\\');
        }
        escaped.push(letter);
    }
    escaped
}

/// Methods and operators of the trait `Arithmetic`.
#[derive(Clone, Copy, Debug)]
pub struct Generic;

impl Generic {
    /// A literal that stands to the right of an operator: a plain number.
    fn right(text: &Text) -> Text {
        match &text.decimal {
            Some(decimal) => plain_literal(decimal),
            None => text.clone(),
        }
    }
}

impl Notation for Generic {
    // What rustfmt leaves on one line.
    const WIDTH: usize = 58;
    const FUSES: bool = true;

    fn literal(&self, decimal: &Decimal) -> Text {
        Text {
            text: format!("T::constant({})", decimal.text),
            binding: Binding::Atom,
            decimal: Some(decimal.clone()),
        }
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        let swaps = matches!(sign, Sign::Add | Sign::Multiply);
        match (&left.decimal, &right.decimal) {
            // Sums and products are the same in both orders, to the bit.
            (Some(_), None) if swaps => infix(sign, right, &Generic::right(left)),
            _ => infix(sign, left, &Generic::right(right)),
        }
    }

    fn negative(&self, operand: &Text) -> Text {
        match &operand.decimal {
            Some(decimal) => self.literal(&decimal.negated()),
            None => prefix(operand),
        }
    }

    fn square_root(&self, operand: &Text) -> Text {
        let operand = operand.at_least(Binding::Atom);
        Text::new(format!("{operand}.square_root()"), Binding::Atom)
    }

    fn fused(&self, fused: &Fused<'_>) -> Text {
        let (left, right) = match (&fused.factors.0.decimal, &fused.factors.1.decimal) {
            (Some(_), None) => (fused.factors.1, fused.factors.0),
            _ => fused.factors,
        };
        let (left, right) = match (fused.negative_product, &right.decimal) {
            (false, _) => (left.clone(), right.clone()),
            (true, Some(_)) => (left.clone(), self.negative(right)),
            (true, None) => (self.negative(left), right.clone()),
        };
        let addend = match fused.negative_addend {
            true => self.negative(fused.addend),
            false => fused.addend.clone(),
        };
        let receiver = left.at_least(Binding::Atom);
        let text = format!("{receiver}.multiply_add({}, {})", right.text, addend.text);
        Text::new(text, Binding::Atom)
    }
}

#[derive(Serialize)]
struct Module {
    header: Vec<String>,
    function: String,
    camel: String,
    inputs: Vec<Field>,
    outputs: Vec<Field>,
    body: Vec<String>,
    /// Empty where no input is a sine or cosine.
    angles: Vec<Field>,
    at_angles: Vec<String>,
    documentation: Vec<String>,
}

#[derive(Serialize)]
struct Library {
    commands: Vec<String>,
    list: Vec<String>,
    /// The declarations of what evaluators build on.
    support: Vec<String>,
    modules: Vec<String>,
}

/// The files of a crate, in no particular order.
///
/// # Errors
///
/// If a name is no identifier or occurs twice, or a constant is beyond the doubles.
fn emit(evaluators: &[Evaluator]) -> Result<Vec<File>, Error> {
    let mut modules = Vec::new();
    let mut list = Vec::new();
    let mut files = Vec::new();
    for (evaluator, named) in evaluators
        .iter()
        .zip(Named::all(evaluators, &Vocabulary::of(TAKEN))?)
    {
        let function = &named.function;
        files.push(File {
            path: format!("{function}.rs"),
            text: module(evaluator, &named)?,
        });
        let title = documentation::title(evaluator, &COMMENTS);
        // A link before the colon would be taken for the definition of a link.
        let title = title.trim_end_matches('.');
        list.push(format!(" - {title}: [`{function}::{function}`]"));
        modules.push(function.clone());
    }
    let mut support = SUPPORT.to_vec();
    if are_iterated(evaluators) {
        support.extend(EXACT_MODES);
        support.sort_unstable();
        list.push(" - The three modes of a section, with a rigorous radius each, by an iteration: [`exact_modes::exact_modes`], and of many: [`exact_modes_batch::exact_modes_batch`]".to_owned());
    }
    modules.sort();
    list.sort();
    if !list.is_empty() {
        list.insert(0, String::new());
    }
    let library = Library {
        commands: commands(evaluators),
        list,
        support: support.iter().map(declaration).collect(),
        modules,
    };
    files.push(File {
        path: "lib.rs".to_owned(),
        text: render(LIBRARY, &library)?,
    });
    files.extend(support.iter().map(|(name, text)| File {
        path: format!("{name}.rs"),
        text: (*text).to_owned(),
    }));
    Ok(files)
}

/// `pub mod lanes`, or without `pub` where there is nothing that is public.
fn declaration((name, text): &(&str, &str)) -> String {
    let is_public = text.lines().any(|line| line.starts_with("pub "));
    let visibility = if is_public { "pub " } else { "" };
    format!("{visibility}mod {name}")
}

/// Whether all evaluators are there that the iteration builds on, each as a function of all of its inputs.
fn are_iterated(evaluators: &[Evaluator]) -> bool {
    ITERATED.iter().all(|name| {
        let is_whole = |own: &&Evaluator| own.inputs.iter().all(|input| input.fixed().is_none());
        evaluators
            .iter()
            .filter(is_whole)
            .any(|own| own.name == *name)
    })
}

fn module(evaluator: &Evaluator, named: &Named) -> Result<String, Error> {
    let ingredients = Ingredients::of(evaluator, named)?;
    let names = &named.variables;
    let printed = statements::statements(&ingredients.program, names, &named.values, &Generic)?;
    let camel = camel_case(&named.function);
    let mut body: Vec<String> = Vec::new();
    for (field, name) in ingredients.read {
        body.push(format!("let {name} = inputs.{field};"));
    }
    for (name, number) in ingredients.fixed {
        body.push(format!("let {name} = T::constant({});", number.text));
    }
    for statement in &printed.statements {
        body.push(format!("let {} = {};", statement.name, statement.text));
    }
    let results: Vec<String> = named
        .outputs
        .iter()
        .zip(&printed.results)
        .map(|(name, text)| match name == text {
            true => name.clone(),
            false => format!("{name}: {text}"),
        })
        .collect();
    body.extend(structure(&format!("{camel}Outputs"), &results));

    let door = Door::of(evaluator, named, &COMMENTS)?;
    let at_angles = door
        .as_ref()
        .map(|door| conversion(&camel, door))
        .unwrap_or_default();
    let (inputs, outputs) = named.fields(evaluator, &COMMENTS);
    let parts = body::parts(evaluator, named)?;
    let documentation = documentation::function(evaluator, &parts, &COMMENTS);
    render(
        MODULE,
        &Module {
            header: super::spaced(super::header(evaluator, &COMMENTS)),
            function: named.function.clone(),
            inputs,
            outputs,
            body,
            angles: door.map(|door| asked(&camel, door)).unwrap_or_default(),
            at_angles,
            documentation: super::spaced(documentation),
            camel,
        },
    )
}

/// What is asked for where angles are; what is an input itself is described there.
fn asked(camel: &str, door: Door<'_>) -> Vec<Field> {
    let is_angle = |name: &String| door.angles.iter().any(|(angle, _)| angle == name);
    let given = vec![format!("As in [`{camel}Inputs`].")];
    let field = |field: Field| match is_angle(&field.name) {
        true => field,
        false => Field {
            documentation: given.clone(),
            ..field
        },
    };
    door.fields.into_iter().map(field).collect()
}

/// The body of the function that takes angles.
fn conversion(camel: &str, door: &Door<'_>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (field, name) in &door.angles {
        lines.push(format!("let {name} = angles.{field};"));
    }
    for (name, number) in &door.fixed {
        lines.push(format!("let {name}: f64 = {};", number.text));
    }
    let fields = door.inputs.iter().map(|(name, source)| match source {
        Source::Given(field) => format!("{name}: angles.{field}"),
        Source::Circular(function, angle) => {
            let function = match function {
                Function::Cosine => "cos",
                Function::Sine => "sin",
            };
            format!("{name}: {}.{function}()", angle.at_least(Binding::Atom))
        }
    });
    let fields: Vec<String> = fields.collect();
    lines.extend(structure(&format!("{camel}Inputs"), &fields));
    lines
}

/// A structure as rustfmt writes it.
fn structure(name: &str, fields: &[String]) -> Vec<String> {
    let short = fields.join(", ");
    if short.len() <= 18 {
        return vec![format!("{name} {{ {short} }}")];
    }
    let mut lines = vec![format!("{name} {{")];
    lines.extend(fields.iter().map(|field| format!("    {field},")));
    lines.push("}".to_owned());
    lines
}
