//! Approximate eigenvalues of a small real matrix, without memory and in a bounded number of steps.
//!
//! Elimination brings the matrix to Hessenberg form, and double steps with implicit shifts (Francis) to 1×1 and 2×2
//! blocks. How good the values are is for the caller to find out.

use num_complex::Complex;

/// A square matrix of which the first rows and columns count.
pub(super) type Matrix<const N: usize> = [[f64; N]; N];

/// The most double steps for one block.
const MOST_STEPS: usize = 30;

/// The eigenvalues of the first `size` rows and columns, complex ones in conjugate pairs, that with the positive
/// imaginary part first; `None` if they do not come apart.
///
/// Complexity: some 10 n³ operations, at most 60 n³.
pub(super) fn eigenvalues<const N: usize>(
    size: usize,
    matrix: &Matrix<N>,
) -> Option<[Complex<f64>; N]> {
    let mut own = Francis {
        rows: *matrix,
        shift: 0.0,
        values: [Complex::ZERO; N],
    };
    own.reduce(size);
    let norm: f64 = own.rows[..size]
        .iter()
        .flat_map(|row| &row[..size])
        .map(|entry| entry.abs())
        .sum();
    if !norm.is_finite() {
        return None;
    }
    let (mut end, mut steps) = (size, 0);
    while end > 0 {
        let first = own.first_of_block(end, norm);
        match end - first {
            1 => own.values[first] = Complex::new(own.rows[first][first] + own.shift, 0.0),
            2 => own.take_pair(first),
            _ if steps == MOST_STEPS => return None,
            _ => {
                own.step(first, end, steps);
                steps += 1;
                continue;
            }
        }
        (end, steps) = (first, 0);
    }
    own.values[..size]
        .iter()
        .all(|own| own.is_finite())
        .then_some(own.values)
}

/// A matrix while it comes apart.
struct Francis<const N: usize> {
    rows: Matrix<N>,
    /// What was subtracted from the diagonal.
    shift: f64,
    values: [Complex<f64>; N],
}

impl<const N: usize> Francis<N> {
    /// To Hessenberg form, by elimination with pivots.
    fn reduce(&mut self, size: usize) {
        for step in 1..size.saturating_sub(1) {
            let size_of = |row: &usize| self.rows[*row][step - 1].abs();
            let pivot = (step..size)
                .max_by(|a, b| size_of(a).total_cmp(&size_of(b)))
                .unwrap_or(step);
            self.rows.swap(pivot, step);
            for row in &mut self.rows[..size] {
                row.swap(pivot, step);
            }
            let own = self.rows[step];
            if own[step - 1] == 0.0 {
                continue;
            }
            let mut factors = [0.0; N];
            for (row, factor) in self.rows[..size]
                .iter_mut()
                .zip(&mut factors)
                .skip(step + 1)
            {
                *factor = row[step - 1] / own[step - 1];
                for (entry, above) in row[..size].iter_mut().zip(&own).skip(step - 1) {
                    *entry -= *factor * above;
                }
                row[step - 1] = 0.0;
            }
            for row in &mut self.rows[..size] {
                row[step] += row[step + 1..size]
                    .iter()
                    .zip(&factors[step + 1..size])
                    .map(|(entry, factor)| entry * factor)
                    .sum::<f64>();
            }
        }
    }

    /// Where the last block begins before `end`: behind an entry below the diagonal that is nothing.
    fn first_of_block(&mut self, end: usize, norm: f64) -> usize {
        for place in (1..end).rev() {
            let beside = self.rows[place - 1][place - 1].abs() + self.rows[place][place].abs();
            let beside = if beside == 0.0 { norm } else { beside };
            if self.rows[place][place - 1].abs() <= f64::EPSILON * beside {
                self.rows[place][place - 1] = 0.0;
                return place;
            }
        }
        0
    }

    /// The two eigenvalues of a 2×2 block.
    fn take_pair(&mut self, first: usize) {
        let (a, d) = (self.rows[first][first], self.rows[first + 1][first + 1]);
        let product = self.rows[first + 1][first] * self.rows[first][first + 1];
        let half = (a - d) / 2.0;
        let square = half * half + product;
        let root = square.abs().sqrt();
        let centre = d + self.shift;
        let [one, other] = match square >= 0.0 {
            true => {
                let far = half + root.copysign(half);
                let near = if far == 0.0 { 0.0 } else { -product / far };
                [far, near].map(|own| Complex::new(centre + own, 0.0))
            }
            false => [root, -root].map(|own| Complex::new(centre + half, own)),
        };
        (self.values[first], self.values[first + 1]) = (one, other);
    }

    /// One double step on the block of the rows from `first` to `end`.
    fn step(&mut self, first: usize, end: usize, steps: usize) {
        let last = end - 1;
        let (mut x, mut y) = (self.rows[last][last], self.rows[last - 1][last - 1]);
        let mut w = self.rows[last][last - 1] * self.rows[last - 1][last];
        if steps == 10 || steps == 20 {
            // An exceptional shift.
            self.shift += x;
            (0..end).for_each(|place| self.rows[place][place] -= x);
            let size = self.rows[last][last - 1].abs() + self.rows[last - 1][last - 2].abs();
            (x, y, w) = (0.75 * size, 0.75 * size, -0.4375 * size * size);
        }
        let (start, mut vector) = self.start(first, last, [x, y, w]);
        for row in start + 2..end {
            self.rows[row][row - 2] = 0.0;
            if row > start + 2 {
                self.rows[row][row - 3] = 0.0;
            }
        }
        for place in start..last {
            let mut size = 0.0;
            if place > start {
                let below = if place + 1 < last {
                    self.rows[place + 2][place - 1]
                } else {
                    0.0
                };
                vector = [
                    self.rows[place][place - 1],
                    self.rows[place + 1][place - 1],
                    below,
                ];
                size = vector.iter().map(|own| own.abs()).sum();
                if size != 0.0 {
                    vector = vector.map(|own| own / size);
                }
            }
            let norm = vector
                .iter()
                .map(|own| own * own)
                .sum::<f64>()
                .sqrt()
                .copysign(vector[0]);
            if norm == 0.0 {
                continue;
            }
            if place > start {
                self.rows[place][place - 1] = -norm * size;
            } else if first != start {
                self.rows[place][place - 1] = -self.rows[place][place - 1];
            }
            self.reflect(first, last, place, vector, norm);
        }
    }

