//! `sextic sweep`: a case at all combinations of values of its quantities.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};
use rayon::prelude::*;
use sha2::{Digest, Sha256};

use crate::algebra::number::Rational;
use crate::compile::fixed::Fixed;
use crate::language::diagnostic::nearest;
use crate::language::syntax::Name;
use crate::report::csv::{grid_heading, grid_row, system_heading, system_row};
use crate::stability::axis::{Axis, spaced};
use crate::stability::coefficient_table::remarks::remarks;
use crate::stability::grid::{Grid, MOST_POINTS, Methods, Rows};
use crate::stability::system::sweep::{Sweep, SweepAxis};
use crate::stability::variable::Variable;

use super::Outcome;
use super::case::{refuse, set_case_and_files, warn};
use super::generate::FixedParser;
use super::output::{complain, finish, reason, stream, wrong};
use super::partial::{Conversion, Left, Partial};
use super::system::{Which, is_document, numbers, with};

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
}

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
example at 361 angles has 14,440,000 of them, and takes minutes.

An interrupted sweep says so, and leaves its rows in a file whose name ends in .part, beside
the other one.

Examples:
  sextic sweep case.toml --vary L_g=0:0.004:200 --vary U=2:40:200 --worst --out sweep.csv
  sextic sweep case.toml --vary alpha_deg=30 --vary U=2:40:39
  sextic sweep case.toml --vary zeta=0:0.02:41 --method state,uniform --out sweep.csv
  sextic sweep mine.md --system bridge --set m=2 --vary U=2:40:1000 --out map.csv

Exit status:
  0  all rows were computed
  2  the input is wrong, or the file cannot be written; rows that were written are kept";

/// About so many points are computed between writes.
const BLOCK: u64 = 16_384;

/// The fewest rows between writes, so that all cores have some.
const FEWEST_ROWS: u64 = 64;

/// Whether the user wants to stop.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Computes a sweep and writes its rows.
pub fn run(arguments: &Arguments) -> Outcome {
    let input = arguments.input.as_deref();
    match is_document(input, &arguments.which) {
        true => of_system(arguments),
        false => of_case(arguments, input.unwrap_or(Path::new(""))),
    }
}

/// A system of a document at all points.
fn of_system(arguments: &Arguments) -> Outcome {
    let document = arguments.input.as_ref().map(|path| path.to_string_lossy());
    if arguments.worst {
        return wrong(
            "a system has no angles to choose the worst from",
            "leave `--worst` away: it is for cases",
        );
    }
    let points: Option<u64> = arguments
        .vary
        .iter()
        .try_fold(1_u64, |points, own| points.checked_mul(own.count as u64));
    if points.is_none_or(|points| points > MOST_POINTS) {
        let what = format!("the sweep has more than {MOST_POINTS} points");
        return wrong(&what, "give fewer values");
    }
    let found = || {
        let moving: Vec<String> = arguments
            .vary
            .iter()
            .map(|own| Name::new(&own.name).ascii)
            .collect();
        let moving: Vec<&str> = moving.iter().map(String::as_str).collect();
        let values = numbers(&arguments.set, &moving)?;
        let ends = [true, false].map(|is_first| {
            let mut all = arguments.set.clone();
            for (own, name) in arguments.vary.iter().zip(&moving) {
                let end = if is_first { own.from } else { own.to };
                all.extend(
                    Rational::try_from(end)
                        .map(|end| with(&[], name, &end))
                        .unwrap_or_default(),
                );
            }
            all
        });
        let chosen = arguments
            .which
            .choose(document.as_deref(), &[&ends[0], &ends[1]])?;
        Ok((values, chosen))
    };
    let (values, chosen) = match found() {
        Ok(found) => found,
        Err(outcome) => return outcome,
    };
    let axes = arguments.vary.iter().map(|own| {
        let name = Name::new(&own.name).ascii;
        let values = spaced(&name, own.from, own.to, own.count)?;
        Ok(SweepAxis { name, values })
    });
    let axes: Vec<SweepAxis> = match axes.collect::<Result<_, String>>() {
        Ok(axes) => axes,
        Err(message) => return wrong(&message, FORM),
    };
    let sweep = match chosen.system.sweep(&values, axes) {
        Ok(sweep) => sweep,
        Err(error) => return super::system::refuse(&error),
    };
    let evaluator = &chosen.system.evaluator;
    let texts = [&*evaluator.hash, &*evaluator.name, &format!("{values:?}")];
    written(&sweep, arguments, &texts)
}

