//! Sines, cosines and the basis of angles.

use proptest::prelude::*;
use sextic::algebra::angle::{Angle, Decomposition, decompose};
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::budget::Budget;
use sextic::algebra::error::AlgebraError;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::Integer;
use sextic::algebra::ring::Ring;
use sextic::algebra::symbol::Symbol;

use super::terms::{World, place, world};

fn coefficients() -> impl Strategy<Value = [i32; 4]> {
    (-2..=2_i32, -1..=1_i32, -1..=1_i32, -1..=1_i32).prop_map(|(k, l, m, n)| [k, l, m, n])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn addition_theorems(k in coefficients(), l in coefficients(), mut world in world(), place in place()) {
        let sum = [k[0] + l[0], k[1] + l[1], k[2] + l[2], k[3] + l[3]];
        let [a, b, both] = [k, l, sum].map(|k| {
            let angle = world.angle(&k);
            (world.ring.cosine_and_sine(&angle).unwrap(), angle)
        });
        let ring = &world.ring;
        let times = |a, b| ring.product(a, b).unwrap();
        let ((cos_a, sin_a), (cos_b, sin_b)) = (&a.0, &b.0);
        prop_assert_eq!(&both.0.0, &ring.difference(&times(cos_a, cos_b), &times(sin_a, sin_b)).unwrap());
        prop_assert_eq!(&both.0.1, &ring.sum(&times(sin_a, cos_b), &times(cos_a, sin_b)).unwrap());
        prop_assert_eq!(ring.sum(&times(cos_a, cos_a), &times(sin_a, sin_a)).unwrap(), ring.one());
        let point = place.point(&world);
        for ((cosine, sine), angle) in [a, b, both] {
            let expected = point.cosine_and_sine(&world.ring, &angle);
            prop_assert_eq!(point.value(&world.ring, &cosine).zip(point.value(&world.ring, &sine)), expected);
        }
    }

    #[test]
    fn the_angle_of_a_turned_vector_is_what_it_was_turned_by(
        k in (-2..=2_i32, -1..=1_i32, -2..=2_i32), mut world in world(),
    ) {
        let angle = world.angle(&[k.0, k.1, k.2, 0]);
        let (cosine, sine) = world.ring.cosine_and_sine(&angle).unwrap();
        let length = world.ring.element(world.free[2]);
        let (x, y) = (world.ring.product(&length, &cosine).unwrap(), world.ring.product(&length, &sine).unwrap());
        prop_assert_eq!(world.ring.direction(&x, &y), Ok(world.ring.angle_element(&angle)));
        // Turned halfway round it is no multiple of these.
        let back = (world.ring.negative(&x), world.ring.negative(&y));
        prop_assert_ne!(world.ring.direction(&back.0, &back.1), Ok(world.ring.angle_element(&angle)));
    }

    #[test]
    fn angles_are_elements_and_back(k in coefficients(), world in world()) {
        let angle = world.angle(&k);
        let element = world.ring.angle_element(&angle);
        prop_assert_eq!(world.ring.angle(&element), Some(angle.clone()));
        let (primitive, k) = angle.primitive();
        let times = |(symbol, own): (Symbol, &Integer)| (symbol, own * &k);
        prop_assert_eq!(Angle::new(primitive.coefficients().map(times)), angle.clone());
        prop_assert_eq!(primitive.primitive(), (primitive.clone(), Integer::from(i32::from(!angle.is_zero()))));
        prop_assert!(primitive.coefficients().next().is_none_or(|(_, first)| *first > Integer::ZERO));
        for (symbol, k) in angle.coefficients() {
            let (rest, own) = angle.split_off(symbol);
            prop_assert_eq!(&own, k);
            prop_assert_eq!(rest.split_off(symbol).1, Integer::ZERO);
        }
    }

    #[test]
    fn combinations_of_a_basis_are_found(
        rows in prop::collection::vec(prop::array::uniform3(-3..=3_i32), 1..=3),
        wanted in prop::array::uniform3(-3..=3_i32), target in prop::array::uniform3(-6..=6_i32),
    ) {
        let angle = |k: &[i32; 3]| Angle::new((0..).map(Symbol::new).zip(k.map(Integer::from)));
        let mut basis: Vec<Angle> = Vec::new();
        let mut chosen = Vec::new();
        for row in &rows {
            if decompose(&angle(row), &basis) == Decomposition::Independent {
                basis.push(angle(row));
                chosen.push(*row);
            }
        }
        // A combination with integers is found again.
        let combination: [i32; 3] = std::array::from_fn(|place| {
            chosen.iter().zip(wanted).map(|(row, k)| row[place] * k).sum()
        });
        let expected = wanted[..chosen.len()].iter().copied().map(Integer::from).collect();
        prop_assert_eq!(decompose(&angle(&combination), &basis), Decomposition::Integral(expected));
        // What is found is a combination; what is not found with integers is none with small ones.
        let all = || -12..=12_i32;
        match decompose(&angle(&target), &basis) {
            Decomposition::Integral(k) => for place in 0..3 {
                let sum: Integer = chosen.iter().zip(&k).map(|(row, k)| k * Integer::from(row[place])).sum();
                prop_assert_eq!(sum, Integer::from(target[place]));
            },
            other if chosen.len() == 2 => {
                let hit = |k: i32, l: i32, m: i32| (0..3).all(|p| chosen[0][p] * k + chosen[1][p] * l == target[p] * m);
                prop_assert!(!all().any(|k| all().any(|l| hit(k, l, 1))));
                let small = |v: &[i32; 3]| v.iter().all(|c| c.abs() <= 1);
                if small(&chosen[0]) && small(&chosen[1]) && small(&target) {
                    let some = (1..=4).any(|m| all().any(|k| all().any(|l| hit(k, l, m))));
                    prop_assert_eq!(some, other == Decomposition::Fractional);
                }
            }
            _ => {}
        }
    }
}

