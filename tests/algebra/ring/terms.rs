//! Arbitrary terms, which become elements of a ring and, on their own, values at a point.

use proptest::prelude::*;
use sextic::algebra::angle::Angle;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::budget::Budget;
use sextic::algebra::error::AlgebraError;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::{Integer, Rational};
use sextic::algebra::ring::Ring;
use sextic::algebra::sign::Signs;
use sextic::algebra::symbol::Symbol;

use super::oracle::{Point, circle_point};
use super::series::{LENGTH, Series};

/// A ring with some of everything: the constants a, b and u > 0, the angles α and β, the coordinates
/// x and θ, i, w = √(a² + b²) and the direction γ of (a, b).
pub struct World {
    pub ring: Ring,
    /// a, b, u, x, α, β, θ
    pub free: [Symbol; 7],
    pub root: Fraction,
    pub direction: Fraction,
    pub i: Symbol,
}

/// The places of α, β, θ among the free symbols.
pub const ANGLES: [usize; 3] = [4, 5, 6];

impl World {
    /// The sines of α·k + β·l come first, where (k, l) is not 0, and those of α or β after them.
    pub fn new((k, l): (i32, i32)) -> Self {
        let mut ring = Ring::new(Budget::new(300_000));
        let named = |name: &str| name.to_owned();
        let coordinate = |name, angular| Generator::Coordinate {
            name,
            order: 0,
            angular,
        };
        let free = [
            Generator::Constant { name: named("a") },
            Generator::Constant { name: named("b") },
            Generator::Constant { name: named("u") },
            coordinate(named("x"), false),
            Generator::Angle { name: named("α") },
            Generator::Angle { name: named("β") },
            coordinate(named("θ"), true),
        ]
        .map(|generator| ring.symbol(generator).unwrap());
        ring.assumptions_mut()
            .assume_symbol(free[2], Signs::POSITIVE);
        let (a, b) = (ring.element(free[0]), ring.element(free[1]));
        let squares = (ring.product(&a, &a).unwrap(), ring.product(&b, &b).unwrap());
        let root = ring
            .square_root(&ring.sum(&squares.0, &squares.1).unwrap())
            .unwrap();
        let direction = ring.direction(&a, &b).unwrap();
        let i = ring.symbol(Generator::ImaginaryUnit).unwrap();
        let second = if k == 0 {
            [(1, 0), (0, 1)]
        } else {
            [(0, 1), (1, 0)]
        };
        for (k, l) in [(k, l)].into_iter().chain(second) {
            let angle = Angle::new([(free[4], Integer::from(k)), (free[5], Integer::from(l))]);
            ring.cosine_and_sine(&angle).unwrap();
        }
        World {
            ring,
            free,
            root,
            direction,
            i,
        }
    }

    /// The angle k₀ α + k₁ β + k₂ θ + k₃ γ.
    pub fn angle(&self, k: &[i32; 4]) -> Angle {
        let direction = self.ring.as_symbol(&self.direction).unwrap();
        let symbols = ANGLES
            .map(|place| self.free[place])
            .into_iter()
            .chain([direction]);
        Angle::new(symbols.zip(k.map(Integer::from)))
    }
}

/// Worlds that differ in what their sines are sines of.
pub fn world() -> impl Strategy<Value = World> {
    (-1..=1, -1..=1).prop_map(World::new)
}

/// A term to be computed.
#[derive(Clone, Debug)]
pub enum Term {
    Number(i32),
    Free(usize),
    I,
    Root,
    Direction,
    Cosine([i32; 4]),
    Sine([i32; 4]),
    /// f⁽ᵏ⁾(a·u + x), 0 ≤ k ≤ 1
    Function(u32),
    Sum(Box<Term>, Box<Term>),
    Difference(Box<Term>, Box<Term>),
    Product(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, i32),
}

impl Term {
    /// The element of the ring.
    pub fn element(&self, world: &mut World) -> Result<Fraction, AlgebraError> {
        let ring = &mut world.ring;
        match self {
            Term::Number(value) => Ok(Fraction::from(Rational::from(*value))),
            Term::Free(place) => Ok(ring.element(world.free[*place])),
            Term::I => Ok(ring.element(world.i)),
            Term::Root => Ok(world.root.clone()),
            Term::Direction => Ok(world.direction.clone()),
            Term::Cosine(k) => {
                let angle = world.angle(k);
                Ok(world.ring.cosine_and_sine(&angle)?.0)
            }
            Term::Sine(k) => {
                let angle = world.angle(k);
                Ok(world.ring.cosine_and_sine(&angle)?.1)
            }
            Term::Function(order) => {
                let [a, _, u, x, ..] = world.free.map(|symbol| ring.element(symbol));
                let argument = ring.sum(&ring.product(&a, &u)?, &x)?;
                ring.function_value("f", *order, &argument)
            }
            Term::Sum(a, b) => {
                let (a, b) = (a.element(world)?, b.element(world)?);
                world.ring.sum(&a, &b)
            }
            Term::Difference(a, b) => {
                let (a, b) = (a.element(world)?, b.element(world)?);
                world.ring.difference(&a, &b)
            }
            Term::Product(a, b) => {
                let (a, b) = (a.element(world)?, b.element(world)?);
                world.ring.product(&a, &b)
            }
            Term::Quotient(a, b) => {
                let (a, b) = (a.element(world)?, b.element(world)?);
                world.ring.quotient(&a, &b)
            }
            Term::Power(a, exponent) => {
                let a = a.element(world)?;
                world.ring.power(&a, i64::from(*exponent))
            }
        }
    }

