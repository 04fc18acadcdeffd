//! `sextic new`: something small to begin with, which runs.

use std::fs::OpenOptions;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::Outcome;
use super::output::{finish, reason, wrong};

/// Writes a small document, case or table to begin with, which runs as it is
///
/// A document is Markdown with a derivation; a case is a section in the wind, beside a table of its force
/// coefficients, which is written too where it is not there. No file is overwritten.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// What is written
    #[arg(value_enum)]
    kind: Kind,

    /// The file; the usual extension need not be written
    #[arg(value_name = "NAME")]
    name: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  sextic new document          document.md
  sextic new document bridge   bridge.md
  sextic new case cable        cable.toml, and cable.csv if it is not there
  sextic new table cable       cable.csv";

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// A derivation with a claim, something refuted, and a system to compute
    Document,
    /// A section in the wind, with its table
    Case,
    /// Force coefficients by the angle of attack
    Table,
}

const DOCUMENT: &str = include_str!("new/document.md");
const CASE: &str = include_str!("new/case.toml");
const TABLE: &str = include_str!("new/table.csv");
/// What the case calls its table.
const TABLE_OF_CASE: &str = "\"table.csv\"";

/// Writes the files and says what to do with them.
pub fn run(arguments: &Arguments) -> Outcome {
    let written = match arguments.kind {
        Kind::Document => document(&arguments.path("document", "md")),
        Kind::Case => case(&arguments.path("case", "toml")),
        Kind::Table => table(&arguments.path("table", "csv")),
    };
    match written {
        Ok(said) => finish(&said, Outcome::AsExpected),
        Err(outcome) => outcome,
    }
}

impl Arguments {
    /// The file that is meant; a name without an extension has the usual one.
    fn path(&self, usual: &str, extension: &str) -> PathBuf {
        let name = self.name.clone().unwrap_or_else(|| usual.into());
        match name.extension() {
            Some(_) => name,
            None => name.with_extension(extension),
        }
    }
}

fn document(path: &Path) -> Result<String, Outcome> {
    create(path, DOCUMENT)?;
    let shown = path.display();
    Ok(format!(
        "{shown}\n\nNow\n  sextic audit {shown}\n  sextic show p --document {shown}\n  \
         sextic modes {shown} --set m=2 --set k=50 --set c=1\n"
    ))
}

/// A case, and its table beside it.
fn case(path: &Path) -> Result<String, Outcome> {
    let table = path.with_extension("csv");
    let Some(name) = table.file_name().and_then(|name| name.to_str()) else {
        return Err(wrong(
            &format!("`{}` is no name of a case", path.display()),
            "`sextic new case cable` writes cable.toml and cable.csv",
        ));
    };
    create(path, &CASE.replace(TABLE_OF_CASE, &format!("{name:?}")))?;
    let (shown, kept) = (path.display(), table.display());
    let said = match table.exists() {
        true => format!("{shown}\n\n`{kept}` is there already: the case reads it\n"),
        false => {
            create(&table, TABLE)?;
            format!("{shown}\n{kept}\n\n")
        }
    };
    Ok(format!(
        "{said}Now\n  sextic stability {shown}\n  sextic speeds {shown}\n"
    ))
}

fn table(path: &Path) -> Result<String, Outcome> {
    create(path, TABLE)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Ok(format!(
        "{}\n\nA case in its folder reads it by\n  coefficients = {name:?}\n",
        path.display()
    ))
}

/// Writes a file that is not there yet.
fn create(path: &Path, text: &str) -> Result<(), Outcome> {
    let written = create_new(path, text);
    written.map_err(|error| {
        let (shown, reason) = (path.display(), reason(&error));
        match error.kind() {
            ErrorKind::AlreadyExists => wrong(
                &format!("`{shown}` is there already, and is not overwritten"),
                "give another name",
            ),
            _ => wrong(
                &format!("`{shown}` cannot be written: {reason}"),
                "name a file in a folder that is there and that you may write to",
            ),
        }
    })
}

fn create_new(path: &Path, text: &str) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_an_extension() {
        let path = |name: Option<&str>| {
            let (kind, name) = (Kind::Document, name.map(PathBuf::from));
            Arguments { kind, name }.path("document", "md")
        };
        assert_eq!(path(None), Path::new("document.md"));
        assert_eq!(path(Some("a/bridge")), Path::new("a/bridge.md"));
        assert_eq!(path(Some("bridge.markdown")), Path::new("bridge.markdown"));
    }

    #[test]
    fn the_case_names_its_table() {
        assert_eq!(CASE.matches(TABLE_OF_CASE).count(), 1);
    }
}
