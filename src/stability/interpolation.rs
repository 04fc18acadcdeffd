//! Coefficients between the angles of a table.

use std::fmt;
use std::sync::OnceLock;

use serde::Deserialize;
use sextic_evaluators::bounded::Bounded;

use super::coefficient_table::angle::WHOLE;
use super::coefficient_table::column::Column;
use super::coefficient_table::{CoefficientTable, FEWEST_ROWS, Row};
use super::forces::Coefficients;
use super::input::{InputError, Place};
use super::smoothing::{MOST_POINTS, Smoother};
use super::spline::{CubicSpline, Ends, cell};

/// How a table is read between its angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight lines; the derivative is the slope of the cell, at an angle of the table that of the
    /// cell above it.
    Linear,
    /// A cubic spline, periodic where the table goes round the circle, not-a-knot elsewhere.
    Cubic,
    /// A [smoothing spline](super::smoothing), periodic or natural: it follows the table no closer than this scatters.
    Smooth,
}

impl fmt::Display for Interpolation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Interpolation::Linear => "straight lines between them",
            Interpolation::Cubic => "cubic splines between them",
            Interpolation::Smooth => "smoothing splines near them",
        })
    }
}

/// An angle that a table does not reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideTable {
    /// The angle, in degrees.
    pub angle: f64,
    /// Where the table ends and begins again around the angle, or its first and last angle, in degrees.
    pub reach: [f64; 2],
    /// Whether the angle is within a hole.
    pub is_in_hole: bool,
}

impl fmt::Display for OutsideTable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (angle, [first, last]) = (self.angle, self.reach);
        match self.is_in_hole {
            true => write!(
                formatter,
                "the angle {angle}° is in a hole of the table, between {first}° and {last}°: nothing is known there"
            ),
            false => write!(
                formatter,
                "the angle {angle}° is outside of the table, which goes from {first}° to {last}°"
            ),
        }
    }
}

impl std::error::Error for OutsideTable {}

/// Curves of C_D, C_L and C_M through a table.
#[derive(Clone, Debug)]
pub struct CoefficientCurves {
    /// The angles of the table.
    angles: Vec<f64>,
    is_circle: bool,
    /// Whether one piece is the circle.
    is_whole: bool,
    /// Whether the circle closes with a jump.
    jumps: bool,
    /// Between holes, in order.
    pieces: Vec<Piece>,
}

/// Curves without a hole.
#[derive(Clone, Debug)]
struct Piece {
    angles: Vec<f64>,
    /// C_D, C_L, C_M.
    curves: [Curve; 3],
    /// Their derivatives per radian, where the table gives them.
    slopes: Option<[Curve; 3]>,
    /// Their errors at the angles.
    errors: [Vec<f64>; 3],
    ends: Ends,
    interpolation: Interpolation,
    /// What smooths the columns, and how much each.
    smoother: Option<(Smoother, [f64; 3])>,
    /// What [`Piece::influences`] gives, from when errors are first asked for: as many numbers as the square of the rows.
    influences: OnceLock<Vec<Vec<Curve>>>,
}

/// C_M without a hole: a cubic in each cell.
#[derive(Clone, Debug)]
pub(super) struct MomentPiece {
    /// In degrees, increasing.
    pub angles: Vec<f64>,
    /// Σ bⱼ (3 over j) tʲ (1 − t)³⁻ʲ, with t from 0 to 1 along the cell.
    pub cubics: Vec<[Bounded; 4]>,
}

impl MomentPiece {
    /// Its first and its last angle.
    pub fn ends(&self) -> [f64; 2] {
        [self.angles[0], self.angles[self.angles.len() - 1]]
    }

    /// The cell of an angle.
    pub fn cell(&self, angle: f64) -> usize {
        cell(&self.angles, angle)
    }
}

/// More than what is lost as bounds are computed.
const MORE: f64 = 1.0 + 1e-12;

#[derive(Clone, Debug)]
enum Curve {
    Lines(Vec<f64>),
    Spline(CubicSpline),
}

