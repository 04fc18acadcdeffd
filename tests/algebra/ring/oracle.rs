//! The value of an element at a point, by what its symbols stand for: no code of the ring is used.

use std::collections::BTreeMap;

use sextic::algebra::angle::Angle;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::{Integer, Rational};
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::ring::Ring;
use sextic::algebra::symbol::Symbol;

use super::series::Series;

/// Values of the free symbols, all functions of one variable ε.
#[derive(Clone, Debug, Default)]
pub struct Point {
    /// Values, also of angles where they stand outside of a sine.
    pub values: BTreeMap<Symbol, Series>,
    /// The cosines and sines of the angles at ε = 0.
    pub turns: BTreeMap<Symbol, (Rational, Rational)>,
}

/// A point of the circle: the rational parametrisation, with the denominator 1 + t².
pub fn circle_point(t: &Rational) -> (Rational, Rational) {
    let square = t * t;
    let below = Rational::ONE + &square;
    (
        (Rational::ONE - square) / &below,
        Rational::from(2) * t / below,
    )
}

/// cos and sin of the sum of two angles.
pub fn turn(a: &(Rational, Rational), b: &(Rational, Rational)) -> (Rational, Rational) {
    (&a.0 * &b.0 - &a.1 * &b.1, &a.1 * &b.0 + &a.0 * &b.1)
}

impl Point {
    /// The value of an element; nothing where it has none.
    pub fn value(&self, ring: &Ring, element: &Fraction) -> Option<Series> {
        let below = self.polynomial(ring, element.denominator())?.inverse()?;
        Some(self.polynomial(ring, element.numerator())?.times(&below))
    }

    /// The value of a polynomial, term by term.
    pub fn polynomial(&self, ring: &Ring, polynomial: &Polynomial) -> Option<Series> {
        let values = polynomial.symbols().into_iter();
        let values: BTreeMap<Symbol, Series> = values
            .map(|symbol| Some((symbol, self.symbol(ring, symbol)?)))
            .collect::<Option<_>>()?;
        let mut sum = Series::number(0);
        for (monomial, coefficient) in polynomial.terms() {
            let term = monomial.factors().fold(
                Series::number(Rational::from(coefficient.clone())),
                |term, (symbol, exponent)| term.times(&values[&symbol].power(exponent)),
            );
            sum = sum.plus(&term);
        }
        Some(sum)
    }

    /// The value of a symbol.
    pub fn symbol(&self, ring: &Ring, symbol: Symbol) -> Option<Series> {
        if let Some(value) = self.values.get(&symbol) {
            return Some(value.clone());
        }
        match ring.generator(symbol) {
            Generator::ImaginaryUnit => Some(Series::i()),
            Generator::Coordinate { name, order, .. } => {
                let function = (0..).map(Symbol::new).find(|other| {
                    matches!(ring.generator(*other),
                        Generator::Coordinate { name: own, order: 0, .. } if own == name)
                })?;
                let function = self.values.get(&function)?.clone();
                Some((0..*order).fold(function, |value, _| value.derivative()))
            }
            Generator::Cosine { angle } => Some(self.cosine_and_sine(ring, angle)?.0),
            Generator::Sine { angle } => Some(self.cosine_and_sine(ring, angle)?.1),
            Generator::Root { radicand } => self.polynomial(ring, radicand)?.square_root(),
            Generator::Direction { x, y, .. } => {
                let (x, y) = (self.value(ring, x)?, self.value(ring, y)?);
                let below = x.times(&x).plus(&y.times(&y)).inverse()?;
                let across = x.times(&y.derivative()).minus(&y.times(&x.derivative()));
                Some(across.times(&below).integral())
            }
            // f(z) = z³ − 2z², whatever its name.
            Generator::FunctionValue {
                order, argument, ..
            } => {
                let z = self.value(ring, argument)?;
                let scaled =
                    |factor: i32, exponent| z.power(exponent).times(&Series::number(factor));
                Some(match order {
                    0 => scaled(1, 3).minus(&scaled(2, 2)),
                    1 => scaled(3, 2).minus(&scaled(4, 1)),
                    2 => scaled(6, 1).minus(&Series::number(4)),
                    3 => Series::number(6),
                    _ => Series::number(0),
                })
            }
            free => panic!("{free:?} has no value"),
        }
    }

    /// The cosine and sine of a sum of angles, turned one angle after another.
    pub fn cosine_and_sine(&self, ring: &Ring, angle: &Angle) -> Option<(Series, Series)> {
        let mut value = Series::number(0);
        let mut start = (Rational::ONE, Rational::ZERO);
        for (symbol, k) in angle.coefficients() {
            let own = self.symbol(ring, symbol)?;
            value = value.plus(&own.times(&Series::number(Rational::from(k.clone()))));
            let (cosine, sine) = self.turn_of(ring, symbol)?;
            let negative = *k < Integer::ZERO;
            let step = (cosine, if negative { -sine } else { sine });
            let count: i64 = k.try_into().expect("small angles");
            for _ in 0..count.unsigned_abs() {
                start = turn(&start, &step);
            }
        }
        Some(value.turned(&start))
    }

    fn turn_of(&self, ring: &Ring, symbol: Symbol) -> Option<(Rational, Rational)> {
        if let Generator::Direction { x, y, .. } = ring.generator(symbol) {
            let (x, y) = (self.value(ring, x)?, self.value(ring, y)?);
            let length = x
                .times(&x)
                .plus(&y.times(&y))
                .square_root()?
                .start()
                .0
                .clone();
            return Some((&x.start().0 / &length, &y.start().0 / &length));
        }
        self.turns.get(&symbol).cloned()
    }
}
