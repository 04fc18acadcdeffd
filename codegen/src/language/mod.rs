//! From evaluators to source text.
//!
//! A printer turns operations into statements; a template only places them.

pub mod c;
pub mod documentation;
pub mod literal;
pub mod names;
pub mod python;
pub mod rust;
pub mod statements;

use std::fmt;
use std::str::FromStr;

use serde::Serialize;

use crate::evaluator::{Evaluator, Quantity};
use crate::program::{Operation, Program};
use documentation::Comments;
use names::Names;

/// What source text can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Language {
    /// Rust: generic bodies, scalar functions, bounds of the rounding error, batches.
    Rust,
    /// C99: scalar functions, bounds of the rounding error, plain loops.
    C,
    /// Python with NumPy.
    Python,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 3] = [Language::Rust, Language::C, Language::Python];

    /// What it is called on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Language::Rust => "rust",
            Language::C => "c",
            Language::Python => "python",
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// No language is called that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLanguage(pub String);

impl fmt::Display for UnknownLanguage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no language {:?}", self.0)
    }
}

impl std::error::Error for UnknownLanguage {}

impl FromStr for Language {
    type Err = UnknownLanguage;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let known = Language::ALL.into_iter().find(|known| known.name() == name);
        known.ok_or_else(|| UnknownLanguage(name.to_owned()))
    }
}

/// A file that is to be written.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct File {
    /// Its path below the output folder, with `/`.
    pub path: String,
    /// What it contains.
    pub text: String,
}

/// Why nothing can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// A name is no ASCII identifier.
    Name(String),
    /// A name occurs twice among the inputs, the outputs or the evaluators.
    Twice(String),
    /// A constant is beyond the doubles.
    Constant(String),
    /// The quantities of an evaluator are not those of its program.
    Quantities(String),
    /// An evaluator has no input or no output left.
    Nothing(String),
    /// A template failed: a bug.
    Template(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Name(name) => write!(
                f,
                "{name:?} is no name in an emitted text: it needs a letter of ASCII first, then \
                 letters, digits and _"
            ),
            Error::Twice(name) => write!(f, "the name {name:?} occurs twice"),
            Error::Constant(value) => {
                let digits = value.len();
                match digits > 40 {
                    true => write!(
                        f,
                        "a constant of {digits} digits is beyond the range of a double"
                    ),
                    false => write!(f, "the constant {value} is beyond the range of a double"),
                }
            }
            Error::Quantities(name) => write!(
                f,
                "the quantities of the evaluator {name} are not the inputs and outputs of its program"
            ),
            Error::Nothing(name) => write!(
                f,
                "the evaluator {name} has no input or no output left; there is nothing to compute"
            ),
            Error::Template(message) => write!(f, "a template failed: {message}"),
        }
    }
}

impl std::error::Error for Error {}

/// Writes evaluators in a language; files come in the order of their paths.
///
/// # Errors
///
/// If a name is no identifier or occurs twice, or a constant is beyond the doubles.
pub fn emit(evaluators: &[Evaluator], language: Language) -> Result<Vec<File>, Error> {
    for evaluator in evaluators {
        check(evaluator)?;
    }
    let mut files = match language {
        Language::Rust => rust::emit(evaluators)?,
        Language::C => c::emit(evaluators)?,
        Language::Python => python::emit(evaluators)?,
    };
    files.sort();
    Ok(files)
}

fn check(evaluator: &Evaluator) -> Result<(), Error> {
    let program = &evaluator.program;
    let inputs = evaluator.inputs.iter().map(|quantity| &quantity.name);
    let outputs = evaluator.outputs.iter().map(|quantity| &quantity.name);
    let same = inputs.eq(program.inputs())
        && outputs.eq(program.outputs().iter().map(|(name, _)| name))
        && evaluator
            .rounding
            .as_ref()
            .is_none_or(|rounding| rounding.largest.len() == evaluator.outputs.len());
    if !same {
        return Err(Error::Quantities(evaluator.name.clone()));
    }
    if evaluator.inputs.is_empty() || evaluator.outputs.is_empty() {
        return Err(Error::Nothing(evaluator.name.clone()));
    }
    Ok(())
}

/// A field of a structure, as a template places it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
struct Field {
    name: String,
    documentation: Vec<String>,
}

