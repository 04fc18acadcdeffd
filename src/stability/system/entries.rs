//! The matrices of a system over any numbers.

use super::error::SystemError;
use super::{MOST_COORDINATES, System};

/// The places of some coordinates, in order.
pub(super) type Block = Vec<usize>;

/// M, and the parts of C and K: each a list of entries, row by row.
#[derive(Clone, Debug)]
pub(super) struct Entries<T> {
    pub mass: Vec<T>,
    pub damping: Vec<Vec<T>>,
    pub stiffness: Vec<Vec<T>>,
}

impl<T: Clone> Entries<T> {
    /// The matrices that the outputs of a program are.
    pub fn new(system: &System, outputs: &[T]) -> Option<Self> {
        let size = system.coordinates.len();
        let mut matrices = outputs.chunks(size * size).map(<[T]>::to_vec);
        let mass = matrices.next()?;
        let damping = matrices.by_ref().take(system.damping.len()).collect();
        Some(Entries {
            mass,
            damping,
            stiffness: matrices.collect(),
        })
    }

    /// M, C and K, where C and K are the sums of their parts.
    pub fn sums<E>(
        &self,
        zero: &T,
        sum: impl Fn(&T, &T) -> Result<T, E>,
    ) -> Result<Matrices<T>, E> {
        let total = |parts: &[Vec<T>]| -> Result<Vec<T>, E> {
            let none = vec![zero.clone(); self.mass.len()];
            parts.iter().try_fold(none, |total, part| {
                total.iter().zip(part).map(|(a, b)| sum(a, b)).collect()
            })
        };
        Ok(Matrices {
            size: self.mass.len().isqrt(),
            powers: [
                total(&self.stiffness)?,
                total(&self.damping)?,
                self.mass.clone(),
            ],
        })
    }

    /// The matrices of the images of the entries.
    pub fn map<U>(&self, image: impl Fn(&T) -> U) -> Entries<U> {
        let matrix = |own: &Vec<T>| own.iter().map(&image).collect();
        Entries {
            mass: matrix(&self.mass),
            damping: self.damping.iter().map(matrix).collect(),
            stiffness: self.stiffness.iter().map(matrix).collect(),
        }
    }
}

/// K, C and M, each row by row: λ⁰, λ¹ and λ² in λ²M + λC + K.
#[derive(Clone, Debug)]
pub(super) struct Matrices<T> {
    /// n
    pub size: usize,
    /// K, C and M.
    pub powers: [Vec<T>; 3],
}

impl<T: Clone> Matrices<T> {
    /// The entry of the matrix that stands with this power of λ.
    pub fn at(&self, power: usize, row: usize, column: usize) -> &T {
        &self.powers[power][row * self.size + column]
    }

    /// The rows and columns of a block.
    pub fn block(&self, block: &Block) -> Self {
        let select = |power: usize| -> Vec<T> {
            let places = block
                .iter()
                .flat_map(|row| block.iter().map(move |column| (*row, *column)));
            places
                .map(|(row, column)| self.at(power, row, column).clone())
                .collect()
        };
        Matrices {
            size: block.len(),
            powers: [0, 1, 2].map(select),
        }
    }

    /// The matrices of the images of the entries: of their power of λ, row, column and value.
    pub fn map<U>(&self, image: impl Fn([usize; 3], &T) -> U) -> Matrices<U> {
        let matrix = |power: usize| {
            let entries = self.powers[power].iter().enumerate();
            let place = |index: usize| [power, index / self.size, index % self.size];
            entries
                .map(|(index, own)| image(place(index), own))
                .collect()
        };
        Matrices {
            size: self.size,
            powers: [0, 1, 2].map(matrix),
        }
    }
}

/// Checks that a program has the outputs that the matrices of a system need.
pub(super) fn check(system: &System) -> Result<(), SystemError> {
    let size = system.coordinates.len();
    if size == 0 || size > MOST_COORDINATES {
        return Err(SystemError::Coordinates { found: size });
    }
    let matrices = 1 + system.damping.len() + system.stiffness.len();
    let (found, expected) = (
        system.evaluator.program.outputs().len(),
        matrices * size * size,
    );
    match found == expected {
        true => Ok(()),
        false => Err(SystemError::Outputs { found, expected }),
    }
}
