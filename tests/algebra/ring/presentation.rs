//! Shorter forms are equal forms.

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, Division};
use sextic::algebra::fraction::Fraction;

use super::field::{Done, element, same};
use super::terms::{Term, World, term, world};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_shorter_form_is_equal_and_no_longer(term in term(6), mut world in world()) {
        let element = element(&term, &mut world)?;
        let ring = &world.ring;
        for side in [element.numerator(), element.denominator()] {
            let short = ring.shorten(side).done()?;
            prop_assert!(short.len() <= side.len());
            prop_assert_eq!(ring.reduce(&short).done()?, ring.reduce(side).done()?);
        }
    }

    #[test]
    fn the_factors_multiply_to_the_element(a in term(4), b in term(3), mut world in world()) {
        let (a, b) = (element(&a, &mut world)?, element(&b, &mut world)?);
        let ring = &world.ring;
        let element = ring.product(&a, &ring.product(&b, &b).done()?).done()?;
        let factored = ring.factored(&element).done()?;
        let mut product = Fraction::from(factored.coefficient.clone());
        for (factor, exponent) in &factored.factors {
            prop_assert!(*exponent != 0 && factor.as_constant().is_none());
            let power = ring.power(&Fraction::from(factor.clone()), *exponent).done()?;
            product = ring.product(&product, &power).done()?;
        }
        prop_assert!(same(ring, &product, &element)?);
    }
}

#[test]
fn cosines_make_way_for_shorter_sines() {
    let mut world = World::new((1, 0));
    let [cosine, sine] = [Term::Cosine([1, 0, 0, 0]), Term::Sine([1, 0, 0, 0])]
        .map(|term| term.element(&mut world).unwrap());
    let ring = &world.ring;
    let square = |a| ring.product(a, a).unwrap();
    let plain = |a: &Fraction| {
        a.numerator()
            .multiply(a.numerator(), ring.budget())
            .unwrap()
    };
    assert_eq!(ring.shorten(square(&sine).numerator()), Ok(plain(&sine)));
    assert_eq!(
        ring.shorten(square(&cosine).numerator()),
        Ok(plain(&cosine))
    );
    // (1 − cos²)²/(1 − cos²) is sin², with both sides of the line known by their factors.
    let inverse = ring.quotient(&ring.one(), &square(&sine)).unwrap();
    let factored = ring.factored(&inverse).unwrap();
    assert_eq!(factored.factors, [(sine.numerator().clone(), -2)]);
}
