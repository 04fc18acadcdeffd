//! A case and its table from the disk.

use std::path::{Path, PathBuf};

use clap::Args;
use sextic_codegen::language::literal::Decimal;

use crate::compile::fixed::Fixed;
use crate::language::diagnostic::SourceFile;
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::coefficient_table::remarks::remarks;
use crate::stability::input::{InputError, Place, Remark, shortened};
use crate::stability::variable::{Setting, Variable};

use super::Outcome;
use super::file::{read_foreign_text, read_text, spare};
use super::generate::{FixedParser, unknown};
use super::output::{complain, wrong};

/// What a command sets in place of what a case says.
#[derive(Args, Debug)]
pub struct Overrides {
    /// A quantity of the case, by a name of `sextic sweep`, and its value; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    pub set: Vec<Fixed>,
}

/// A case and its table from the disk, with what is set in place of it, for a command that writes to `outputs` and does not
/// consider errors of the coefficients: what is odd about them is written to standard error.
///
/// # Errors
///
/// The outcome, after what is wrong was written: also where an output is one of both files, or something cannot be set.
pub fn case_and_table(
    path: &Path,
    set: &[Fixed],
    outputs: &[PathBuf],
) -> Result<(Case, CoefficientTable), Outcome> {
    let (case, table, _) = set_case_and_files(path, set, outputs)?;
    warn_without_errors(&case, &table);
    Ok((case, table))
}

/// The same with the texts of the files; what is odd about them is left to the caller. What is read is said on
/// standard error.
///
/// # Errors
///
/// As [`case_and_table`].
pub fn set_case_and_files(
    path: &Path,
    set: &[Fixed],
    outputs: &[PathBuf],
) -> Result<(Case, CoefficientTable, [SourceFile; 2]), Outcome> {
    let set: Vec<Setting> = set.iter().map(setting).collect::<Result<_, _>>()?;
    let (case, table, files) = case_and_files(path, &set, outputs)?;
    complain(&read_from(&case, &table));
    Ok((case, table, files))
}

/// A quantity of a case and its value.
fn setting(fixed: &Fixed) -> Result<Setting, Outcome> {
    let name = &fixed.name;
    let Some(variable) = Variable::named(name) else {
        let known: Vec<String> = Variable::all().map(|own| own.name.into()).collect();
        let what = format!("a case has no quantity `{name}`");
        return Err(unknown(&what, name, &known));
    };
    let value = Decimal::nearest(&fixed.value).map(|own| own.value);
    let value = value.ok_or_else(|| {
        let what = format!("`{name}={}` is beyond the range of a double", fixed.text);
        wrong(&what, "quantities are in the units of a case file")
    })?;
    Ok(Setting { variable, value })
}

/// A case with what is set and its table from the disk, with the texts of their files, that of the case first; what is odd about
/// them is left to the caller.
///
/// # Errors
///
/// As [`case_and_table`].
fn case_and_files(
    path: &Path,
    set: &[Setting],
    outputs: &[PathBuf],
) -> Result<(Case, CoefficientTable, [SourceFile; 2]), Outcome> {
    let text = read_text(path, "a case file: `sextic stability --help` shows one")?;
    let case_file = SourceFile::new(path.to_string_lossy(), text);
    let case = Case::read(&case_file.path, &case_file.text);
    let case = case.and_then(|own| own.with(set));
    let case = case.map_err(|error| refuse(&error))?;
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
    let table = case
        .read_table(&table_file.path, &table_file.text)
        .map_err(|error| refuse(&error))?;
    Ok((case, table, [case_file, table_file]))
}

/// What is read: how far the table goes, how it is read between its angles, and by which columns.
fn read_from(case: &Case, table: &CoefficientTable) -> String {
    let [from, to] = table.ends();
    let end = match table.is_circle() {
        true => "period 360°".to_string(),
        false => format!("ends at {from}° and {to}°"),
    };
    let slopes = match table.has_slopes() {
        true => "derivatives by columns",
        false => "derivatives of the curves",
    };
    format!(
        "Table {}: {}; {end}; {}\nColumns {}; {slopes}{}\n",
        shortened(table.file()),
        table.reading(),
        case.interpolation,
        table.columns().join(", "),
        case.over_lengths()
    )
}

/// Writes what is wrong with a case or a table.
pub fn refuse(error: &InputError) -> Outcome {
    wrong(&format!("{}: {}", error.place, error.what), &error.help)
}

/// Writes what is odd about a case and its table to standard error.
pub fn warn_of(case: &Case, table: &CoefficientTable) {
    warn(case.scatter_remark(table).as_slice());
    warn(&remarks(table));
    warn(&case.remarks());
}

/// The same, for a command that does not consider errors of the coefficients.
pub fn warn_without_errors(case: &Case, table: &CoefficientTable) {
    warn_of(case, table);
    if table.has_errors() {
        complain(
            "Errors of the coefficients are not considered here, but by `sextic stability`.\n",
        );
    }
}

/// Writes what is odd about the input to standard error.
pub fn warn(remarks: &[Remark]) {
    for remark in remarks {
        complain(&format!("Warning: {remark}\n"));
    }
}
