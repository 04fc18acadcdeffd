//! Octave and MATLAB: a function file for each evaluator, on arrays in the fields of a structure.
//!
//! Up to thirty inputs in a row would be exchanged unseen; a structure, or a table of MATLAB, has their names.

mod reserved;

use serde::Serialize;

use super::body::{self, Ingredients};
use super::documentation::{self, Comments};
use super::door::{Door, Source};
use super::literal::Decimal;
use super::notation::{Binding, Notation, Sign, Text, infix_by, plain_literal, prefix};
use super::printer::Printer;
use super::statements;
use super::taken::{Taken, Vocabulary};
use super::{Error, Field, File, Named, render, spaced};
use crate::evaluator::{Evaluator, Function};
use reserved::{FUNCTIONS, KEYWORDS};

const FUNCTION: &str = include_str!("../../templates/octave/function.m.tera");

/// MATLAB keeps so many letters of a name.
const LONGEST: usize = 63;

/// The language.
pub(super) const PRINTER: Printer = Printer {
    name: "octave",
    title: "Octave",
    taken: TAKEN,
    comments: COMMENTS,
    emit,
};

/// Every file has its own space of names; what it is called may hide a function from other files.
const TAKEN: Taken = Taken {
    words: KEYWORDS,
    files: FUNCTIONS,
    functions: &[],
    endings: &[],
    templates: &[FUNCTION],
    printed: &["cos", "double", "sin"],
    has_fields: true,
    is_shared: false,
};

const COMMENTS: Comments = Comments {
    prose: harmless,
    code: harmless,
    heading: |heading| format!("{heading}:"),
    constants: "which are done once a call",
    shows_fields: false,
};

/// Octave takes a help text with these for one in another language.
fn harmless(text: &str) -> String {
    text.replace("-*-", "- * -")
        .replace("<html", "< html")
        .replace("<HTML", "< HTML")
}

/// The signs of elements.
#[derive(Clone, Copy, Debug)]
pub struct Elements;

impl Notation for Elements {
    const WIDTH: usize = 72;

    fn literal(&self, decimal: &Decimal) -> Text {
        plain_literal(decimal)
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        infix_by([".*", "./"], sign, left, right)
    }

    fn negative(&self, operand: &Text) -> Text {
        prefix(operand)
    }

    fn square_root(&self, operand: &Text) -> Text {
        Text::new(format!("square_root({})", operand.text), Binding::Atom)
    }
}

#[derive(Serialize)]
struct View {
    function: String,
    documentation: Vec<String>,
    inputs: Vec<String>,
    outputs: Vec<String>,
    body: Vec<String>,
    /// Empty where no input is a sine or cosine.
    angles: Vec<String>,
    at_angles: Vec<String>,
}

/// A file for each evaluator.
///
/// # Errors
///
/// If a name is no identifier, is too long or occurs twice, or a constant is beyond the doubles.
fn emit(evaluators: &[Evaluator]) -> Result<Vec<File>, Error> {
    let all = Named::all(evaluators, &Vocabulary::of(TAKEN))?;
    let pairs = evaluators.iter().zip(&all);
    let files = pairs.map(|(evaluator, named)| {
        Ok(File {
            path: format!("{}.m", named.function),
            text: function(evaluator, named)?,
        })
    });
    files.collect()
}

fn function(evaluator: &Evaluator, named: &Named) -> Result<String, Error> {
    let (inputs, outputs) = named.fields(evaluator, &COMMENTS);
    let door = Door::of(evaluator, named, &COMMENTS)?;
    let names = |fields: &[Field]| -> Vec<String> {
        let names = fields.iter().map(|field| field.name.clone());
        names.collect()
    };
    let view = View {
        function: named.function.clone(),
        documentation: spaced(help(evaluator, named, door.as_ref())?),
        inputs: names(&inputs),
        outputs: names(&outputs),
        body: computed(evaluator, named)?,
        at_angles: door.as_ref().map(conversion).unwrap_or_default(),
        angles: door.map(|door| names(&door.fields)).unwrap_or_default(),
    };
    refuse_long(&view)?;
    render(FUNCTION, &view)
}

