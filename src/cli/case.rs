//! A case and its table from the disk.

use std::path::Path;

use crate::derivation::diagnostic::SourceFile;
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::input::InputError;

use super::Outcome;
use super::file::read_text;
use super::output::wrong;

/// A case and its table from the disk.
pub fn case_and_table(path: &Path) -> Result<(Case, CoefficientTable), Outcome> {
    let (case, table, _) = case_and_files(path)?;
    Ok((case, table))
}

/// A case and its table from the disk, with the texts of their files, that of the case first.
pub fn case_and_files(path: &Path) -> Result<(Case, CoefficientTable, [SourceFile; 2]), Outcome> {
    let text = read_text(path, "a case file: `sextic stability --help` shows one")?;
    let case_file = SourceFile::new(path.to_string_lossy(), text);
    let case = Case::read(&case_file.path, &case_file.text).map_err(|error| refuse(&error))?;
    let table = path.with_file_name(&case.coefficients);
    let text = read_text(
        &table,
        &format!("a table in {}, relative to its folder", case.file),
    )?;
    let table_file = SourceFile::new(table.to_string_lossy(), text);
    let table = CoefficientTable::read(&table_file.path, &table_file.text)
        .map_err(|error| refuse(&error))?;
    Ok((case, table, [case_file, table_file]))
}

/// Writes what is wrong with a case or a table.
pub fn refuse(error: &InputError) -> Outcome {
    wrong(&format!("{}: {}", error.place, error.what), &error.help)
}
