//! `sextic speeds`: the wind speeds at which a section gallops.

use std::path::PathBuf;

use clap::Args;

use crate::report::speeds::SpeedsFound;
use crate::report::{csv, json, speeds_figure, text};
use crate::stability::critical_speed::speeds_of;

use super::Outcome;
use super::case::{case_and_table, refuse};
use super::view::View;

/// Finds the critical wind speeds of a case
///
/// At each angle of the case: from which wind speed on the section gallops, and at which it is stable again.
/// The speeds are the roots of a Hurwitz determinant as a polynomial in U, isolated in exact arithmetic, so
/// that none is missed but where speeds are undecided; those of static divergence are roots of the determinant
/// of the stiffness. The wind speed of the case does not matter. Numbers of the case count as doubles.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file: `sextic stability --help` shows one
    #[arg(value_name = "CASE")]
    case: PathBuf,

    /// The highest wind speed, in m/s
    #[arg(long, value_name = "SPEED", default_value_t = USUAL_HIGHEST, value_parser = speed, allow_hyphen_values = true)]
    to: f64,

    #[command(flatten)]
    view: View,
}

/// In m/s: faster than wind that a section must bear.
pub const USUAL_HIGHEST: f64 = 100.0;

const EXAMPLES: &str = "\
Verdicts:
  stable     every eigenvalue has a negative real part, at all speeds of the range
  unstable   one has a positive real part, at all speeds of the range
  divergent  the stiffness of the turn is below 0: with aerodynamic stiffness the wind turns the
             section over, without any oscillation, and whether it gallops beside that or not
  undecided  none is shown: a real part that is exactly 0 at every speed, which is said, and beside
             which nothing grows; or speeds that lie too close

Columns of --format csv, a row a range of speeds: alpha_deg, from and to with as many decimals as
are certain, verdict. Between ranges that differ there is a critical speed; --format json has it
with its error, as an enclosure.

Examples:
  sextic speeds case.toml
  sextic speeds case.toml --to 40 --plot speeds.svg
  sextic speeds case.toml --to 40 --format json | jq '.points[].critical'";

/// Finds the speeds and writes them.
pub fn run(arguments: &Arguments) -> Outcome {
    let (case, table) = match case_and_table(&arguments.case, arguments.view.outputs()) {
        Ok(both) => both,
        Err(outcome) => return outcome,
    };
    let angles = match speeds_of(&case, &table, arguments.to) {
        Ok(angles) => angles,
        Err(error) => return refuse(&error),
    };
    let found = SpeedsFound {
        case,
        highest: arguments.to,
        angles,
    };
    arguments.view.show(
        || speeds_figure::figure(&found).svg(),
        |width| text::speeds(&found, width),
        || csv::speeds(&found),
        || json::speeds(&found),
    )
}

/// A speed above 0 that makes sense: nothing is faster than light.
fn speed(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(speed) if speed > 0.0 && speed <= 3e8 => Ok(speed),
        _ => Err("the highest wind speed is a number above 0 and at most 3e8, in m/s".to_string()),
    }
}
