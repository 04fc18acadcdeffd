//! `sextic sweep`: a case at all combinations of values of its quantities.

mod messages;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "parquet")]
mod parts;
mod rows;
mod written;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::algebra::number::Rational;
use crate::compile::fixed::Fixed;
use crate::language::diagnostic::nearest;
use crate::language::syntax::Name;
use crate::stability::axis::{Axis, spaced};
use crate::stability::grid::{Grid, MOST_POINTS, Methods, Rows};
use crate::stability::system::sweep::SweepAxis;
use crate::stability::variable::Variable;

use super::Outcome;
use super::case::{refuse, set_case_and_files, warn_without_errors};
use super::generate::FixedParser;
use super::output::wrong;
use super::system::{Which, is_document, numbers, with};

#[cfg(feature = "parquet")]
use self::parts::Parts;
use self::rows::Table;
use self::written::written;

/// Computes a case, or a system that a document derives, at all combinations of values of its quantities
///
/// Each --vary adds a quantity and its evenly spaced values, the first one changing slowest; the angles are
/// those of the case unless alpha_deg is varied. Every combination is a row of a table: S_3D by each method
/// as `sextic stability` has it, bounds of the errors, and the mode with the least damping. Rows come in
/// the same order however many cores compute them. An interrupted sweep goes on where it was when the same
/// command is given again.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file, as `sextic stability --help` shows one, or a Markdown document with a system
    #[arg(value_name = "CASE|DOC")]
    input: Option<PathBuf>,

    #[command(flatten)]
    which: Which,

    /// A quantity, its first and last value and how many there are, or one value; may be given several times
    #[arg(long, value_name = "NAME=FROM:TO:COUNT", value_parser = varied, allow_hyphen_values = true)]
    vary: Vec<Varied>,

    /// A quantity that stays, of a system or in place of what a case says, and its value; may be given several
    /// times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    set: Vec<Fixed>,

    /// The methods that are asked
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = [Method::State, Method::Companion, Method::Closed, Method::Uniform])]
    method: Vec<Method>,

    /// One row for all angles: that of the smallest S_3D, by the first of state, companion, uniform and
    /// closed that is asked
    #[arg(long)]
    worst: bool,

    /// The file for the table, .csv or (in builds with Parquet) .parquet; standard output without it
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    /// Write the rows in so many parts, as Parquet files of the folder --out; parts that are there are kept
    #[cfg(feature = "parquet")]
    #[arg(long, value_name = "COUNT", requires = "out", value_parser = clap::value_parser!(u64).range(1..=MOST_PARTS))]
    parts: Option<u64>,

    /// Compute only this one of the parts, counted from 1: other processes or machines compute the others
    #[cfg(feature = "parquet")]
    #[arg(long, value_name = "NUMBER", requires = "parts", value_parser = clap::value_parser!(u64).range(1..=MOST_PARTS))]
    part: Option<u64>,
}

/// Names of parts have so many digits.
#[cfg(feature = "parquet")]
const MOST_PARTS: u64 = 99_999;

/// A method of the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    /// The state matrix (16), in the column `s3d_exact`
    State,
    /// The companion matrix of the characteristic polynomial (19)
    Companion,
    /// The closed forms (21) to (23), where they apply
    Closed,
    /// The form that holds at every eccentricity
    Uniform,
}

const EXAMPLES: &str = "\
Quantities, as in a case file or in SI units and radians:
  alpha_deg, D, m, r, L_g, alpha_g_deg or alpha_g, L_a, gamma_r_deg or gamma_r, rho, U; f_x, f_y,
  f_theta or omega_x, omega_y, omega_theta, and f or omega_n for all three; zeta_x, zeta_y,
  zeta_theta, and zeta for all three; C_D, C_L, C_M, dC_D, dC_L, dC_M (per radian) in place of what
  the table says

Quantities of a system are the parameters, angles and values of functions of its document; what is
not varied is given by --set. Its columns, after the quantities: growth (the largest real part) and
its error in 1/s, frequency_hz of that mode, and the verdict where the errors decide it.