    /// Where two entries below the diagonal in a row are small together, and the first column of the double step there.
    fn start(&self, first: usize, last: usize, [x, y, w]: [f64; 3]) -> (usize, [f64; 3]) {
        let rows = &self.rows;
        let mut place = last - 2;
        loop {
            let z = rows[place][place];
            let (r, s) = (x - z, y - z);
            let p = (r * s - w) / rows[place + 1][place] + rows[place][place + 1];
            let q = rows[place + 1][place + 1] - z - r - s;
            let vector = [p, q, rows[place + 2][place + 1]];
            let size: f64 = vector.iter().map(|own| own.abs()).sum();
            let vector = vector.map(|own| own / size);
            if place == first {
                return (place, vector);
            }
            let small = rows[place][place - 1].abs() * (vector[1].abs() + vector[2].abs());
            let large = vector[0].abs()
                * (rows[place - 1][place - 1].abs() + z.abs() + rows[place + 1][place + 1].abs());
            if small <= f64::EPSILON * large {
                return (place, vector);
            }
            place -= 1;
        }
    }

    /// A reflection of three rows and columns, or two at the end.
    fn reflect(&mut self, first: usize, last: usize, place: usize, [p, q, r]: [f64; 3], norm: f64) {
        let p = p + norm;
        let (x, y, z) = (p / norm, q / norm, r / norm);
        let (q, r) = (q / p, r / p);
        let has_third = place + 1 < last;
        let [one, two, three] = [
            place,
            place + 1,
            if has_third { place + 2 } else { place + 1 },
        ];
        let [mut above, mut middle, mut below] = [self.rows[one], self.rows[two], self.rows[three]];
        for column in place..=last {
            let third = if has_third { r * below[column] } else { 0.0 };
            let sum = above[column] + q * middle[column] + third;
            above[column] -= sum * x;
            middle[column] -= sum * y;
            below[column] -= sum * z;
        }
        self.rows[one] = above;
        if has_third {
            self.rows[three] = below;
        }
        self.rows[two] = middle;
        for row in &mut self.rows[first..=last.min(place + 3)] {
            let third = if has_third { z * row[three] } else { 0.0 };
            let sum = x * row[one] + y * row[two] + third;
            if has_third {
                row[three] -= sum * r;
            }
            row[two] -= sum * q;
            row[one] -= sum;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST: usize = 16;
    use proptest::prelude::*;

    /// |A − λI| by elimination.
    fn determinant(size: usize, matrix: &Matrix<MOST>, value: Complex<f64>) -> Complex<f64> {
        let mut rows = matrix.map(|row| row.map(|own| Complex::new(own, 0.0)));
        let mut product = Complex::ONE;
        (0..size).for_each(|step| rows[step][step] -= value);
        for step in 0..size {
            let pivot = (step..size)
                .max_by(|a, b| rows[*a][step].norm().total_cmp(&rows[*b][step].norm()))
                .unwrap();
            rows.swap(step, pivot);
            let own = rows[step];
            product *= own[step] * if pivot == step { 1.0 } else { -1.0 };
            for row in &mut rows[step + 1..size] {
                let factor = row[step] / own[step];
                (step..size).for_each(|column| row[column] -= factor * own[column]);
            }
        }
        product
    }

    proptest! {
        /// Π (z − λ) is the determinant at any z.
        #[test]
        fn the_characteristic_polynomial_has_these_roots(
            entries in prop::collection::vec(-1.0..1.0f64, MOST * MOST), size in 1..=MOST, zeros in 0_usize..4,
        ) {
            let mut matrix: Matrix<MOST> = std::array::from_fn(|i| std::array::from_fn(|j| entries[i * MOST + j]));
            (0..zeros * size).for_each(|place| matrix[(place * 7) % size][(place * 5) % size] = 0.0);
            let values = eigenvalues(size, &matrix).unwrap();
            for at in [Complex::new(3.0, 1.0), Complex::new(-2.5, 0.0), Complex::new(0.0, 4.0)] {
                let product: Complex<f64> = values[..size].iter().map(|own| own - at).product();
                let expected = determinant(size, &matrix, at);
                prop_assert!((product - expected).norm() <= 1e-10 * (expected.norm() + 1.0), "{product} {expected}");
            }
            let sum: Complex<f64> = values[..size].iter().sum();
            prop_assert!(sum.im == 0.0);
        }
    }

    #[test]
    fn groups_of_equal_size_come_apart() {
        // A permutation: roots of 1.
        for size in 1..=MOST {
            let mut matrix = [[0.0; MOST]; MOST];
            (0..size).for_each(|row| matrix[row][(row + 1) % size] = 1.0);
            let values = eigenvalues(size, &matrix).unwrap();
            for own in &values[..size] {
                assert!((own.powu(size as u32) - 1.0).norm() < 1e-12);
            }
        }
        assert!(eigenvalues(3, &[[f64::NAN; MOST]; MOST]).is_none());
    }
}
