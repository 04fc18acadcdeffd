//! Where the rows of a sweep are written.

use std::path::Path;

use sha2::{Digest, Sha256};

use crate::cli::Outcome;
use crate::cli::output::{reason, stream, wrong};
use crate::cli::partial::Partial;
use crate::report::columns::Column;
use crate::report::csv::{heading, rows};

use super::messages::{AGAIN, FOLDER, ended, told, unwritable};
use super::rows::{Sizes, Table, compute};

/// How text is written.
const TEXT: Sizes = Sizes {
    points: 1 << 10,
    fewest_rows: 4,
    parts: 16,
};

/// Computes a table, and writes it to a file or to standard output; what it rests on tells it from others.
pub(super) fn written(table: &dyn Table, out: Option<&Path>, identity: &[String]) -> Outcome {
    let Some(path) = out else {
        return to_output(table);
    };
    let written = match path.extension().and_then(|extension| extension.to_str()) {
        Some("csv") | None => to_text(table, path, &digest(identity)),
        #[cfg(feature = "parquet")]
        Some("parquet") => super::parquet::to_columns(table, path, &digest(identity)),
        #[cfg(not(feature = "parquet"))]
        Some("parquet") => {
            let help = "build it with `--features parquet`, or name a .csv file";
            Err(wrong("this build writes no Parquet", help))
        }
        Some(other) => Err(wrong(
            &format!("a sweep is not written as .{other}"),
            "name a .csv file, or a .parquet file",
        )),
    };
    written.unwrap_or_else(|outcome| outcome)
}

fn to_output(table: &dyn Table) -> Outcome {
    let write = |parts: Vec<String>| stream(&parts.concat());
    let begun = stream(&heading(&table.columns(0..0)));
    let written = begun.and_then(|is_read| match is_read {
        true => compute(table, 0, TEXT, text, write),
        false => Ok(()),
    });
    match written {
        Ok(()) => Outcome::AsExpected,
        Err(error) => wrong(
            &format!("standard output cannot be written: {}", reason(&error)),
            "name a file with --out",
        ),
    }
}

fn text(parts: &[Vec<Column>]) -> String {
    parts.iter().map(|own| rows(own)).collect()
}

fn to_text(table: &dyn Table, path: &Path, identity: &str) -> Result<Outcome, Outcome> {
    let heading = heading(&table.columns(0..0));
    let row = |number| (number < table.count()).then(|| rows(&table.columns(number..number + 1)));
    let begun = Partial::open(path, identity, &heading, row);
    let (mut partial, left) = begun.map_err(|error| unwritable(path, &error, FOLDER))?;
    let done = told(partial.reserved(), left);
    let write = |parts: Vec<String>| partial.write(&parts.concat()).map(|()| true);
    let written = compute(table, done, TEXT, text, write).and_then(|()| partial.finish());
    ended(table, path, written, AGAIN)
}

/// What tells a sweep from others in the name of a file, with this version.
pub(super) fn digest(identity: &[String]) -> String {
    let mut hash = Sha256::new();
    for text in identity
        .iter()
        .map(String::as_str)
        .chain([env!("CARGO_PKG_VERSION")])
    {
        hash.update(text.len().to_le_bytes());
        hash.update(text);
    }
    let digest = hash.finalize();
    digest[..6]
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
