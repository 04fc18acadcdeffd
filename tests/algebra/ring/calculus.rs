//! Differentials, substitutions and expansions, against series in ε.

use std::collections::BTreeMap;

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::differential::Differential;
use sextic::algebra::error::AlgebraError;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::number::{Integer, Rational};
use sextic::algebra::substitution::Substitution;
use sextic::algebra::symbol::Symbol;

use super::field::{Done, element, same};
use super::oracle::{Point, circle_point, turn};
use super::series::{Complex, LENGTH, Series};
use super::terms::{ANGLES, Term, World, place, term, world};

/// A differential of each kind: d/dt, ∂/∂q, and one with two images.
fn differential(kind: usize, world: &World) -> Differential {
    match kind {
        0 => Differential::Time,
        kind @ 1..=7 => Differential::partial(world.free[kind - 1], &world.ring),
        _ => {
            let [a, b, u, ..] = world.free.map(|symbol| world.ring.element(symbol));
            let image = world.ring.product(&a, &b).unwrap();
            Differential::Images(BTreeMap::from([(world.free[0], u), (world.free[4], image)]))
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn differentials_are_derivations(a in term(4), b in term(4), kind in 0..=8_usize, mut world in world()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        let d = differential(kind, &world);
        let ring = &mut world.ring;
        let (da, db) = (ring.differentiate(&a, &d).done()?, ring.differentiate(&b, &d).done()?);
        let sum = ring.sum(&a, &b).done()?;
        let changed = ring.differentiate(&sum, &d).done()?;
        prop_assert!(same(ring, &changed, &ring.sum(&da, &db).done()?)?);
        let product = ring.product(&a, &b).done()?;
        let changed = ring.differentiate(&product, &d).done()?;
        let leibniz = ring.sum(&ring.product(&da, &b).done()?, &ring.product(&a, &db).done()?).done()?;
        prop_assert!(same(ring, &changed, &leibniz)?);
        if let Ok(quotient) = ring.quotient(&a, &b) {
            // d(a/b)·b² = da·b − a·db
            let changed = ring.differentiate(&quotient, &d).done()?;
            let square = ring.product(&b, &b).done()?;
            let across = ring.difference(&ring.product(&da, &b).done()?, &ring.product(&a, &db).done()?).done()?;
            prop_assert!(same(ring, &ring.product(&changed, &square).done()?, &across)?);
        }
    }

    #[test]
    fn time_derivatives_are_those_of_functions_of_time(term in term(6), mut world in world(), place in place()) {
        let element = element(&term, &mut world)?;
        let change = world.ring.differentiate(&element, &Differential::Time).done()?;
        let again = world.ring.differentiate(&change, &Differential::Time).done()?;
        // Only the coordinates change.
        let mut point = place.point(&world);
        for (index, symbol) in world.free.iter().enumerate() {
            if index != 3 && index != 6 {
                let start = point.values[symbol].start().clone();
                point.values.insert(*symbol, Series::new([start]));
            }
        }
        let value = term.value(&world, &point);
        prop_assume!(value.is_some());
        let value = value.done()?;
        if let Some(change) = point.value(&world.ring, &change) {
            prop_assert_eq!(&change.0[..LENGTH - 1], &value.derivative().0[..LENGTH - 1]);
        }
        if let Some(again) = point.value(&world.ring, &again) {
            prop_assert_eq!(&again.0[..LENGTH - 2], &value.derivative().derivative().0[..LENGTH - 2]);
        }
    }

    #[test]
    fn partial_derivatives_are_slopes(term in term(6), kind in 1..=8_usize, mut world in world(), place in place()) {
        let element = element(&term, &mut world)?;
        let differential = differential(kind, &world);
        let change = world.ring.differentiate(&element, &differential).done()?;
        // Every free symbol moves by ε times its image.
        let mut point = place.point(&world);
        let starts: Vec<Complex> = world.free.iter().map(|s| point.values[s].start().clone()).collect();
        let Differential::Images(images) = &differential else { unreachable!() };
        for (symbol, start) in world.free.iter().zip(&starts) {
            point.values.insert(*symbol, Series::new([start.clone()]));
        }
        let still = point.clone();
        for (symbol, start) in world.free.iter().zip(&starts) {
            let slope = images.get(symbol).map(|image| still.value(&world.ring, image).unwrap());
            let slope = slope.map_or(Complex::real(Rational::ZERO), |slope| slope.start().clone());
            point.values.insert(*symbol, Series::new([start.clone(), slope]));
        }
        let value = term.value(&world, &point);
        prop_assume!(value.is_some());
        if let Some(change) = still.value(&world.ring, &change) {
            prop_assert_eq!(change.start(), &value.done()?.0[1]);
        }
    }

    #[test]
    fn substitutions_are_values_elsewhere(
        term in term(6), shape in 0..6_usize, k in -2..=2_i32, mut world in world(), place in place(),
    ) {
        let element = element(&term, &mut world)?;
        let (substitution, moved) = moved(shape, k, &world, &place.point(&world));
        let image = match world.ring.substitute(&element, &substitution) {
            Err(AlgebraError::DivisionByZero) => {
                let value = term.value(&world, &moved);
                prop_assert!(value.is_none(), "{:?}", value);
                return Err(TestCaseError::reject("has no value there"));
            }
            image => image.done()?,
        };
        let value = term.value(&world, &moved);
        prop_assume!(value.is_some());
        let value = value.done()?;
        if let Some(image) = place.point(&world).value(&world.ring, &image) {
            prop_assert_eq!(image.start(), value.start());
        }
    }

    #[test]
    fn substitutions_are_homomorphisms(a in term(4), b in term(4), shape in 0..6_usize, k in -2..=2_i32, mut world in world(), place in place()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        let (substitution, _) = moved(shape, k, &world, &place.point(&world));
        let ring = &mut world.ring;
        let (Ok(image_a), Ok(image_b)) = (ring.substitute(&a, &substitution), ring.substitute(&b, &substitution)) else {
            return Err(TestCaseError::reject("has no value there"));
        };
        let (sum, product) = (ring.sum(&a, &b).done()?, ring.product(&a, &b).done()?);
        if let Ok(image) = ring.substitute(&sum, &substitution) {
            prop_assert!(same(ring, &image, &ring.sum(&image_a, &image_b).done()?)?);
        }
        if let Ok(image) = ring.substitute(&product, &substitution) {
            prop_assert!(same(ring, &image, &ring.product(&image_a, &image_b).done()?)?);
        }
    }

    #[test]
    fn differentiating_commutes_with_giving_another_constant_a_value(term in term(5), mut world in world()) {
        // ∂/∂u does not see x, so that x = a·b may be set before or after.
        let element = element(&term, &mut world)?;
        let [a, b, u, x, ..] = world.free;
        let d = Differential::partial(u, &world.ring);
        let ring = &mut world.ring;
        let image = ring.product(&ring.element(a), &ring.element(b)).done()?;
        let substitution = Substitution::from([(x, image)]);
        let change = ring.differentiate(&element, &d).done()?;
        let (Ok(after), Ok(set)) = (ring.substitute(&change, &substitution), ring.substitute(&element, &substitution)) else {
            return Err(TestCaseError::reject("has no value there"));
        };
        let before = ring.differentiate(&set, &d).done()?;
        prop_assert!(same(ring, &before, &after)?);
    }

    #[test]
    fn expansions_are_series(term in term(5), places in prop::sample::subsequence(vec![2, 3, 4, 6], 1..=2), mut world in world(), place in place()) {
        let element = element(&term, &mut world)?;
        let small: Vec<Symbol> = places.iter().map(|place| world.free[*place]).collect();
        let parts = world.ring.expand(&element, &small, 3).done()?;
        // The small quantities are multiples of ε.
        let mut still = place.point(&world);
        for symbol in world.free {
            let start = still.values[&symbol].start().clone();
            still.values.insert(symbol, Series::new([start]));
        }
        let mut moving = still.clone();
        for symbol in &small {
            let slope = still.values[symbol].start().clone();
            moving.values.insert(*symbol, Series::new([Complex::real(Rational::ZERO), slope]));
            moving.turns.entry(*symbol).and_modify(|turn| *turn = circle_point(&Rational::ZERO));
        }
        let value = term.value(&world, &moving);
        prop_assume!(value.is_some());
        let value = value.done()?;
        for (part, coefficient) in parts.iter().zip(&value.0) {
            if let Some(part) = still.value(&world.ring, part) {
                prop_assert_eq!(part.start(), coefficient);
            }
        }
        let whole = world.ring.truncate(&element, &small, 2).done()?;
        let expected = parts[..3].iter().try_fold(world.ring.zero(), |sum, part| world.ring.sum(&sum, part)).done()?;
        prop_assert!(same(&world.ring, &whole, &expected)?);
        let again = world.ring.truncate(&whole, &small, 2).done()?;
        prop_assert!(same(&world.ring, &again, &whole)?);
        let leading = world.ring.leading_part(&element, &small, 0, 3).done()?;
        let first = (0..).zip(parts).find(|(_, part)| !part.is_zero());
        prop_assert_eq!(leading, first);
    }
}

/// A substitution, and the point it takes a point to.
fn moved(shape: usize, k: i32, world: &World, point: &Point) -> (Substitution, Point) {
    let [a, b, u, x, ..] = world.free;
    let ring = &world.ring;
    let scale = |factor: i32| {
        let factor = Fraction::from(Rational::from(factor));
        ring.product(&factor, &ring.element(u)).unwrap()
    };
    let images: Vec<(Symbol, Fraction)> = match shape {
        // w becomes 5 u.
        0 => vec![(a, scale(3)), (b, scale(-4))],
        // All at once: they change places.
        1 => vec![(a, ring.element(b)), (b, ring.element(a))],
        2 => vec![(x, ring.product(&ring.element(a), &ring.element(b)).unwrap())],
        3 => vec![
            (u, Fraction::from(Rational::from(k.abs() + 1))),
            (x, ring.zero()),
        ],
        _ => {
            // α becomes k α + β, or 0, and β the other way round.
            let own = world.angle(&if shape == 4 { [k, 1, 0, 0] } else { [0; 4] });
            let other = world.angle(&[1, 0, k, 0]);
            vec![
                (world.free[ANGLES[0]], ring.angle_element(&own)),
                (world.free[ANGLES[1]], ring.angle_element(&other)),
            ]
        }
    };
    let mut moved = point.clone();
    for (symbol, image) in &images {
        let value = point.value(&world.ring, image).unwrap();
        moved.values.insert(*symbol, value);
        if point.turns.contains_key(symbol) {
            let mut whole = circle_point(&Rational::ZERO);
            for (own, k) in world.ring.angle(image).unwrap().coefficients() {
                let (cosine, sine) = point.turns[&own].clone();
                let negative = *k < Integer::ZERO;
                let step = (cosine, if negative { -sine } else { sine });
                let count = i64::try_from(k).unwrap().unsigned_abs();
                whole = (0..count).fold(whole, |whole, _| turn(&whole, &step));
            }
            moved.turns.insert(*symbol, whole);
        }
    }
    (images.into_iter().collect(), moved)
}

/// 2 s ds = d(s²) for every symbol s whose square a relation gives.
#[test]
fn relations_are_constant() {
    for (k, l) in [(1, 0), (1, 1), (-1, 1), (0, 1)] {
        let mut world = World::new((k, l));
        let theta = Term::Sine([0, 0, 1, 0]).element(&mut world).unwrap();
        let sines = world.ring.basis().to_vec();
        let mut changing = 0;
        for kind in 0..=8 {
            let d = differential(kind, &world);
            let ring = &mut world.ring;
            let sines = sines.iter().map(|basis| ring.element(basis.sine));
            let mut elements: Vec<Fraction> = sines.collect();
            elements.extend([ring.element(world.i), world.root.clone()]);
            assert!(elements.contains(&theta));
            for element in elements {
                let symbol = ring.as_symbol(&element).unwrap();
                assert!(ring.generator(symbol).is_quadratic());
                let square = ring.product(&element, &element).unwrap();
                let change = ring.differentiate(&element, &d).unwrap();
                let half = ring.product(&element, &change).unwrap();
                let expected = ring.differentiate(&square, &d).unwrap();
                assert_eq!(ring.sum(&half, &half), Ok(expected.clone()), "{kind}");
                changing += usize::from(!expected.is_zero());
            }
        }
        // w by a and b, the sines by their angles, and three by what moves a and α.
        assert!(changing >= 7, "{changing}");
    }
}

#[test]
fn values_of_functions_can_be_replaced() {
    let mut world = World::new((1, 0));
    let value = Term::Function(0).element(&mut world).unwrap();
    let slope = Term::Function(1).element(&mut world).unwrap();
    let ring = &mut world.ring;
    let (f, g) = (
        ring.as_symbol(&value).unwrap(),
        ring.as_symbol(&slope).unwrap(),
    );
    let product = ring.product(&value, &slope).unwrap();
    let substitution = Substitution::from([(f, slope.clone()), (g, ring.one())]);
    assert_eq!(ring.substitute(&product, &substitution), Ok(slope));
}

#[test]
fn directions_follow_their_vectors() {
    let mut world = World::new((1, 0));
    let [a, b, u, ..] = world.free;
    let direction = world.direction.clone();
    let ring = &mut world.ring;
    let (x, y) = (ring.element(b), ring.element(a));
    let expected = ring.direction(&x, &y).unwrap();
    assert_ne!(expected, direction);
    let swap = Substitution::from([(a, x), (b, y)]);
    assert_eq!(ring.substitute(&direction, &swap), Ok(expected));
    let along = Substitution::from([(a, ring.element(u)), (b, ring.zero())]);
    assert_eq!(ring.substitute(&direction, &along), Ok(ring.zero()));
}

#[test]
fn what_has_no_value_is_refused() {
    let mut world = World::new((1, 0));
    let [a, _, u, _, alpha, ..] = world.free;
    let ring = &mut world.ring;
    let inverse = ring.quotient(&ring.one(), &ring.element(u)).unwrap();
    let at_zero = Substitution::from([(u, ring.zero())]);
    assert_eq!(
        ring.substitute(&inverse, &at_zero),
        Err(AlgebraError::DivisionByZero)
    );
    assert_eq!(
        ring.expand(&inverse, &[u], 1),
        Err(AlgebraError::DivisionByZero)
    );
    let sine = Term::Sine([1, 0, 0, 0]).element(&mut world).unwrap();
    let ring = &mut world.ring;
    let no_angle = Substitution::from([(alpha, ring.element(a))]);
    assert_eq!(
        ring.substitute(&sine, &no_angle),
        Err(AlgebraError::NotAnAngle)
    );
}
