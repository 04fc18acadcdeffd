//! `sextic figures`: the paper's kinds of figures, on any case.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::report::gallery;

use super::Outcome;
use super::case::{Overrides, case_and_table, refuse};
use super::file::{spare, write_whole};
use super::output::{complain, finish, reason, wrong};
use super::picture::Kind;

/// Draws the paper's kinds of figures for a case
///
/// Its stability by every method; with and without inertial coupling (as Figs. 3 to 6 and 9); the damping
/// and the frequency of every mode; modes against the offset of the mass centre, at the worst angle (as
/// Fig. 7). For the section perfectly tuned and without structural damping: frequencies and trajectories
/// without wind (as Figs. 11 and 12), and the closed form beside the state matrix (as Figs. 13 and 14).
/// The offset of the case is marked. What the case has nothing to show for is left out, and so is what would
/// draw the same as another figure; both are said on standard error.
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

    /// What the figures are written as
    #[arg(long, value_enum, default_value_t = Kind::Svg)]
    format: Kind,
}

/// Draws all figures of a case and names their files.
pub fn run(arguments: &Arguments) -> Outcome {
    let (case, table) = match case_and_table(&arguments.case, &arguments.overrides.set, &[]) {
        Ok(both) => both,
        Err(outcome) => return outcome,
    };
    let pictures = match arguments.format.pictures() {
        Ok(pictures) => pictures,
        Err(reason) => return wrong(&reason, "`--format svg` is in every build"),
    };
    let gallery = match gallery::figures(&case, &table) {
        Ok(gallery) => gallery,
        Err(error) => return refuse(&error),
    };
    let folder = &arguments.out;
    let read = [&arguments.case, Path::new(table.file())];
    let path = |name: &str| folder.join(format!("{name}.{}", arguments.format.ending()));
    for (name, _) in &gallery.figures {
        if let Err(outcome) = spare(&path(name), &read) {
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
    for (name, figure) in gallery.figures {
        let path = path(&name);
        let made = figure.svg().and_then(|svg| pictures.made(svg));
        let written =
            made.and_then(|made| write_whole(&path, made).map_err(|error| reason(&error)));
        if let Err(reason) = written {
            return unwritable(&path, &reason);
        }
        list += &format!("{}\n", path.display());
    }
    for (name, why) in gallery.left_out {
        complain(&format!("Left out: {name}, since {why}\n"));
    }
    finish(&list, Outcome::AsExpected)
}
