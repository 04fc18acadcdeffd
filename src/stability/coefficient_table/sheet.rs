//! A text with columns: its separator, its comments, its heading, and its rows.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::meaning::are_units;
use super::names::Names;
use crate::stability::input::{InputError, Place, shortened};

/// What begins a comment.
const COMMENTS: [&str; 4] = ["#", "!", "%", "//"];

/// The rows of a text.
#[derive(Clone, Debug, Default)]
pub(super) struct Sheet {
    /// The line of the heading, from 1.
    pub line: usize,
    pub heading: Vec<String>,
    /// The row of units, if there is one.
    pub units: Vec<String>,
    /// Cells with their lines.
    pub rows: Vec<(usize, Vec<String>)>,
    pub separator: Separator,
    /// The lines before the heading that say something and are no comments.
    pub before: Vec<usize>,
}

/// What stands between cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Separator {
    #[default]
    Comma,
    Semicolon,
    Tab,
    /// Any number of them, as in polars of AeroDyn.
    Blanks,
}

impl Separator {
    /// That of a line that has several cells.
    fn of(line: &str) -> Self {
        match line {
            _ if line.contains(';') => Separator::Semicolon,
            _ if line.contains('\t') => Separator::Tab,
            _ if line.contains(',') => Separator::Comma,
            _ => Separator::Blanks,
        }
    }

    fn byte(self) -> u8 {
        match self {
            Separator::Comma => b',',
            Separator::Semicolon => b';',
            Separator::Tab | Separator::Blanks => b'\t',
        }
    }
}

impl Sheet {
    /// Reads a text.
    ///
    /// The heading is the first line that names an angle, a lift and a drag, or else the first comment that does, as
    /// in polars of AeroDyn; without one it is the first line with a name that the case says, or that says anything.
    ///
    /// # Errors
    ///
    /// An empty text, and what is no CSV, with its line.
    pub fn read(file: &str, text: &str, names: &Names) -> Result<Self, InputError> {
        let lines: Vec<&str> = text.lines().collect();
        let says_something = |own: &usize| {
            let line = lines[*own].trim();
            !line.is_empty() && !is_comment(line) && !line.starts_with("sep=")
        };
        let cells_of = |own: &usize| cells(uncommented(lines[*own]));
        let is_named = |own: &usize| names.are_in(&cells_of(own));
        let is_partly_named = |own: &usize| names.are_partly_in(&cells_of(own));
        let all = 0..lines.len();
        let named = all.clone().filter(says_something).find(is_named);
        let in_a_comment = || all.clone().find(is_named);
        let in_parts = || all.clone().find(is_partly_named);
        let first = || all.clone().find(says_something);
        let heading = named.or_else(in_a_comment).or_else(in_parts);
        let Some(heading) = heading.or_else(first) else {
            let help = "the first row names the columns alpha_deg, CL, CD, CM";
            return Err(InputError::new(
                Place::file(file),
                "the table is empty",
                help,
            ));
        };
        let line = uncommented(lines[heading]);
        let mut sheet = Sheet {
            line: heading + 1,
            heading: cells(line),
            separator: Separator::of(line),
            before: (0..heading)
                .filter(says_something)
                .map(|own| own + 1)
                .collect(),
            ..Sheet::default()
        };
        sheet.read_rows(file, &lines[heading + 1..])?;
        // In polars of AeroDyn units stand in a comment, as the heading does.
        let next = lines
            .get(heading + 1)
            .filter(|line| is_comment(line.trim()));
        let next = next.map(|line| cells(uncommented(line)));
        let is_first = |sheet: &Sheet| sheet.rows.first().is_some_and(|(_, own)| are_units(own));
        sheet.units = match next.filter(|own| are_units(own)) {
            Some(units) => units,
            None if is_first(&sheet) => sheet.rows.remove(0).1,
            None => Vec::new(),
        };
        Ok(sheet)
    }

    fn read_rows(&mut self, file: &str, lines: &[&str]) -> Result<(), InputError> {
        // Lines keep their numbers, but for breaks within quotation marks.
        let kept = lines.iter().map(|line| match is_comment(line.trim()) {
            true => String::new(),
            false if self.separator == Separator::Blanks => blanks_as_tabs(line),
            false => (*line).to_string(),
        });
        let text = kept.collect::<Vec<_>>().join("\n");
        let mut reader = reader(self.separator, text.as_bytes());
        let mut record = StringRecord::new();
        loop {
            let is_there = reader.read_record(&mut record).map_err(|error| {
                let line = error.position().map_or(0, |own| own.line() as usize);
                let what = shortened(&error.to_string());
                InputError::new(Place::line(file, self.line + line), what, "a table is CSV")
            })?;
            if !is_there {
                return Ok(());
            }
            if record.iter().any(|cell| !cell.is_empty()) {
                let line = self.line + line_of(&record, &text);
                self.rows
                    .push((line, record.iter().map(String::from).collect()));
            }
        }
    }
}

fn reader(separator: Separator, bytes: &[u8]) -> csv::Reader<&[u8]> {
    ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(Trim::All)
        .delimiter(separator.byte())
        .from_reader(bytes)
}

/// The line of a record, from 1: the reader's position is where it stood before the empty lines that it passes
/// over.
fn line_of(record: &StringRecord, text: &str) -> usize {
    let (line, byte) = record.position().map_or((1, 0), |position| {
        (position.line() as usize, position.byte() as usize)
    });
    let rest = text.get(byte..).unwrap_or_default();
    line + rest.lines().take_while(|line| line.is_empty()).count()
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    let separator = Separator::of(line);
    let line = match separator {
        Separator::Blanks => blanks_as_tabs(line),
        _ => line.to_string(),
    };
    let record = reader(separator, line.as_bytes()).into_records().next();
    let record = record.and_then(Result::ok).unwrap_or_default();
    record.iter().map(String::from).collect()
}

fn blanks_as_tabs(line: &str) -> String {
    line.split_whitespace().collect::<Vec<_>>().join("\t")
}

fn is_comment(line: &str) -> bool {
    COMMENTS.iter().any(|mark| line.starts_with(mark))
}

/// A line without the marks of a comment.
fn uncommented(line: &str) -> &str {
    line.trim()
        .trim_start_matches(['#', '!', '%', '/'])
        .trim_start()
}
