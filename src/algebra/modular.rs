//! Whole numbers modulo a large prime.

use super::number::Integer;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_is_a_field() {
        for value in [1, 2, 3, PRIME / 2, PRIME - 2, PRIME - 1] {
            assert_eq!(times(value, power(value, PRIME - 2)), 1);
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
