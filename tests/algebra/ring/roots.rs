//! Square roots.

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::budget::Budget;
use sextic::algebra::error::AlgebraError;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::number::Rational;
use sextic::algebra::ring::Ring;
use sextic::algebra::sign::Signs;

use super::field::{Done, element, same};
use super::terms::{Term, World, place, term, world};

fn number(n: i64, d: i64) -> Fraction {
    Fraction::from(Rational::from(n) / Rational::from(d))
}

/// A ring with a > 0, b < 0 and c of any sign.
fn ring() -> (Ring, [Fraction; 3]) {
    let mut ring = Ring::new(Budget::new(20_000_000));
    let signs = [
        ("a", Signs::POSITIVE),
        ("b", Signs::NEGATIVE),
        ("c", Signs::ANY),
    ];
    let elements = signs.map(|(name, signs)| {
        let symbol = ring
            .symbol(Generator::Constant { name: name.into() })
            .unwrap();
        ring.assumptions_mut().assume_symbol(symbol, signs);
        ring.element(symbol)
    });
    (ring, elements)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn roots_of_numbers(n in 1..5000_i64, d in 1..200_i64) {
        let (mut ring, _) = ring();
        let root = ring.square_root(&number(n, d)).done()?;
        prop_assert_eq!(ring.product(&root, &root).done()?, number(n, d));
        let exact = (0..=5000).find_map(|m| (1..=200).find(|e| m * m * d == n * e * e).map(|e| number(m, e)));
        prop_assert_eq!(root.as_constant().map(Fraction::from), exact);
        prop_assert!(ring.signs(&root).done()?.is_positive());
    }

    #[test]
    fn the_square_of_a_root_is_its_radicand(term in term(4), k in 1..=2_i32, mut world in world(), place in place()) {
        // t² + k u² is certainly positive, where t is real.
        let real = element(&term, &mut world)?;
        let i = world.i;
        prop_assume!(!real.numerator().contains(i) && !real.denominator().contains(i));
        let ring = &mut world.ring;
        let u = ring.element(world.free[2]);
        let term = ring.product(&Fraction::from(Rational::from(k)), &ring.product(&u, &u).done()?).done()?;
        let radicand = ring.sum(&ring.product(&real, &real).done()?, &term).done()?;
        let root = match ring.square_root(&radicand) {
            // Nothing tells that this is positive, or that the denominator is.
            Err(AlgebraError::UnknownSign) => return Err(TestCaseError::reject("unknown")),
            root => root.done()?,
        };
        let square = ring.product(&root, &root).done()?;
        prop_assert!(same(ring, &square, &radicand)?);
        let point = place.point(&world);
        if let Some(value) = point.value(&world.ring, &root) {
            prop_assert!(value.start().0 >= Rational::ZERO);
        }
    }

    #[test]
    fn known_signs_leave_the_root(exponents in prop::array::uniform3(-3..=3_i64), n in 1..50_i64, d in 1..50_i64) {
        let (mut ring, elements) = ring();
        let mut square = number(n * n, d * d);
        let mut expected = number(n, d);
        for (element, exponent) in elements.iter().zip([exponents[0], exponents[1], 2 * exponents[2]]) {
            square = ring.product(&square, &ring.power(element, 2 * exponent).done()?).done()?;
            expected = ring.product(&expected, &ring.power(element, exponent).done()?).done()?;
        }
        // c⁴ⁿ has the root c²ⁿ, aⁿ is positive, and bⁿ is negative for odd n.
        if exponents[1] % 2 != 0 {
            expected = ring.negative(&expected);
        }
        let root = ring.square_root(&square);
        prop_assert!(root == Ok(expected) || exponents[2] != 0 && root == Err(AlgebraError::UnknownSign));
    }
}

#[test]
fn roots_that_depend_on_an_unknown_sign_are_refused() {
    let (mut ring, [a, b, c]) = ring();
    let square = ring.product(&c, &c).unwrap();
    assert_eq!(ring.square_root(&square), Err(AlgebraError::UnknownSign));
    for negative in [&b, &number(-1, 1)] {
        assert_eq!(
            ring.square_root(negative),
            Err(AlgebraError::NegativeRadicand)
        );
    }
    let scaled = ring
        .quotient(&square, &ring.product(&a, &a).unwrap())
        .unwrap();
    assert_eq!(ring.square_root(&scaled), Err(AlgebraError::UnknownSign));
    assert_eq!(ring.square_root(&ring.zero()), Ok(ring.zero()));
}

#[test]
fn a_root_is_at_least_zero_whatever_is_below_the_line() {
    let (mut ring, [a, b, _]) = ring();
    // √(a/b²) = √a/|b|
    let quotient = ring.quotient(&a, &ring.product(&b, &b).unwrap()).unwrap();
    let root = ring.square_root(&quotient).unwrap();
    assert!(ring.signs(&root).unwrap().is_positive());
    // √(−a·b)
    let product = ring.negative(&ring.product(&a, &b).unwrap());
    let root = ring.square_root(&product).unwrap();
    assert_eq!(ring.product(&root, &root), Ok(product));
    assert!(ring.signs(&root).unwrap().is_positive());
}

#[test]
fn equal_arguments_have_one_symbol() {
    let mut world = World::new((1, 0));
    let sine = Term::Sine([1, 0, 0, 0]).element(&mut world).unwrap();
    let ring = &mut world.ring;
    let symbol = ring.as_symbol(&sine).unwrap();
    ring.assumptions_mut()
        .assume_symbol(symbol, Signs::POSITIVE);
    // 1/sin α and sin α/(1 − cos²α)
    let one = ring.quotient(&ring.one(), &sine).unwrap();
    let other = ring.canonical(&one).unwrap();
    assert_ne!(one, other);
    let value = ring.function_value("f", 0, &one);
    assert_eq!(ring.function_value("f", 0, &other), value);
    let x = ring.element(world.free[3]);
    let direction = ring.direction(&x, &one).unwrap();
    assert_eq!(ring.direction(&x, &other), Ok(direction));
}