/// A ring with two angles and no sines yet.
fn angles() -> (Ring, [Symbol; 2]) {
    let mut ring = Ring::new(Budget::new(1_000_000));
    let symbols =
        ["α", "β"].map(|name| ring.symbol(Generator::Angle { name: name.into() }).unwrap());
    (ring, symbols)
}

fn combination(symbols: [Symbol; 2], k: i32, l: i32) -> Angle {
    Angle::new(symbols.into_iter().zip([k, l].map(Integer::from)))
}

#[test]
fn the_sine_of_a_fraction_of_the_basis_is_refused() {
    let (mut ring, symbols) = angles();
    for (k, l) in [(1, 1), (1, -1), (2, 0), (0, -4)] {
        assert!(ring.cosine_and_sine(&combination(symbols, k, l)).is_ok());
    }
    let single = combination(symbols, 1, 0);
    assert_eq!(
        ring.cosine_and_sine(&single),
        Err(AlgebraError::FractionalAngle)
    );
    assert_eq!(ring.basis().len(), 2);
}

#[test]
fn multiples_do_not_take_the_place_of_the_angle() {
    let (mut ring, symbols) = angles();
    let (cosine, _) = ring.cosine_and_sine(&combination(symbols, -6, 4)).unwrap();
    let (_, sine) = ring.cosine_and_sine(&combination(symbols, 3, -2)).unwrap();
    // cos 2A = 1 − 2 sin²A
    let square = ring.product(&sine, &sine).unwrap();
    let expected = ring
        .difference(&ring.one(), &ring.sum(&square, &square).unwrap())
        .unwrap();
    assert_eq!(cosine, expected);
    assert_eq!(ring.basis().len(), 1);
}

#[test]
fn what_is_no_sum_of_angles_is_no_angle() {
    let world = World::new((0, 0));
    let ring = &world.ring;
    let [a, _, _, x, alpha, ..] = world.free.map(|symbol| ring.element(symbol));
    let two = ring.sum(&ring.one(), &ring.one()).unwrap();
    for element in [
        ring.one(),
        a.clone(),
        x,
        ring.product(&alpha, &alpha).unwrap(),
        ring.product(&a, &alpha).unwrap(),
        ring.quotient(&alpha, &two).unwrap(),
        ring.quotient(&alpha, &a).unwrap(),
        ring.sum(&alpha, &a).unwrap(),
    ] {
        assert_eq!(ring.angle(&element), None);
    }
    assert_eq!(ring.angle(&ring.zero()), Some(Angle::default()));
}

#[test]
fn directions_that_are_known_are_recognised() {
    let mut world = World::new((1, 0));
    let [a, _, u, ..] = world.free.map(|symbol| world.ring.element(symbol));
    let angle = world.angle(&[1, 1, 0, 0]);
    world.ring.cosine_and_sine(&angle).unwrap();
    let basis = world.ring.basis().to_vec();
    for known in &basis {
        let (cosine, sine) = (
            world.ring.element(known.cosine),
            world.ring.element(known.sine),
        );
        let (x, y) = (
            world.ring.product(&u, &cosine).unwrap(),
            world.ring.product(&u, &sine).unwrap(),
        );
        let expected = world.ring.angle_element(&known.angle);
        assert_eq!(world.ring.direction(&x, &y), Ok(expected.clone()));
        // With a factor of unknown or of negative sign it is another angle.
        let back = (world.ring.negative(&x), world.ring.negative(&y));
        assert_ne!(world.ring.direction(&back.0, &back.1), Ok(expected));
    }
    assert_eq!(
        world.ring.direction(&u, &world.ring.zero()),
        Ok(world.ring.zero())
    );
    assert_ne!(
        world.ring.direction(&a, &world.ring.zero()).ok(),
        Some(world.ring.zero())
    );
    let zero = world.ring.zero();
    assert_eq!(
        world.ring.direction(&zero, &zero),
        Err(AlgebraError::DivisionByZero)
    );
    let direction = world.direction.clone();
    let (a, b) = (
        world.ring.element(world.free[0]),
        world.ring.element(world.free[1]),
    );
    assert_eq!(world.ring.direction(&a, &b), Ok(direction));
}
