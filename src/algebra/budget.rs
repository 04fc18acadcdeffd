//! The bounds on what a computation may cost.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

use dashu_base::BitTest;

use super::number::Integer;

/// The most terms one polynomial may have.
pub const MOST_TERMS: usize = 500_000;

/// The most binary digits one integer may have.
pub const MOST_BITS: usize = 1 << 20;

/// The largest exponent of a symbol in a monomial.
pub const LARGEST_EXPONENT: u32 = u16::MAX as u32;

/// A supply of steps that a computation draws from as it goes.
///
/// A step is about one product of two terms with coefficients of one machine
/// word each. Coefficients of `v` and `w` words cost `v·w` steps. Counting
/// steps instead of seconds makes the outcome the same on every machine.
///
/// What is kept costs steps, too, so that a supply bounds the memory of a
/// computation. Whatever the supply, there are at most [`MOST_TERMS`] terms in a
/// polynomial, [`MOST_BITS`] bits in an integer and [`LARGEST_EXPONENT`] as an
/// exponent.
///
/// ```
/// use sextic::algebra::budget::Budget;
///
/// let budget = Budget::new(10);
/// assert!(budget.spend(7).is_ok());
/// assert!(budget.spend(7).is_err());
/// budget.refill();
/// assert!(budget.spend(7).is_ok());
/// ```
#[derive(Debug)]
pub struct Budget {
    limit: u64,
    remaining: Supply,
    /// What all computations together may still take.
    reserve: Supply,
}

/// Steps that are left. One computation at a time draws from it, so that no order of threads matters.
#[derive(Debug)]
struct Supply(AtomicU64);

impl Supply {
    const fn new(steps: u64) -> Self {
        Supply(AtomicU64::new(steps))
    }

    fn get(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }

    fn set(&self, steps: u64) {
        self.0.store(steps, Ordering::Relaxed);
    }
}

impl Clone for Budget {
    /// A supply with as much left.
    fn clone(&self) -> Self {
        Budget {
            limit: self.limit,
            remaining: Supply::new(self.remaining.get()),
            reserve: Supply::new(self.reserve.get()),
        }
    }
}

/// So many full supplies are there in all: a step takes up to 50 ns, and what is kept costs 20 steps for
/// each term of 80 bytes, so that no document takes much more than 10 s, or 1 GiB for its elements.
const SUPPLIES: u64 = 4;

impl Budget {
    /// A supply of `limit` steps.
    pub const fn new(limit: u64) -> Self {
        Budget {
            limit,
            remaining: Supply::new(limit),
            reserve: Supply::new(limit.saturating_mul(SUPPLIES)),
        }
    }

    /// A supply of steps that no computation lives to use up.
    pub const fn unlimited() -> Self {
        Budget::new(u64::MAX)
    }

    /// The number of steps of a full supply.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// The number of steps that were taken from a full supply.
    #[cfg(test)]
    pub(super) fn spent(&self) -> u64 {
        self.limit - self.remaining.get()
    }

    /// Makes the supply full again, for the next computation; after some full ones were used up, there
    /// is none.
    pub fn refill(&self) {
        self.remaining.set(self.limit.min(self.reserve.get()));
    }

    /// Takes `steps` from the supply.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if fewer are left; then none are left afterwards, so that
    /// smaller computations do not slip through once a large one has failed.
    pub fn spend(&self, steps: u64) -> Result<(), Exhausted> {
        let (remaining, reserve) = (self.remaining.get(), self.reserve.get());
        let left = remaining.checked_sub(steps);
        self.remaining.set(left.unwrap_or(0));
        self.reserve
            .set(reserve - remaining.min(steps).min(reserve));
        match left {
            Some(_) => Ok(()),
            None if self.reserve.get() == 0 => Err(Exhausted {
                resource: Resource::AllSteps,
                limit: self.limit.saturating_mul(SUPPLIES),
            }),
            None => Err(Exhausted {
                resource: Resource::Steps,
                limit: self.limit,
            }),
        }
    }
}

/// What there was not enough of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resource {
    /// Steps of a [`Budget`].
    Steps,
    /// Steps of a [`Budget`] for all computations together.
    AllSteps,
    /// Terms of a polynomial.
    Terms,
    /// Bits of an integer.
    Bits,
    /// The size of an exponent.
    Exponent,
}

/// A computation was given up because it would have gone beyond a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhausted {
    /// What there was not enough of.
    pub resource: Resource,
    /// How much there was of it.
    pub limit: u64,
}

