//! A case as a page, a table or an object, and as a figure: the options of every command that shows one.

use std::path::PathBuf;

use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::Outcome;
use super::file::{promising, write_made};
use super::output::{finish, width};

/// How a case is shown.
#[derive(Args, Debug)]
pub struct View {
    /// How the results are written
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,

    /// Also draw them, as SVG
    #[arg(long, value_name = "FILE.svg", value_parser = PathBufValueParser::new().try_map(svg))]
    plot: Option<PathBuf>,

    /// How many columns text may fill (at least 40); as many as the terminal has if not given
    #[arg(long, value_name = "COLUMNS", value_parser = clap::value_parser!(u16).range(40..))]
    width: Option<u16>,
}

/// How results are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    /// A page for a terminal
    Text,
    /// A table, whose columns are named below
    Csv,
    /// For programs
    Json,
}

impl View {
    /// The files that are written beside standard output.
    pub fn outputs(&self) -> &[PathBuf] {
        self.plot.as_slice()
    }

    /// Whether the results are a table, which has no place for what is odd about the input.
    pub fn is_table(&self) -> bool {
        self.format == Form::Csv
    }

    /// Draws the figure if it is asked for, and writes the results: for so many columns, as CSV, or as JSON.
    pub fn show(
        &self,
        figure: impl FnOnce() -> Result<String, String>,
        text: impl FnOnce(usize) -> String,
        csv: impl FnOnce() -> String,
        json: impl FnOnce() -> String,
    ) -> Outcome {
        if let Some(path) = &self.plot
            && let Err(outcome) = write_made(path, figure())
        {
            return outcome;
        }
        let written = match self.format {
            Form::Text => text(width(self.width)),
            Form::Csv => csv(),
            Form::Json => json(),
        };
        finish(&written, Outcome::AsExpected)
    }
}

fn svg(path: PathBuf) -> Result<PathBuf, String> {
    promising("svg", path)
}
