//! What an evaluator computes, as its document writes it.

use crate::derivation::foundation::nearest;
use crate::derivation::scope::Scope;
use crate::language::evaluator::Evaluator;
use crate::language::notation::Notation;
use crate::language::syntax::Expression;

/// A reader of more than this is better off with the document.
const MOST_DEFINITIONS: usize = 20;

/// The outputs as the document writes them, and the nearest definitions that they rest on.
pub(super) fn of(evaluator: &Evaluator, scope: &Scope) -> Vec<String> {
    let write = |expression: &Expression| Notation::Unicode.expression(expression);
    let outputs = evaluator.outputs.iter();
    let written = outputs.map(|output| {
        let name = &output.name.unicode;
        format!("{name} = {}", write(&output.expression))
    });
    let mut lines: Vec<String> = written.collect();
    let expressions = evaluator.outputs.iter().map(|output| &output.expression);
    let (definitions, is_all) = nearest(scope, expressions, MOST_DEFINITIONS);
    let defined = definitions.iter().map(|(left, right)| {
        let (left, right) = (write(left), write(right));
        format!("{left} := {right}")
    });
    lines.extend(defined);
    if !is_all {
        lines.push("…".to_string());
    }
    lines
}
