//! Names that are read as complex ones.
//!
//! Signs, roots and conditions are found for the real values that a name was declared to have. Where it is
//! replaced by something that is not real, the expression is elaborated once more with a complex symbol in
//! its place, its twin.

use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::symbol::Symbol;
use crate::derivation::condition::Conditions;
use crate::derivation::quantity::Value;
use crate::derivation::scope::Entry;
use crate::language::diagnostic::Diagnostic;
use crate::language::syntax::{Expression, Name, Span};

use super::Elaborator;
use super::error::algebra;

impl Elaborator {
    /// The symbols that were declared real and are replaced by something that is not, with their twins.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where one is no parameter, or an argument of the call that one is in rests on it.
    pub(super) fn twins<'e>(
        &mut self,
        images: impl Iterator<Item = (Symbol, &'e Fraction)>,
        span: &Span,
    ) -> Result<Vec<(Symbol, Symbol)>, Diagnostic> {
        let is_changed = |symbol: &Symbol, image: &Fraction| {
            !self.ring.assumptions().is_complex(*symbol) && !self.ring.is_real(image)
        };
        let changed: Vec<Symbol> = images
            .filter(|(symbol, image)| is_changed(symbol, image))
            .map(|(symbol, _)| symbol)
            .collect();
        let mut twins = Vec::new();
        for symbol in changed {
            let Generator::Constant { name } = self.ring.generator(symbol).clone() else {
                return Err(algebra(AlgebraError::NotReal, span)
                    .with_label("replaces an angle, a coordinate or a function, which are real"));
            };
            // Its value was found for a real number, also where that does not occur in it any more.
            let call = self.arguments.last().into_iter();
            let mut arguments = call.flat_map(|known| known.values());
            if arguments.any(|argument| argument.rests_on.contains(&*name)) {
                return Err(algebra(AlgebraError::NotReal, span).with_help(format!(
                    "an argument of this call contains {name} as a real number: declare it with `complex`"
                )));
            }
            let generator = Generator::Constant {
                name: format!("complex {name}"),
            };
            let twin = self
                .ring
                .symbol(generator)
                .map_err(|error| algebra(error, span))?;
            if !self.ring.assumptions().is_complex(twin) {
                self.ring.assumptions_mut().assume_complex(twin);
            }
            twins.push((symbol, twin));
        }
        Ok(twins)
    }

    /// What is computed where the first symbols stand for the second ones.
    pub(super) fn as_complex<T>(
        &mut self,
        twins: &[(Symbol, Symbol)],
        compute: impl FnOnce(&mut Elaborator) -> T,
    ) -> T {
        let (outer, known) = (self.twins.clone(), std::mem::take(&mut self.twin_values));
        for (symbol, twin) in twins {
            if let Some(name) = self.ring.generator(*symbol).name() {
                self.twins.insert(name.to_owned(), *twin);
            }
        }
        let computed = compute(self);
        (self.twins, self.twin_values) = (outer, known);
        computed
    }

    /// How the document calls what a symbol stands for: also one that stands for a name read as complex.
    pub(super) fn written_name(&self, symbol: Symbol) -> Option<&str> {
        let mut twins = self.twins.iter();
        match twins.find(|(_, twin)| **twin == symbol) {
            Some((name, _)) => Some(name),
            None => self.ring.generator(symbol).name(),
        }
    }

    /// Whether a name rests on one that is read as a complex one.
    pub(super) fn rests_on_twin(&self, name: &Name) -> bool {
        let entry = self.scope.get(name).into_iter();
        let mut names = entry.flat_map(Entry::rests_on);
        !self.twins.is_empty() && names.any(|name| self.twins.contains_key(name))
    }

    /// The value of a definition that rests on a name that is read as a complex one.
    pub(super) fn complex_definition(
        &mut self,
        name: &Name,
        expression: &Expression,
    ) -> Result<Value, Diagnostic> {
        if let Some((value, conditions)) = self.twin_values.get(&name.ascii).cloned() {
            self.conditions.extend(&conditions);
            return Ok(value);
        }
        // The arguments of a call mean nothing within a definition.
        self.arguments.push(Default::default());
        let found = self.value_and_conditions(expression);
        self.arguments.pop();
        let (value, conditions): (Value, Conditions) = found?;
        self.conditions.extend(&conditions);
        let known = (value.clone(), conditions);
        self.twin_values.insert(name.ascii.clone(), known);
        Ok(value)
    }
}
