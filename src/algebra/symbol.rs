//! The letters of polynomials.

/// A letter of the polynomials, known to them only by its index.
///
/// Symbols are ordered by index. The symbol with the lowest index is the most
/// significant one in the order of the monomials.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(u16);

impl Symbol {
    /// The symbol with this index.
    pub const fn new(index: u16) -> Self {
        Symbol(index)
    }

    /// The index, to look the symbol up in tables.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The index in the width it is stored in.
    pub(super) const fn number(self) -> u16 {
        self.0
    }
}
