//! Monomials as machine words.
//!
//! The symbols of a computation get fields in one word, the most significant
//! symbol the most significant field, each wide enough for every exponent that
//! can occur. Then the order of the words is the order of the monomials, and
//! the product of two monomials is the sum of two words.

use std::hash::Hash;

use super::budget::Exhausted;
use super::degrees::Degrees;
use super::monomial::Monomial;
use super::symbol::Symbol;

/// The fields of a packed monomial.
pub(super) struct Layout {
    /// The number of bits of all fields together.
    bits: u32,
    /// By increasing symbol.
    fields: Vec<Field>,
    /// By the index of a symbol, the lowest bit of its field.
    shifts: Vec<u32>,
    /// By bit, the place of its field.
    places: [u8; 128],
}

/// The bits that hold the exponent of one symbol.
struct Field {
    symbol: Symbol,
    shift: u32,
    width: u32,
    /// All bits of the fields behind it.
    below: u128,
}

impl Layout {
    /// Room for all monomials of at most these degrees, with `guard` bits to
    /// spare above every exponent.
    pub(super) fn new(degrees: &Degrees, guard: u32) -> Self {
        let width = |degree: u32| guard + u32::BITS - degree.leading_zeros();
        let widths = || {
            degrees
                .iter()
                .map(|(symbol, degree)| (symbol, width(degree)))
        };
        let bits = widths().map(|(_, width)| width).sum();
        let mut fields = Vec::with_capacity(degrees.len());
        let mut shift = bits;
        for (symbol, width) in widths() {
            shift -= width;
            fields.push(Field {
                symbol,
                shift,
                width,
                below: 1_u128.checked_shl(shift).map_or(0, |bit| bit - 1),
            });
        }
        Layout::of_fields(bits, fields)
    }

    /// Finds the fields by symbol and by bit.
    fn of_fields(bits: u32, fields: Vec<Field>) -> Self {
        let last = fields.last().map(|field| field.symbol.index());
        let mut shifts = vec![0; last.map_or(0, |last| last + 1)];
        let mut places = [0; 128];
        for (place, field) in fields.iter().enumerate() {
            shifts[field.symbol.index()] = field.shift;
            // What takes more bits than there are is never packed.
            let own = field.shift as usize..(field.shift + field.width) as usize;
            if let Some(own) = places.get_mut(own) {
                own.fill(place as u8);
            }
        }
        Layout {
            bits,
            fields,
            shifts,
            places,
        }
    }

    /// The number of bits of a packed monomial.
    pub(super) fn bits(&self) -> u32 {
        self.bits
    }

    fn pack(&self, monomial: &Monomial) -> u128 {
        let field =
            |(symbol, exponent): (Symbol, u32)| u128::from(exponent) << self.shifts[symbol.index()];
        monomial.factors().map(field).sum()
    }

    /// Field by field, without looking at those that are 0.
    fn unpack(&self, mut word: u128) -> Monomial {
        let mut monomial = Monomial::one();
        while word != 0 {
            let highest = 127 & !word.leading_zeros();
            let field = &self.fields[usize::from(self.places[highest as usize])];
            monomial.push(field.symbol, (word >> field.shift) as u16);
            word &= field.below;
        }
        monomial
    }

    /// The highest bit of every field.
    fn guards(&self) -> u128 {
        let guard = |field: &Field| 1 << (field.shift + field.width - 1);
        self.fields.iter().map(guard).sum()
    }
}

/// What a division has to know about the monomials of its quotient.
pub(super) struct Frame<K> {
    /// The guard bits of all fields.
    guards: K,
    /// The monomial that all those of the quotient divide.
    bound: K,
}

/// A representation of monomials, in the order of the monomials.
pub(super) trait Key: Clone + Ord + Hash {
    /// The key of a monomial within the degrees of the layout.
    fn encode(monomial: &Monomial, layout: &Layout) -> Self;

    /// The monomial of a key.
    fn decode(&self, layout: &Layout) -> Monomial;

    /// The frame of a division, where the layout has one guard bit.
    fn frame(layout: &Layout, bound: &Monomial) -> Frame<Self>;

    /// The product of two monomials.
    fn product(&self, other: &Self) -> Result<Self, Exhausted>;

    /// The quotient of two monomials, `None` where it does not exist or does
    /// not divide the bound of the frame.
    fn quotient(&self, divisor: &Self, frame: &Frame<Self>) -> Option<Self>;
}

impl Key for Monomial {
    fn encode(monomial: &Monomial, _: &Layout) -> Self {
        monomial.clone()
    }

    fn decode(&self, _: &Layout) -> Monomial {
        self.clone()
    }

    fn frame(_: &Layout, bound: &Monomial) -> Frame<Self> {
        Frame {
            guards: Monomial::one(),
            bound: bound.clone(),
        }
    }

