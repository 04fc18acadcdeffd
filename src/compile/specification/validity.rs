//! Where the result of an evaluator means something.

use std::collections::BTreeSet;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::algebra::substitution::Replacing;
use crate::algebra::symbol::Symbol;
use crate::compile::input::Input;
use crate::derivation::condition::Condition;
use crate::derivation::condition::Requirement as Demand;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::presentation::Presenter;
use crate::language::notation::Notation;
use crate::language::syntax::{Comparison, Relation, Replacement};
use crate::verdict::audit::Audit;

use super::{Refusal, Specification};

impl Specification {
    /// Whether the document allows numbers, and none of them makes a divisor zero.
    pub(super) fn admit_replacements(&mut self, numbers: &[Replacement]) -> Result<(), Refusal> {
        let names: Vec<String> = numbers
            .iter()
            .map(|number| Notation::Ascii.expression(&number.target))
            .collect();
        let refuse = |reason: String| Refusal::Number(names.join(", "), reason);
        let elaborator = &mut self.elaborator;
        elaborator.fresh();
        let images = elaborator.admit(numbers, &(0..0));
        let images = images.map_err(|error| refuse(error.message))?;
        let after = self.conditions.substitute(&images, &mut elaborator.ring);
        let mut replacing = Replacing::by(&images);
        for requirement in &self.requirements {
            let difference = replacing.image(&requirement.difference, &mut elaborator.ring);
            let difference = difference.map_err(|error| refuse(error.to_string()))?;
            let is_met = difference
                .as_constant()
                .is_none_or(|value| requirement.comparison.holds(value.cmp(&Rational::ZERO)));
            if !is_met {
                return Err(refuse(format!(
                    "it means something only where {}",
                    requirement.text
                )));
            }
        }
        match after {
            Ok(_) => Ok(()),
            Err(AlgebraError::DivisionByZero) => Err(refuse("a divisor becomes 0".to_string())),
            Err(error) => Err(refuse(error.to_string())),
        }
    }
}

/// What a document says must hold: that a − b compares so with 0.
#[derive(Clone, Debug)]
pub(super) struct Requirement {
    difference: Fraction,
    comparison: Comparison,
    /// As a person reads it.
    pub(super) text: String,
}

/// What an evaluator needs beyond what its outputs themselves do.
pub(super) fn requirements(
    relations: &[Relation],
    elaborator: &mut Elaborator,
) -> Result<Vec<Requirement>, Refusal> {
    let mut requirements = Vec::new();
    for relation in relations {
        let (left, right) = (&relation.left, &relation.right);
        let (left, right) = (elaborator.scalar(left), elaborator.scalar(right));
        let left = left.map_err(Refusal::document)?.value;
        let right = right.map_err(Refusal::document)?.value;
        let refuse = |error: AlgebraError| Refusal::Program(error.to_string());
        let Elaborator { ring, scope, .. } = &*elaborator;
        let presenter = Presenter { ring, scope };
        requirements.push(Requirement {
            difference: ring.difference(&left, &right).map_err(refuse)?,
            comparison: relation.comparison,
            text: Notation::Unicode.relation(&Relation {
                left: presenter.element(&left).map_err(refuse)?,
                comparison: relation.comparison,
                right: presenter.element(&right).map_err(refuse)?,
            }),
        });
    }
    Ok(requirements)
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
    let relations = audit.assumptions.iter().map(|own| &own.relation);
    let relations = relations.filter(is_about_inputs);
    signs
        .chain(relations.map(|relation| Notation::Unicode.relation(relation)))
        .collect()
}

/// `L_g ≠ 0`
pub(super) fn condition(condition: &Condition) -> String {
    let expression = Notation::Unicode.expression(&condition.expression);
    match condition.requirement {
        Demand::NonZero => format!("{expression} ≠ 0"),
        Demand::Positive => format!("{expression} > 0"),
    }
}
