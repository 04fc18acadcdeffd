//! Signs: their arithmetic against all small numbers, and what is concluded for polynomials against
//! points that obey the assumptions.

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::budget::Budget;
use sextic::algebra::generator::Generator;
use sextic::algebra::monomial::Monomial;
use sextic::algebra::number::Integer;
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::ring::Ring;
use sextic::algebra::sign::Signs;
use sextic::algebra::symbol::Symbol;

use crate::algebra::support::{small_polynomial, value};

fn every() -> impl Iterator<Item = Signs> {
    (0..8).map(|bits| Signs {
        negative: bits & 1 != 0,
        zero: bits & 2 != 0,
        positive: bits & 4 != 0,
    })
}

/// The small numbers of these signs.
fn numbers(signs: Signs) -> Vec<i64> {
    let allowed = move |n: &i64| match n.signum() {
        -1 => signs.negative,
        0 => signs.zero,
        _ => signs.positive,
    };
    (-3..=3_i64).filter(allowed).collect()
}

/// The signs that some of the numbers have.
fn of(numbers: impl IntoIterator<Item = i64>) -> Signs {
    let none = Signs {
        negative: false,
        zero: false,
        positive: false,
    };
    numbers.into_iter().fold(none, |signs, n| {
        let own = Signs::of_integer(&Integer::from(n));
        Signs {
            negative: signs.negative || own.negative,
            zero: signs.zero || own.zero,
            positive: signs.positive || own.positive,
        }
    })
}

#[test]
fn signs_are_those_of_numbers() {
    for a in every() {
        assert_eq!(a.opposite(), of(numbers(a).into_iter().map(|n| -n)));
        for exponent in 1..=4 {
            assert_eq!(
                a.power(exponent),
                of(numbers(a).into_iter().map(|n| n.pow(exponent)))
            );
        }
        assert_eq!(a.power(0), Signs::POSITIVE);
        assert_eq!(a.is_positive(), a == Signs::POSITIVE);
        assert_eq!(a.is_non_negative(), numbers(a).iter().all(|n| *n >= 0));
        assert_eq!(a.is_non_zero(), numbers(a).iter().all(|n| *n != 0));
        for b in every() {
            let pairs = || {
                numbers(a)
                    .into_iter()
                    .flat_map(|n| numbers(b).into_iter().map(move |m| (n, m)))
            };
            assert_eq!(a.sum(b), of(pairs().map(|(n, m)| n + m)), "{a:?} {b:?}");
            // Of nothing there is no product, but that never arises: 0·nothing stays 0.
            if !numbers(a).is_empty() && !numbers(b).is_empty() {
                assert_eq!(a.product(b), of(pairs().map(|(n, m)| n * m)), "{a:?} {b:?}");
            }
            let both: Vec<i64> = numbers(a)
                .into_iter()
                .filter(|n| numbers(b).contains(n))
                .collect();
            assert_eq!(a.intersection(b), of(both));
        }
    }
}

/// A ring of three constants with signs, and perhaps an assumption on a polynomial.
fn ring(signs: &[Signs; 3], known: Option<(&Polynomial, Signs)>) -> Ring {
    let mut ring = Ring::new(Budget::new(20_000_000));
    for (name, signs) in ["a", "b", "c"].iter().zip(signs) {
        let symbol = ring
            .symbol(Generator::Constant {
                name: (*name).into(),
            })
            .unwrap();
        ring.assumptions_mut().assume_symbol(symbol, *signs);
    }
    if let Some((known, signs)) = known {
        ring.assumptions_mut()
            .assume_polynomial(known.clone(), signs);
    }
    ring
}

fn any_signs() -> impl Strategy<Value = Signs> {
    prop::sample::select(vec![
        Signs::ANY,
        Signs::POSITIVE,
        Signs::POSITIVE,
        Signs::NEGATIVE,
        Signs::NON_NEGATIVE,
        Signs::NON_ZERO,
    ])
}