impl CoefficientCurves {
    /// Curves through a table: linear in its length, but for sorting the widths of its cells.
    ///
    /// Where derivatives are those of the table's columns, they are curves of their own.
    ///
    /// Nothing is drawn across a [hole](CoefficientTable::holes): the rows between two of them make a curve of
    /// their own if there are at least four. What is smoothed takes the third power of its length.
    ///
    /// # Errors
    ///
    /// If more than [`MOST_POINTS`] rows are to be smoothed, or no smoothing curve is found.
    pub fn new(table: &CoefficientTable, interpolation: Interpolation) -> Result<Self, InputError> {
        let mut rows = table.converted_rows();
        let is_circle = table.is_circle();
        // A table that stops one step short of the circle is closed with its first row.
        if is_circle && !table.is_closed() {
            let first = rows[0];
            rows.push(Row {
                angle: first.angle + 360.0,
                ..first
            });
        }
        let angles = rows.iter().map(|row| row.angle).collect();
        let mut holes = table.holes();
        let jumps = is_circle && table.has_a_jump_at_its_end();
        let goes_on = is_circle && !jumps;
        let is_whole = goes_on && holes.is_empty();
        if let (true, Some(&hole)) = (goes_on, holes.first()) {
            rows = behind(hole, &rows);
            // The first one lies beyond the last row now.
            holes = holes[1..].iter().map(|own| own - hole - 1).collect();
        }
        let ends = match (is_whole, interpolation) {
            (true, _) => Ends::Periodic,
            (false, Interpolation::Smooth) => Ends::Natural,
            (false, _) => Ends::NotAKnot,
        };
        let mut pieces = Vec::new();
        let mut rest = rows.as_slice();
        let mut taken = 0;
        for hole in holes {
            let (piece, others) = rest.split_at(hole + 1 - taken);
            pieces.push(piece);
            (rest, taken) = (others, hole + 1);
        }
        pieces.push(rest);
        let is_long = |piece: &&[Row]| piece.len() >= FEWEST_ROWS;
        let pieces = pieces.into_iter().filter(is_long);
        let pieces = pieces.map(|piece| {
            Piece::new(piece, interpolation, ends, table.has_slopes()).ok_or_else(|| {
                let what = format!("{} rows are not smoothed", piece.len());
                let help = format!(
                    "leave rows out, or average neighbours: at most {MOST_POINTS} are smoothed"
                );
                InputError::new(Place::file(table.file()), what, help)
            })
        });
        Ok(CoefficientCurves {
            angles,
            is_circle,
            is_whole,
            jumps,
            pieces: pieces.collect::<Result<_, _>>()?,
        })
    }

    /// The coefficients at an angle in degrees, and their derivatives per radian; on the circle, at any
    /// angle.
    ///
    /// Logarithmic in the length of the table, and linear in the number of its holes.
    ///
    /// # Errors
    ///
    /// If the table does not reach the angle, or it is in a hole.
    pub fn at(&self, angle: f64) -> Result<Coefficients, OutsideTable> {
        let outside = || self.outside(angle);
        let (piece, place) = self.place(angle).ok_or_else(outside)?;
        Ok(coefficients(
            [0, 1, 2].map(|curve: usize| piece.at(curve, place)),
        ))
    }

    /// The piece that holds an angle, and the angle there: as it is if any does, else turned round the circle.
    fn place(&self, angle: f64) -> Option<(&Piece, f64)> {
        let (piece, place) = self.piece_at(angle)?;
        Some((&self.pieces[piece], place))
    }

    /// The number of that piece, and the angle there.
    pub(super) fn piece_at(&self, angle: f64) -> Option<(usize, f64)> {
        let holds = |piece: &Piece| piece.first() <= angle && angle <= piece.last();
        if let Some(piece) = self.pieces.iter().position(holds) {
            return Some((piece, angle));
        }
        if !self.is_circle || !angle.is_finite() {
            return None;
        }
        self.pieces.iter().enumerate().find_map(|(number, piece)| {
            let place = piece.first() + (angle - piece.first()).rem_euclid(360.0);
            // The circle has no end, whatever the rounding of its last angle.
            (self.is_whole || place <= piece.last()).then(|| (number, place.min(piece.last())))
        })
    }

    /// C_M piece by piece, and whether the only one goes round the circle.
    pub(super) fn moment_pieces(&self) -> (Vec<MomentPiece>, bool) {
        let piece = |own: &Piece| MomentPiece {
            cubics: (0..own.angles.len() - 1)
                .map(|cell| own.cubic(2, cell))
                .collect(),
            angles: own.angles.clone(),
        };
        (self.pieces.iter().map(piece).collect(), self.is_whole)
    }

    /// The ends of a circle that closes with a jump.
    pub(super) fn jump(&self) -> Option<[f64; 2]> {
        let ends = [*self.angles.first()?, *self.angles.last()?];
        self.jumps.then_some(ends)
    }

