//! Emitted text, read back by parsers that share no code with the printers.
//!
//! A file is read as a whole: its bodies become readings, and everything around them must be, token for
//! token, what its shape says. Comments alone are not read.

mod body;
mod c;
mod cursor;
mod infix;
mod literal;
pub(super) mod names;
mod octave;
mod python;
mod reader;
mod rust;
mod shape;
mod source;
mod token;

use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{File, Language};

pub use body::{Door, Reading, Source, Term, Unreadable};
use names::{Names, spellings};
use reader::{Reader, Texts};

/// What was read of an evaluator's files, each part with its place in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// The functions that compute the outputs.
    pub bodies: Vec<(String, Reading)>,
    /// The function that takes angles, if any input is a sine or cosine.
    pub door: Option<(String, Door)>,
}

/// What some emitted files of an evaluator compute.
///
/// Files of other evaluators, and those that all evaluators share, are not read.
///
/// Complexity: linear in the length of the files.
///
/// # Errors
///
/// The name of a file and why it is [`Unreadable`]: it is missing, or something in it is not as it must be.
pub fn read(
    files: &[File],
    evaluator: &Evaluator,
    language: Language,
) -> Result<Readings, (String, Unreadable)> {
    let reader = reader(language);
    // A file of the name itself may be one that all evaluators share, such as `lib.rs`.
    let is_there = |function: &String| {
        let path = format!("{function}.{}", reader.ending);
        files.iter().any(|file| file.path == path)
    };
    let mut found = spellings(&evaluator.name, |_| false).filter(is_there);
    let first = found.next().unwrap_or_else(|| evaluator.name.clone());
    let read = |function: &str| {
        let texts = Texts { files, function };
        let mut names = Names::new(evaluator, function);
        let readings = (reader.read)(&texts, &mut names);
        readings.map(|(bodies, door)| Readings {
            bodies,
            door: (!names.asked.is_empty()).then_some(door),
        })
    };
    match read(&first) {
        Ok(readings) => Ok(readings),
        Err(refused) => found
            .find_map(|function| read(&function).ok())
            .ok_or(refused),
    }
}

fn reader(language: Language) -> Reader {
    match language {
        Language::Rust => rust::READER,
        Language::C => c::READER,
        Language::Python => python::READER,
        Language::Octave => octave::READER,
    }
}