fn written(table: &dyn Table, arguments: &Arguments, texts: &[&str]) -> Outcome {
    match &arguments.out {
        None => to_output(table),
        Some(path) => to_file(table, path, &identity(arguments, texts)),
    }
}

/// Rows that are computed one after the other, each by its number alone.
trait Table: Sync {
    /// How many rows there are.
    fn count(&self) -> u64;
    /// How many points it takes to compute one.
    fn points_in_a_row(&self) -> u64;
    /// The heading, with the end of the line.
    fn heading(&self) -> String;
    /// How many rows one core computes at a time.
    fn at_once(&self) -> u64;
    /// Rows with the ends of their lines.
    fn text(&self, rows: Range<u64>) -> String;
}

impl Table for Grid<'_> {
    fn count(&self) -> u64 {
        self.rows()
    }

    fn points_in_a_row(&self) -> u64 {
        Grid::points_in_a_row(self)
    }

    fn heading(&self) -> String {
        grid_heading(self)
    }

    fn at_once(&self) -> u64 {
        8
    }

    fn text(&self, rows: Range<u64>) -> String {
        rows.map(|number| grid_row(self, &self.row(number)))
            .collect()
    }
}

impl Table for Sweep<'_> {
    fn count(&self) -> u64 {
        self.len() as u64
    }

    fn points_in_a_row(&self) -> u64 {
        1
    }

    fn heading(&self) -> String {
        system_heading(self)
    }

    fn at_once(&self) -> u64 {
        512
    }

    fn text(&self, rows: Range<u64>) -> String {
        let places = rows.start as usize..rows.end as usize;
        let found = self.rows(places.clone());
        let rows = places.zip(found);
        rows.map(|(place, row)| system_row(&self.values(place), &row))
            .collect()
    }
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
    warn(&remarks(&table));
    warn(&case.remarks());
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
    written(&grid, arguments, &[&files[0].text, &files[1].text, &set])
}

fn to_output(table: &dyn Table) -> Outcome {
    let written = stream(&table.heading()).and_then(|is_read| match is_read {
        true => compute(table, 0, &mut stream),
        false => Ok(()),
    });
    match written {
        Ok(()) => Outcome::AsExpected,
        Err(error) => wrong(
            &format!("standard output cannot be written: {}", reason(&error)),
            "name a file with --out",
        ),
    }
}

