//! How a verdict was reached.

use super::claim::Claim;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::foundation::Foundation;
use crate::derivation::quantity::{Quantity, Value};
use crate::language::syntax::Expression;

/// Longer normal forms are not shown.
const MOST_TERMS_TO_SHOW: usize = 100;

/// How a verdict was reached.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explanation {
    /// The definitions that the assertion rests on, left and right of `:=`, each before those that
    /// use it.
    pub definitions: Vec<(Expression, Expression)>,
    /// The normal forms of the left side, entry by entry; nothing for one too long to read.
    pub left: Vec<Option<Expression>>,
    /// The normal forms of the right side, entry by entry; nothing for one too long to read.
    pub right: Vec<Option<Expression>>,
    /// The unit of the first entry of both sides.
    pub unit: Option<String>,
}

impl Elaborator {
    /// How the verdict on a claim of this elaborator's document was reached.
    pub(super) fn explain(&self, claim: &Claim) -> Explanation {
        let definitions =
            Foundation::of(&self.scope, [&claim.statement.left, &claim.statement.right]);
        let Some((left, right)) = &claim.sides else {
            return Explanation {
                definitions,
                ..Explanation::default()
            };
        };
        let unit = left.entries().iter().chain(right.entries());
        Explanation {
            definitions,
            left: self.normal_forms(left),
            right: self.normal_forms(right),
            unit: unit
                .filter_map(|entry| entry.unit.as_ref())
                .map(ToString::to_string)
                .next(),
        }
    }

    fn normal_forms(&self, value: &Value) -> Vec<Option<Expression>> {
        self.ring.budget().refill();
        let shown = |entry: &Quantity| {
            let terms = entry.value.numerator().len() + entry.value.denominator().len();
            let short = (terms <= MOST_TERMS_TO_SHOW).then_some(&entry.value);
            short.and_then(|value| self.presenter().element(value).ok())
        };
        value.entries().iter().map(shown).collect()
    }
}
