//! A case as a page, a table or an object, and as a figure: the options of every command that shows one.

use std::path::PathBuf;

use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::Outcome;
use super::file::write_made;
use super::output::{finish, width};
use super::picture::Plot;

/// How a case is shown.
#[derive(Args, Debug)]
pub struct View {
    /// How the results are written
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,

    /// Also draw them: as SVG, or in builds with pictures as PNG or PDF, by what the name ends in
    #[arg(long, value_name = "FILE.svg", value_parser = PathBufValueParser::new().try_map(Plot::new))]
    plot: Option<Plot>,

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
        let plot = self.plot.as_ref();
        plot.map_or(&[], |own| std::slice::from_ref(&own.path))
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
        if let Some(plot) = &self.plot
            && let Err(outcome) = write_made(&plot.path, figure().and_then(|svg| plot.made(svg)))
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
