//! Results to standard output, diagnostics to standard error.

use std::io::{self, IsTerminal, Write};

use anstyle::AnsiColor;
use clap::ValueEnum;

use super::Outcome;
pub use crate::disk::reason;

/// The width where no terminal says how wide it is.
const USUAL_WIDTH: usize = 100;

/// How results are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For a terminal
    Text,
    /// For programs; SymPy reads residuals, solutions, determinants, tables, points and the left sides
    /// of conditions, while statements and definitions are in the block language in ASCII names
    Json,
    /// For a code host or a notebook
    Markdown,
    /// A document for pdflatex
    Latex,
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Results {
    /// For a terminal
    Text,
    /// For programs
    Json,
}

/// Writes a part of the results, with colours only where they are seen; whether more of them is read.
///
/// A reader who has seen enough closes the pipe: that is no mistake of anybody.
pub fn stream(text: &str) -> Result<bool, io::Error> {
    let mut stream = anstream::stdout().lock();
    let written = stream
        .write_all(text.as_bytes())
        .and_then(|()| stream.flush());
    match written {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        written => written.map(|()| true),
    }
}

/// Writes results: the outcome, which is worse if they cannot be written.
pub fn finish(text: &str, outcome: Outcome) -> Outcome {
    match stream(text) {
        Ok(_) => outcome,
        Err(error) => outcome.max(unwritten(&error)),
    }
}

/// Says that results cannot be written.
pub fn unwritten(error: &io::Error) -> Outcome {
    let what = format!("standard output cannot be written: {}", reason(error));
    wrong(&what, "let it go where there is room")
}

/// Writes to standard error; if that is closed, there is nobody to tell.
pub fn complain(text: &str) {
    let mut stream = anstream::stderr().lock();
    let _ = stream
        .write_all(text.as_bytes())
        .and_then(|()| stream.flush());
}

/// Writes what is wrong with the command itself, and what to do about it.
pub fn wrong(message: &str, help: &str) -> Outcome {
    let (alarm, hint) = (AnsiColor::Red.on_default(), AnsiColor::Cyan.on_default());
    complain(&format!(
        "{alarm}Error:{alarm:#} {message}\n{hint}Help:{hint:#} {help}\n"
    ));
    Outcome::WrongInput
}

/// How many columns to fill: those asked for, or those of the terminal.
pub fn width(asked: Option<u16>) -> usize {
    let terminal = || {
        let stream = io::stdout();
        let is_terminal = stream.is_terminal();
        let size = is_terminal
            .then(|| terminal_size::terminal_size_of(stream))
            .flatten();
        size.map(|(terminal_size::Width(columns), _)| usize::from(columns))
    };
    let asked = asked.map(usize::from);
    asked.or_else(terminal).unwrap_or(USUAL_WIDTH)
}