    /// How far the coefficients at an angle, and their slopes, may be from those at others that are no farther from it
    /// than this, in degrees.
    ///
    /// # Errors
    ///
    /// As [`CoefficientCurves::at`].
    pub(super) fn moved_by(&self, angle: f64, by: f64) -> Result<Coefficients, OutsideTable> {
        let (piece, place) = self.place(angle).ok_or_else(|| self.outside(angle))?;
        Ok(coefficients(
            [0, 1, 2].map(|curve: usize| piece.moved_by(curve, place, by)),
        ))
    }

    /// Why an angle has no place: the pieces around it, if there are any.
    fn outside(&self, angle: f64) -> OutsideTable {
        let turns: &[f64] = match self.is_circle {
            true => &[-360.0, 0.0, 360.0],
            false => &[0.0],
        };
        let start = self.angles[0];
        let own = match self.is_circle {
            true => start + (angle - start).rem_euclid(360.0),
            false => angle,
        };
        let mut hole: [Option<f64>; 2] = [None, None];
        for turn in turns {
            for piece in &self.pieces {
                let (first, last) = (piece.first() + turn, piece.last() + turn);
                if last < own {
                    hole[0] = Some(hole[0].map_or(last, |end| end.max(last)));
                }
                if first > own {
                    hole[1] = Some(hole[1].map_or(first, |end| end.min(first)));
                }
            }
        }
        let reach = [start, self.angles[self.angles.len() - 1]];
        let is_in_hole = self.pieces.is_empty() && reach[0] <= own && own <= reach[1];
        match hole {
            [Some(below), Some(above)] => OutsideTable {
                angle,
                reach: [below, above],
                is_in_hole: true,
            },
            _ => OutsideTable {
                angle,
                reach,
                is_in_hole,
            },
        }
    }

    /// How far the coefficients at an angle, and their derivatives, may be off if each row of the table is off by at most its
    /// errors: Σ|w_j| e_j with the weights w_j that the value or slope there gives to each row. A curve that is smoothed is
    /// one with the smoothness that was found.
    ///
    /// Linear in the number of rows around the angle, and for splines the first time in its square: see
    /// [`CoefficientCurves::follows_errors`].
    ///
    /// # Errors
    ///
    /// As [`CoefficientCurves::at`].
    pub fn errors_at(&self, angle: f64) -> Result<Coefficients, OutsideTable> {
        let sum = |sum: f64, weight: f64, error: f64| sum + weight.abs() * error;
        self.spread_at(angle, sum, |own| own)
    }

    /// How far they are off where the errors of the rows are independent of each other, and of that size in the quadratic
    /// mean: √Σ(w_j e_j)².
    ///
    /// # Errors
    ///
    /// As [`CoefficientCurves::at`].
    pub fn scatter_at(&self, angle: f64) -> Result<Coefficients, OutsideTable> {
        let sum = |sum: f64, weight: f64, error: f64| sum + (weight * error).powi(2);
        self.spread_at(angle, sum, f64::sqrt)
    }

    fn spread_at(
        &self,
        angle: f64,
        sum: fn(f64, f64, f64) -> f64,
        of_sum: fn(f64) -> f64,
    ) -> Result<Coefficients, OutsideTable> {
        let (piece, place) = self.place(angle).ok_or_else(|| self.outside(angle))?;
        let spread = |curve| {
            let (value, slope) = piece.spread_at(curve, place, sum);
            (of_sum(value), of_sum(slope))
        };
        Ok(coefficients([0, 1, 2].map(spread)))
    }

    /// Whether errors are followed through the curves in bounded memory: through lines, and splines of at most
    /// [`MOST_POINTS`] rows.
    pub fn follows_errors(&self) -> bool {
        let is_short = |piece: &Piece| {
            piece.interpolation == Interpolation::Linear || piece.angles.len() <= MOST_POINTS + 1
        };
        self.pieces.iter().all(is_short)
    }

    /// How many of these angles are corners of straight lines, where the slope jumps.
    pub fn corners(&self, angles: &[f64]) -> usize {
        let is_linear =
            |piece: &Piece| piece.slopes.is_none() && matches!(piece.curves[0], Curve::Lines(_));
        if !self.pieces.iter().all(is_linear) {
            return 0;
        }
        let is_corner = |angle: &&f64| {
            let i = cell(&self.angles, **angle);
            self.angles[i..=i + 1]
                .iter()
                .any(|own| (own - **angle).abs() < 1e-9)
        };
        angles.iter().filter(is_corner).count()
    }
}

