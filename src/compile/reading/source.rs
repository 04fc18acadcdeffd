//! Where an input comes from, in the function that takes angles: what is given, or a sine or cosine of a sum of angles.

use super::body::{Source, Unreadable};
use super::cursor::Cursor;
use super::infix::{Words, expression};
use super::names::{Name, quantity};

/// `angles->m` of the tokens in front of a field, or `cos(alpha + beta)`.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is neither.
pub(super) fn source(
    cursor: &mut Cursor<'_, '_>,
    asked: &[Name],
    fields: &[&str],
) -> Result<Source, Unreadable> {
    if !cursor.accept(fields) {
        // A whole number times an angle has the usual sign also where elements have others: no other product passes.
        return circular(cursor, &Words::usual(&[]));
    }
    let field = cursor.word()?;
    match quantity(asked, field) {
        Some(name) => Ok(Source::Given(name.to_string())),
        None => Err(cursor.refuse(&format!("something else behind `{field}`"))),
    }
}

/// `cos(alpha + beta)`
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
pub(super) fn circular(
    cursor: &mut Cursor<'_, '_>,
    words: &Words<'_>,
) -> Result<Source, Unreadable> {
    let is_cosine = cursor.accept(&["cos"]);
    if !is_cosine {
        cursor.expect(&["sin"])?;
    }
    cursor.expect(&["("])?;
    let angle = expression(cursor, words)?;
    cursor.expect(&[")"])?;
    Ok(match is_cosine {
        true => Source::Cosine(angle),
        false => Source::Sine(angle),
    })
}
