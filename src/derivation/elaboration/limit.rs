//! The limits on what is elaborated: what is too large is refused before it is computed.

use std::collections::BTreeSet;

use crate::derivation::quantity::{Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Name, Span};

/// The largest side of a matrix.
pub const MOST_ROWS: usize = 64;

/// How many definitions with arguments may be called within each other.
const DEEPEST_CALL: usize = 32;

/// How deep expressions may be nested, calls included; what evaluates them is recursive.
const DEEPEST_NESTING: usize = 600;

/// The most steps of one statement are spent on so many parts of expressions.
pub const MOST_PARTS: u64 = 200_000;

/// The highest order of an expansion in small quantities.
const HIGHEST_ORDER: u32 = 12;

/// The most minors that one determinant may need.
const MOST_MINORS: usize = 20_000;

/// The most replacements in one `at`.
const MOST_REPLACEMENTS: usize = 500;

/// The most terms that the entries of one value may have together.
const MOST_TERMS_OF_A_VALUE: usize = 1_000_000;

/// The most terms that the residuals of one matching may have together.
const MOST_TERMS_OF_RESIDUALS: usize = 50_000;

/// Allows so many calls within each other.
pub fn check_calls(depth: usize, function: &Name, span: &Span) -> Result<(), Diagnostic> {
    if depth < DEEPEST_CALL {
        return Ok(());
    }
    let message = format!("more than {DEEPEST_CALL} definitions within each other");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!("`{function}` is one too many"))
            .with_help(
                "no definition calls itself, not even by others; in a chain, put what one says into the next",
            ),
    )
}

/// Allows so many expressions within each other.
pub fn check_nesting(depth: usize, span: &Span) -> Result<(), Diagnostic> {
    if depth < DEEPEST_NESTING {
        return Ok(());
    }
    let message = "calls and brackets are nested too deeply";
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!("more than {DEEPEST_NESTING} within each other"))
            .with_help("give names to parts with `:=`"),
    )
}

/// Allows a value by the number of its terms.
pub fn check_terms(value: &Value, span: &Span) -> Result<(), Diagnostic> {
    let terms = |entry: &Quantity| entry.value.numerator().len() + entry.value.denominator().len();
    if value.entries().iter().map(terms).sum::<usize>() <= MOST_TERMS_OF_A_VALUE {
        return Ok(());
    }
    let message = format!(
        "this is too large to compute: its entries have more than {MOST_TERMS_OF_A_VALUE} terms"
    );
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label("given up here")
            .with_help("compute with fewer entries at a time"),
    )
}

/// Allows the residuals of a matching by the number of their terms, before they are written out.
pub fn check_residuals(terms: usize, span: &Span) -> Result<(), Diagnostic> {
    if terms <= MOST_TERMS_OF_RESIDUALS {
        return Ok(());
    }
    let message = format!(
        "this is too large to compute: the residuals of this matching have more than \
         {MOST_TERMS_OF_RESIDUALS} terms"
    );
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label("given up here")
            .with_help(
                "match fewer unknowns at a time, or let a `parameter` stand for a coefficient",
            ),
    )
}

/// Allows an expansion up to terms of this order.
pub fn check_order(order: u32, span: &Span) -> Result<u32, Diagnostic> {
    if order <= HIGHEST_ORDER {
        return Ok(order);
    }
    let message = format!("expansions go up to order {HIGHEST_ORDER}");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!("order {order}"))
            .with_help("take coefficients of a polynomial with `coefficient(…)`"),
    )
}

/// Allows so many replacements at once; what carries them out is recursive.
pub fn check_replacements(count: usize, span: &Span) -> Result<(), Diagnostic> {
    if count <= MOST_REPLACEMENTS {
        return Ok(());
    }
    let message = format!("more than {MOST_REPLACEMENTS} replacements in one `at`");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!("{count} replacements"))
            .with_help("replace in several steps: `(… at …) at …`"),
    )
}

/// Allows a matrix of so many rows and columns.
pub fn check_sides(rows: usize, columns: usize, span: &Span) -> Result<(), Diagnostic> {
    if rows.max(columns) <= MOST_ROWS {
        return Ok(());
    }
    let message = format!("a matrix may have {MOST_ROWS} rows and columns at most");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!(
                "this one would have {rows} rows and {columns} columns"
            ))
            .with_help("compute with blocks of it"),
    )
}

/// Counts the minors that an expansion along the rows needs, leaving out entries that are 0 and have no
/// unit; each counts as often as `weight` says.
pub fn check_minors(matrix: &Value, weight: usize, span: &Span) -> Result<(), Diagnostic> {
    let is_zero = |row: usize, column: usize| matrix.at(row, column).fits_every_unit();
    check_minors_of(matrix.shape(), is_zero, weight, span)
}

/// The same by the shape of a matrix and the places of its zeros.
pub fn check_minors_of(
    (rows, columns): (usize, usize),
    is_zero: impl Fn(usize, usize) -> bool,
    weight: usize,
    span: &Span,
) -> Result<(), Diagnostic> {
    let all = u64::MAX >> (u64::BITS as usize - columns.clamp(1, u64::BITS as usize));
    let (mut level, mut count) = (BTreeSet::from([all]), 0);
    for row in 0..rows {
        let mut next = BTreeSet::new();
        for left in level {
            for column in (0..columns).filter(|column| left & (1 << column) != 0) {
                if !is_zero(row, column) {
                    next.insert(left & !(1 << column));
                }
            }
            if (count + next.len()).saturating_mul(weight) > MOST_MINORS {
                let message = format!(
                    "this is too large to compute: the determinants of this {rows}×{columns} matrix \
                     need more than {MOST_MINORS} minors"
                );
                return Err(
                    Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
                        .with_label("given up here")
                        .with_help(
                            "break the matrix into blocks, or claim its determinant block by block",
                        ),
                );
            }
        }
        count += next.len();
        level = next;
    }
    Ok(())
}
