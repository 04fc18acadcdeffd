//! The gcd from its images modulo primes at a grid of points (Brown's algorithm).
//!
//! Put numbers for all symbols but one, `x`, and the gcd of what is left is the image of the gcd `g`,
//! but for a factor. With `γ`, the gcd of both leading coefficients in `x`, the images of
//! `h = (γ/lc g)·g` are known in full, so that `h` follows by interpolation and `g` is what is left of
//! it without its content. A wrong image shows when `g` does not divide.

use std::collections::BTreeMap;

use super::{gcd_of_all, split_content};
use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::degrees::Degrees;
use crate::algebra::modular::Field;
use crate::algebra::monomial::Monomial;
use crate::algebra::number::Integer;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::symbol::Symbol;

/// The most values that a grid may hold.
const MOST_VALUES: u64 = 1 << 20;

/// The most symbols and the largest exponent that fit into a [`Key`].
const MOST_SYMBOLS: usize = 16;
const LARGEST_EXPONENT: u32 = 255;

/// The exponents of a term, a byte each; that of `x` stands highest.
type Key = u128;

/// The gcd of two polynomials without contents in `symbol`, whose degrees are known not to exceed
/// `bounds`; none where the grid would be too large, or the images do not show it.
///
/// Takes as many steps as the grid has points, times the number of terms.
pub(super) fn gcd(
    left: &Polynomial,
    right: &Polynomial,
    symbol: Symbol,
    bounds: &Degrees,
    budget: &Budget,
) -> Result<Option<Polynomial>, Exhausted> {
    let leading = [left, right].map(|side| side.coefficient_in(symbol, side.degree_in(symbol)));
    let scale = gcd_of_all(&leading, budget)?;
    let Some(grid) = Grid::new([left, right], &scale, symbol, bounds) else {
        return Ok(None);
    };
    let mut lifted = Lifted::default();
    for field in Field::all() {
        let Some(values) = grid.images(field, budget)? else {
            continue;
        };
        if values.degree == 0 {
            return Ok(Some(Polynomial::one()));
        }
        lifted.extend(&grid.interpolated(values, field, budget)?, field, budget)?;
        let candidate = grid.polynomial(&lifted);
        let candidate = candidate.primitive_part();
        let candidate = split_content(&candidate, symbol, budget)?.1;
        if !candidate.is_zero()
            && left.divide_exact(&candidate, budget)?.is_some()
            && right.divide_exact(&candidate, budget)?.is_some()
        {
            return Ok(Some(candidate));
        }
    }
    Ok(None)
}

/// The points at which images are taken, and the polynomials that have them.
struct Grid<'a> {
    sides: [&'a Polynomial; 2],
    scale: &'a Polynomial,
    symbol: Symbol,
    axes: Vec<Axis>,
}

/// The values of one symbol.
struct Axis {
    symbol: Symbol,
    /// One more than the degree of what is interpolated.
    count: usize,
}

/// Values at the points of a grid, or coefficients; those of one point side by side.
struct Values {
    degree: usize,
    entries: Vec<u64>,
}