/// Names that MATLAB would cut off, and might take for one another then.
fn refuse_long(view: &View) -> Result<(), Error> {
    let fields = view.inputs.iter().chain(&view.outputs).chain(&view.angles);
    let mut names = fields.chain([&view.function]);
    match names.find(|name| name.len() > LONGEST) {
        Some(long) => Err(Error::Long(long.clone(), LONGEST)),
        None => Ok(()),
    }
}

/// The statements between the inputs and the outputs, with both.
fn computed(evaluator: &Evaluator, named: &Named) -> Result<Vec<String>, Error> {
    let ingredients = Ingredients::of(evaluator, named)?;
    let printed = statements::statements(
        &ingredients.program,
        &named.variables,
        &named.values,
        &Elements,
    )?;
    let mut lines: Vec<String> = Vec::new();
    for (field, name) in ingredients.read {
        lines.push(format!("{name} = double(given.{field});"));
    }
    for (name, number) in ingredients.fixed {
        lines.push(format!("{name} = {};", number.text));
    }
    for statement in &printed.statements {
        lines.push(format!("{} = {};", statement.name, statement.text));
    }
    for (name, text) in named.outputs.iter().zip(&printed.results) {
        lines.push(format!("values.{name} = {text};"));
    }
    Ok(lines)
}

/// The body of the function that takes angles.
fn conversion(door: &Door<'_>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (field, name) in &door.angles {
        lines.push(format!("{name} = double(angles.{field});"));
    }
    for (name, number) in &door.fixed {
        lines.push(format!("{name} = {};", number.text));
    }
    lines.extend(door.inputs.iter().map(|(name, source)| match source {
        Source::Given(field) => format!("inputs.{name} = angles.{field};"),
        Source::Circular(Function::Cosine, angle) => {
            format!("inputs.{name} = cos({});", angle.text)
        }
        Source::Circular(Function::Sine, angle) => format!("inputs.{name} = sin({});", angle.text),
    }));
    lines
}

/// What `help` shows: the title, how it is called, and all the rest.
fn help(
    evaluator: &Evaluator,
    named: &Named,
    door: Option<&Door<'_>>,
) -> Result<Vec<String>, Error> {
    let parts = body::parts(evaluator, named)?;
    let text = documentation::function(evaluator, &parts, &COMMENTS);
    let title = documentation::opening(evaluator, &COMMENTS).len();
    let (title, rest) = text.split_at(title.min(text.len()));
    let mut lines = title.to_vec();
    lines.extend(
        [
            "",
            "Generated by sextic from a derivation: do not edit.",
            "",
        ]
        .map(str::to_owned),
    );
    lines.extend(usage(evaluator, named));
    lines.extend(door.map(from_angles).unwrap_or_default());
    lines.extend(rest.to_vec());
    Ok(lines)
}

/// How it is called.
fn usage(evaluator: &Evaluator, named: &Named) -> Vec<String> {
    let function = &named.function;
    match evaluator.is_constant() {
        true => vec![
            format!("    result = {function}()"),
            String::new(),
            "The outputs are the fields of `result`.".to_owned(),
        ],
        false => vec![
            format!("    result = {function}(given)"),
            String::new(),
            "The inputs are the fields of the structure `given`, or columns of a table of MATLAB:".to_owned(),
            "numbers or arrays, whose sizes are equal, or 1, in each dimension. The outputs are the".to_owned(),
            "fields of `result`: arrays of the size of all inputs together.".to_owned(),
        ],
    }
}

/// What may be given for sines and cosines.
fn from_angles(door: &Door<'_>) -> Vec<String> {
    let is_angle = |field: &&Field| door.angles.iter().any(|(angle, _)| *angle == field.name);
    let mut lines = vec![
        String::new(),
        "Sines and cosines may be left out, where these angles are given beside the other inputs:"
            .to_owned(),
        String::new(),
    ];
    for field in door.fields.iter().filter(is_angle) {
        lines.push(format!(
            "- `{}`: {}",
            field.name,
            field.documentation.join(" ")
        ));
    }
    lines
}
