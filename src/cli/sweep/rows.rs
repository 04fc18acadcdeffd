//! The rows of a sweep, block by block.

use std::io;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::cli::progress;
use crate::report::columns::{Column, of_grid, of_system};
use crate::stability::grid::Grid;
use crate::stability::system::sweep::Sweep;

/// About so many points are computed at a time: their columns stay near a core.
const AT_ONCE: u64 = 1024;

/// Whether the user wants to stop.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Lets an interruption be told to [`compute`], where signals can be caught; elsewhere it is silent.
pub(super) fn await_interruption() {
    let _ = ctrlc::set_handler(|| IS_INTERRUPTED.store(true, Ordering::Relaxed));
}

/// How much is computed between writes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes {
    /// About so many points are a part, which one core computes.
    pub points: u64,
    /// A part has no fewer rows, however many points they take.
    pub fewest_rows: u64,
    /// The parts of a block.
    pub parts: u64,
}

/// Rows that are computed one after the other, each by its number alone.
pub(super) trait Table: Sync {
    /// How many rows there are.
    fn count(&self) -> u64;
    /// How many points it takes to compute one.
    fn points_in_a_row(&self) -> u64;
    /// Some rows in columns; of no rows there are the headings.
    fn columns(&self, rows: Range<u64>) -> Vec<Column>;
}

impl Table for Grid<'_> {
    fn count(&self) -> u64 {
        self.rows()
    }

    fn points_in_a_row(&self) -> u64 {
        Grid::points_in_a_row(self)
    }

    fn columns(&self, rows: Range<u64>) -> Vec<Column> {
        of_grid(self, rows)
    }
}

impl Table for Sweep<'_> {
    fn count(&self) -> u64 {
        self.len() as u64
    }

    fn points_in_a_row(&self) -> u64 {
        1
    }

    fn columns(&self, rows: Range<u64>) -> Vec<Column> {
        of_system(self, rows)
    }
}

/// Computes the rows from one on, and writes them in order, until there is nobody who reads them.
///
/// `form` is what one core makes of a part, given as columns of some of its rows after the other; after each block of
/// parts they are written.
///
/// # Errors
///
/// Those of `write`; [`io::ErrorKind::Interrupted`] if the user wants to stop.
pub(super) fn compute<P: Send>(
    table: &dyn Table,
    from: u64,
    sizes: Sizes,
    form: impl Fn(&[Vec<Column>]) -> P + Sync,
    mut write: impl FnMut(Vec<P>) -> io::Result<bool>,
) -> io::Result<()> {
    let progress = progress::bar(table.count(), "rows").with_position(from);
    progress.reset_eta();
    let part = (sizes.points / table.points_in_a_row()).max(sizes.fewest_rows);
    let block = part * sizes.parts;
    let mut next = from;
    while next < table.count() {
        let end = (next + block).min(table.count());
        let starts: Vec<u64> = (next..end).step_by(part as usize).collect();
        let formed = |start: u64| Ok(form(&columns(table, start..(start + part).min(end))?));
        let parts: Vec<io::Result<P>> = starts.into_par_iter().map(formed).collect();
        if !write(parts.into_iter().collect::<io::Result<_>>()?)? {
            return Ok(());
        }
        next = end;
        progress.set_position(next);
    }
    Ok(())
}

/// The columns of some rows after the other.
fn columns(table: &dyn Table, rows: Range<u64>) -> io::Result<Vec<Vec<Column>>> {
    let at_once = (AT_ONCE / table.points_in_a_row()).max(1);
    let some = |start: u64| match IS_INTERRUPTED.load(Ordering::Relaxed) {
        true => Err(io::ErrorKind::Interrupted.into()),
        false => Ok(table.columns(start..(start + at_once).min(rows.end))),
    };
    rows.clone().step_by(at_once as usize).map(some).collect()
}
