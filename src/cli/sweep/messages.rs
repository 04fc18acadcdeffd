//! What is said of the file of a sweep.

use std::io;
use std::path::Path;

use crate::cli::Outcome;
use crate::cli::output::{complain, finish, reason, wrong};
use crate::cli::partial::{Left, Reserved};

use super::rows::{Table, await_interruption};

/// What helps where a file cannot be made.
pub(super) const FOLDER: &str = "name a file in a folder that is there and that you may write to, and to which no other sweep writes";

/// What helps where a file cannot be written to.
pub(super) const AGAIN: &str =
    "give the same command again to go on with the rows that were written";

/// Says what an earlier run left, and gives the number of rows to go on from.
pub(super) fn told(reserved: Option<&Reserved>, left: Left) -> u64 {
    for (other, is_written) in reserved.map(Reserved::others).unwrap_or_default() {
        let what = match is_written {
            true => "is being written by another sweep to the same file, with other inputs",
            false => {
                "is left of a sweep with other inputs that was interrupted: delete it if you need it no more"
            }
        };
        complain(&format!("{} {what}\n", other.display()));
    }
    await_interruption();
    match left {
        Left::Nothing => 0,
        Left::Rows(rows) => {
            complain(&format!("{rows} rows are there already\n"));
            rows
        }
        Left::Useless(rows) => {
            complain(&format!(
                "{rows} rows that are there are not as this program computes them: all begins anew\n"
            ));
            0
        }
    }
}

/// How a sweep to a file ended.
pub(super) fn ended(
    table: &dyn Table,
    path: &Path,
    written: io::Result<()>,
    help: &str,
) -> Result<Outcome, Outcome> {
    match written {
        Ok(()) => Ok(finish(
            &format!("{}: {} rows\n", path.display(), table.count()),
            Outcome::AsExpected,
        )),
        Err(error) if error.kind() == io::ErrorKind::Interrupted => Err(wrong(
            &format!(
                "the sweep was interrupted: `{}` is not there yet",
                path.display()
            ),
            help,
        )),
        Err(error) => Err(unwritable(path, &error, help)),
    }
}

/// Says that a file cannot be written.
pub(super) fn unwritable(path: &Path, error: &io::Error, help: &str) -> Outcome {
    let what = format!("`{}` cannot be written: {}", path.display(), reason(error));
    wrong(&what, help)
}
