//! Determinants, adjugates, linear systems and null spaces, over fractions with relations.

use proptest::prelude::*;
use sextic::algebra::arithmetic::{Arithmetic, SignedProduct};
use sextic::algebra::determinant::{adjugate, determinant};
use sextic::algebra::error::AlgebraError;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::linear_system::{null_space, solve};
use sextic::algebra::matrix::Matrix;
use sextic::algebra::number::Rational;
use sextic::algebra::ring::Ring;
use sextic::algebra::univariate::Univariate;

use super::field::{self, Done, element};
use super::terms::{Term, World, term, world};

/// Integers as elements of a ring: small enough for the permutations to be summed.
fn numbers(rows: usize, columns: usize, entries: &[i32]) -> Matrix<Fraction> {
    Matrix::from_fn(rows, columns, |row, column| {
        Fraction::from(Rational::from(entries[row * columns + column]))
    })
}

/// Σ over all permutations of the sign and the product.
fn by_permutations(size: usize, entries: &[i32]) -> i64 {
    fn rest(size: usize, entries: &[i32], row: usize, used: &mut Vec<usize>) -> i64 {
        if row == size {
            return 1;
        }
        let mut sum = 0;
        for column in (0..size)
            .filter(|column| !used.contains(column))
            .collect::<Vec<_>>()
        {
            let inversions = used.iter().filter(|earlier| **earlier > column).count();
            used.push(column);
            let product =
                i64::from(entries[row * size + column]) * rest(size, entries, row + 1, used);
            used.pop();
            sum += if inversions % 2 == 0 {
                product
            } else {
                -product
            };
        }
        sum
    }
    rest(size, entries, 0, &mut Vec::new())
}

fn symbolic(
    terms: &[Term],
    size: usize,
    world: &mut World,
) -> Result<Matrix<Fraction>, TestCaseError> {
    Matrix::try_from_fn(size, size, |row, column| {
        element(&terms[row * size + column], world)
    })
}

fn same(ring: &Ring, a: &Matrix<Fraction>, b: &Matrix<Fraction>) -> Result<bool, TestCaseError> {
    let canonical =
        |matrix: &Matrix<Fraction>| matrix.try_map(|entry| ring.canonical(entry)).done();
    Ok(canonical(a)? == canonical(b)?)
}

fn scaled_identity(size: usize, factor: &Fraction, ring: &Ring) -> Matrix<Fraction> {
    Matrix::from_fn(size, size, |row, column| {
        if row == column {
            factor.clone()
        } else {
            ring.zero()
        }
    })
}

