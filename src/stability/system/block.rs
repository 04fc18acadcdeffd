//! Coordinates that move together: the diagonal blocks of matrices that are triangular in blocks.

use super::entries::{Block, Matrices};
use super::real::Real;

/// The coarsest blocks that do not come apart: with rows and columns in some order, λ²M + λC + K is triangular in
/// blocks, so that its determinant is the product of theirs, and an eigenvalue of it is one of a block.
///
/// Only what is exactly 0 sets coordinates apart. Complexity: n³ for n coordinates.
pub(super) fn blocks(matrices: &Matrices<Real>) -> Vec<Block> {
    let size = matrices.size;
    let mut reaches: Vec<Vec<bool>> = (0..size)
        .map(|row| {
            (0..size)
                .map(|column| row == column || is_coupled(matrices, row, column))
                .collect()
        })
        .collect();
    for middle in 0..size {
        for from in 0..size {
            for to in 0..size {
                reaches[from][to] |= reaches[from][middle] && reaches[middle][to];
            }
        }
    }
    let together = |first: usize| -> Block {
        (0..size)
            .filter(|other| reaches[first][*other] && reaches[*other][first])
            .collect()
    };
    (0..size)
        .map(together)
        .enumerate()
        .filter(|(own, block)| block.first() == Some(own))
        .map(|(_, block)| block)
        .collect()
}

fn is_coupled(matrices: &Matrices<Real>, row: usize, column: usize) -> bool {
    (0..3).any(|power| !matrices.at(power, row, column).is_zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_couplings(size: usize, couplings: &[(usize, usize)]) -> Vec<Block> {
        let entry = |index: usize| {
            let place = (index / size, index % size);
            let is_there = place.0 == place.1 || couplings.contains(&place);
            if is_there { Real::ONE } else { Real::ZERO }
        };
        let zero = vec![Real::ZERO; size * size];
        let stiffness = (0..size * size).map(entry).collect();
        blocks(&Matrices {
            size,
            powers: [stiffness, zero.clone(), zero],
        })
    }

    #[test]
    fn what_moves_together_is_one_block() {
        for (couplings, expected) in [
            (vec![], vec![vec![0], vec![1], vec![2], vec![3]]),
            // One way only: triangular.
            (
                vec![(0, 1), (1, 2), (0, 3)],
                vec![vec![0], vec![1], vec![2], vec![3]],
            ),
            (
                vec![(0, 2), (2, 0), (1, 2)],
                vec![vec![0, 2], vec![1], vec![3]],
            ),
            // In a circle.
            (vec![(0, 1), (1, 2), (2, 0)], vec![vec![0, 1, 2], vec![3]]),
            (
                vec![(3, 1), (1, 0), (0, 3), (2, 3)],
                vec![vec![0, 1, 3], vec![2]],
            ),
        ] {
            assert_eq!(with_couplings(4, &couplings), expected, "{couplings:?}");
        }
    }
}
