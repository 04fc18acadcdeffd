//! The laws of rings, fields and divisibility, on arbitrary elements.

use super::support::{budget, fraction, grid, integer, polynomial, small_polynomial, value};
use proptest::prelude::*;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::number::Integer;
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::symbol::Symbol;

fn times(left: &Polynomial, right: &Polynomial) -> Polynomial {
    left.multiply(right, &budget()).unwrap()
}

fn divides(divisor: &Polynomial, dividend: &Polynomial) -> bool {
    dividend.divide_exact(divisor, &budget()).unwrap().is_some()
}

fn gcd(left: &Polynomial, right: &Polynomial) -> Polynomial {
    left.gcd(right, &budget()).unwrap()
}

proptest! {
    #[test]
    fn sums_and_products_have_the_values_they_should(a in polynomial(12, 2), b in polynomial(12, 2)) {
        let (sum, difference, product) = (&a + &b, &a - &b, times(&a, &b));
        for point in grid(4) {
            let (left, right) = (value(&a, &point), value(&b, &point));
            prop_assert_eq!(value(&sum, &point), &left + &right);
            prop_assert_eq!(value(&difference, &point), &left - &right);
            prop_assert_eq!(value(&product, &point), left * right);
        }
    }

    #[test]
    fn polynomials_are_a_commutative_ring(
        a in polynomial(8, 3), b in polynomial(8, 3), c in polynomial(8, 3),
    ) {
        prop_assert_eq!(&(&a + &b) + &c, &a + &(&b + &c));
        prop_assert_eq!(&a + &b, &b + &a);
        prop_assert_eq!(&(&a - &b) + &b, a.clone());
        prop_assert_eq!(&a + &-&a, Polynomial::zero());
        prop_assert_eq!(times(&a, &b), times(&b, &a));
        prop_assert_eq!(times(&times(&a, &b), &c), times(&a, &times(&b, &c)));
        prop_assert_eq!(times(&a, &(&b + &c)), &times(&a, &b) + &times(&a, &c));
        prop_assert_eq!(times(&a, &Polynomial::one()), a);
    }

    #[test]
    fn powers_are_repeated_products(a in small_polynomial(4, 2), exponent in 0_u32..6) {
        let product = (0..exponent).fold(Polynomial::one(), |product, _| times(&product, &a));
        prop_assert_eq!(a.power(exponent, &budget()).unwrap(), product);
    }

    #[test]
    fn coefficients_put_together_are_the_polynomial(a in polynomial(10, 3), index in 0_u16..4) {
        let symbol = Symbol::new(index);
        let coefficients = a.coefficients_in(symbol);
        prop_assert!(coefficients.values().all(|part| !part.is_zero() && !part.contains(symbol)));
        prop_assert_eq!(Polynomial::from_coefficients_in(symbol, &coefficients).unwrap(), a);
    }

    #[test]
    fn contents_and_primitive_parts_multiply_to_the_polynomial(a in polynomial(6, 2), factor in integer()) {
        let multiple = a.scale(&factor);
        let primitive = multiple.primitive_part();
        prop_assert_eq!(primitive.scale(&multiple.content()), multiple);
        prop_assert!(primitive.is_zero() || primitive.content().is_one());
    }

    #[test]
    fn derivatives_obey_the_product_rule(a in polynomial(6, 3), b in polynomial(6, 3)) {
        let symbol = Symbol::new(1);
        let left = times(&a.derivative(symbol), &b);
        let right = times(&a, &b.derivative(symbol));
        prop_assert_eq!(times(&a, &b).derivative(symbol), &left + &right);
    }

    #[test]
    fn a_product_divides_by_its_factors(a in polynomial(10, 3), b in polynomial(10, 3)) {
        prop_assume!(!b.is_zero());
        prop_assert_eq!(times(&a, &b).divide_exact(&b, &budget()).unwrap(), Some(a));
    }

    #[test]
    fn a_quotient_times_the_divisor_is_the_dividend(a in small_polynomial(5, 2), b in small_polynomial(2, 1)) {
        if let Some(quotient) = a.divide_exact(&b, &budget()).unwrap() {
            prop_assert_eq!(times(&quotient, &b), a);
        }
    }

    #[test]
    fn no_product_plus_a_smaller_term_divides(a in polynomial(6, 2), b in small_polynomial(6, 2)) {
        prop_assume!(b.as_constant().is_none());
        let almost = &times(&a, &b) + &Polynomial::one();
        prop_assert!(!divides(&b, &almost));
    }

    #[test]
    fn pseudo_remainders_are_of_lower_degree_and_congruent(a in small_polynomial(5, 3), b in small_polynomial(4, 2)) {
        let x = Symbol::new(0);
        prop_assume!(!b.is_zero());
        let remainder = a.pseudo_remainder(&b, x, &budget()).unwrap();
        let degree = b.degree_in(x);
        prop_assert!(remainder.is_zero() || remainder.degree_in(x) < degree || a.degree_in(x) < degree);
        let excess = (a.degree_in(x) + 1).saturating_sub(degree);
        let leading = b.coefficients_in(x).remove(&degree).unwrap();
        let multiple = times(&a, &leading.power(excess, &budget()).unwrap());
        prop_assert!(divides(&b, &(&multiple - &remainder)));
    }

    #[test]
    fn a_gcd_divides_both_and_common_factors_divide_it(
        a in small_polynomial(4, 2), b in small_polynomial(4, 2), c in small_polynomial(4, 2),
    ) {
        let (left, right) = (times(&a, &c), times(&b, &c));
        let common = gcd(&left, &right);
        prop_assert!(divides(&common, &left) && divides(&common, &right) && divides(&c, &common));
        prop_assert!(common.leading().is_none_or(|(_, coefficient)| *coefficient > Integer::ZERO));
        prop_assert_eq!(gcd(&right, &left), common);
    }

    #[test]
    fn cofactors_of_a_gcd_are_coprime(
        a in polynomial(4, 2), b in polynomial(4, 2), c in polynomial(3, 2),
    ) {
        let (left, right) = (times(&a, &c), times(&b, &c));
        let common = gcd(&left, &right);
        prop_assume!(!common.is_zero());
        let left = left.divide_exact(&common, &budget()).unwrap().unwrap();
        let right = right.divide_exact(&common, &budget()).unwrap().unwrap();
        prop_assert!(gcd(&left, &right).is_one());
    }

    #[test]
    fn squares_have_roots_and_others_do_not(a in polynomial(6, 3), b in small_polynomial(3, 2)) {
        let square = times(&a, &a);
        let root = square.square_root(&budget()).unwrap().unwrap();
        prop_assert!(root == a || root == -&a);
        prop_assert!(root.leading().is_none_or(|(_, coefficient)| *coefficient > Integer::ZERO));
        if let Some(root) = (&square + &b).square_root(&budget()).unwrap() {
            prop_assert_eq!(times(&root, &root), &square + &b);
        }
    }

    #[test]
    fn square_free_factors_multiply_to_the_polynomial(
        a in small_polynomial(3, 1), b in small_polynomial(3, 1), c in small_polynomial(2, 1),
    ) {
        let product = times(&times(&a, &times(&b, &b)), &times(&c, &c));
        let factors = product.square_free(&budget()).unwrap();
        let mut again = Polynomial::constant(product.signed_content());
        for (place, (factor, multiplicity)) in factors.iter().enumerate() {
            prop_assert!(factor.as_constant().is_none() && factor.content().is_one());
            for symbol in factor.symbols() {
                prop_assert!(!divides(factor, &factor.derivative(symbol)));
                prop_assert!(gcd(factor, &factor.derivative(symbol)).is_one());
            }
            for (other, _) in &factors[..place] {
                prop_assert!(gcd(factor, other).is_one());
            }
            again = times(&again, &factor.power(*multiplicity, &budget()).unwrap());
        }
        prop_assert_eq!(again, product);
    }

    #[test]
    fn what_is_divided_out_is_no_longer_there(a in small_polynomial(3, 2), b in small_polynomial(3, 2), power in 0_u32..3) {
        let product = times(&a, &b.power(power, &budget()).unwrap());
        let (rest, multiplicity) = product.divide_out(&b, &budget()).unwrap();
        prop_assert_eq!(times(&rest, &b.power(multiplicity, &budget()).unwrap()), product.clone());
        let unit = b.as_constant().is_some_and(|value| value <= Integer::ONE && value >= -Integer::ONE);
        prop_assert!(unit || product.is_zero() || (multiplicity >= power && !divides(&b, &rest)));
    }

    #[test]
    fn fractions_are_a_field(a in fraction(), b in fraction(), c in fraction()) {
        let budget = budget();
        let plus = |left: &Fraction, right: &Fraction| left.sum(right, &budget).unwrap();
        let times = |left: &Fraction, right: &Fraction| left.product(right, &budget).unwrap();
        prop_assert_eq!(plus(&plus(&a, &b), &c), plus(&a, &plus(&b, &c)));
        prop_assert_eq!(plus(&a, &b), plus(&b, &a));
        prop_assert_eq!(times(&times(&a, &b), &c), times(&a, &times(&b, &c)));
        prop_assert_eq!(times(&a, &plus(&b, &c)), plus(&times(&a, &b), &times(&a, &c)));
        prop_assert_eq!(plus(&a.difference(&b, &budget).unwrap(), &b), a.clone());
        prop_assert!(plus(&a, &a.negative()).is_zero());
        if !b.is_zero() {
            prop_assert_eq!(times(&a.quotient(&b, &budget).unwrap(), &b), a);
        }
    }

    #[test]
    fn fractions_are_in_lowest_terms(a in fraction(), b in fraction(), exponent in -2_i32..=2) {
        let budget = budget();
        let mut results = vec![
            a.sum(&b, &budget), a.difference(&b, &budget), a.product(&b, &budget), Ok(a.negative()),
        ];
        if !b.is_zero() {
            results.push(a.quotient(&b, &budget));
            results.push(b.power(exponent, &budget));
        }
        for result in results {
            let result = result.unwrap();
            prop_assert!(gcd(result.numerator(), result.denominator()).is_one());
            prop_assert!(result.denominator().leading().unwrap().1 > Integer::ZERO);
        }
    }
}
