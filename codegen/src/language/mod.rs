//! From evaluators to source text.
//!
//! A printer turns operations into statements; a template only places them.

mod body;
pub mod c;
pub mod documentation;
mod door;
mod error;
pub mod literal;
mod named;
pub mod names;
pub mod notation;
pub mod python;
pub mod rust;
pub mod statements;

use std::fmt;
use std::str::FromStr;

use serde::Serialize;

use crate::evaluator::{Evaluator, Input};
use documentation::Comments;
pub use error::Error;
use named::{Field, Named};

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
    let inputs = evaluator.inputs.iter().map(|input| &input.quantity.name);
    let outputs = evaluator.outputs.iter().map(|quantity| &quantity.name);
    let count = evaluator.outputs.len();
    let same = inputs.eq(program.inputs())
        && outputs.eq(program.outputs().iter().map(|(name, _)| name))
        && evaluator.rounding.as_ref().is_none_or(|rounding| {
            rounding.largest.len() == count && rounding.percentile_99.len() == count
        });
    if !same || !has_its_angles(evaluator) {
        return Err(Error::Quantities(evaluator.name.clone()));
    }
    if evaluator.free_inputs().next().is_none() || evaluator.outputs.is_empty() {
        return Err(Error::Nothing(evaluator.name.clone()));
    }
    Ok(())
}

/// Whether every circular input is that of a sum of known angles, none of them both fixed and asked for.
fn has_its_angles(evaluator: &Evaluator) -> bool {
    let is_given = |name: &str| {
        let mut names = evaluator.free_inputs().map(|input| &input.quantity.name);
        names.any(|input| input == name)
    };
    let is_known = |(count, name): &(i32, String)| {
        let angle = evaluator.angle(name);
        let is_clear = angle.is_some_and(|angle| angle.fixed.is_none() || !is_given(name));
        *count != 0 && is_clear
    };
    let mut sums = evaluator.inputs.iter().filter_map(Input::circular);
    sums.all(|sum| !sum.angle.is_empty() && sum.angle.iter().all(is_known))
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
    let mut lines = documentation::opening(evaluator, comments);
    lines.push(String::new());
    lines.push("Generated by sextic from a derivation: do not edit.".to_owned());
    lines.push(String::new());
    lines.extend(documentation::summary(evaluator, comments));
    lines.extend(documentation::origin(evaluator, comments));
    lines
}