impl<'a> Grid<'a> {
    fn new(
        sides: [&'a Polynomial; 2],
        scale: &'a Polynomial,
        symbol: Symbol,
        bounds: &Degrees,
    ) -> Option<Self> {
        let degrees = sides.map(Degrees::of);
        let largest = degrees
            .iter()
            .flat_map(|degrees| degrees.iter().map(|(_, degree)| degree))
            .max();
        let extra = Degrees::of(scale);
        let others = bounds.iter().filter(|(other, _)| *other != symbol);
        let axes: Vec<Axis> = others
            .map(|(symbol, bound)| Axis {
                symbol,
                count: (bound + extra.get(symbol)) as usize + 1,
            })
            .collect();
        let sizes = axes.iter().map(|axis| axis.count as u64);
        let size = sizes.fold(u64::from(bounds.get(symbol)) + 1, u64::saturating_mul);
        let fits = axes.len() < MOST_SYMBOLS && largest? <= LARGEST_EXPONENT && size <= MOST_VALUES;
        fits.then_some(Grid {
            sides,
            scale,
            symbol,
            axes,
        })
    }

    /// The terms of a polynomial by the exponents, modulo a prime, in increasing order.
    fn image(&self, polynomial: &Polynomial, field: Field) -> Vec<(Key, u64)> {
        let key = |monomial: &Monomial| {
            let axes = self.axes.iter().map(|axis| axis.symbol);
            std::iter::once(self.symbol)
                .chain(axes)
                .fold(0, |key, symbol| {
                    key << 8 | Key::from(monomial.exponent(symbol))
                })
        };
        let terms = polynomial.terms().iter();
        let mut image: Vec<(Key, u64)> = terms
            .map(|(monomial, coefficient)| (key(monomial), field.residue(coefficient)))
            .collect();
        image.sort_unstable_by_key(|(key, _)| *key);
        image
    }

    /// The values of h at all points; none where a point is unlucky.
    fn images(&self, field: Field, budget: &Budget) -> Result<Option<Values>, Exhausted> {
        let [left, right] = self.sides.map(|side| self.image(side, field));
        let scale = self.image(self.scale, field);
        let mut values = Values {
            degree: usize::MAX,
            entries: Vec::new(),
        };
        let lucky = self.fill([left, right, scale], &self.axes, field, &mut values, budget)?;
        Ok(lucky.then_some(values))
    }

    /// Takes the images at all values of the last axis, and within each at those of the others.
    fn fill(
        &self,
        [left, right, scale]: [Vec<(Key, u64)>; 3],
        axes: &[Axis],
        field: Field,
        values: &mut Values,
        budget: &Budget,
    ) -> Result<bool, Exhausted> {
        let Some((axis, others)) = axes.split_last() else {
            budget.spend((left.len() * right.len()) as u64)?;
            return Ok(values.push(&left, &right, &scale, field));
        };
        for place in 0..axis.count {
            budget.spend((left.len() + right.len() + scale.len()) as u64)?;
            let node = field.node(axis.symbol, place);
            let put = |image: &[(Key, u64)]| put(image, node, field);
            let images = [put(&left), put(&right), put(&scale)];
            if !self.fill(images, others, field, values, budget)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The coefficients of h from its values, along one axis after the other.
    fn interpolated(
        &self,
        values: Values,
        field: Field,
        budget: &Budget,
    ) -> Result<Values, Exhausted> {
        let Values {
            degree,
            mut entries,
        } = values;
        let mut stride = degree + 1;
        // The first axis runs fastest.
        for axis in &self.axes {
            budget.spend((entries.len() * axis.count) as u64)?;
            let nodes: Vec<u64> = (0..axis.count)
                .map(|place| field.node(axis.symbol, place))
                .collect();
            let inverses: Vec<u64> = (0..axis.count as u64).map(|k| field.inverse(k)).collect();
            for block in entries.chunks_mut(stride * axis.count) {
                for start in 0..stride {
                    interpolate(block, start, stride, &nodes, &inverses, field);
                }
            }
            stride *= axis.count;
        }
        Ok(Values { degree, entries })
    }

    /// h from its coefficients.
    fn polynomial(&self, lifted: &Lifted) -> Polynomial {
        let terms = lifted.coefficients.iter().map(|(place, coefficient)| {
            let mut rest = *place;
            let mut exponents = BTreeMap::new();
            exponents.insert(self.symbol, rest % (lifted.degree + 1));
            rest /= lifted.degree + 1;
            for axis in &self.axes {
                exponents.insert(axis.symbol, rest % axis.count);
                rest /= axis.count;
            }
            let mut monomial = Monomial::one();
            for (symbol, exponent) in exponents {
                monomial.push(symbol, exponent as u16);
            }
            (monomial, coefficient.clone())
        });
        Polynomial::from_terms(terms)
    }
}

impl Values {
    /// Adds the image of h at a point: the monic gcd times the scale; false if the point is unlucky.
    fn push(
        &mut self,
        left: &[(Key, u64)],
        right: &[(Key, u64)],
        scale: &[(Key, u64)],
        field: Field,
    ) -> bool {
        let Some((_, scale)) = scale.first() else {
            return false;
        };
        let mut gcd = field.gcd(dense(left), dense(right));
        if self.degree == usize::MAX && !gcd.is_empty() {
            self.degree = gcd.len() - 1;
        }
        let Some(leading) = gcd.last().filter(|_| gcd.len() == self.degree + 1) else {
            return false;
        };
        let factor = field.times(*scale, field.inverse(*leading));
        gcd.iter_mut()
            .for_each(|value| *value = field.times(*value, factor));
        self.entries.append(&mut gcd);
        true
    }
}

/// The coefficients of a polynomial in `x` alone, from the lowest.
fn dense(image: &[(Key, u64)]) -> Vec<u64> {
    let degree = image.last().map_or(0, |(key, _)| *key as usize);
    let mut coefficients = vec![0; degree + 1];
    for (key, value) in image {
        coefficients[*key as usize] = *value;
    }
    coefficients
}

/// An image with a number for the symbol whose exponent stands lowest.
fn put(image: &[(Key, u64)], node: u64, field: Field) -> Vec<(Key, u64)> {
    let mut result: Vec<(Key, u64)> = Vec::with_capacity(image.len());
    let (mut reached, mut power) = (0, 1);
    for (key, value) in image {
        let exponent = (key & 255) as u64;
        if exponent < reached {
            (reached, power) = (0, 1);
        }
        power = field.times(power, field.power(node, exponent - reached));
        reached = exponent;
        let (key, value) = (key >> 8, field.times(*value, power));
        match result.last_mut() {
            Some((last, sum)) if *last == key => *sum = field.sum(*sum, value),
            _ => result.push((key, value)),
        }
    }
    result.retain(|(_, value)| *value != 0);
    result
}

/// Newton's interpolation at nodes that are one apart, of every `stride`-th entry.
fn interpolate(
    entries: &mut [u64],
    start: usize,
    stride: usize,
    nodes: &[u64],
    inverses: &[u64],
    field: Field,
) {
    let at = |place: usize| start + place * stride;
    let count = nodes.len();
    for (order, inverse) in inverses.iter().enumerate().take(count).skip(1) {
        for place in (order..count).rev() {
            let difference = field.difference(entries[at(place)], entries[at(place - 1)]);
            entries[at(place)] = field.times(difference, *inverse);
        }
    }
    for first in (0..count.saturating_sub(1)).rev() {
        for place in first..count - 1 {
            let lowered = field.times(entries[at(place + 1)], nodes[first]);
            entries[at(place)] = field.difference(entries[at(place)], lowered);
        }
    }
}

/// Whole numbers that are known modulo some primes, the nearest ones to 0, by place.
#[derive(Default)]
struct Lifted {
    degree: usize,
    modulus: Integer,
    coefficients: BTreeMap<usize, Integer>,
}

impl Lifted {
    /// Takes over what is known modulo one more prime.
    fn extend(&mut self, values: &Values, field: Field, budget: &Budget) -> Result<(), Exhausted> {
        budget.spend(values.entries.len() as u64)?;
        if self.modulus.is_zero() || values.degree < self.degree {
            *self = Lifted {
                degree: values.degree,
                modulus: Integer::ONE,
                coefficients: BTreeMap::new(),
            };
        } else if values.degree > self.degree {
            return Ok(());
        }
        let prime = Integer::from(field.prime());
        let inverse = field.inverse(field.residue(&self.modulus));
        let product = &self.modulus * &prime;
        let half = &product / Integer::from(2);
        for (place, value) in values.entries.iter().enumerate() {
            let known = self.coefficients.get(&place).cloned().unwrap_or_default();
            let step = field.times(field.difference(*value, field.residue(&known)), inverse);
            let mut sum = known + &self.modulus * Integer::from(step);
            if sum > half {
                sum -= &product;
            }
            match sum.is_zero() {
                true => drop(self.coefficients.remove(&place)),
                false => drop(self.coefficients.insert(place, sum)),
            }
        }
        self.modulus = product;
        Ok(())
    }
}