fn to_file(table: &dyn Table, path: &Path, identity: &str) -> Outcome {
    let unwritable = |error: &io::Error, help: &str| {
        let what = format!("`{}` cannot be written: {}", path.display(), reason(error));
        wrong(&what, help)
    };
    let conversion = match conversion(path) {
        Ok(conversion) => conversion,
        Err(outcome) => return outcome,
    };
    let heading = table.heading();
    let row = |number| (number < table.count()).then(|| table.text(number..number + 1));
    let (mut partial, left) = match Partial::open(path, identity, &heading, row) {
        Ok(begun) => begun,
        Err(error) => {
            let help = "name a file in a folder that is there and that you may write to, and to which no other sweep writes";
            return unwritable(&error, help);
        }
    };
    for (other, is_written) in partial.others() {
        let what = match is_written {
            true => "is being written by another sweep to the same file, with other inputs",
            false => {
                "is left of a sweep with other inputs that was interrupted: delete it if you need it no more"
            }
        };
        complain(&format!("{} {what}\n", other.display()));
    }
    let done = match left {
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
    };
    // Where signals cannot be caught, an interruption is silent.
    let _ = ctrlc::set_handler(|| IS_INTERRUPTED.store(true, Ordering::Relaxed));
    let mut write = |rows: &str| {
        partial.write(rows)?;
        match IS_INTERRUPTED.load(Ordering::Relaxed) {
            true => Err(io::ErrorKind::Interrupted.into()),
            false => Ok(true),
        }
    };
    let written = compute(table, done, &mut write).and_then(|()| partial.finish(conversion));
    match written {
        Ok(()) => finish(
            &format!("{}: {} rows\n", path.display(), table.count()),
            Outcome::AsExpected,
        ),
        Err(error) if error.kind() == io::ErrorKind::Interrupted => wrong(
            &format!(
                "the sweep was interrupted: `{}` is not there yet",
                path.display()
            ),
            "give the same command again to go on with the rows that were written",
        ),
        Err(error) => unwritable(
            &error,
            "give the same command again to go on with the rows that were written",
        ),
    }
}

/// Computes the rows from one on and writes them in order, until there is nobody who reads them.
fn compute(
    table: &dyn Table,
    from: u64,
    write: &mut dyn FnMut(&str) -> io::Result<bool>,
) -> io::Result<()> {
    let progress = ProgressBar::new(table.count())
        .with_position(from)
        .with_finish(ProgressFinish::AndClear);
    let style = ProgressStyle::with_template(
        "{bar:40} {percent} %  {human_pos} of {human_len} rows, {eta} left",
    );
    progress.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    progress.reset_eta();
    let block = (BLOCK / table.points_in_a_row()).max(FEWEST_ROWS);
    let mut next = from;
    while next < table.count() {
        let end = (next + block).min(table.count());
        let parts: Vec<u64> = (next..end).step_by(table.at_once() as usize).collect();
        let part = |start: u64| table.text(start..(start + table.at_once()).min(end));
        let texts: Vec<String> = parts.into_par_iter().map(part).collect();
        for text in texts {
            if !write(&text)? {
                return Ok(());
            }
        }
        next = end;
        progress.set_position(next);
    }
    Ok(())
}

/// What tells a sweep from others: this version, the texts that it rests on, and what was asked.
fn identity(arguments: &Arguments, texts: &[&str]) -> String {
    let asked = format!(
        "{:?} {:?} {}",
        arguments.vary, arguments.method, arguments.worst
    );
    let version = env!("CARGO_PKG_VERSION");
    let texts = texts.iter().copied().chain([version, &asked]);
    let mut hash = Sha256::new();
    for text in texts {
        hash.update(text.len().to_le_bytes());
        hash.update(text);
    }
    let digits: String = hash
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    digits[..12].to_string()
}

/// How rows become a file with this name.
fn conversion(path: &Path) -> Result<Option<Conversion>, Outcome> {
    match path.extension().and_then(|extension| extension.to_str()) {
        #[cfg(feature = "parquet")]
        Some("parquet") if path.exists() && !path.is_file() => Err(wrong(
            &format!(
                "`{}` is no regular file: Parquet is not written row by row",
                path.display()
            ),
            "name a file, or a pipe whose name does not end in .parquet",
        )),
        #[cfg(feature = "parquet")]
        Some("parquet") => Ok(Some(super::parquet::from_csv)),
        #[cfg(not(feature = "parquet"))]
        Some("parquet") => Err(wrong(
            "this build writes no Parquet",
            "build it with `--features parquet`, or name a .csv file",
        )),
        Some("csv") | None => Ok(None),
        Some(other) => Err(wrong(
            &format!("a sweep is not written as .{other}"),
            "name a .csv file, or a .parquet file",
        )),
    }
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
