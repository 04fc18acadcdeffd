//! `sextic stability`: where a section gallops, by every method.

use std::path::PathBuf;

use clap::Args;

use crate::report::{csv, json, stability_figure, text};
use crate::stability::comparison::{Comparison, compare};

use super::Outcome;
use super::case::{Overrides, refuse, set_case_and_files, warn};
use super::view::View;

/// Shows at which angles a section gallops, and how the methods agree
///
/// The case file names the section, its structure, the wind, the angles, and a table of force
/// coefficients beside it. At each angle the damping coefficient S_3D = -4 m max(lambda_R)/(rho D U) is
/// computed from the state matrix, from the characteristic polynomial, by the closed forms (21) to (23),
/// and by the uniform form, which holds at every eccentricity; the section gallops where it is below 0.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file, in TOML
    #[arg(value_name = "CASE")]
    case: PathBuf,

    #[command(flatten)]
    overrides: Overrides,

    #[command(flatten)]
    view: View,
}

const EXAMPLES: &str = "\
Examples:
  sextic stability case.toml
  sextic stability case.toml --set U=12 --plot stability.svg
  sextic stability case.toml --format csv > curves.csv

A case file:
  [section]
  D = 0.05                        # reference dimension in m
  m = 3.5                         # mass in kg/m
  r = 0.0178                      # radius of gyration about the elastic centre in m
  L_g = 0.004                     # from the elastic centre to the mass centre in m
  alpha_g_deg = 0                 # and its angle in degrees
  L_a = 0.03                      # to the aerodynamic centre in m
  gamma_r_deg = 0                 # and its angle in degrees
  coefficients = \"table.csv\"      # with the columns alpha_deg, CL, CD, CM
  # columns = { CL = \"ca\" }        if columns have other names than the usual ones
  mirror = false                  # true: half a table is continued by symmetry
  slopes = false                  # true: derivatives are dCL, dCD, dCM of the table
  interpolation = \"cubic\"         # or \"linear\": a slope for each cell, at a row that above it;
                                  # \"smooth\": no closer to the table than this scatters
  errors = { CD = 0.02, CL = 0.02, CM = 0.005 }  # the largest of the coefficients, not the usual
  reference = { CL = 0.3, CM = [0.3, 0.3] }      # lengths in m below them where that is not D
                                  # mirror, slopes, errors and reference may be left out
  [structure]
  f_x = 0.96                      # frequencies in Hz
  f_y = 0.845
  f_theta = 0.865
  zeta_x = 0.008                  # damping ratios
  zeta_y = 0.008
  zeta_theta = 0.03
  free = [\"x\", \"y\", \"theta\"]      # may be left out; what is held needs no numbers
  [wind]
  rho = 1.25                      # in kg/m³
  U = 9                           # in m/s
  aerodynamic_stiffness = false   # true: the angle of attack follows the turn; may be left out
  mean_twist = false              # true: the mean moment turns the section; may be left out
  [sweep]
  alpha_deg = { from = 0, to = 180, step = 0.5 }
  turn = \"section\"                # alpha turns the section (theta_0), or \"wind\" (alpha_0)

A table names its columns in a row by their usual names (alpha_deg, AoA, alpha [rad]; CL, Cl, C_L;
CD; CM), separated by commas, semicolons, tabs or blanks. A row of units, comments (#, !, %, //),
other columns, any order of rows and rows that are repeated are read over, and said; polars of
AeroDyn are such tables. A case may say what else columns are called, by alpha_deg or alpha_rad, CL,
CD, CM, dCL, dCD, dCM, CL_error, CD_error, CM_error. A table that is to be mirrored ends at 0 or 180
degrees; drag is even about it, lift and moment are odd. Slopes are per radian, or per degree if the
heading says so (dCL [1/deg]). What is read of a table is said on standard error.

Where the coefficients have errors, each angle also has a verdict for all coefficients within them:
stable, unstable, depends (two were found, one stable and one not) or open (none of these is shown).
Slopes are off by what the errors of the rows around an angle make of them.

Signs: the wind blows along (cos alpha_0, sin alpha_0) in the plane of x and y. Positive theta moves
a point at the distance L and the angle beta from the elastic centre O, at (-L cos beta, L sin
beta), to (-L cos(beta + theta), L sin(beta + theta)); alpha_g and gamma_r are the beta of the mass
centre G and of the aerodynamic centre A. The relative wind is that at A, and coefficients are read
at the angle of attack alpha = alpha_0 + theta_0, which moves with the section if
aerodynamic_stiffness = true. Drag is along the relative wind, lift 90 degrees anticlockwise from
it, each rho D U^2 C/2; the moment is about O in the sense of theta, rho D^2 U^2 C_M/2.

With mean_twist = true angles are those without wind. The section is looked at where the spring of
the turn and the moment at the twisted angle are in balance: at the first balance that a rising
wind reaches, which is certain within 4e-12 rad. An angle without one has no verdict, which is said
with its reason; the other angles are computed.

Modes are numbered by their frequency at the first angle, the highest first, and followed by their
shapes. Where strong damping or stiffness splits a pair of eigenvalues into two real ones, one of
them goes on, and the other takes the lowest free number.

What is unstable diverges where the stiffness of the turn is below 0, which takes aerodynamic
stiffness, and gallops everywhere else, with or without an oscillation.

Columns of --format csv, a row an angle (an empty cell: a method that does not apply, no such mode,
or a number of which no digit is certain):
  alpha_deg
  s3d_exact (state matrix), s3d_companion, s3d_closed, s3d_uniform: S_3D, or S of fewer freedoms
  error_exact, error_companion: what is exact is no farther from the number that is printed
  verdict: stable, unstable (it gallops or diverges) or undecided, certain for the numbers as
  doubles: by the errors, or by exact arithmetic
  mode, frequency_hz: number and frequency of the mode with the least damping
  s_mode_1, frequency_hz_mode_1 and so on: S and frequency of every mode
  C_D, C_L, C_M, dC_D, dC_L, dC_M: the coefficients as they are read between the rows of the table,
  and their derivatives per radian
  twist_deg, balance, with a mean twist: only, several (there are other balances), jump (the twist
  may not have grown steadily with the wind) or none (no certain twist, and no other number)
  within_errors, s3d_least, s3d_most, where the coefficients have errors: the verdict for all of
  them, and between which numbers S is then (empty where they are too large to tell the modes apart)

Exit status:
  0  the case was computed, whether the section gallops or not
  2  the input is wrong, or a file cannot be written";

/// Computes a case and writes it.
pub fn run(arguments: &Arguments) -> Outcome {
    let comparison = match comparison(arguments) {
        Ok(comparison) => comparison,
        Err(outcome) => return outcome,
    };
    if arguments.view.is_table() {
        warn(&comparison.remarks);
    }
    arguments.view.show(
        || stability_figure::figure(&comparison).svg(),
        |width| text::comparison(&comparison, width),
        || csv::comparison(&comparison),
        || json::comparison(&comparison),
    )
}

/// A case from the disk, compared at all its angles.
fn comparison(arguments: &Arguments) -> Result<Comparison, Outcome> {
    let (case, table, _) = set_case_and_files(
        &arguments.case,
        &arguments.overrides.set,
        arguments.view.outputs(),
    )?;
    compare(&case, &table).map_err(|error| refuse(&error))
}
