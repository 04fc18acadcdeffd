//! The laws of a field, the normal form and the canonical form.

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::budget::Exhausted;
use sextic::algebra::error::AlgebraError;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::ring::Ring;

use super::terms::{Term, World, place, term, world};

impl std::fmt::Debug for World {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "basis {:?}", self.ring.basis())
    }
}

/// A result, or a case that is passed over because there is none.
pub trait Done<T> {
    fn done(self) -> Result<T, TestCaseError>;
}

impl<T> Done<T> for Result<T, AlgebraError> {
    fn done(self) -> Result<T, TestCaseError> {
        self.map_err(|error| match error {
            AlgebraError::DivisionByZero | AlgebraError::Exhausted(_) => {
                TestCaseError::reject(error.to_string())
            }
            _ => TestCaseError::fail(error.to_string()),
        })
    }
}

impl<T> Done<T> for Result<T, Exhausted> {
    fn done(self) -> Result<T, TestCaseError> {
        self.map_err(AlgebraError::from).done()
    }
}

impl<T> Done<T> for Option<T> {
    fn done(self) -> Result<T, TestCaseError> {
        self.ok_or_else(|| TestCaseError::reject("has no value"))
    }
}

/// The element of a term.
pub fn element(term: &Term, world: &mut World) -> Result<Fraction, TestCaseError> {
    term.element(world).done()
}

/// Whether two elements are equal.
pub fn same(ring: &Ring, a: &Fraction, b: &Fraction) -> Result<bool, TestCaseError> {
    Ok(ring.canonical(a).done()? == ring.canonical(b).done()?)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn elements_have_the_values_of_their_terms(term in term(8), mut world in world(), place in place()) {
        let element = element(&term, &mut world)?;
        let point = place.point(&world);
        let expected = term.value(&world, &point);
        prop_assume!(expected.is_some());
        for form in [element.clone(), world.ring.canonical(&element).done()?] {
            if let Some(value) = point.value(&world.ring, &form) {
                prop_assert_eq!(Some(value), expected.clone());
            }
        }
    }

    #[test]
    fn what_cannot_be_divided_by_is_zero(term in term(6), mut world in world(), place in place()) {
        let divisor = element(&term, &mut world)?;
        let ring = &world.ring;
        let inverse = ring.quotient(&ring.one(), &divisor);
        if inverse == Err(AlgebraError::DivisionByZero) {
            let value = term.value(&world, &place.point(&world));
            prop_assert!(value.is_none_or(|value| value.start().is_zero()));
        } else {
            let product = ring.product(&divisor, &inverse.done()?).done()?;
            prop_assert!(same(ring, &product, &ring.one())?);
        }
    }

    #[test]
    fn elements_are_a_field(a in term(4), b in term(4), c in term(3), mut world in world()) {
        let (a, b, c) = (element(&a, &mut world)?, element(&b, &mut world)?, element(&c, &mut world)?);
        let ring = &world.ring;
        let plus = |a: &Fraction, b: &Fraction| ring.sum(a, b).done();
        let times = |a: &Fraction, b: &Fraction| ring.product(a, b).done();
        let (sum, product) = (plus(&a, &b)?, times(&a, &b)?);
        prop_assert!(same(ring, &plus(&sum, &c)?, &plus(&a, &plus(&b, &c)?)?)?);
        prop_assert!(same(ring, &sum, &plus(&b, &a)?)?);
        prop_assert!(same(ring, &times(&product, &c)?, &times(&a, &times(&b, &c)?)?)?);
        prop_assert!(same(ring, &product, &times(&b, &a)?)?);
        prop_assert!(same(ring, &times(&a, &plus(&b, &c)?)?, &plus(&product, &times(&a, &c)?)?)?);
        prop_assert!(plus(&a, &ring.negative(&a))?.is_zero());
        prop_assert!(same(ring, &plus(&ring.difference(&a, &b).done()?, &b)?, &a)?);
        prop_assert_eq!(plus(&a, &ring.zero())?, a.clone());
        prop_assert_eq!(times(&a, &ring.one())?, a.clone());
        if !b.is_zero() {
            prop_assert!(same(ring, &times(&ring.quotient(&a, &b).done()?, &b)?, &a)?);
        }
    }

    #[test]
    fn powers_are_repeated_products(a in term(3), exponent in 0_i64..5, mut world in world()) {
        let a = element(&a, &mut world)?;
        let ring = &world.ring;
        let product = (0..exponent).try_fold(ring.one(), |power, _| ring.product(&power, &a)).done()?;
        let power = ring.power(&a, exponent).done()?;
        prop_assert!(same(ring, &power, &product)?);
        if !a.is_zero() {
            let inverse = ring.power(&a, -exponent).done()?;
            prop_assert!(same(ring, &ring.product(&inverse, &power).done()?, &ring.one())?);
        }
    }

    #[test]
    fn normal_forms_are_linear_and_stay(a in term(6), b in term(6), k in -5_i32..5, mut world in world()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        let ring = &world.ring;
        let budget = ring.budget();
        // Squares that nothing has folded yet.
        let a = a.numerator().multiply(a.numerator(), budget).done()?;
        let b = b.numerator().multiply(&(&a + &Polynomial::one()), budget).done()?;
        let (folded_a, folded_b) = (ring.reduce(&a).done()?, ring.reduce(&b).done()?);
        prop_assert_eq!(ring.reduce(&folded_a).done()?, folded_a.clone());
        let k = k.into();
        prop_assert_eq!(ring.reduce(&(&a.scale(&k) + &b)).done()?, &folded_a.scale(&k) + &folded_b);
        for symbol in folded_a.symbols() {
            prop_assert!(!ring.generator(symbol).is_quadratic() || folded_a.degree_in(symbol) == 1);
        }
    }

    #[test]
    fn canonical_forms_decide_equality(a in term(5), b in term(4), mut world in world(), place in place()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        let ring = &world.ring;
        let canonical = ring.canonical(&a).done()?;
        prop_assert_eq!(ring.canonical(&canonical).done()?, canonical.clone());
        for symbol in canonical.denominator().symbols() {
            prop_assert!(!ring.generator(symbol).is_quadratic());
        }
        if !b.is_zero() {
            let detour = ring.quotient(&ring.product(&a, &b).done()?, &b).done()?;
            prop_assert_eq!(ring.canonical(&detour).done()?, canonical.clone());
        }
        let difference = ring.difference(&a, &b).done()?;
        prop_assert_eq!(difference.is_zero(), canonical == ring.canonical(&b).done()?);
        let point = place.point(&world);
        if let (Some(left), Some(right)) = (point.value(&world.ring, &a), point.value(&world.ring, &b))
            && left != right {
            prop_assert!(!difference.is_zero());
        }
    }

    #[test]
    fn no_root_and_no_i_is_below_the_line(a in term(6), b in term(6), mut world in world()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        if let Ok(quotient) = world.ring.quotient(&a, &b) {
            for symbol in quotient.denominator().symbols() {
                let generator = world.ring.generator(symbol);
                let unwanted = matches!(generator, Generator::Root { .. } | Generator::ImaginaryUnit);
                prop_assert!(!unwanted);
            }
        }
    }
}

