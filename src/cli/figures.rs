//! `sextic figures`: the paper's kinds of figures, on any case.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::report::gallery;

use super::Outcome;
use super::case::{Overrides, case_and_table, refuse};
use super::file::{spare, write_text};
use super::output::{finish, reason, wrong};

/// Draws the paper's kinds of figures for a case, as SVG
///
/// Figs. 11 and 12, which rest on no measurement, are drawn as they are: frequencies and trajectories
/// without wind. The others are drawn for the case: its stability by every method; with and without
/// inertial coupling (as Figs. 3 to 6 and 9); modes against the offset of the mass centre, at the worst
/// angle (as Fig. 7); and the closed form against the state matrix, for the section perfectly tuned and
/// without structural damping (as Figs. 13 and 14). What the case has nothing to show for is left out:
/// eccentricity where only one coordinate is free or the turn is held, closed forms where not all are free.
#[derive(Args, Debug)]
pub struct Arguments {
    /// A case file: `sextic stability --help` shows one
    #[arg(value_name = "CASE")]
    case: PathBuf,

    #[command(flatten)]
    overrides: Overrides,

    /// The folder for the figures, which is made if need be
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Draws all figures of a case and names their files.
pub fn run(arguments: &Arguments) -> Outcome {
    let (case, table) = match case_and_table(&arguments.case, &arguments.overrides.set, &[]) {
        Ok(both) => both,
        Err(outcome) => return outcome,
    };
    let figures = match gallery::figures(&case, &table) {
        Ok(figures) => figures,
        Err(error) => return refuse(&error),
    };
    let folder = &arguments.out;
    let read = [&arguments.case, Path::new(table.file())];
    for (name, _) in &figures {
        if let Err(outcome) = spare(&folder.join(format!("{name}.svg")), &read) {
            return outcome;
        }
    }
    let unwritable = |path: &Path, reason: &str| {
        wrong(
            &format!("`{}` cannot be written: {reason}", path.display()),
            "name a folder that you may write to",
        )
    };
    if let Err(error) = std::fs::create_dir_all(folder) {
        return unwritable(folder, &reason(&error));
    }
    let mut list = String::new();
    for (name, figure) in figures {
        let path = folder.join(format!("{name}.svg"));
        let written = figure
            .svg()
            .and_then(|svg| write_text(&path, &svg).map_err(|error| reason(&error)));
        if let Err(reason) = written {
            return unwritable(&path, &reason);
        }
        list += &format!("{}\n", path.display());
    }
    finish(&list, Outcome::AsExpected)
}