Columns of a case, after the quantities and the angle, as far as their methods are asked:
  twist_deg, balance, with a mean twist: as `sextic stability` has them; none where springs and wind
  have no balance that is certain
  s3d_exact (state matrix), s3d_companion, s3d_closed, s3d_uniform: S_3D; empty where a method does
  not apply, or no digit is certain
  error_exact, error_companion: what is exact is no farther from the number that is printed
  frequency_hz, mostly: of the mode with the least damping, and the coordinate that moves most in it
  closed_limits, uniform_limits: what speaks against the form, in words: held (a coordinate),
  detuned, damped (structural damping is left out), stiffness (aerodynamic stiffness is),
  eccentricity (below the aerodynamic damping), sign (S is as small as what is left out), strong
  (damping, above a tenth: for the closed form of a mode over its frequency, for the uniform form
  the norm of all damping over twice the lowest frequency), no-roots (none found in doubles)

Without --worst there is a row for every combination at every angle of the case: that of the first
example at 361 angles has 14,440,000 of them, and takes a while.

An interrupted sweep says so, and leaves its rows in a file whose name ends in .part, beside
the other one. A .parquet file has all digits; what is left of one is a Parquet file as well. Where
the process is killed nothing can be gone on with, and a file .sextic-… is left to be deleted.
In parts (in builds with Parquet), each file has the same rows whoever computes it, and has its name
only when it is whole: where a process is killed, the same command computes what is missing.

Examples:
  sextic sweep case.toml --vary L_g=0:0.004:200 --vary U=2:40:200 --worst --out sweep.csv
  sextic sweep case.toml --vary alpha_deg=30 --vary U=2:40:39
  sextic sweep case.toml --vary zeta=0:0.02:41 --method state,uniform --out sweep.csv
  sextic sweep case.toml --vary U=2:40:4000 --parts 16 --out sweep
  sextic sweep mine.md --system bridge --set m=2 --vary U=2:40:1000 --out map.csv

Exit status:
  0  all rows were computed
  2  the input is wrong, or the file cannot be written; rows that were written are kept";

/// Computes a sweep and writes its rows.
pub fn run(arguments: &Arguments) -> Outcome {
    let input = arguments.input.as_deref();
    match is_document(input, &arguments.which) {
        true => of_system(arguments).unwrap_or_else(|outcome| outcome),
        false => of_case(arguments, input.unwrap_or(Path::new(""))),
    }
}

/// A system of a document at all points.
fn of_system(arguments: &Arguments) -> Result<Outcome, Outcome> {
    if arguments.worst {
        return Err(wrong(
            "a system has no angles to choose the worst from",
            "leave `--worst` away: it is for cases",
        ));
    }
    let counts = arguments.vary.iter().map(|own| own.count as u64);
    let points = counts.fold(1_u64, u64::saturating_mul);
    if points > MOST_POINTS {
        let what = format!("the sweep has more than {MOST_POINTS} points");
        return Err(wrong(&what, "give fewer values"));
    }
    let names: Vec<String> = arguments
        .vary
        .iter()
        .map(|own| Name::new(&own.name).ascii)
        .collect();
    let moving: Vec<&str> = names.iter().map(String::as_str).collect();
    numbers(&arguments.set, &moving)?;
    let [first, last] = [true, false].map(|is_first| end(arguments, &moving, is_first));
    let document = arguments.input.as_ref().map(|path| path.to_string_lossy());
    let chosen = arguments
        .which
        .choose(document.as_deref(), &[&first, &last])?;
    let known: Vec<(String, f64)> = names
        .iter()
        .map(|name| {
            let renamed = chosen.vocabulary.renamed(name);
            renamed.unwrap_or_else(|| (name.clone(), 1.0))
        })
        .collect();
    let moving: Vec<&str> = known.iter().map(|(name, _)| name.as_str()).collect();
    let values = chosen.numbers(&arguments.set, &moving)?;
    let axes = arguments
        .vary
        .iter()
        .zip(&known)
        .map(|(own, (name, factor))| {
            let values = spaced(name, own.from * *factor, own.to * factor, own.count)?;
            let name = name.clone();
            Ok(SweepAxis { name, values })
        });
    let axes: Result<Vec<SweepAxis>, String> = axes.collect();
    let axes = axes.map_err(|message| wrong(&message, FORM))?;
    let sweep = chosen.system.sweep(&values, axes);
    let sweep = sweep.map_err(|error| super::system::refuse(&error))?;
    let evaluator = &chosen.system.evaluator;
    let texts = [&*evaluator.hash, &*evaluator.name, &format!("{values:?}")];
    let identity = identity(arguments, &texts);
    Ok(write(&sweep, arguments, &identity))
}

