//! The results of another system: tables made with SymPy, which say in their
//! headers how.

use super::support::{budget, monomial};
use sextic::algebra::determinant::determinant;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::matrix::Matrix;
use sextic::algebra::number::Integer;
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::ring::Ring;

/// The rows of a table, each a list of polynomials.
fn rows(table: &str) -> Vec<Vec<Polynomial>> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| line.split('|').map(polynomial).collect())
        .collect()
}

/// Reads `coefficient:exponent,exponent,... coefficient:... ...` or `0`.
fn polynomial(text: &str) -> Polynomial {
    let terms = text.split_whitespace().filter(|term| *term != "0");
    Polynomial::from_terms(terms.map(|term| {
        let (coefficient, exponents) = term.split_once(':').unwrap();
        let exponents: Vec<u16> = exponents.split(',').map(|e| e.parse().unwrap()).collect();
        (
            monomial(&exponents),
            coefficient.parse::<Integer>().unwrap(),
        )
    }))
}

fn fraction(numerator: &Polynomial, denominator: &Polynomial) -> Fraction {
    Fraction::new(numerator.clone(), denominator.clone(), &budget()).unwrap()
}

#[test]
fn products() {
    for row in rows(include_str!("../data/algebra/products.txt")) {
        let [left, right, product] = &*row else {
            panic!("{row:?}")
        };
        assert_eq!(left.multiply(right, &budget()).unwrap(), *product);
    }
}

#[test]
fn determinants() {
    let mut ring = Ring::new(budget());
    for name in ["x0", "x1", "x2"] {
        ring.symbol(Generator::Constant { name: name.into() })
            .unwrap();
    }
    for row in rows(include_str!("../data/algebra/determinants.txt")) {
        let (expected, entries) = row.split_last().unwrap();
        let entry = |row: usize, column: usize| Fraction::from(entries[3 * row + column].clone());
        let found = determinant(&Matrix::from_fn(3, 3, entry), &ring).unwrap();
        assert_eq!(found, expected.clone().into());
    }
}

#[test]
fn gcds() {
    for row in rows(include_str!("../data/algebra/gcds.txt")) {
        let [left, right, gcd] = &*row else {
            panic!("{row:?}")
        };
        assert_eq!(left.gcd(right, &budget()).unwrap(), *gcd);
        assert_eq!(right.gcd(left, &budget()).unwrap(), *gcd);
    }
}

#[test]
fn fractions() {
    for row in rows(include_str!("../data/algebra/fractions.txt")) {
        let [n, d, numerator, denominator] = &*row else {
            panic!("{row:?}")
        };
        let lowest = fraction(n, d);
        assert_eq!(
            (lowest.numerator(), lowest.denominator()),
            (numerator, denominator)
        );
    }
}

#[test]
fn sums_of_fractions() {
    for row in rows(include_str!("../data/algebra/sums.txt")) {
        let [n, d, m, e, numerator, denominator] = &*row else {
            panic!("{row:?}")
        };
        let (left, right) = (fraction(n, d), fraction(m, e));
        let sum = left.sum(&right, &budget()).unwrap();
        assert_eq!(
            (sum.numerator(), sum.denominator()),
            (numerator, denominator)
        );
        let negative = right.negative();
        assert_eq!(left.difference(&negative, &budget()).unwrap(), sum);
    }
}

#[test]
fn square_free_parts() {
    for row in rows(include_str!("../data/algebra/square_free.txt")) {
        let (polynomial, parts) = row.split_first().unwrap();
        let factors = polynomial.square_free(&budget()).unwrap();
        let highest = factors
            .iter()
            .map(|(_, multiplicity)| *multiplicity as usize)
            .max();
        assert_eq!(highest.unwrap_or(0), parts.len());
        for (multiplicity, part) in (1..).zip(parts) {
            let here = factors.iter().filter(|(_, own)| *own == multiplicity);
            let product = here.fold(Polynomial::one(), |product, (factor, _)| {
                product.multiply(factor, &budget()).unwrap()
            });
            assert_eq!(product, *part);
        }
    }
}
