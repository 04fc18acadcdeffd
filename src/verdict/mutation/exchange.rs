//! Two neighbours of a statement that are exchanged.

use crate::language::syntax::{
    EvaluatorBody, Expression, Node, Span, Statement, StatementKind, SystemBody,
};

/// Neighbours that are exchanged, each pair with the place of both and what stands there then: what a statement gives to
/// several names, such as the outputs of an evaluator, and the entries of matrices, row by row.
pub(super) fn exchanges(text: &str, statement: &Statement) -> Vec<(Span, String)> {
    let values = values(&statement.kind);
    let mut lists = vec![values.clone()];
    for value in values {
        value.visit(&mut |own| {
            if let Node::Matrix(rows) = &own.node {
                lists.push(rows.iter().flatten().collect());
            }
        });
    }
    let pairs = lists.iter().flat_map(|list| list.windows(2));
    pairs.filter_map(|pair| exchange(text, pair)).collect()
}

/// What a statement gives to names, in their order.
fn values(kind: &StatementKind) -> Vec<&Expression> {
    match kind {
        StatementKind::Definition { values, .. } => values.iter().collect(),
        StatementKind::Substitution { replacements, .. } => {
            replacements.iter().map(|own| &own.value).collect()
        }
        StatementKind::System(system) => matrices(&system.body),
        StatementKind::Evaluator {
            body: EvaluatorBody::Outputs(outputs),
            ..
        } => outputs.iter().map(|(_, own)| own).collect(),
        _ => Vec::new(),
    }
}

fn matrices(body: &SystemBody) -> Vec<&Expression> {
    match body {
        SystemBody::Equations { equations, .. } => vec![equations],
        SystemBody::Matrices {
            mass,
            damping,
            stiffness,
        } => {
            let parts = damping.iter().chain(stiffness);
            [mass]
                .into_iter()
                .chain(parts.map(|own| &own.matrix))
                .collect()
        }
    }
}

/// Nothing where both are written alike.
fn exchange(text: &str, pair: &[&Expression]) -> Option<(Span, String)> {
    let [one, other] = [&pair.first()?.span, &pair.get(1)?.span];
    let [first, second] = [text.get(one.clone())?, text.get(other.clone())?];
    let between = text.get(one.end..other.start)?;
    (first != second).then(|| (one.start..other.end, [second, between, first].concat()))
}