fn points(signs: &[Signs; 3]) -> Vec<[i64; 3]> {
    let [a, b, c] = signs.map(numbers);
    let mut points = Vec::new();
    for a in &a {
        for b in &b {
            points.extend(c.iter().map(|c| [*a, *b, *c]));
        }
    }
    points
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_is_concluded_is_true(
        p in small_polynomial(3, 2), q in small_polynomial(2, 1), known in small_polynomial(3, 1),
        assumed in prop::option::of(any_signs()), signs in prop::array::uniform3(any_signs()),
    ) {
        let ring = ring(&signs, assumed.map(|signs| (&known, signs)));
        let budget = ring.budget();
        // Products and squares, and differences from what is known, so that there is something to find.
        let shifted = &(&p.multiply(&p, budget).unwrap() + &known) + &q;
        for polynomial in [p.clone(), p.multiply(&q, budget).unwrap(), shifted, known.multiply(&q, budget).unwrap()] {
            let concluded = ring.polynomial_signs(&polynomial).unwrap();
            for point in points(&signs) {
                let own = Signs::of_integer(&value(&known, &point));
                if assumed.is_some_and(|signs| own.intersection(signs) != own) {
                    continue;
                }
                let own = Signs::of_integer(&value(&polynomial, &point));
                prop_assert_eq!(own.intersection(concluded), own, "{:?} at {:?}", polynomial, point);
            }
        }
    }
}

#[test]
fn signs_that_are_found() {
    let symbol = |index| Polynomial::symbol(Symbol::new(index));
    let (a, b, c) = (symbol(0), symbol(1), symbol(2));
    let plain = ring(&[Signs::POSITIVE, Signs::POSITIVE, Signs::ANY], None);
    let budget = plain.budget();
    let square = |p: &Polynomial| p.multiply(p, budget).unwrap();
    let known = &a - &c;
    let shifted = ring(
        &[Signs::POSITIVE, Signs::POSITIVE, Signs::NON_NEGATIVE],
        Some((&known, Signs::POSITIVE)),
    );
    let difference = &square(&a) - &square(&c);
    for (ring, polynomial, expected) in [
        (&plain, &a + &b, Signs::POSITIVE),
        (&plain, -&(&a + &b), Signs::NEGATIVE),
        (&plain, &a - &b, Signs::ANY),
        (&plain, square(&(&a - &b)), Signs::NON_NEGATIVE),
        (
            &plain,
            -&square(&(&a - &c)),
            Signs {
                positive: false,
                ..Signs::ANY
            },
        ),
        (&plain, square(&c), Signs::NON_NEGATIVE),
        (&plain, &square(&c) + &a, Signs::POSITIVE),
        (&plain, difference.clone(), Signs::ANY),
        (&shifted, known.clone(), Signs::POSITIVE),
        (&shifted, &known + &b, Signs::POSITIVE),
        (&shifted, -&known, Signs::NEGATIVE),
        (&shifted, difference, Signs::POSITIVE),
        (&shifted, Polynomial::zero(), Signs::ZERO),
    ] {
        assert_eq!(
            ring.polynomial_signs(&polynomial),
            Ok(expected),
            "{polynomial:?}"
        );
    }
}

#[test]
fn sines_cosines_and_i() {
    let mut ring = Ring::new(Budget::new(1_000_000));
    let angle = ring.symbol(Generator::Angle { name: "A".into() }).unwrap();
    let angle = ring.angle(&ring.element(angle)).unwrap();
    let (cosine, sine) = ring.cosine_and_sine(&angle).unwrap();
    let i = ring.symbol(Generator::ImaginaryUnit).unwrap();
    let unfolded = Polynomial::from_terms([(Monomial::power(i, 2), Integer::ONE)]);
    assert_eq!(ring.assumptions().of_terms(&unfolded), Signs::ANY);
    let i = ring.element(i);
    let square = |ring: &Ring, a| ring.product(a, a).unwrap();
    // sin² is 1 − cos² in normal form, and no sum of terms of one sign there.
    assert_eq!(ring.signs(&square(&ring, &sine)), Ok(Signs::NON_NEGATIVE));
    assert_eq!(ring.signs(&square(&ring, &cosine)), Ok(Signs::NON_NEGATIVE));
    assert_eq!(ring.signs(&i), Ok(Signs::ANY));
    let product = ring.product(&i, &cosine).unwrap();
    assert!(!ring.signs(&square(&ring, &product)).unwrap().positive);
    let inverse = ring.quotient(&ring.one(), &square(&ring, &sine)).unwrap();
    assert!(ring.signs(&inverse).unwrap().is_non_negative());
}
