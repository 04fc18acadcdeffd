//! A sweep as the files of a folder: each has a range of its rows, and any process or machine can compute it.

use std::fs;
use std::ops::Range;
use std::path::Path;

use crate::cli::Outcome;
use crate::cli::output::{complain, wrong};
use crate::report::columns::Column;

use super::messages::unwritable;
use super::parquet::{Standing, standing, to_columns};
use super::rows::Table;
use super::written::digest;

/// Which parts of a sweep are computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts {
    /// How many there are.
    pub count: u64,
    /// The only one to compute, counted from 1; all if there is none.
    pub only: Option<u64>,
}

/// Some of the rows of a table.
struct Part<'a> {
    table: &'a dyn Table,
    rows: Range<u64>,
}

impl Table for Part<'_> {
    fn count(&self) -> u64 {
        self.rows.end - self.rows.start
    }

    fn points_in_a_row(&self) -> u64 {
        self.table.points_in_a_row()
    }

    fn columns(&self, rows: Range<u64>) -> Vec<Column> {
        let start = self.rows.start;
        self.table.columns(start + rows.start..start + rows.end)
    }
}

impl Parts {
    /// The rows of the part of a number, counted from 1.
    fn rows(&self, number: u64, table: &dyn Table) -> Range<u64> {
        let end = |parts: u64| {
            let rows = u128::from(table.count()) * u128::from(parts) / u128::from(self.count);
            u64::try_from(rows).unwrap_or(table.count())
        };
        end(number - 1)..end(number)
    }

    /// Computes the parts that are not there, each to a file of a folder.
    pub(super) fn write(
        &self,
        table: &dyn Table,
        folder: &Path,
        identity: &[String],
    ) -> Result<Outcome, Outcome> {
        if self.count > table.count() {
            let what = format!("{} rows have no {} parts", table.count(), self.count);
            return Err(wrong(&what, "give fewer parts"));
        }
        let help = "name a folder that you may write to";
        fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error, help))?;
        let numbers = self.only.map_or(1..=self.count, |own| own..=own);
        let mut outcome = Outcome::AsExpected;
        for number in numbers {
            let rows = self.rows(number, table);
            let name = format!("part-{number:05}-of-{:05}.parquet", self.count);
            let part = Part { table, rows };
            outcome = outcome.max(part.write(&folder.join(name), identity)?);
        }
        Ok(outcome)
    }
}

impl Part<'_> {
    /// Computes the part, unless it is there.
    fn write(&self, path: &Path, identity: &[String]) -> Result<Outcome, Outcome> {
        let own = format!("{:?}", self.rows);
        let identity: Vec<String> = identity.iter().cloned().chain([own]).collect();
        let (identity, help) = (digest(&identity), "delete it, or name another folder");
        match standing(path, &identity).map_err(|error| unwritable(path, &error, help))? {
            Standing::Absent => to_columns(self, path, &identity),
            Standing::Whole => {
                complain(&format!("{} is there already\n", path.display()));
                Ok(Outcome::AsExpected)
            }
            Standing::Other => {
                let what = format!("`{}` is no part of this sweep", path.display());
                Err(wrong(&what, help))
            }
        }
    }
}
