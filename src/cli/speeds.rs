//! `sextic speeds`: the wind speeds at which a section gallops.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::algebra::number::Rational;
use crate::compile::fixed::{Fixed, number_of};
use crate::language::syntax::Name;
use crate::report::ranges::RangesFound;
use crate::report::speeds::SpeedsFound;
use crate::report::{csv, json, speeds_figure, text};
use crate::stability::critical_speed::speeds_of;

use super::Outcome;
use super::case::{case_and_table, refuse};
use super::generate::FixedParser;
use super::output::wrong;
use super::system::{Which, is_document, named, numbers, with};
use super::view::View;

/// Finds the critical wind speeds of a case, or critical values of any quantity of a system
///
/// At each angle of the case: from which wind speed on the section gallops, and at which it is stable again.
/// The speeds are the roots of a Hurwitz determinant as a polynomial in U, isolated in exact arithmetic, so
/// that none is missed but where speeds are undecided; those of static divergence are roots of the determinant
/// of the stiffness. The wind speed of the case does not matter. Numbers of the case count as doubles.
/// With a mean twist, which goes with U, there are none: sweep over U.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file, as `sextic stability --help` shows one, or a Markdown document with a system
    #[arg(value_name = "CASE|DOC")]
    input: Option<PathBuf>,

    #[command(flatten)]
    which: Which,

    /// Of a system: the quantity that is followed, with its first and last value
    #[arg(long, value_name = "NAME=FROM:TO", value_parser = followed, allow_hyphen_values = true)]
    over: Option<Followed>,

    /// A quantity of the system, or of the case by a name of `sextic sweep`, and its value; may be given
    /// several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    set: Vec<Fixed>,

    /// Of a case: the highest wind speed, in m/s
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
  divergent  of a case: the stiffness of the turn is below 0: with aerodynamic stiffness the wind
             turns the section over, without any oscillation, and whether it gallops beside that or
             not; of a system: a real eigenvalue is above 0
  undecided  none is shown: a real part that is exactly 0 at every speed, which is said, and beside
             which nothing grows; or speeds that lie too close

Of a system --over follows any quantity, angles too, within at most 12,000 parts of its range; what
these leave open is undecided. The columns are from, to and verdict, which may be neutral as well:
no real part is above 0, and some are exactly 0.

Columns of --format csv, a row a range of speeds: alpha_deg, from and to with as many decimals as
are certain, verdict. Between ranges that differ there is a critical speed; --format json has it
with its error, as an enclosure.

Examples:
  sextic speeds case.toml
  sextic speeds case.toml --set alpha_deg=68.5 --set L_g=0.002
  sextic speeds case.toml --to 40 --plot speeds.svg
  sextic speeds case.toml --to 40 --format json | jq '.points[].critical'
  sextic speeds mine.md --system bridge --set m=2 --over U=0:100";

/// Finds the speeds and writes them.
pub fn run(arguments: &Arguments) -> Outcome {
    let input = arguments.input.as_deref();
    if arguments.over.is_some() || is_document(input, &arguments.which) {
        return of_system(arguments);
    }
    of_case(arguments, input.unwrap_or(Path::new("")))
}

/// The critical values of a quantity of a system.
fn of_system(arguments: &Arguments) -> Outcome {
    let Some(Followed { name, from, to }) = &arguments.over else {
        return wrong(
            "it is not said along which quantity critical values are sought",
            "`--over U=0:100`",
        );
    };
    let found = || {
        let document = arguments.input.as_ref().map(|path| path.to_string_lossy());
        numbers(&arguments.set, &[name])?;
        let ends = [from, to].map(|end| with(&arguments.set, name, end));
        let chosen = arguments
            .which
            .choose(document.as_deref(), &[&ends[0], &ends[1]])?;
        let end = |value: &Rational| chosen.vocabulary.in_si(&named(name, value));
        let [from, to] = [from, to].map(end);
        let name = &from.name;
        let values = chosen.numbers(&arguments.set, &[name])?;
        let ranges = chosen
            .system
            .critical(&values, name, &from.value, &to.value);
        Ok(RangesFound {
            system: chosen.system.evaluator.name.clone(),
            over: name.clone(),
            ranges: ranges.map_err(|error| super::system::refuse(&error))?,
        })
    };
    if !arguments.view.outputs().is_empty() {
        return wrong(
            "ranges of a system are not drawn",
            "leave `--plot` away: it is for cases",
        );
    }
    match found() {
        Err(outcome) => outcome,
        Ok(found) => arguments.view.show(
            // No file is asked for: that was refused above.
            || Ok(String::new()),
            |_| text::ranges(&found),
            || csv::ranges(&found.ranges),
            || json::ranges(&found),
        ),
    }
}

fn of_case(arguments: &Arguments, path: &Path) -> Outcome {
    let (case, table) = match case_and_table(path, &arguments.set, arguments.view.outputs()) {
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

/// A quantity and the ends of its range.
#[derive(Clone, Debug)]
struct Followed {
    name: String,
    from: Rational,
    to: Rational,
}

/// `U=0:100`
fn followed(text: &str) -> Result<Followed, String> {
    let form = "write NAME=FROM:TO, such as U=0:100";
    let (name, range) = text.split_once('=').ok_or(form)?;
    let (from, to) = range.split_once(':').ok_or(form)?;
    let number = |text: &str| {
        let number = number_of(text.trim());
        number.ok_or_else(|| format!("`{text}` is no decimal number and no fraction: {form}"))
    };
    Ok(Followed {
        name: Name::new(name.trim()).ascii,
        from: number(from)?,
        to: number(to)?,
    })
}
