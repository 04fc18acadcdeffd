//! `sextic validity`: where the closed forms of a case may be trusted.

use std::path::PathBuf;

use clap::Args;

use crate::report::{csv, json, text, validity_figure};
use crate::stability::validity::validity;

use super::Outcome;
use super::case::{Overrides, case_and_table, refuse};
use super::view::View;

/// Shows where the closed forms of a case may be trusted
///
/// The closed forms (21) to (23) hold where the eccentricity L_g/r is well above the aerodynamic damping;
/// the uniform forms need small damping only. Their errors against the state matrix are shown for the case
/// as it is, and over eccentricity and wind for the case perfectly tuned and without structural damping.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file: `sextic stability --help` shows one
    #[arg(value_name = "CASE")]
    case: PathBuf,

    #[command(flatten)]
    overrides: Overrides,

    #[command(flatten)]
    view: View,
}

const EXAMPLES: &str = "\
The forms are of sections whose x, y and theta are free, without aerodynamic stiffness and mean
twist. For other cases `sextic stability` has the state matrix, which needs none of them.

Examples:
  sextic validity case.toml
  sextic validity case.toml --plot map.svg
  sextic validity case.toml --format csv > map.csv

The error of a form is that of S_3D over |S_a|, the norm of the scaled damping matrix (18), at the
worst angle. delta is rho D U/(2 m omega_y).

All angles of the case are looked at, at every place of the map; a case with more than 400 of them
has a coarser map.

Columns of --format csv, a row for each place of the map: eccentricity, delta; for each form its
error, at how many of the angles the sign of stability is wrong for certain (wrong_signs), and at
how many more it may be, since the exact S_3D is within its error of 0 (open_signs).

Exit status:
  0  the case was computed, wherever it lies
  2  the input is wrong, or a file cannot be written";

/// Computes the map of a case and writes it.
pub fn run(arguments: &Arguments) -> Outcome {
    let (case, table) = match case_and_table(
        &arguments.case,
        &arguments.overrides.set,
        arguments.view.outputs(),
    ) {
        Ok(both) => both,
        Err(outcome) => return outcome,
    };
    let validity = match validity(&case, &table) {
        Ok(validity) => validity,
        Err(error) => return refuse(&error),
    };
    arguments.view.show(
        || validity_figure::map(&validity).svg(),
        |width| text::validity(&validity, width),
        || csv::validity(&validity),
        || json::validity(&validity),
    )
}
