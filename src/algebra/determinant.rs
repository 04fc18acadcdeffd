//! Determinants and adjugates without division.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::arithmetic::{Arithmetic, SignedProduct};
use super::matrix::Matrix;

/// |A| of a square matrix, by expansion along the rows with every minor computed once.
///
/// |A| = Σ_j (−1)ʲ a₀ⱼ |A without row 0 and column j|, and the minors of the lower rows are shared
/// between the branches. Nothing is divided, so it serves every commutative ring.
///
/// Complexity: n·2ⁿ⁻¹ products for n rows; negligible entries cost nothing.
///
/// # Errors
///
/// Those of the arithmetic.
///
/// # Panics
///
/// If the matrix is not square.
///
/// ```
/// use sextic::algebra::{
///     budget::Budget, determinant::determinant, fraction::Fraction, matrix::Matrix,
///     number::Rational, ring::Ring,
/// };
///
/// let ring = Ring::new(Budget::new(10_000));
/// let number = |n: usize| Fraction::from(Rational::from(n));
/// // |1 2; 3 5| = −1
/// let matrix = Matrix::from_fn(2, 2, |row, column| number([[1, 2], [3, 5]][row][column]));
/// assert_eq!(determinant(&matrix, &ring)?, number(1).negative());
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
pub fn determinant<A: Arithmetic>(
    matrix: &Matrix<A::Element>,
    arithmetic: &A,
) -> Result<A::Element, A::Error> {
    assert!(
        matrix.is_square(),
        "the matrix has {} rows, {} columns",
        matrix.rows(),
        matrix.columns()
    );
    let columns: Vec<usize> = (0..matrix.columns()).collect();
    let mut minors = Minors {
        matrix,
        is_turned: false,
        arithmetic,
        known: BTreeMap::new(),
    };
    minors.expanded(0, &columns)
}

/// The determinants of the first k rows and columns of a square matrix, k from 1 on, each as it is asked for.
///
/// Turned round, they are minors of the last rows, which [`determinant`] shares: all together cost no more than the last.
///
/// # Errors
///
/// Those of the arithmetic.
///
/// # Panics
///
/// If the matrix is not square.
///
/// ```
/// use sextic::algebra::{
///     budget::Budget, determinant::leading_minors, fraction::Fraction, matrix::Matrix,
///     number::Rational, ring::Ring,
/// };
///
/// let ring = Ring::new(Budget::new(10_000));
/// let number = |n: i32| Fraction::from(Rational::from(n));
/// // 1 and |1 2; 3 5| = −1
/// let matrix = Matrix::from_fn(2, 2, |row, column| number([[1, 2], [3, 5]][row][column]));
/// let minors: Vec<_> = leading_minors(&matrix, &ring).collect::<Result<_, _>>()?;
/// assert_eq!(minors, [number(1), number(-1)]);
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
pub fn leading_minors<'a, A: Arithmetic>(
    matrix: &'a Matrix<A::Element>,
    arithmetic: &'a A,
) -> impl Iterator<Item = Result<A::Element, A::Error>> {
    assert!(
        matrix.is_square(),
        "the matrix has {} rows, {} columns",
        matrix.rows(),
        matrix.columns()
    );
    let size = matrix.rows();
    let mut minors = Minors {
        matrix,
        is_turned: true,
        arithmetic,
        known: BTreeMap::new(),
    };
    let columns: Vec<usize> = (0..size).collect();
    (0..size).rev().map(move |first| {
        let minor = minors.minor(first, &columns[first..])?;
        Ok(A::Element::clone(&minor))
    })
}

/// The minors of the last rows of a matrix, each computed once.
struct Minors<'a, A: Arithmetic> {
    matrix: &'a Matrix<A::Element>,
    /// Whether rows and columns count from the last one.
    is_turned: bool,
    arithmetic: &'a A,
    known: BTreeMap<Vec<usize>, Rc<A::Element>>,
}

impl<'a, A: Arithmetic> Minors<'a, A> {
    fn entry(&self, row: usize, column: usize) -> &'a A::Element {
        match self.is_turned {
            true => {
                let last = self.matrix.rows() - 1;
                self.matrix.at(last - row, last - column)
            }
            false => self.matrix.at(row, column),
        }
    }

    /// The minor of the rows from `row` on and as many columns.
    fn minor(&mut self, row: usize, columns: &[usize]) -> Result<Rc<A::Element>, A::Error> {
        if let Some(known) = self.known.get(columns) {
            return Ok(known.clone());
        }
        let minor = Rc::new(self.expanded(row, columns)?);
        self.known.insert(columns.to_vec(), minor.clone());
        Ok(minor)
    }

    /// The same by its first row, as one sum.
    fn expanded(&mut self, row: usize, columns: &[usize]) -> Result<A::Element, A::Error> {
        match columns {
            [] => return Ok(self.arithmetic.one()),
            [last] => return Ok(self.entry(row, *last).clone()),
            _ => (),
        }
        let arithmetic = self.arithmetic;
        let entries: Vec<&A::Element> = columns.iter().map(|own| self.entry(row, *own)).collect();
        let entries = entries.into_iter().enumerate();
        let products = entries.filter(|(_, entry)| !arithmetic.is_negligible(entry));
        arithmetic.sum_of_products(products.map(|(place, left)| {
            Ok(SignedProduct {
                is_negative: place % 2 == 1,
                left,
                right: self.minor(
                    row + 1,
                    &[&columns[..place], &columns[place + 1..]].concat(),
                )?,
            })
        }))
    }
}

/// adj A of a square matrix: A·adj A = |A|·I.
///
/// (adj A)ᵢⱼ = (−1)ⁱ⁺ʲ |A without row j and column i|.
///
/// Complexity: n² determinants of n − 1 rows, for n rows.
///
/// # Errors
///
/// Those of the arithmetic.
///
/// # Panics
///
/// If the matrix is not square.
///
/// ```
/// use sextic::algebra::{
///     budget::Budget, determinant::adjugate, fraction::Fraction, matrix::Matrix,
///     number::Rational, ring::Ring,
/// };
///
/// let ring = Ring::new(Budget::new(10_000));
/// let matrix = |entries: [[i32; 2]; 2]| {
///     Matrix::from_fn(2, 2, |i, j| Fraction::from(Rational::from(entries[i][j])))
/// };
/// assert_eq!(adjugate(&matrix([[1, 2], [3, 5]]), &ring)?, matrix([[5, -2], [-3, 1]]));
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
pub fn adjugate<A: Arithmetic>(
    matrix: &Matrix<A::Element>,
    arithmetic: &A,
) -> Result<Matrix<A::Element>, A::Error> {
    assert!(
        matrix.is_square(),
        "the matrix has {} rows, {} columns",
        matrix.rows(),
        matrix.columns()
    );
    let size = matrix.rows();
    if size == 1 {
        return Ok(Matrix::from_fn(1, 1, |_, _| arithmetic.one()));
    }
    let without =
        |left_out: usize| -> Vec<usize> { (0..size).filter(|k| *k != left_out).collect() };
    Matrix::try_from_fn(size, size, |row, column| {
        // The transpose: the cofactor of (column, row).
        let minor = determinant(&matrix.select(&without(column), &without(row)), arithmetic)?;
        Ok(if (row + column) % 2 == 0 {
            minor
        } else {
            arithmetic.negative(&minor)
        })
    })
}
