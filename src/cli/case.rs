//! A case and its table from the disk.

use std::path::{Path, PathBuf};

use crate::language::diagnostic::SourceFile;
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::coefficient_table::remarks::remarks;
use crate::stability::input::{InputError, Place, Remark, shortened};

use super::Outcome;
use super::file::{read_foreign_text, read_text, spare};
use super::output::{complain, wrong};

/// A case and its table from the disk, for a command that writes to `outputs`: what is odd about them is written
/// to standard error.
///
/// # Errors
///
/// The outcome, after what is wrong was written: also where an output is one of both files.
pub fn case_and_table(
    path: &Path,
    outputs: &[PathBuf],
) -> Result<(Case, CoefficientTable), Outcome> {
    let (case, table, _) = case_and_files(path, outputs)?;
    warn(&remarks(&table));
    warn(&case.remarks());
    Ok((case, table))
}

/// A case and its table from the disk, with the texts of their files, that of the case first; what is odd about
/// them is left to the caller.
///
/// # Errors
///
/// As [`case_and_table`].
pub fn case_and_files(
    path: &Path,
    outputs: &[PathBuf],
) -> Result<(Case, CoefficientTable, [SourceFile; 2]), Outcome> {
    let text = read_text(path, "a case file: `sextic stability --help` shows one")?;
    let case_file = SourceFile::new(path.to_string_lossy(), text);
    let case = Case::read(&case_file.path, &case_file.text).map_err(|error| refuse(&error))?;
    let table = path.with_file_name(&case.coefficients);
    for output in outputs {
        spare(output, &[path, &table])?;
    }
    let (text, encoding) = read_foreign_text(
        &table,
        &format!(
            "a table in {}, relative to its folder",
            shortened(&case.file)
        ),
    )?;
    let table_file = SourceFile::new(table.to_string_lossy(), text);
    if let Some(encoding) = encoding {
        let what = format!("it is not in UTF-8, and is read in {encoding}");
        let place = Place::file(&table_file.path);
        warn(&[Remark { place, what }]);
    }
    let table = CoefficientTable::read(&table_file.path, &table_file.text)
        .map_err(|error| refuse(&error))?;
    Ok((case, table, [case_file, table_file]))
}

/// Writes what is wrong with a case or a table.
pub fn refuse(error: &InputError) -> Outcome {
    wrong(&format!("{}: {}", error.place, error.what), &error.help)
}

/// Writes what is odd about the input to standard error.
pub fn warn(remarks: &[Remark]) {
    for remark in remarks {
        complain(&format!("Warning: {remark}\n"));
    }
}