/// C_D, C_L and C_M with their slopes per degree.
fn coefficients([drag, lift, moment]: [(f64, f64); 3]) -> Coefficients {
    let per_radian = |slope: f64| slope.to_degrees();
    Coefficients {
        drag: drag.0,
        lift: lift.0,
        moment: moment.0,
        drag_slope: per_radian(drag.1),
        lift_slope: per_radian(lift.1),
        moment_slope: per_radian(moment.1),
    }
}

impl Piece {
    /// Curves through, or near, at least four rows; `None` where they cannot be smoothed.
    fn new(
        rows: &[Row],
        interpolation: Interpolation,
        ends: Ends,
        has_slopes: bool,
    ) -> Option<Self> {
        let angles: Vec<f64> = rows.iter().map(|row| row.angle).collect();
        let smoother = match interpolation {
            Interpolation::Smooth => Some(Smoother::new(&angles, ends)?),
            _ => None,
        };
        let mut smoothness = [0.0; 3];
        let smoothed = |column: &Column| {
            let values: Vec<f64> = rows.iter().map(|row| column.of(row)).collect();
            match &smoother {
                None => (values, 0.0),
                Some(own) => {
                    let found = own.smoothed(&values);
                    (found.values, found.smoothness)
                }
            }
        };
        let found = Column::COEFFICIENTS.each_ref().map(smoothed);
        let slopes = has_slopes.then(|| Column::SLOPES.each_ref().map(|own| smoothed(own).0));
        for (own, (_, found)) in smoothness.iter_mut().zip(&found) {
            *own = *found;
        }
        let mut piece = Piece {
            errors: errors(rows, ends, interpolation),
            slopes: None,
            angles,
            curves: [const { Curve::Lines(Vec::new()) }; 3],
            ends,
            interpolation,
            smoother: smoother.map(|own| (own, smoothness)),
            influences: OnceLock::new(),
        };
        piece.curves = found.map(|(values, _)| piece.through(values));
        piece.slopes = slopes.map(|own| own.map(|values| piece.through(values)));
        Some(piece)
    }

    fn through(&self, values: Vec<f64>) -> Curve {
        match self.interpolation {
            Interpolation::Linear => Curve::Lines(values),
            _ => Curve::Spline(CubicSpline::new(&self.angles, &values, self.ends)),
        }
    }

    /// A column in a cell as Σ bⱼ (3 over j) tʲ (1 − t)³⁻ʲ, with t from 0 to 1 along the cell.
    fn cubic(&self, column: usize, cell: usize) -> [Bounded; 4] {
        let exact = |own: f64| Bounded::exact(own);
        match &self.curves[column] {
            Curve::Lines(values) => {
                let [from, to] = [exact(values[cell]), exact(values[cell + 1])];
                let third = (to - from) / 3.0;
                [from, from + third, to - third, to]
            }
            Curve::Spline(spline) => {
                let third = (exact(self.angles[cell + 1]) - exact(self.angles[cell])) / 3.0;
                let [from, to, rise, fall] = spline.ends(cell).map(exact);
                [from, from + third * rise, to - third * fall, to]
            }
        }
    }

    /// How far a curve and its slope, per degree, may be from what they are at places no farther away than this.
    fn moved_by(&self, column: usize, place: f64, by: f64) -> (f64, f64) {
        let (_, slope) = self.at_curve(&self.curves[column], place);
        let bend = self.bend(&self.curves[column], place, by);
        let value = by * (slope.abs() + bend);
        let given = self.slopes.as_ref().map(|own| &own[column]);
        let given = given.map(|own| {
            let (_, slope) = self.at_curve(own, place);
            (by * (slope.abs() + self.bend(own, place, by))).to_radians()
        });
        (value * MORE, given.unwrap_or(bend) * MORE)
    }

    /// How far the slope of a curve may be from what it is at places no farther away than this.
    fn bend(&self, curve: &Curve, place: f64, by: f64) -> f64 {
        // Where an angle falls on a row by rounding, the cells on both sides count.
        let [first, last] =
            [place - by - WHOLE, place + by + WHOLE].map(|own| cell(&self.angles, own));
        match curve {
            Curve::Spline(spline) => {
                let bends = (first..=last).map(|cell| spline.largest_bend(cell));
                by * bends.fold(0.0, f64::max)
            }
            Curve::Lines(_) => {
                let slope = |cell: usize| {
                    let middle = f64::midpoint(self.angles[cell], self.angles[cell + 1]);
                    self.at_curve(curve, middle).1
                };
                let own = self.at_curve(curve, place).1;
                let slopes = (first..=last).map(|cell| (slope(cell) - own).abs());
                if first == last {
                    0.0
                } else {
                    slopes.fold(0.0, f64::max)
                }
            }
        }
    }