    fn product(&self, other: &Self) -> Result<Self, Exhausted> {
        Monomial::product(self, other)
    }

    fn quotient(&self, divisor: &Self, frame: &Frame<Self>) -> Option<Self> {
        let quotient = Monomial::quotient(self, divisor)?;
        frame
            .bound
            .quotient(&quotient)
            .is_some()
            .then_some(quotient)
    }
}

/// Packed monomials: the same text for words of 64 and of 128 bits.
macro_rules! packed_key {
    ($word:ty) => {
        impl Key for $word {
            fn encode(monomial: &Monomial, layout: &Layout) -> Self {
                layout.pack(monomial) as $word
            }

            fn decode(&self, layout: &Layout) -> Monomial {
                layout.unpack(u128::from(*self))
            }

            fn frame(layout: &Layout, bound: &Monomial) -> Frame<Self> {
                Frame {
                    guards: layout.guards() as $word,
                    bound: Self::encode(bound, layout),
                }
            }

            fn product(&self, other: &Self) -> Result<Self, Exhausted> {
                Ok(self + other)
            }

            fn quotient(&self, divisor: &Self, frame: &Frame<Self>) -> Option<Self> {
                let quotient = fieldwise_difference(*self, *divisor, frame.guards)?;
                fieldwise_difference(frame.bound, quotient, frame.guards)?;
                return Some(quotient);

                /// A field that borrows clears its own guard bit and no other.
                fn fieldwise_difference(left: $word, right: $word, guards: $word) -> Option<$word> {
                    let difference = (left | guards) - right;
                    (difference & guards == guards).then_some(difference ^ guards)
                }
            }
        }
    };
}

packed_key!(u64);
packed_key!(u128);

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::polynomial::Polynomial;
    use super::*;

    /// Monomials in many symbols, some of them with gaps between.
    fn monomials() -> impl Strategy<Value = (Monomial, Monomial)> {
        let exponents = || prop::collection::vec(prop_oneof![Just(0), 0_u16..=5], 9);
        let monomial = |exponents: Vec<u16>| {
            let mut monomial = Monomial::one();
            for (index, exponent) in (0..).zip(exponents) {
                monomial.push(Symbol::new(3 * index), exponent);
            }
            monomial
        };
        (exponents(), exponents()).prop_map(move |(left, right)| (monomial(left), monomial(right)))
    }

    fn layout(monomials: &[&Monomial], guard: u32) -> Layout {
        let sum = monomials
            .iter()
            .fold(Monomial::one(), |sum, own| sum.product(own).unwrap());
        Layout::new(&Degrees::of(&Polynomial::from(sum)), guard)
    }

    fn laws<K: Key + std::fmt::Debug>(left: &Monomial, right: &Monomial) {
        let layout = layout(&[left, right], 1);
        let (packed, partner) = (K::encode(left, &layout), K::encode(right, &layout));
        assert_eq!(packed.decode(&layout), *left);
        assert_eq!(packed.cmp(&partner), left.cmp(right));
        let product = left.product(right).unwrap();
        assert_eq!(packed.product(&partner).unwrap().decode(&layout), product);
        let frame = K::frame(&layout, &product);
        let quotient = packed
            .quotient(&partner, &frame)
            .map(|key| key.decode(&layout));
        assert_eq!(quotient, left.quotient(right));
        // The bound counts as well.
        let frame = K::frame(&layout, right);
        let quotient = packed.quotient(&K::encode(&Monomial::one(), &layout), &frame);
        assert_eq!(quotient.is_some(), right.quotient(left).is_some());
    }

    proptest! {
        #[test]
        fn keys_behave_as_monomials((left, right) in monomials()) {
            laws::<u64>(&left, &right);
            laws::<u128>(&left, &right);
            laws::<Monomial>(&left, &right);
        }
    }

    #[test]
    fn a_field_is_as_wide_as_its_degree_needs() {
        for (degree, width) in [
            (1, 1),
            (2, 2),
            (3, 2),
            (4, 3),
            (255, 8),
            (256, 9),
            (65_535, 16),
        ] {
            let power = Monomial::power(Symbol::new(5), degree);
            assert_eq!(layout(&[&power], 0).bits(), width);
            assert_eq!(layout(&[&power], 1).bits(), width + 1);
        }
    }

    #[test]
    fn all_of_the_word_can_be_used() {
        let mut full = Monomial::one();
        for index in 0..128 {
            full.push(Symbol::new(index), 1);
        }
        let layout = layout(&[&full], 0);
        assert_eq!(layout.bits(), 128);
        assert_eq!(u128::encode(&full, &layout), u128::MAX);
        assert_eq!(u128::MAX.decode(&layout), full);
    }
}
