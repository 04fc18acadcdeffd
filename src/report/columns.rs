//! Sweeps in columns: what a table of text and a file of columns have in common.

use std::f64::consts::TAU;
use std::ops::Range;

use crate::stability::closed_form::Estimate;
use crate::stability::comparison::Value;
use crate::stability::coordinate::Coordinate;
use crate::stability::grid::Grid;
use crate::stability::limitation::Limits;
use crate::stability::mean_twist::Twist;
use crate::stability::system::sweep::Sweep;

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its heading.
    pub name: String,
    /// Its cells, a row each.
    pub cells: Cells,
    /// Whether no cell is ever empty.
    pub is_full: bool,
}

/// The cells of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers; no number is an empty cell.
    Numbers(Vec<f64>, Digits),
    /// Numbers with bounds of their errors: the numbers.
    Certain(Vec<Option<Value>>),
    /// The bounds.
    Bounds(Vec<Option<Value>>),
    /// Words; none is an empty cell.
    Words(Vec<&'static str>),
}

/// How a number becomes text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// The fewest digits that tell it from others.
    All,
    /// The same, with a decimal point or a power of ten: as a number that is not a whole one.
    Point,
    /// So many decimals.
    Decimals(u8),
}

/// The columns of some rows of a grid: its quantities, S by the methods that are asked, bounds of their errors, the
/// frequency and the coordinate that moves most in the mode with the least damping, and what speaks against the
/// closed and the uniform form.
///
/// An empty cell is a method that does not apply, or has no answer.
pub fn of_grid(grid: &Grid, rows: Range<u64>) -> Vec<Column> {
    let found = grid.rows_at(rows);
    let asked = grid.methods();
    let axes = grid
        .variables()
        .zip(found.values)
        .map(|(own, values)| Column {
            name: own.name.to_string(),
            cells: Cells::Numbers(values, Digits::All),
            // No angle may be the worst.
            is_full: !(own.is_angle() && grid.has_worst_angles()),
        });
    let (frequencies, mostly) = critical(&found.critical);
    let methods = [
        (
            asked.exact,
            "s3d_exact",
            Cells::Certain(found.exact.clone()),
        ),
        (
            asked.companion,
            "s3d_companion",
            Cells::Certain(found.companion.clone()),
        ),
        (asked.closed, "s3d_closed", estimates(&found.closed)),
        (asked.uniform, "s3d_uniform", estimates(&found.uniform)),
        (asked.exact, "error_exact", Cells::Bounds(found.exact)),
        (
            asked.companion,
            "error_companion",
            Cells::Bounds(found.companion),
        ),
        (asked.exact, "frequency_hz", frequencies),
        (asked.exact, "mostly", mostly),
        (asked.closed, "closed_limits", limits(&found.closed)),
        (asked.uniform, "uniform_limits", limits(&found.uniform)),
    ];
    let asked = methods.into_iter().filter(|(is_asked, ..)| *is_asked);
    let asked = asked.map(|(_, name, cells)| column(name, cells));
    let twists = grid.has_twists().then(|| twists(&found.twists));
    axes.chain(twists.into_iter().flatten())
        .chain(asked)
        .collect()
}

/// Mean twists in degrees, and what is known of the balance there.
fn twists(found: &[Option<Twist>]) -> [Column; 2] {
    let degrees = |own: &Option<Twist>| own.map_or(f64::NAN, |own| own.angle.to_degrees());
    let word = |own: &Option<Twist>| own.map_or("none", |own| own.word());
    let degrees = found.iter().map(degrees).collect();
    [
        column("twist_deg", Cells::Numbers(degrees, Digits::Decimals(9))),
        column("balance", Cells::Words(found.iter().map(word).collect())),
    ]
}

/// Frequencies in Hz, and the coordinates that move most.
fn critical(found: &[Option<(f64, Coordinate)>]) -> (Cells, Cells) {
    let frequency = |own: &Option<(f64, _)>| own.map_or(f64::NAN, |(frequency, _)| frequency);
    let mostly = |own: &Option<(_, Coordinate)>| own.map_or("", |(_, mostly)| mostly.name());
    (
        Cells::Numbers(found.iter().map(frequency).collect(), Digits::Decimals(6)),
        Cells::Words(found.iter().map(mostly).collect()),
    )
}

/// The columns of some rows of a sweep of a system: its quantities, the largest real part and its error in 1/s, the
/// frequency of that mode in Hz, and whether the system is stable.
///
/// Cells are empty where the system has no numbers, and the verdict where the errors do not decide it.
pub fn of_system(sweep: &Sweep<'_>, rows: Range<u64>) -> Vec<Column> {
    let rows = rows.start as usize..rows.end as usize;
    let values: Vec<Vec<f64>> = rows.clone().map(|row| sweep.values(row)).collect();
    let found = sweep.rows(rows);
    let numbers =
        |name: &str, numbers: Vec<f64>| column(name, Cells::Numbers(numbers, Digits::Point));
    let axes = sweep.axes().iter().enumerate().map(|(place, axis)| Column {
        is_full: true,
        ..numbers(&axis.name, values.iter().map(|own| own[place]).collect())
    });
    let growths: Vec<[f64; 3]> = found
        .iter()
        .map(|own| match &own.growth {
            Ok(own) => [own.value.re, own.error, own.value.im / TAU],
            Err(_) => [f64::NAN; 3],
        })
        .collect();
    let growth = ["growth", "error", "frequency_hz"].into_iter().enumerate();
    let growth =
        growth.map(|(place, name)| numbers(name, growths.iter().map(|own| own[place]).collect()));
    let verdicts = found
        .iter()
        .map(|own| own.verdict.map_or("", |own| own.name()));
    let verdict = column("verdict", Cells::Words(verdicts.collect()));
    axes.chain(growth).chain([verdict]).collect()
}

fn column(name: &str, cells: Cells) -> Column {
    Column {
        name: name.to_string(),
        cells,
        is_full: false,
    }
}

fn estimates(found: &[Estimate<Limits>]) -> Cells {
    let numbers = found.iter().map(|own| own.value.unwrap_or(f64::NAN));
    Cells::Numbers(numbers.collect(), Digits::Decimals(9))
}

fn limits(found: &[Estimate<Limits>]) -> Cells {
    Cells::Words(found.iter().map(|own| own.limitations.words()).collect())
}

impl Cells {
    /// The numbers, no number for an empty cell; of words there are none.
    pub fn numbers(&self) -> Vec<f64> {
        let number =
            |own: &Option<Value>, number: fn(&Value) -> f64| own.as_ref().map_or(f64::NAN, number);
        match self {
            Cells::Numbers(own, _) => own.clone(),
            Cells::Certain(own) => own.iter().map(|own| number(own, |own| own.value)).collect(),
            Cells::Bounds(own) => own.iter().map(|own| number(own, |own| own.error)).collect(),
            Cells::Words(own) => vec![f64::NAN; own.len()],
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Cells::Numbers(own, _) => own.len(),
            Cells::Certain(own) | Cells::Bounds(own) => own.len(),
            Cells::Words(own) => own.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