    /// The value at a point, computed from the term and not from the element.
    pub fn value(&self, world: &World, point: &Point) -> Option<Series> {
        let free = |place: usize| point.values[&world.free[place]].clone();
        let both = |a: &Term, b: &Term| Some((a.value(world, point)?, b.value(world, point)?));
        match self {
            Term::Number(value) => Some(Series::number(*value)),
            Term::Free(place) => Some(free(*place)),
            Term::I => Some(Series::i()),
            Term::Root => free(0).power(2).plus(&free(1).power(2)).square_root(),
            Term::Direction => point.value(&world.ring, &world.direction),
            Term::Cosine(k) => Some(point.cosine_and_sine(&world.ring, &world.angle(k))?.0),
            Term::Sine(k) => Some(point.cosine_and_sine(&world.ring, &world.angle(k))?.1),
            Term::Function(order) => {
                let z = free(0).times(&free(2)).plus(&free(3));
                let scaled = |factor, exponent| z.power(exponent).times(&Series::number(factor));
                Some(match order {
                    0 => scaled(1, 3).minus(&scaled(2, 2)),
                    _ => scaled(3, 2).minus(&scaled(4, 1)),
                })
            }
            Term::Sum(a, b) => both(a, b).map(|(a, b)| a.plus(&b)),
            Term::Difference(a, b) => both(a, b).map(|(a, b)| a.minus(&b)),
            Term::Product(a, b) => both(a, b).map(|(a, b)| a.times(&b)),
            Term::Quotient(a, b) => Some(
                a.value(world, point)?
                    .times(&b.value(world, point)?.inverse()?),
            ),
            Term::Power(a, exponent) => {
                let power = a.value(world, point)?.power(exponent.unsigned_abs());
                if *exponent < 0 {
                    power.inverse()
                } else {
                    Some(power)
                }
            }
        }
    }
}

fn leaf() -> impl Strategy<Value = Term> {
    let angle = prop_oneof![
        4 => (-2..=2_i32, -1..=1_i32).prop_map(|(k, l)| [k, l, 0, 0]),
        1 => (-1..=1_i32, -1..=1_i32).prop_map(|(k, m)| [k, 0, m, 0]),
        1 => (-1..=1_i32, -1..=1_i32).prop_map(|(k, n)| [k, 0, 0, n]),
    ];
    prop_oneof![
        2 => (-3..=3_i32).prop_map(Term::Number),
        4 => (0..7_usize).prop_map(Term::Free),
        1 => Just(Term::I),
        2 => Just(Term::Root),
        1 => Just(Term::Direction),
        2 => angle.clone().prop_map(Term::Cosine),
        3 => angle.prop_map(Term::Sine),
        1 => (0..=1_u32).prop_map(Term::Function),
    ]
}

/// Terms of about `size` leaves.
pub fn term(size: u32) -> impl Strategy<Value = Term> {
    leaf().prop_recursive(3, size, 2, |inner| {
        let pair = (
            inner.clone().prop_map(Box::new),
            inner.clone().prop_map(Box::new),
        );
        prop_oneof![
            2 => pair.clone().prop_map(|(a, b)| Term::Sum(a, b)),
            2 => pair.clone().prop_map(|(a, b)| Term::Difference(a, b)),
            3 => pair.clone().prop_map(|(a, b)| Term::Product(a, b)),
            1 => pair.prop_map(|(a, b)| Term::Quotient(a, b)),
            1 => (inner.prop_map(Box::new), -1..=2_i32).prop_map(|(a, n)| Term::Power(a, n)),
        ]
    })
}

fn rational() -> impl Strategy<Value = Rational> {
    (-6..=6_i32, 1..=3_u32).prop_map(|(n, d)| Rational::from(n) / Rational::from(d))
}

/// What a point is made of, before the symbols are known.
#[derive(Clone, Debug)]
pub struct Place {
    series: Vec<Vec<Rational>>,
    turns: Vec<Rational>,
    radius: Rational,
}

/// Arbitrary places at which w is rational.
pub fn place() -> impl Strategy<Value = Place> {
    let series = prop::collection::vec(prop::collection::vec(rational(), LENGTH), 7);
    (series, prop::collection::vec(rational(), 4), 1..=4_u32).prop_map(|(series, turns, radius)| {
        Place {
            series,
            turns,
            radius: Rational::from(radius),
        }
    })
}

impl Place {
    /// The point of a world.
    pub fn point(&self, world: &World) -> Point {
        let mut point = Point::default();
        let (cosine, sine) = circle_point(&self.turns[3]);
        let mut series = self.series.clone();
        series[0][0] = &self.radius * cosine;
        series[1][0] = &self.radius * sine;
        series[2][0] = self.radius.clone();
        for (symbol, coefficients) in world.free.iter().zip(&series) {
            point
                .values
                .insert(*symbol, Series::rationals(coefficients));
        }
        for (place, t) in ANGLES.iter().zip(&self.turns) {
            point.turns.insert(world.free[*place], circle_point(t));
        }
        point
    }
}
