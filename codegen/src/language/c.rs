//! C99: a header and a source for each evaluator.

mod reserved;

use serde::Serialize;

use super::body::{self, Ingredients};
use super::documentation::{self, Comments};
use super::door::{Door, Source};
use super::literal::Decimal;
use super::notation::{Binding, Notation, Sign, Text, infix, plain_literal, prefix};
use super::printer::Printer;
use super::statements::{self, Body};
use super::taken::{Taken, Vocabulary, guard};
use super::{Error, Field, File, Named, render};
use crate::evaluator::{Evaluator, Function};
use reserved::{FUNCTIONS, RESERVED};

const HEADER: &str = include_str!("../../templates/c/header.h.tera");
const SOURCE: &str = include_str!("../../templates/c/source.c.tera");
const BOUNDED: &str = include_str!("../../support/sextic_bounded.h");

/// One space of names holds all evaluators, in C++ also what a structure has and the types of its fields.
/// The language.
pub(super) const PRINTER: Printer = Printer {
    name: "c",
    title: "C",
    taken: TAKEN,
    comments: COMMENTS,
    emit,
};

const TAKEN: Taken = Taken {
    words: RESERVED,
    files: &["float", "math", "sextic_bounded", "stddef"],
    functions: FUNCTIONS,
    endings: &["", "f", "l"],
    templates: &[HEADER, SOURCE],
    printed: &[
        "cos",
        "sextic_add",
        "sextic_divide",
        "sextic_exact",
        "sextic_multiply",
        "sextic_negative",
        "sextic_square_root",
        "sextic_subtract",
        "sin",
        "sqrt",
    ],
    has_fields: true,
    is_shared: true,
};

const COMMENTS: Comments = Comments {
    prose: harmless,
    code: harmless,
    heading: |heading| format!("{heading}:"),
    constants: "which the compiler does once",
    shows_fields: false,
};

/// Neither begins nor ends a comment, is no trigraph and continues no line.
fn harmless(text: &str) -> String {
    text.replace("*/", "* /")
        .replace("/*", "/ *")
        .replace("??", "? ?")
        .replace('\\', "\u{2216}")
}

/// The usual signs.
#[derive(Clone, Copy, Debug)]
pub struct Infix;

impl Notation for Infix {
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
        Text::new(format!("sqrt({})", operand.text), Binding::Atom)
    }
}

/// Calls of the functions of `sextic_bounded.h`.
#[derive(Clone, Copy, Debug)]
pub struct Calls;

impl Notation for Calls {
    const WIDTH: usize = 72;

    fn literal(&self, decimal: &Decimal) -> Text {
        Text::new(format!("sextic_exact({})", decimal.text), Binding::Atom)
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        let function = match sign {
            Sign::Add => "sextic_add",
            Sign::Subtract => "sextic_subtract",
            Sign::Multiply => "sextic_multiply",
            Sign::Divide => "sextic_divide",
        };
        let text = format!("{function}({}, {})", left.text, right.text);
        Text::new(text, Binding::Atom)
    }

    fn negative(&self, operand: &Text) -> Text {
        Text::new(format!("sextic_negative({})", operand.text), Binding::Atom)
    }

    fn square_root(&self, operand: &Text) -> Text {
        Text::new(
            format!("sextic_square_root({})", operand.text),
            Binding::Atom,
        )
    }
}

#[derive(Serialize)]
struct Module {
    header: Vec<String>,
    guard: String,
    function: String,
    inputs: Vec<Field>,
    outputs: Vec<Field>,
    body: Vec<String>,
    bounded_body: Vec<String>,
    /// Empty where no input is a sine or cosine.
    angles: Vec<Field>,
    at_angles: Vec<String>,
    documentation: Vec<String>,
}

/// The headers and sources, in no particular order.
///
/// # Errors
///
/// If a name is no identifier or occurs twice, or a constant is beyond the doubles.
fn emit(evaluators: &[Evaluator]) -> Result<Vec<File>, Error> {
    let mut files = vec![File {
        path: "sextic_bounded.h".to_owned(),
        text: BOUNDED.to_owned(),
    }];
    let all = Named::all(evaluators, &Vocabulary::of(TAKEN))?;
    for (evaluator, named) in evaluators.iter().zip(&all) {
        let module = module(evaluator, named)?;
        for (template, ending) in [(HEADER, "h"), (SOURCE, "c")] {
            files.push(File {
                path: format!("{}.{ending}", named.function),
                text: render(template, &module)?,
            });
        }
    }
    Ok(files)
}