/// Writes the rows as one table, or in parts.
fn write(table: &dyn Table, arguments: &Arguments, identity: &[String]) -> Outcome {
    #[cfg(feature = "parquet")]
    if let (Some(count), Some(folder)) = (arguments.parts, &arguments.out) {
        let only = arguments.part;
        if only.is_some_and(|own| own > count) {
            return wrong("there are fewer parts", "--part counts from 1 to --parts");
        }
        let written = Parts { count, only }.write(table, folder, identity);
        return written.unwrap_or_else(|outcome| outcome);
    }
    written(table, arguments.out.as_deref(), identity)
}

/// The numbers at the first or last values of all that is varied.
fn end(arguments: &Arguments, moving: &[&str], is_first: bool) -> Vec<Fixed> {
    let mut all = arguments.set.clone();
    for (own, name) in arguments.vary.iter().zip(moving) {
        let end = if is_first { own.from } else { own.to };
        let end = Rational::try_from(end).map(|end| with(&[], name, &end));
        all.extend(end.unwrap_or_default());
    }
    all
}

/// A case and its table at all points.
fn of_case(arguments: &Arguments, path: &Path) -> Outcome {
    let outputs = arguments.out.as_slice();
    let (case, table, files) = match set_case_and_files(path, &arguments.set, outputs) {
        Ok(read) => read,
        Err(outcome) => return outcome,
    };
    let axes = match arguments
        .vary
        .iter()
        .map(axis)
        .collect::<Result<_, String>>()
    {
        Ok(axes) => axes,
        Err(message) => return wrong(&message, FORM),
    };
    warn_without_errors(&case, &table);
    let methods = Methods {
        exact: arguments.method.contains(&Method::State),
        companion: arguments.method.contains(&Method::Companion),
        closed: arguments.method.contains(&Method::Closed),
        uniform: arguments.method.contains(&Method::Uniform),
    };
    let rows = if arguments.worst {
        Rows::WorstAngles
    } else {
        Rows::Points
    };
    let grid = match Grid::new(&case, &table, axes, rows, methods) {
        Ok(grid) => grid,
        Err(error) => return refuse(&error),
    };
    let set = format!("{:?}", arguments.set);
    let texts = [&*files[0].text, &files[1].text, &set];
    write(&grid, arguments, &identity(arguments, &texts))
}

/// What tells a sweep from others: the texts that it rests on, and what was asked.
fn identity(arguments: &Arguments, texts: &[&str]) -> Vec<String> {
    let asked = format!(
        "{:?} {:?} {}",
        arguments.vary, arguments.method, arguments.worst
    );
    texts
        .iter()
        .map(ToString::to_string)
        .chain([asked])
        .collect()
}

/// A quantity and its evenly spaced values, as they are written.
#[derive(Clone, Debug)]
struct Varied {
    name: String,
    from: f64,
    to: f64,
    count: usize,
}

/// How a quantity is varied.
const FORM: &str = "write NAME=FROM:TO:COUNT, such as U=2:40:200, or NAME=VALUE";

/// `U=2:40:200`, or `U=9` for one value.
fn varied(text: &str) -> Result<Varied, String> {
    let (name, values) = text.split_once('=').ok_or(FORM)?;
    let number = |text: &str| -> Result<f64, String> {
        let decimal = text.trim().parse::<f64>();
        decimal.map_err(|_| format!("`{text}` is no decimal number: {FORM}"))
    };
    let (from, to, count) = match *values.split(':').collect::<Vec<_>>().as_slice() {
        [value] => (number(value)?, number(value)?, 1),
        [from, to, count] => {
            let count = count.trim().parse::<usize>();
            let count = count.map_err(|_| format!("the count is a whole number: {FORM}"))?;
            (number(from)?, number(to)?, count)
        }
        _ => return Err(FORM.to_string()),
    };
    Ok(Varied {
        name: name.trim().to_string(),
        from,
        to,
        count,
    })
}

/// The values of a quantity of a case.
fn axis(varied: &Varied) -> Result<Axis, String> {
    let name = &varied.name;
    let variable = Variable::named(name).ok_or_else(|| not_varied(name))?;
    Axis::new(variable, varied.from, varied.to, varied.count)
}

fn not_varied(name: &str) -> String {
    if ["alpha_0", "theta_0"].contains(&name) {
        return format!("{name} goes with the angle of attack: vary alpha_deg");
    }
    match nearest(name, Variable::all().map(|own| own.name)) {
        Some(near) => format!("there is no quantity `{name}`: did you mean `{near}`?"),
        None => format!("there is no quantity `{name}`: `sextic sweep --help` names them"),
    }
}
