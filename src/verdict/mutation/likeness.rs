//! Names of one sort: each may stand where another stands.

use crate::derivation::quantity::Value;
use crate::derivation::scope::Meaning;

/// Whether two names are of one sort, with the same unit and as many rows and columns.
pub(super) fn alike(one: &Meaning, other: &Meaning) -> bool {
    match (one, other) {
        (
            Meaning::Symbol { unit, kind, .. },
            Meaning::Symbol {
                unit: other,
                kind: other_kind,
                ..
            },
        ) => unit == other && kind == other_kind,
        (Meaning::Function { unit, .. }, Meaning::Function { unit: other, .. }) => unit == other,
        (Meaning::Definition { value, .. }, Meaning::Definition { value: other, .. }) => {
            units_agree(value, other)
        }
        (
            Meaning::Template { arguments, .. },
            Meaning::Template {
                arguments: other, ..
            },
        ) => arguments.len() == other.len(),
        (Meaning::Substitution { .. }, Meaning::Substitution { .. }) => true,
        _ => false,
    }
}

fn units_agree(one: &Value, other: &Value) -> bool {
    let units = |own: &Value| {
        own.entries()
            .iter()
            .map(|entry| entry.unit.clone())
            .collect::<Vec<_>>()
    };
    (one.rows(), one.columns()) == (other.rows(), other.columns()) && units(one) == units(other)
}
