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
mod python;
mod rust;
mod shape;
mod token;

use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::{File, Language};

pub use body::{Door, Reading, Source, Term, Unreadable};
use names::{Names, spellings};

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
    let main = match language {
        Language::Rust => "rs",
        Language::C => "c",
        Language::Python => "py",
    };
    // A file of the name itself may be one that all evaluators share, such as `lib.rs`.
    let is_there = |function: &String| {
        let path = format!("{function}.{main}");
        files.iter().any(|file| file.path == path)
    };
    let mut found = spellings(&evaluator.name, |_| false).filter(is_there);
    let first = found.next().unwrap_or_else(|| evaluator.name.clone());
    let read = |function: &str| read_as(files, evaluator, language, function);
    match read(&first) {
        Ok(readings) => Ok(readings),
        Err(refused) => found
            .find_map(|function| read(&function).ok())
            .ok_or(refused),
    }
}

/// The same where the function has this name.
fn read_as(
    files: &[File],
    evaluator: &Evaluator,
    language: Language,
    function: &str,
) -> Result<Readings, (String, Unreadable)> {
    let (main, ending) = match language {
        Language::Rust => ("rs", "rs"),
        Language::C => ("c", "h"),
        Language::Python => ("py", "py"),
    };
    let file = |path: &str| files.iter().find(|file| file.path == path);
    let text = |ending: &str| {
        let path = format!("{function}.{ending}");
        match file(&path) {
            Some(file) => Ok((path, file.text.as_str())),
            None => {
                let reason = "the file is missing".to_string();
                Err((path, Unreadable { line: 1, reason }))
            }
        }
    };
    let mut names = Names::new(evaluator, function);
    let (path, source) = text(main)?;
    let unreadable = |unreadable| (path.clone(), unreadable);
    let place = |suffix: &str| format!("{path}, `{function}{suffix}`");
    let (bodies, door) = match language {
        Language::Rust => {
            let (reading, door) = rust::read(source, &mut names).map_err(unreadable)?;
            (
                vec![(place("_body"), reading)],
                (place("Inputs::from"), door),
            )
        }
        Language::C => {
            let (header_path, header) = text(ending)?;
            c::read_header(header, &mut names).map_err(|unreadable| (header_path, unreadable))?;
            let ([plain, bounded], door) =
                c::read_source(source, &mut names).map_err(unreadable)?;
            let bodies = vec![(place("_body"), plain), (place("_with_bound"), bounded)];
            (bodies, (place("_inputs_at"), door))
        }
        Language::Python => {
            let (reading, door) = python::read(source, &mut names).map_err(unreadable)?;
            (vec![(place(""), reading)], (place(".at_angles"), door))
        }
    };
    Ok(Readings {
        bodies,
        door: (!names.asked.is_empty()).then_some(door),
    })
}
