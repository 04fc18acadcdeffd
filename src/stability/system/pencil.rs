//! The matrices of a system in doubles with bounds, in units in which their entries are of one size.

use super::MOST_COORDINATES as MOST;
use super::real::Real;

/// A matrix of which the first n rows and columns count.
pub(super) type Square = [[f64; MOST]; MOST];

/// A matrix, and bounds of the errors of its entries.
#[derive(Clone, Debug)]
pub(super) struct Bounded {
    pub centre: Square,
    pub radius: Square,
}

impl Bounded {
    const ZERO: Bounded = Bounded {
        centre: [[0.0; MOST]; MOST],
        radius: [[0.0; MOST]; MOST],
    };
}

/// λ²M + λC + K with scaled rows, columns and λ, by powers of 2, which round nothing.
#[derive(Clone, Debug)]
pub(super) struct Pencil {
    /// n
    pub size: usize,
    /// K, C and M.
    pub powers: [Bounded; 3],
    /// What the rows are multiplied by.
    pub rows: [f64; MOST],
    /// The units of the coordinates.
    pub columns: [f64; MOST],
    /// The unit of λ.
    pub unit: f64,
}

/// So often rows and columns of M are brought to one size in turn.
const ROUNDS: usize = 3;

/// No power of 2 beyond this is a factor, so that products of four of them are doubles.
const LARGEST_POWER: i32 = 200;

impl Pencil {
    /// The matrices with the entries that stand with a power of λ, in a row and a column.
    ///
    /// Rows and columns are scaled so that the largest entries of M are about 1, and λ so that those of K and C are at
    /// most about 1. Complexity: some n² operations.
    pub fn new(size: usize, entry: impl Fn(usize, usize, usize) -> Real) -> Self {
        let mut powers = [Bounded::ZERO, Bounded::ZERO, Bounded::ZERO];
        for (power, row, column) in places(size) {
            let own = entry(power, row, column);
            powers[power].centre[row][column] = own.centre;
            powers[power].radius[row][column] = own.radius;
        }
        let (rows, columns) = scales(&powers[2].centre, size);
        let mut pencil = Pencil {
            size,
            powers,
            rows: rows.map(power_of_two),
            columns: columns.map(power_of_two),
            unit: 1.0,
        };
        pencil.unit = power_of_two(pencil.exponent_of_unit(&rows, &columns));
        pencil.scale();
        pencil
    }

    /// The factor of an entry.
    pub fn factor(&self, power: usize, row: usize, column: usize) -> f64 {
        let units = [1.0 / self.unit / self.unit, 1.0 / self.unit, 1.0];
        self.rows[row] * self.columns[column] * units[power]
    }

    /// The exponent of the frequency that the largest entries of K and C ask for.
    fn exponent_of_unit(&self, rows: &[i32; MOST], columns: &[i32; MOST]) -> i32 {
        let largest = |power: usize| {
            let exponents = places(self.size)
                .filter(|place| place.0 == power)
                .filter_map(|(_, i, j)| {
                    let own = exponent(self.powers[power].centre[i][j])?;
                    Some(own + rows[i] + columns[j])
                });
            exponents.max()
        };
        let frequency = largest(0).map(|own| own.div_euclid(2));
        frequency.max(largest(1)).unwrap_or(0)
    }

    fn scale(&mut self) {
        for (power, row, column) in places(self.size) {
            let factor = self.factor(power, row, column);
            let matrix = &mut self.powers[power];
            let own = Real::new(matrix.centre[row][column], matrix.radius[row][column]);
            let scaled = own.scaled(factor);
            matrix.centre[row][column] = scaled.centre;
            matrix.radius[row][column] = scaled.radius;
        }
    }
}

/// All powers of λ, rows and columns.
fn places(size: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..3).flat_map(move |power| {
        (0..size).flat_map(move |row| (0..size).map(move |column| (power, row, column)))
    })
}

/// The exponents of factors of rows and columns with which the largest entry of each is about 1.
fn scales(mass: &Square, size: usize) -> ([i32; MOST], [i32; MOST]) {
    let (mut rows, mut columns) = ([0; MOST], [0; MOST]);
    for _ in 0..ROUNDS {
        let (before_rows, before_columns) = (rows, columns);
        let scaled =
            |i: usize, j: usize| Some(exponent(mass[i][j])? + before_rows[i] + before_columns[j]);
        for own in 0..size {
            let largest = |entries: &mut dyn Iterator<Item = Option<i32>>| {
                entries.flatten().max().unwrap_or(0)
            };
            rows[own] -= largest(&mut (0..size).map(|other| scaled(own, other))).div_euclid(2);
            columns[own] -= largest(&mut (0..size).map(|other| scaled(other, own))).div_euclid(2);
        }
    }
    (rows, columns)
}

/// The exponent of 2 of a number; `None` for 0 and what is no number.
fn exponent(value: f64) -> Option<i32> {
    let biased = (value.to_bits() >> 52) & 0x7ff;
    (value != 0.0 && biased != 0x7ff).then(|| biased as i32 - 1023)
}

fn power_of_two(exponent: i32) -> f64 {
    let bounded = exponent.clamp(-LARGEST_POWER, LARGEST_POWER);
    f64::from_bits(((bounded + 1023) as u64) << 52)
}
