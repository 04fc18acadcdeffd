//! Whole numbers modulo a large prime.

use super::number::Integer;
use super::symbol::Symbol;

/// The prime 2^61 - 1; it is 3 modulo 4.
pub const PRIME: u64 = (1 << 61) - 1;

/// The residue of an integer.
pub fn residue(integer: &Integer) -> u64 {
    (integer % PRIME as i64).rem_euclid(PRIME as i64) as u64
}

/// Reduces a number below twice the prime.
pub fn reduce(value: u64) -> u64 {
    value.checked_sub(PRIME).unwrap_or(value)
}

/// a·b of two residues.
pub fn times(left: u64, right: u64) -> u64 {
    let product = u128::from(left) * u128::from(right);
    // 2^61 is 1 modulo the prime.
    reduce((product as u64 & PRIME) + (product >> 61) as u64)
}

/// A power of a residue.
pub fn power(base: u64, exponent: impl Into<u64>) -> u64 {
    let mut exponent = exponent.into();
    let (mut power, mut square) = (1, base);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = times(power, square);
        }
        square = times(square, square);
        exponent >>= 1;
    }
    power
}

/// −a of a residue.
pub fn negative(value: u64) -> u64 {
    reduce(PRIME - value)
}

/// 1/a of a residue; none of 0.
pub fn inverse(value: u64) -> Option<u64> {
    (value != 0).then(|| power(value, PRIME - 2))
}

/// One of the two roots of a residue; none if it is no square.
pub fn square_root(value: u64) -> Option<u64> {
    let root = power(value, PRIME.div_ceil(4));
    (times(root, root) == value).then_some(root)
}

/// The numbers modulo one of a few primes just below 2^61, and polynomials in one symbol over them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field {
    prime: u64,
}

/// What the primes lack of 2^61.
const GAPS: [u64; 7] = [1, 31, 45, 229, 259, 283, 339];

impl Field {
    /// The field modulo [`PRIME`], which is the fastest.
    pub const FIRST: Field = Field { prime: PRIME };

    /// All of them, [`Field::FIRST`] first.
    pub fn all() -> impl Iterator<Item = Field> {
        GAPS.iter().map(|gap| Field {
            prime: (1 << 61) - gap,
        })
    }

    /// The number of elements.
    pub fn prime(self) -> u64 {
        self.prime
    }

    /// The residue of an integer.
    pub fn residue(self, integer: &Integer) -> u64 {
        (integer % self.prime as i64).rem_euclid(self.prime as i64) as u64
    }

    /// a + b
    pub fn sum(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        sum.checked_sub(self.prime).unwrap_or(sum)
    }

    /// a − b
    pub fn difference(self, a: u64, b: u64) -> u64 {
        self.sum(a, self.prime - b)
    }

    /// a·b
    pub fn times(self, a: u64, b: u64) -> u64 {
        if self.prime == PRIME {
            return times(a, b);
        }
        (u128::from(a) * u128::from(b) % u128::from(self.prime)) as u64
    }

    /// aⁿ
    pub fn power(self, base: u64, mut exponent: u64) -> u64 {
        let (mut power, mut square) = (1, base);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.times(power, square);
            }
            exponent >>= 1;
            if exponent > 0 {
                square = self.times(square, square);
            }
        }
        power
    }

    /// 1/a, and 0 for 0.
    pub fn inverse(self, a: u64) -> u64 {
        self.power(a, self.prime - 2)
    }

    /// One of the numbers that are put for a symbol, each one more than the one before: arbitrary but
    /// fixed ones, from the mixing function of SplitMix64.
    pub fn node(self, symbol: Symbol, place: usize) -> u64 {
        let mut mixed = (symbol.index() as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        self.sum(mixed % (self.prime - 1) + 1, place as u64)
    }

    /// The gcd of two polynomials in one symbol but for a factor, all given by their coefficients from
    /// the lowest, the last of them not zero.
    pub fn gcd(self, mut left: Vec<u64>, mut right: Vec<u64>) -> Vec<u64> {
        while let Some(&leading) = right.last() {
            // Both are multiplied across, since an inverse costs ninety products.
            while left.len() >= right.len() {
                let Some(top) = left.pop() else { break };
                left.iter_mut()
                    .for_each(|value| *value = self.times(leading, *value));
                let low = left.len() + 1 - right.len();
                for (value, partner) in left[low..].iter_mut().zip(&right) {
                    *value = self.difference(*value, self.times(top, *partner));
                }
            }
            trim(&mut left);
            (left, right) = (right, left);
        }
        left
    }
}

/// Whether a number is a prime.
///
/// Rabin's test to the bases up to 37 is a proof below 3·10²³.
pub fn is_prime(number: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if number < 2 || BASES.iter().any(|base| number.is_multiple_of(*base)) {
        return BASES.contains(&number);
    }
    let (field, twos) = (Field { prime: number }, (number - 1).trailing_zeros());
    BASES.iter().all(|base| {
        let first = field.power(*base, (number - 1) >> twos);
        let squares = std::iter::successors(Some(first), |power| Some(field.times(*power, *power)));
        first == 1 || squares.take(twos as usize).any(|power| power == number - 1)
    })
}

/// Takes leading zeros away.
pub(super) fn trim(coefficients: &mut Vec<u64>) {
    let top = coefficients.iter().rposition(|&value| value != 0);
    coefficients.truncate(top.map_or(0, |top| top + 1));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_one_of_a_prime() {
        for field in Field::all() {
            assert!(is_prime(field.prime()));
            assert_eq!(field.times(3, field.inverse(3)), 1);
            assert_eq!(field.residue(&Integer::from(-1)), field.prime() - 1);
            assert_eq!(field.difference(1, 2), field.prime() - 1);
        }
    }

    #[test]
    fn primes_are_told_from_other_numbers() {
        let divides = |number: u64| (2..number).any(|divisor| number.is_multiple_of(divisor));
        for number in 0..2_000 {
            assert_eq!(is_prime(number), number > 1 && !divides(number), "{number}");
        }
        // Products of two large primes, and numbers that pass the test to some of the bases.
        for number in [
            1_373_653,
            3_215_031_751,
            3_825_123_056_546_413_051,
            4_294_967_291 * 2_147_483_647,
        ] {
            assert!(!is_prime(number), "{number}");
        }
        assert!(is_prime((1 << 61) - 1));
    }

    #[test]
    fn the_field_is_a_field() {
        for value in [1, 2, 3, PRIME / 2, PRIME - 2, PRIME - 1] {
            assert_eq!(inverse(value).map(|inverse| times(value, inverse)), Some(1));
            assert_eq!(reduce(value + (PRIME - value)), 0);
        }
        assert_eq!(residue(&Integer::from(-1)), PRIME - 1);
        assert_eq!(residue(&(Integer::ONE << 61)), 1);
        assert_eq!(residue(&-(Integer::ONE << 122)), PRIME - 1);
    }

    #[test]
    fn one_of_two_opposites_has_a_root() {
        for value in [1, 2, 3, 5, PRIME / 2] {
            let root = square_root(value).or_else(|| square_root(negative(value)));
            let square = root.map(|root| times(root, root));
            assert!(square == Some(value) || square == Some(negative(value)));
            assert_ne!(
                square_root(value).is_some(),
                square_root(negative(value)).is_some()
            );
        }
        assert_eq!(inverse(0), None);
        assert_eq!(negative(0), 0);
    }
}
