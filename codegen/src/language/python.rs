//! Python: a module for each evaluator, on NumPy arrays.

use serde::Serialize;

use super::body::{self, Ingredients};
use super::documentation::{self, Comments};
use super::door::{Door, Source};
use super::literal::Decimal;
use super::names::camel_case;
use super::notation::{Binding, Notation, Sign, Text, infix, plain_literal, prefix};
use super::printer::Printer;
use super::statements;
use super::taken::{Taken, Vocabulary};
use super::{Error, Field, File, Named, commands, render};
use crate::evaluator::{Evaluator, Function};

const MODULE: &str = include_str!("../../templates/python/module.py.tera");
const PACKAGE: &str = include_str!("../../templates/python/__init__.py.tera");

/// The keywords, and what was one.
pub const KEYWORDS: [&str; 41] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "case", "class",
    "continue", "def", "del", "elif", "else", "except", "exec", "finally", "float", "for", "from",
    "global", "if", "import", "in", "is", "lambda", "match", "nonlocal", "not", "or", "pass",
    "print", "raise", "return", "try", "type", "while", "with", "yield",
];

/// Fields are arguments too.
/// The language.
pub(super) const PRINTER: Printer = Printer {
    name: "python",
    title: "Python",
    taken: TAKEN,
    comments: COMMENTS,
    emit,
};

const TAKEN: Taken = Taken {
    words: &KEYWORDS,
    files: &[],
    functions: &[],
    endings: &[],
    templates: &[MODULE],
    printed: &["np", "shape"],
    has_fields: false,
    is_shared: true,
};

const COMMENTS: Comments = Comments {
    prose: harmless,
    code: harmless,
    heading: |heading| format!("{heading}:"),
    constants: "which are done once a call",
    shows_fields: false,
};

/// Does not end a text, and escapes nothing.
fn harmless(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"")
}

/// The usual signs, and roots by NumPy.
#[derive(Clone, Copy, Debug)]
pub struct Numpy;

impl Notation for Numpy {
    const WIDTH: usize = 72;

    fn literal(&self, decimal: &Decimal) -> Text {
        plain_literal(decimal)
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        infix(sign, left, right)
    }

    fn negative(&self, operand: &Text) -> Text {
        prefix(operand)
    }

    fn square_root(&self, operand: &Text) -> Text {
        Text::new(format!("np.sqrt({})", operand.text), Binding::Atom)
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
struct Import {
    function: String,
    camel: String,
    has_inputs: bool,
}

#[derive(Serialize)]
struct Package {
    commands: Vec<String>,
    modules: Vec<Import>,
}

/// The files of a package, in no particular order.
///
/// # Errors
///
/// If a name is no identifier or occurs twice, or a constant is beyond the doubles.
fn emit(evaluators: &[Evaluator]) -> Result<Vec<File>, Error> {
    let all = Named::all(evaluators, &Vocabulary::of(TAKEN))?;
    let mut files = Vec::new();
    let mut modules = Vec::new();
    for (evaluator, named) in evaluators.iter().zip(&all) {
        files.push(File {
            path: format!("{}.py", named.function),
            text: module(evaluator, named)?,
        });
        modules.push(Import {
            function: named.function.clone(),
            camel: camel_case(&named.function),
            has_inputs: !evaluator.is_constant(),
        });
    }
    modules.sort_by(|a, b| a.function.cmp(&b.function));
    let commands = commands(evaluators)
        .iter()
        .map(|command| harmless(command))
        .collect();
    files.push(File {
        path: "__init__.py".to_owned(),
        text: render(PACKAGE, &Package { commands, modules })?,
    });
    Ok(files)
}

fn module(evaluator: &Evaluator, named: &Named) -> Result<String, Error> {
    let ingredients = Ingredients::of(evaluator, named)?;
    let names = &named.variables;
    let printed = statements::statements(&ingredients.program, names, &named.values, &Numpy)?;
    let camel = camel_case(&named.function);
    let (mut inputs, mut outputs) = named.fields(evaluator, &COMMENTS);
    let mut body: Vec<String> = Vec::new();
    for (field, name) in ingredients.read {
        body.push(format!(
            "{name} = np.asarray(inputs.{field}, dtype=np.float64)"
        ));
    }
    for (name, number) in ingredients.fixed {
        body.push(format!("{name} = {}", number.text));
    }
    for statement in &printed.statements {
        body.push(format!("{} = {}", statement.name, statement.text));
    }
    // An output that does not depend on all inputs has the shape of all of them nevertheless.
    body.push("shape = np.broadcast_shapes(".to_owned());
    body.extend(
        inputs
            .iter()
            .map(|field| format!("    np.shape(inputs.{}),", field.name)),
    );
    body.push(")".to_owned());
    body.push(format!("return {camel}Outputs("));
    for (name, text) in named.outputs.iter().zip(&printed.results) {
        body.push(format!(
            "    {name}=np.array(np.broadcast_to({text}, shape))[()],"
        ));
    }
    body.push(")".to_owned());

    for field in inputs.iter_mut().chain(&mut outputs) {
        field.documentation = text(&field.documentation);
    }
    let door = Door::of(evaluator, named, &COMMENTS)?;
    let parts = body::parts(evaluator, named)?;
    render(
        MODULE,
        &Module {
            header: super::header(evaluator, &COMMENTS),
            function: named.function.clone(),
            camel,
            inputs,
            outputs,
            body,
            at_angles: door.as_ref().map(conversion).unwrap_or_default(),
            angles: door.map(|door| door.fields).unwrap_or_default(),
            documentation: documentation::function(evaluator, &parts, &COMMENTS),
        },
    )
}

/// The body of the method that takes angles.
fn conversion(door: &Door<'_>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (_, name) in &door.angles {
        lines.push(format!("{name} = np.asarray({name}, dtype=np.float64)"));
    }
    for (name, number) in &door.fixed {
        lines.push(format!("{name} = {}", number.text));
    }
    lines.push("return cls(".to_owned());
    lines.extend(door.inputs.iter().map(|(name, source)| match source {
        Source::Given(argument) => format!("    {name}={argument},"),
        Source::Circular(Function::Cosine, angle) => format!("    {name}=np.cos({}),", angle.text),
        Source::Circular(Function::Sine, angle) => format!("    {name}=np.sin({}),", angle.text),
    }));
    lines.push(")".to_owned());
    lines
}

/// Lines as a text that documents the field above it.
fn text(lines: &[String]) -> Vec<String> {
    let last = lines.len().saturating_sub(1);
    let line = |(place, line): (usize, &String)| {
        let start = if place == 0 { "\"\"\"" } else { "" };
        let end = if place == last { "\"\"\"" } else { "" };
        format!("{start}{line}{end}")
    };
    lines.iter().enumerate().map(line).collect()
}