impl fmt::Display for Exhausted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let limit = self.limit;
        match self.resource {
            Resource::Steps => write!(f, "the computation needs more than {limit} steps"),
            Resource::AllSteps => {
                write!(f, "all computations together need more than {limit} steps")
            }
            Resource::Terms => write!(f, "a polynomial needs more than {limit} terms"),
            Resource::Bits => write!(f, "an integer needs more than {limit} bits"),
            Resource::Exponent => write!(f, "an exponent is larger than {limit}"),
        }
    }
}

impl std::error::Error for Exhausted {}

/// Allows a polynomial of `count` terms.
pub(super) fn check_terms(count: usize) -> Result<(), Exhausted> {
    within(Resource::Terms, count as u64, MOST_TERMS as u64)
}

/// Allows an integer of `count` bits.
pub(super) fn check_bits(count: usize) -> Result<(), Exhausted> {
    within(Resource::Bits, count as u64, MOST_BITS as u64)
}

/// Allows `exponent`, and gives it back in the width it is stored in.
pub(super) fn check_exponent(exponent: u64) -> Result<u16, Exhausted> {
    u16::try_from(exponent).map_err(|_| Exhausted {
        resource: Resource::Exponent,
        limit: u64::from(LARGEST_EXPONENT),
    })
}

fn within(resource: Resource, amount: u64, limit: u64) -> Result<(), Exhausted> {
    if amount <= limit {
        Ok(())
    } else {
        Err(Exhausted { resource, limit })
    }
}

/// What a quotient or a gcd of two integers costs: nothing beside what it is a part of if one of them
/// fits a word.
pub(super) fn steps_of_division(left: &Integer, right: &Integer) -> u64 {
    const STEPS_FOR_TWO_WORDS: u64 = 4;
    match (words(left), words(right)) {
        (1, _) | (_, 1) => 0,
        (left, right) => STEPS_FOR_TWO_WORDS * left * right,
    }
}

/// The number of machine words of an integer, and 1 for zero: what it costs to
/// go over it once.
pub(super) fn words(integer: &Integer) -> u64 {
    (integer.bit_len() as u64).div_ceil(64).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_request_leaves_nothing() {
        let budget = Budget::new(5);
        assert_eq!(budget.spend(5), Ok(()));
        budget.refill();
        let refusal = budget.spend(6).unwrap_err();
        assert_eq!((refusal.resource, refusal.limit), (Resource::Steps, 5));
        assert!(budget.spend(1).is_err());
        assert!(budget.spend(0).is_ok());
    }

    #[test]
    fn all_supplies_together_are_bounded() {
        let budget = Budget::new(10);
        for _ in 0..SUPPLIES {
            assert!(budget.spend(10).is_ok());
            budget.refill();
        }
        let refusal = budget.spend(1).unwrap_err();
        assert_eq!(
            refusal.to_string(),
            "all computations together need more than 40 steps"
        );
    }

    #[test]
    fn every_limit_is_stated() {
        let cases = [
            (
                check_terms(MOST_TERMS + 1),
                "a polynomial needs more than 500000 terms",
            ),
            (
                check_bits(MOST_BITS + 1),
                "an integer needs more than 1048576 bits",
            ),
            (
                check_exponent(65536).map(drop),
                "an exponent is larger than 65535",
            ),
            (
                Budget::new(7).spend(8),
                "the computation needs more than 7 steps",
            ),
        ];
        for (outcome, text) in cases {
            assert_eq!(outcome.unwrap_err().to_string(), text);
        }
        assert!(check_terms(MOST_TERMS).is_ok());
        assert!(check_bits(MOST_BITS).is_ok());
        assert_eq!(check_exponent(65535), Ok(u16::MAX));
    }

    #[test]
    fn an_integer_is_as_long_as_its_magnitude() {
        assert_eq!(words(&Integer::ZERO), 1);
        assert_eq!(words(&Integer::from(-1)), 1);
        assert_eq!(words(&(Integer::ONE << 64)), 2);
        assert_eq!(words(&-(Integer::ONE << 63)), 1);
    }

    #[test]
    fn division_of_long_integers_costs_steps() {
        let [word, long] = [63, 640].map(|bits| Integer::ONE << bits);
        assert_eq!(steps_of_division(&word, &long), 0);
        assert_eq!(steps_of_division(&long, &long), 4 * 11 * 11);
    }
}
