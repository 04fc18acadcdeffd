//! Modes followed from point to point by their shapes.

use std::array;
use std::sync::LazyLock;

use num_complex::Complex;

use super::coordinate::Coordinate;
use super::eigenvalue::{Eigenvalue, Spectrum};
use super::model::Model;
use super::section::Section;
use super::shape::mode_shape;

/// An eigenvalue and the shape of its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// λ in 1/s, its imaginary part 0 or above.
    pub value: Complex<f64>,
    /// The free ones of x, y and rθ, its largest entry 1.
    pub shape: Vec<Complex<f64>>,
}

impl Mode {
    /// The mode of an eigenvalue that stands alone, or has a place among those that coincide. `None` if the
    /// decomposition behind it does not converge.
    pub fn new(model: &Model, value: Complex<f64>, place: Option<Place>) -> Option<Self> {
        let shape = match place {
            None => mode_shape(model, value, None),
            Some(Place { first, number }) => mode_shape(model, first, Some(number)),
        };
        Some(Mode {
            value,
            shape: shape?,
        })
    }

    /// Its frequency in Hz; 0 for a motion that does not oscillate.
    pub fn frequency(&self) -> f64 {
        self.value.im / std::f64::consts::TAU
    }

    /// The coordinate with the largest part of the motion, rθ counting as a length.
    pub fn mostly(&self, section: &Section) -> Coordinate {
        mostly(section.free(), &self.shape)
    }
}

/// The coordinate with the largest part of a motion of the free ones.
pub(super) fn mostly(free: &[Coordinate], shape: &[Complex<f64>]) -> Coordinate {
    let parts = free.iter().zip(shape);
    let largest = parts.max_by(|one, other| one.1.norm_sqr().total_cmp(&other.1.norm_sqr()));
    largest.map_or(free[0], |(coordinate, _)| *coordinate)
}

/// The place of an eigenvalue among those that coincide with it.
///
/// The shapes of all are sought at one of them, so that they are different ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The first of them.
    pub first: Complex<f64>,
    /// How many of them stand before it.
    pub number: usize,
}

/// One eigenvalue of each pair of conjugates, with its place among those that coincide with it within their
/// errors; `None` for one that stands alone.
pub fn places(spectrum: &Spectrum) -> Vec<(Eigenvalue, Option<Place>)> {
    let pairs: Vec<Eigenvalue> = spectrum.one_of_each_pair().copied().collect();
    let place = |(index, own): (usize, &Eigenvalue)| {
        let coincide =
            |other: &&Eigenvalue| (other.value - own.value).norm() <= other.error + own.error;
        let is_alone = pairs.iter().filter(coincide).count() == 1;
        let before = || pairs[..index].iter().filter(coincide);
        let place = || Place {
            first: before().next().unwrap_or(own).value,
            number: before().count(),
        };
        (*own, (!is_alone).then(place))
    };
    pairs.iter().enumerate().map(place).collect()
}

/// How alike two modes move: |φᴴMψ|²/(φᴴMφ · ψᴴMψ) with the mass matrix M of a model; 1 for the same
/// shape, 0 for shapes that share no kinetic energy.
pub fn overlap(model: &Model, one: &Mode, other: &Mode) -> f64 {
    let energies = product(model, one, one).re * product(model, other, other).re;
    product(model, one, other).norm_sqr() / energies
}

/// φᴴMψ
fn product(model: &Model, one: &Mode, other: &Mode) -> Complex<f64> {
    let pairs = one.shape.iter().zip(&model.mass);
    let rows = pairs.map(|(left, row)| {
        let terms = row.iter().zip(&other.shape);
        let along: Complex<f64> = terms.map(|(mass, right)| right * mass.centre.re).sum();
        left.conj() * along
    });
    rows.sum()
}

/// Which of the modes at the next point continues each of those before: `result[i]` is the place of the one that
/// continues `before[i]`, or beyond the last of them where that ends.
///
/// Of all assignments it is that with the largest sum of overlaps; sums within 1e-6 of each other count as equal, and
/// the smallest change of the eigenvalues decides. What ends or begins, as where a pair of eigenvalues becomes real,
/// adds to neither. `None` beyond 6 modes.
///
/// All assignments of n ≤ 6 modes are tried, n being the larger number: n!.
pub fn follow(model: &Model, before: &[&Mode], next: &[&Mode]) -> Option<&'static [usize]> {
    let energy = |mode: &&Mode| product(model, mode, mode).re;
    let energies: Vec<f64> = next.iter().map(energy).collect();
    let rates = |old: &&Mode| -> Vec<(f64, f64)> {
        let own = energy(old);
        let rate = |(new, energy): (&&Mode, &f64)| {
            let alike = product(model, old, new).norm_sqr() / (own * energy);
            (alike, (old.value - new.value).norm())
        };
        next.iter().zip(&energies).map(rate).collect()
    };
    let rates: Vec<_> = before.iter().map(rates).collect();
    let rate = |assignment: &[usize]| {
        let pairs = rates.iter().zip(assignment);
        let pairs = pairs.filter_map(|(row, &new)| row.get(new));
        pairs.fold((0.0, 0.0), |sum, own| (sum.0 + own.0, sum.1 + own.1))
    };
    let size = before.len().max(next.len());
    ORDERS
        .get(size)?
        .iter()
        .map(|assignment| (rate(assignment), &assignment[..before.len()]))
        .reduce(|best, other| {
            let ((best_alike, best_change), (alike, change)) = (best.0, other.0);
            let is_tie = (alike - best_alike).abs() <= 1e-6;
            let is_better = if is_tie {
                change < best_change
            } else {
                alike > best_alike
            };
            if is_better { other } else { best }
        })
        .map(|(_, assignment)| assignment)
}

/// All orders of 0..n, for each n up to 6.
static ORDERS: LazyLock<[Vec<Vec<usize>>; 7]> = LazyLock::new(|| array::from_fn(orders));

fn orders(n: usize) -> Vec<Vec<usize>> {
    (0..n).fold(vec![Vec::new()], |shorter, last| {
        let longer = |order: &Vec<usize>| {
            let order = order.clone();
            (0..=last).map(move |place| {
                let mut longer = order.clone();
                longer.insert(place, last);
                longer
            })
        };
        shorter.iter().flat_map(longer).collect()
    })
}
