//! The symbols that others stand for.

use std::collections::BTreeSet;

use super::fraction::Fraction;
use super::generator::Generator;
use super::ring::Ring;
use super::symbol::Symbol;

impl Ring {
    /// The symbols in what a symbol stands for, which are earlier ones; none for a free symbol.
    ///
    /// Complexity: one pass over the terms of what it stands for.
    pub(super) fn parts_of(&self, symbol: Symbol) -> BTreeSet<Symbol> {
        match self.generator(symbol) {
            Generator::Cosine { angle } | Generator::Sine { angle } => {
                angle.coefficients().map(|(part, _)| part).collect()
            }
            Generator::Root { radicand } => radicand.symbols(),
            Generator::Direction { x, y, .. } => &x.symbols() | &y.symbols(),
            Generator::FunctionValue { argument, .. } => argument.symbols(),
            Generator::Constant { .. }
            | Generator::Angle { .. }
            | Generator::Coordinate { .. }
            | Generator::ImaginaryUnit => BTreeSet::new(),
        }
    }

    /// The symbols of an element, and those that these stand for.
    ///
    /// Complexity: one pass over the terms of each.
    pub fn constituents(&self, element: &Fraction) -> BTreeSet<Symbol> {
        self.unknown_constituents(element.symbols(), |_| false)
    }

    /// Those of the symbols that are not known yet, and what is not known of what they stand for.
    ///
    /// In the order of the set each of them comes after all that it stands for, so that whatever
    /// carries over from symbols to others is found in one pass.
    ///
    /// Complexity: one pass over the terms of each.
    pub(super) fn unknown_constituents(
        &self,
        symbols: BTreeSet<Symbol>,
        is_known: impl Fn(&Symbol) -> bool,
    ) -> BTreeSet<Symbol> {
        let mut open: Vec<Symbol> = symbols.into_iter().collect();
        let mut found = BTreeSet::new();
        while let Some(symbol) = open.pop() {
            if !is_known(&symbol) && found.insert(symbol) {
                open.extend(self.parts_of(symbol));
            }
        }
        found
    }
}
