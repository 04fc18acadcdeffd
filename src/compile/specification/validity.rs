//! Where the result of an evaluator means something.

use std::collections::BTreeSet;

use crate::algebra::error::AlgebraError;
use crate::algebra::sign::Signs;
use crate::algebra::symbol::Symbol;
use crate::compile::input::Input;
use crate::derivation::audit::Audit;
use crate::derivation::condition::Requirement;
use crate::derivation::notation::Notation;
use crate::derivation::syntax::{Relation, Replacement};
use crate::derivation::verdict::Condition;

use super::{Refusal, Specification};

impl Specification {
    /// Whether the document allows numbers, and none of them makes a divisor zero.
    pub(super) fn admit_replacements(
        &self,
        numbers: &[Replacement],
        audit: &mut Audit,
    ) -> Result<(), Refusal> {
        let names: Vec<String> = numbers
            .iter()
            .map(|number| Notation::Ascii.expression(&number.target))
            .collect();
        let refuse = |reason: String| Refusal::Number(names.join(", "), reason);
        let elaborator = &mut audit.elaborator;
        elaborator.fresh();
        let images = elaborator.admit(numbers, &(0..0));
        let images = images.map_err(|error| refuse(error.message))?;
        let after = self.conditions.substitute(&images, &mut elaborator.ring);
        match after {
            Ok(_) => Ok(()),
            Err(AlgebraError::DivisionByZero) => Err(refuse("a divisor becomes 0".to_string())),
            Err(error) => Err(refuse(error.to_string())),
        }
    }
}

/// What the document assumes of the inputs: `m > 0`, `L_g < r`.
pub(super) fn assumptions(inputs: &[(Symbol, Input)], audit: &Audit) -> Vec<String> {
    let known = audit.elaborator.ring.assumptions();
    let signs = inputs.iter().filter_map(|(symbol, input)| {
        let signs = known.of_symbol(*symbol);
        (signs != Signs::ANY).then(|| format!("{} {signs}", input.shown))
    });
    let names: BTreeSet<&str> = inputs
        .iter()
        .map(|(_, input)| input.name.as_str())
        .collect();
    let is_about_inputs = |relation: &&Relation| {
        let mut all = true;
        for side in [&relation.left, &relation.right] {
            side.visit_names(&mut |name| all &= names.contains(name.ascii.as_str()));
        }
        all
    };
    let relations = audit.assumptions.iter().filter(is_about_inputs);
    signs
        .chain(relations.map(|relation| Notation::Unicode.relation(relation)))
        .collect()
}

/// `L_g ≠ 0`
pub(super) fn condition(condition: &Condition) -> String {
    let expression = Notation::Unicode.expression(&condition.expression);
    match condition.requirement {
        Requirement::NonZero => format!("{expression} ≠ 0"),
        Requirement::Positive => format!("{expression} > 0"),
    }
}