fn entries() -> impl Strategy<Value = (usize, usize, Vec<i32>)> {
    (1..=4_usize, 1..=5_usize).prop_flat_map(|(rows, columns)| {
        (
            Just(rows),
            Just(columns),
            prop::collection::vec(-2..=2_i32, rows * columns),
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn determinants_are_sums_over_permutations(size in 1..=5_usize, entries in prop::collection::vec(-3..=3_i32, 25)) {
        let world = World::new((0, 0));
        let matrix = numbers(size, size, &entries);
        let expected = Fraction::from(Rational::from(by_permutations(size, &entries)));
        prop_assert_eq!(determinant(&matrix, &world.ring), Ok(expected.clone()));
        prop_assert_eq!(determinant(&matrix.transpose(), &world.ring), Ok(expected));
    }

    #[test]
    fn null_spaces_have_their_dimension((rows, columns, entries) in entries()) {
        let world = World::new((0, 0));
        let ring = &world.ring;
        let matrix = numbers(rows, columns, &entries);
        let found = null_space(&matrix, ring).done()?;
        // The rank is the size of the largest minor that is not 0.
        let minor = |size: usize| {
            let sets = |count: usize| (0..1_usize << count).filter(move |set| set.count_ones() as usize == size);
            let chosen = |set: usize| (0..5).filter(|place| set >> place & 1 == 1).collect::<Vec<usize>>();
            sets(rows).any(|r| sets(columns).any(|c| {
                let (r, c) = (chosen(r), chosen(c));
                let own: Vec<i32> = r.iter().flat_map(|r| c.iter().map(|c| entries[*r * columns + *c])).collect();
                by_permutations(size, &own) != 0
            }))
        };
        let rank = (1..=rows.min(columns)).rev().find(|size| minor(*size)).unwrap_or(0);
        prop_assert_eq!(found.basis.len(), columns - rank);
        prop_assert_eq!(found.pivots.len(), rank);
        for vector in &found.basis {
            prop_assert!(matrix.product(vector, ring).done()?.entries().iter().all(|entry| entry.is_zero()));
        }
        // A 1 at a place of its own: they are independent.
        for (index, vector) in found.basis.iter().enumerate() {
            let own = (0..columns).any(|place| *vector.at(place, 0) == ring.one()
                && found.basis.iter().enumerate().all(|(other, v)| other == index || v.at(place, 0).is_zero()));
            prop_assert!(own);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_sum_of_products_is_the_products_summed(
        terms in prop::collection::vec((any::<bool>(), term(2), term(2)), 1..4), mut world in world(),
    ) {
        let mut products = Vec::new();
        for (is_negative, left, right) in &terms {
            let [left, right] = [left, right].map(|term| element(term, &mut world));
            products.push(SignedProduct { is_negative: *is_negative, left: left?, right: right? });
        }
        let ring = &world.ring;
        let mut expected = ring.zero();
        for product in &products {
            let term = ring.product(&product.left, &product.right).done()?;
            let term = if product.is_negative { ring.negative(&term) } else { term };
            expected = ring.sum(&expected, &term).done()?;
        }
        let found = ring.sum_of_products(products.into_iter().map(Ok::<_, AlgebraError>)).done()?;
        prop_assert_eq!(found, expected);
    }

    #[test]
    fn the_powers_of_a_determinant_are_those_of_its_unknown(terms in prop::collection::vec(term(1), 8), mut world in world()) {
        let unknown = world.ring.symbol(Generator::Constant { name: "unknown".into() }).unwrap();
        let (a, b) = (symbolic(&terms[..4], 2, &mut world)?, symbolic(&terms[4..], 2, &mut world)?);
        let ring = &world.ring;
        let linear = Matrix::from_fn(2, 2, |row, column| vec![a.at(row, column).clone(), b.at(row, column).clone()]);
        let powers = determinant(&linear, &Univariate(ring)).done()?;
        let unknown = ring.element(unknown);
        let pencil = a.zip_with(&b, |a, b| ring.sum(a, &ring.product(&unknown, b)?)).done()?;
        let value = Univariate(ring).value(&powers, &unknown).done()?;
        prop_assert!(field::same(ring, &value, &determinant(&pencil, ring).done()?)?);
    }

    #[test]
    fn determinants_are_multiplicative(terms in prop::collection::vec(term(2), 8), mut world in world()) {
        let (a, b) = (symbolic(&terms[..4], 2, &mut world)?, symbolic(&terms[4..], 2, &mut world)?);
        let ring = &world.ring;
        let product = determinant(&a.product(&b, ring).done()?, ring).done()?;
        let expected = ring.product(&determinant(&a, ring).done()?, &determinant(&b, ring).done()?).done()?;
        prop_assert!(field::same(ring, &product, &expected)?);
    }

    #[test]
    fn adjugates_times_the_matrix(terms in prop::collection::vec(term(2), 9), size in 1..=3_usize, mut world in world()) {
        let matrix = symbolic(&terms, size, &mut world)?;
        let ring = &world.ring;
        let adjugate = adjugate(&matrix, ring).done()?;
        let expected = scaled_identity(size, &determinant(&matrix, ring).done()?, ring);
        prop_assert!(same(ring, &matrix.product(&adjugate, ring).done()?, &expected)?);
        prop_assert!(same(ring, &adjugate.product(&matrix, ring).done()?, &expected)?);
    }

    #[test]
    fn solutions_solve(terms in prop::collection::vec(term(2), 12), size in 1..=3_usize, mut world in world()) {
        let matrix = symbolic(&terms, size, &mut world)?;
        let right = Matrix::try_from_fn(size, 1, |row, _| element(&terms[9 + row], &mut world))?;
        let ring = &world.ring;
        let solution = solve(&matrix, &right, ring).done()?;
        prop_assert_eq!(&solution.determinant, &determinant(&matrix, ring).done()?);
        let scaled = right.try_map(|entry| ring.product(entry, &solution.determinant)).done()?;
        prop_assert!(same(ring, &matrix.product(&solution.numerators, ring).done()?, &scaled)?);
    }

    #[test]
    fn null_spaces_are_null(terms in prop::collection::vec(term(2), 6), mut world in world()) {
        // The third row is the sum of the first two, so that there is one vector at least.
        let mut rows = Vec::new();
        for term in &terms {
            rows.push(element(term, &mut world)?);
        }
        let ring = &world.ring;
        let matrix = Matrix::try_from_fn(3, 3, |row, column| match row {
            2 => ring.sum(&rows[column], &rows[3 + column]),
            row => Ok(rows[3 * row + column].clone()),
        }).done()?;
        let found = null_space(&matrix, ring).done()?;
        prop_assert!(!found.basis.is_empty());
        prop_assert!(found.pivots.iter().all(|pivot| !pivot.is_zero()));
        for vector in &found.basis {
            prop_assert!(matrix.product(vector, ring).done()?.entries().iter().all(|entry| entry.is_zero()));
        }
    }
}

#[test]
fn entries_are_where_they_were_put() {
    let matrix = Matrix::from_fn(2, 3, |row, column| 10 * row + column);
    assert_eq!(
        (matrix.rows(), matrix.columns(), matrix.shape()),
        (2, 3, (2, 3))
    );
    assert!(!matrix.is_square() && matrix.select(&[0, 1], &[2, 0]).is_square());
    assert_eq!(matrix.entries(), [0, 1, 2, 10, 11, 12]);
    assert_eq!(*matrix.at(1, 2), 12);
    assert_eq!(matrix.transpose().entries(), [0, 10, 1, 11, 2, 12]);
    assert_eq!(matrix.select(&[1], &[2, 0]).entries(), [12, 10]);
    assert_eq!(
        matrix.map(|entry| entry + 1).entries(),
        [1, 2, 3, 11, 12, 13]
    );
    let zipped = matrix
        .zip_with(&matrix, |a, b| Ok::<usize, ()>(a + b))
        .unwrap();
    assert_eq!(zipped, matrix.map(|entry| 2 * entry));
    assert_eq!(
        matrix.try_map(|entry| if *entry < 12 { Ok(*entry) } else { Err("late") }),
        Err("late")
    );
}