#[test]
fn there_is_no_division_by_what_folds_to_zero() {
    let mut world = World::new((1, 0));
    let sine = Term::Sine([1, 0, 0, 0]);
    let cosine = Term::Cosine([1, 0, 0, 0]);
    let square = |term: &Term| Box::new(Term::Power(Box::new(term.clone()), 2));
    let one = Term::Sum(square(&sine), square(&cosine));
    let zero = Term::Difference(Box::new(one), Box::new(Term::Number(1)));
    for quotient in [
        Term::Quotient(Box::new(Term::I), Box::new(zero.clone())),
        Term::Power(Box::new(zero), -2),
    ] {
        assert_eq!(
            quotient.element(&mut world),
            Err(AlgebraError::DivisionByZero)
        );
    }
}

#[test]
fn symbols_are_made_once_and_found_again() {
    let mut world = World::new((0, 0));
    let again = world
        .ring
        .symbol(Generator::Constant { name: "a".into() })
        .unwrap();
    assert_eq!(again, world.free[0]);
    let a = world.ring.element(again);
    assert_eq!(world.ring.as_symbol(&a), Some(again));
    let twice = world.ring.sum(&a, &a).unwrap();
    let square = world.ring.product(&a, &a).unwrap();
    let inverse = world.ring.quotient(&world.ring.one(), &a).unwrap();
    let shifted = world.ring.sum(&a, &world.ring.one()).unwrap();
    for other in [
        twice,
        square,
        inverse,
        shifted,
        world.ring.one(),
        world.ring.zero(),
    ] {
        assert_eq!(world.ring.as_symbol(&other), None);
    }
}