    /// A sum over the rows for value and slope of a curve: of a sum so far, the weight of a row, and its error.
    fn spread_at(&self, column: usize, place: f64, sum: fn(f64, f64, f64) -> f64) -> (f64, f64) {
        let errors = &self.errors[column];
        let add = |(value, slope): (f64, f64), (own, error): ((f64, f64), f64)| {
            (sum(value, own.0, error), sum(slope, own.1, error))
        };
        if let Curve::Lines(_) = self.curves[column] {
            let i = cell(&self.angles, place);
            let width = self.angles[i + 1] - self.angles[i];
            let share = (place - self.angles[i]) / width;
            let weights = [(1.0 - share, -1.0 / width), (share, 1.0 / width)];
            let both = weights.into_iter().zip([errors[i], errors[i + 1]]);
            return both.fold((0.0, 0.0), add);
        }
        let influences = self.influences.get_or_init(|| self.influences());
        let curves = influences.get(column).or(influences.first());
        let rows = curves.into_iter().flatten().zip(errors);
        let rows = rows.map(|(curve, error)| (self.at_curve(curve, place), *error));
        rows.fold((0.0, 0.0), add)
    }

    /// The curves of rows of which one is 1 and the others are 0: for all columns, or for each if what smooths them differs.
    fn influences(&self) -> Vec<Vec<Curve>> {
        let count = self.angles.len();
        // The last row of a whole circle is the first again.
        let free = match self.ends {
            Ends::Periodic => count - 1,
            _ => count,
        };
        let curves = |weight: &dyn Fn(usize, usize) -> f64| -> Vec<Curve> {
            let values = |row: usize| (0..count).map(|own| weight(own % free, row)).collect();
            (0..free).map(|row| self.through(values(row))).collect()
        };
        let Some((smoother, smoothness)) = &self.smoother else {
            return vec![curves(&|own, row| f64::from(u8::from(own == row)))];
        };
        let of_column = |smoothness: &f64| {
            let weights = smoother.weights(*smoothness);
            curves(&|own, row| weights[own][row])
        };
        smoothness.iter().map(of_column).collect()
    }

    fn first(&self) -> f64 {
        self.angles[0]
    }

    fn last(&self) -> f64 {
        self.angles[self.angles.len() - 1]
    }

    /// A curve and its slope per degree.
    fn at(&self, curve: usize, place: f64) -> (f64, f64) {
        let (value, slope) = self.at_curve(&self.curves[curve], place);
        let given = self.slopes.as_ref().map(|own| &own[curve]);
        let given = given.map(|own| self.at_curve(own, place).0.to_radians());
        (value, given.unwrap_or(slope))
    }

    fn at_curve(&self, curve: &Curve, place: f64) -> (f64, f64) {
        match curve {
            Curve::Spline(spline) => spline.at(place),
            Curve::Lines(values) => {
                let i = cell(&self.angles, place);
                let width = self.angles[i + 1] - self.angles[i];
                let slope = (values[i + 1] - values[i]) / width;
                (values[i] + slope * (place - self.angles[i]), slope)
            }
        }
    }
}

/// The errors of C_D, C_L and C_M; a spline takes the last row of a whole circle for the first, with the larger errors of
/// both.
fn errors(rows: &[Row], ends: Ends, interpolation: Interpolation) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|column: usize| {
        let mut errors: Vec<f64> = rows.iter().map(|row| row.errors[column]).collect();
        let is_closed = ends == Ends::Periodic && interpolation != Interpolation::Linear;
        if let ([first, .., last], true) = (errors.as_mut_slice(), is_closed) {
            *first = first.max(*last);
        }
        errors
    })
}

/// The rows of a circle, of which the last one is the first again, from behind a hole to the hole.
fn behind(hole: usize, rows: &[Row]) -> Vec<Row> {
    let once = &rows[..rows.len() - 1];
    let (before, after) = once.split_at((hole + 1) % once.len());
    let turned = before.iter().map(|row| Row {
        angle: row.angle + 360.0,
        ..*row
    });
    after.iter().copied().chain(turned).collect()
}