/// The names of an evaluator in a language.
struct Named {
    function: String,
    inputs: Names,
    outputs: Names,
    /// What the values of the outputs are called in the body, where that name is free.
    values: Vec<Option<String>>,
}

impl Named {
    /// Of each evaluator.
    ///
    /// `modules` are names that only an evaluator must not have.
    fn all(
        evaluators: &[Evaluator],
        reserved: &[&str],
        modules: &[&str],
    ) -> Result<Vec<Self>, Error> {
        let forbidden: Vec<&str> = reserved.iter().chain(modules).copied().collect();
        let functions = evaluators.iter().map(|evaluator| evaluator.name.as_str());
        let functions = names::safe(functions, &forbidden)?.names;
        let pairs = evaluators.iter().zip(functions);
        pairs
            .map(|(evaluator, function)| Named::of(evaluator, function, reserved))
            .collect()
    }

    fn of(evaluator: &Evaluator, function: String, reserved: &[&str]) -> Result<Self, Error> {
        let inputs = evaluator.inputs.iter().map(|what| what.name.as_str());
        let outputs = evaluator.outputs.iter().map(|what| what.name.as_str());
        let inputs = names::safe(inputs, reserved)?;
        let outputs = names::safe(outputs, reserved)?;
        let free = |name: &String| (!inputs.names.contains(name)).then(|| name.clone());
        Ok(Named {
            function,
            values: outputs.names.iter().map(free).collect(),
            inputs,
            outputs,
        })
    }

    fn fields(&self, evaluator: &Evaluator, comments: &Comments) -> (Vec<Field>, Vec<Field>) {
        let field = |name: &String, what: &Quantity| Field {
            name: name.clone(),
            documentation: documentation::field(what, *name != what.name, comments),
        };
        let of = |names: &Names, quantities: &[Quantity]| {
            let pairs = names.names.iter().zip(quantities);
            pairs.map(|(name, what)| field(name, what)).collect()
        };
        (
            of(&self.inputs, &evaluator.inputs),
            of(&self.outputs, &evaluator.outputs),
        )
    }
}

/// Places strings in a template. The names of templates end in none of those that are escaped.
fn render<T: Serialize>(template: &str, view: &T) -> Result<String, Error> {
    let failed = |error: tera::Error| {
        let mut message = error.to_string();
        let mut cause = std::error::Error::source(&error);
        while let Some(inner) = cause {
            message.push_str(&format!(": {inner}"));
            cause = inner.source();
        }
        Error::Template(message)
    };
    let mut tera = tera::Tera::new();
    tera.add_raw_template("text", template).map_err(failed)?;
    let context = tera::Context::from_serialize(view).map_err(failed)?;
    tera.render("text", &context).map_err(failed)
}

/// The commands that made some evaluators, each once, in order.
fn commands(evaluators: &[Evaluator]) -> Vec<String> {
    let mut commands: Vec<String> = Vec::new();
    for evaluator in evaluators {
        let command = documentation::flat(&evaluator.command);
        if !command.is_empty() && !commands.contains(&command) {
            commands.push(command);
        }
    }
    commands
}

/// The names of the inputs that a program uses.
fn used<'a>(evaluator: &Evaluator, program: &Program, names: &'a [String]) -> Vec<&'a String> {
    let operations = program.operations();
    let mut used = vec![false; operations.len()];
    for node in operations
        .iter()
        .flat_map(Operation::operands)
        .chain(program.outputs().iter().map(|(_, node)| *node))
    {
        used[node.index()] = true;
    }
    let inputs = names.iter().zip(&evaluator.inputs);
    inputs
        .filter(|(_, what)| {
            program
                .input(&what.name)
                .is_some_and(|node| used[node.index()])
        })
        .map(|(name, _)| name)
        .collect()
}

/// A comment's lines: a space before those that are not empty.
fn spaced(lines: Vec<String>) -> Vec<String> {
    let space = |line: String| match line.is_empty() {
        true => line,
        false => format!(" {line}"),
    };
    lines.into_iter().map(space).collect()
}

/// The first lines of a file.
fn header(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    let mut lines = vec![documentation::title(evaluator, comments), String::new()];
    lines.push("Generated by sextic from a derivation: do not edit.".to_owned());
    let origin = documentation::origin(evaluator, comments);
    if !origin.is_empty() {
        lines.push(String::new());
        lines.extend(origin);
    }
    lines
}