fn module(evaluator: &Evaluator, named: &Named) -> Result<Module, Error> {
    let ingredients = Ingredients::of(evaluator, named)?;
    let (program, names) = (&ingredients.program, &named.variables);

    let infix = statements::statements(program, names, &named.values, &Infix)?;
    let read = ingredients.read.iter();
    let mut body: Vec<String> = read
        .map(|(field, name)| format!("const double {name} = inputs->{field};"))
        .collect();
    let fixed = ingredients.fixed.iter();
    body.extend(fixed.map(|(name, number)| format!("const double {name} = {};", number.text)));
    body.extend(lines("double", &infix));
    body.extend(result(&named.function, "outputs", named, &infix));

    let calls = statements::statements(program, names, &named.values, &Calls)?;
    let bounded =
        |name: &str, text: &str| format!("const sextic_bounded {name} = sextic_exact({text});");
    let read = ingredients.read.iter();
    let mut bounded_body: Vec<String> = read
        .map(|(field, name)| bounded(name, &format!("inputs->{field}")))
        .collect();
    let fixed = ingredients.fixed.iter();
    bounded_body.extend(fixed.map(|(name, number)| bounded(name, &number.text)));
    bounded_body.extend(lines("sextic_bounded", &calls));
    bounded_body.extend(result(&named.function, "bounds", named, &calls));

    let door = Door::of(evaluator, named, &COMMENTS)?;
    let at_angles = door
        .as_ref()
        .map(|door| conversion(&named.function, door))
        .unwrap_or_default();
    let mut angles = door.map(|door| door.fields).unwrap_or_default();
    let (mut inputs, mut outputs) = named.fields(evaluator, &COMMENTS);
    for field in inputs.iter_mut().chain(&mut outputs).chain(&mut angles) {
        field.documentation = block(&field.documentation);
    }
    let parts = body::parts(evaluator, named)?;
    Ok(Module {
        header: super::spaced(super::header(evaluator, &COMMENTS)),
        guard: guard(&named.function),
        function: named.function.clone(),
        inputs,
        outputs,
        body,
        bounded_body,
        angles,
        at_angles,
        documentation: super::spaced(documentation::function(evaluator, &parts, &COMMENTS)),
    })
}

/// The body of the function that takes angles.
fn conversion(function: &str, door: &Door<'_>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (field, name) in &door.angles {
        lines.push(format!("const double {name} = angles->{field};"));
    }
    for (name, number) in &door.fixed {
        lines.push(format!("const double {name} = {};", number.text));
    }
    lines.push(format!("return ({function}_inputs){{"));
    lines.extend(door.inputs.iter().map(|(name, source)| match source {
        Source::Given(field) => format!("    .{name} = angles->{field},"),
        Source::Circular(Function::Cosine, angle) => format!("    .{name} = cos({}),", angle.text),
        Source::Circular(Function::Sine, angle) => format!("    .{name} = sin({}),", angle.text),
    }));
    lines.push("};".to_owned());
    lines
}

fn lines(kind: &str, body: &Body) -> Vec<String> {
    let statements = body.statements.iter();
    statements
        .map(|statement| format!("const {kind} {} = {};", statement.name, statement.text))
        .collect()
}

fn result(function: &str, kind: &str, named: &Named, body: &Body) -> Vec<String> {
    let mut lines = vec![format!("return ({function}_{kind}){{")];
    let fields = named.outputs.iter().zip(&body.results);
    lines.extend(fields.map(|(name, text)| format!("    .{name} = {text},")));
    lines.push("};".to_owned());
    lines
}

/// Lines as a comment.
fn block(lines: &[String]) -> Vec<String> {
    let last = lines.len().saturating_sub(1);
    let line = |(place, line): (usize, &String)| {
        let start = if place == 0 { "/*" } else { " *" };
        let end = if place == last { " */" } else { "" };
        format!("{start} {line}{end}")
    };
    lines.iter().enumerate().map(line).collect()
}
