//! What matchings leave, in a line each; `sextic match` shows the rest.

use crate::derivation::matching::{Matched, Row};
use crate::language::notation::Notation;

use super::phrase::Phrase;
use super::words;

/// `closed_form: 4 of 7 powers matched exactly, residuals of order 2 (λ⁴), 3 (λ³) in ρ; see sextic match`
pub fn overview(matched: &Matched, notation: Notation) -> Phrase {
    let total = matched.table.len();
    let exact = total - left(matched).count();
    let phrase = Phrase::default()
        .mathematics(notation.name(&matched.name))
        .words(format!(": {exact} of {total} powers matched exactly"));
    let mut phrase = orders(phrase, matched, notation);
    if let Some(reason) = warning(matched) {
        let rows = not_small(matched).map(|row| words::power(matched, row.power, notation));
        phrase = phrase.words("; WARNING: what is left of the coefficient of ");
        phrase = phrase.list(rows, ", ").words(format!(" {reason}"));
    }
    phrase.words("; see sextic match")
}

/// `, residuals of order 2 (λ⁴), 3 (λ³) in ρ`, of those that have an order.
fn orders(phrase: Phrase, matched: &Matched, notation: Notation) -> Phrase {
    let ordered: Vec<(&Row, u32)> = left(matched)
        .filter_map(|row| row.order.map(|order| (row, order)))
        .collect();
    if ordered.is_empty() {
        return phrase;
    }
    let mut phrase = phrase.words(", residuals of order ");
    for (index, (row, order)) in ordered.into_iter().enumerate() {
        let separator = if index > 0 { ", " } else { "" };
        phrase = phrase
            .words(format!("{separator}{order} ("))
            .mathematics(words::power(matched, row.power, notation))
            .words(")");
    }
    let small = matched.small.iter().map(|name| notation.name(name));
    phrase.words(" in ").list(small, ", ")
}

/// Why what a matching leaves need not be small; nothing where it must be.
pub fn warning(matched: &Matched) -> Option<&'static str> {
    not_small(matched).next()?;
    Some(if matched.small.is_empty() {
        "has no order, since the matching names nothing small"
    } else {
        "is not small: it is of order 0 or of none that was found"
    })
}

/// The powers that are not matched exactly.
fn left(matched: &Matched) -> impl Iterator<Item = &Row> {
    let rows = matched.table.iter();
    rows.filter(|row| !words::is_zero(&row.residual))
}

/// The powers at which what is left vanishes with nothing that is small.
fn not_small(matched: &Matched) -> impl Iterator<Item = &Row> {
    left(matched).filter(|row| row.order.is_none_or(|order| order == 0))
}
