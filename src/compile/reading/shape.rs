//! What stands around the bodies of an emitted file, token for token.
//!
//! A shape is the text of such a file with holes. Where a line has `$input` or `$output` it stands there
//! once for each of them, in order, and so with `$asked`, which is what angles and other inputs are called
//! where angles are asked for; only evaluators with such have the lines with a question mark. `$function`,
//! `$Function` and `$GUARD` are the name of the evaluator, `$first` is the first input. The other words with
//! a dollar sign are holes for what is computed.

use super::Unreadable;
use super::cursor::Cursor;
use super::names::{Name, Names, spellings};
use super::token::{Dialect, tokens};

/// What is computed: the statements of a body, or the value of the output of this place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hole {
    Body,
    BoundedBody,
    Result(usize),
    BoundedResult(usize),
    Door,
    Source(usize),
}

/// Moves over a text that has a shape, and reads what is in its holes.
///
/// The first line with a new input or output says what the text calls it.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as in the shape, or that a hole refuses.
pub(super) fn follow<'t, 'a>(
    shape: &str,
    dialect: Dialect,
    names: &mut Names,
    cursor: &mut Cursor<'t, 'a>,
    read: &mut dyn FnMut(Hole, &Names, &mut Cursor<'t, 'a>) -> Result<(), Unreadable>,
) -> Result<(), Unreadable> {
    for line in shape.lines() {
        let line = match line.strip_prefix('?') {
            Some(_) if names.asked.is_empty() => continue,
            Some(line) => of_function(line, names),
            None => of_function(line, names),
        };
        let count = quantities(&line, names).map_or(1, |(_, quantities)| quantities.len());
        for place in 0..count {
            let line = of_quantity(&line, place, dialect, names, cursor)?;
            for token in tokens(&line, dialect)? {
                let hole = match token.text {
                    "$body" => Hole::Body,
                    "$bounded_body" => Hole::BoundedBody,
                    "$result" => Hole::Result(place),
                    "$bounded_result" => Hole::BoundedResult(place),
                    "$door" => Hole::Door,
                    "$source" => Hole::Source(place),
                    text => {
                        cursor.expect(&[text])?;
                        continue;
                    }
                };
                read(hole, names, cursor)?;
            }
        }
    }
    cursor.end()
}

fn of_function(line: &str, names: &Names) -> String {
    if !line.contains('$') {
        return line.to_string();
    }
    let first = names.inputs.first().and_then(|name| name.text.as_deref());
    let guard = format!("SEXTIC_{}_H", names.function.to_ascii_uppercase());
    line.replace("$GUARD", &guard)
        .replace("$function", &names.function)
        .replace("$Function", &names.type_prefix())
        .replace("$first", first.unwrap_or_default())
}

/// The quantities that a line stands there for, and the word in it.
fn quantities<'n>(line: &str, names: &'n mut Names) -> Option<(&'static str, &'n mut Vec<Name>)> {
    if line.contains("$input") {
        Some(("$input", &mut names.inputs))
    } else if line.contains("$output") {
        Some(("$output", &mut names.outputs))
    } else if line.contains("$asked") {
        Some(("$asked", &mut names.asked))
    } else {
        None
    }
}

/// The line for the input and output of a place.
fn of_quantity(
    line: &str,
    place: usize,
    dialect: Dialect,
    names: &mut Names,
    cursor: &Cursor<'_, '_>,
) -> Result<String, Unreadable> {
    let Some((hole, quantities)) = quantities(line, names) else {
        return Ok(line.to_string());
    };
    if let Some(text) = &quantities[place].text {
        return Ok(line.replace(hole, text));
    }
    let name = quantities[place].quantity.clone();
    let taken: Vec<String> = quantities
        .iter()
        .map(|other| other.quantity.clone())
        .collect();
    let is_taken = |spelling: &str| taken.iter().any(|name| name == spelling);
    for spelling in spellings(&name, is_taken) {
        let declaration = line.replace(hole, &spelling);
        let expected = tokens(&declaration, dialect)?;
        let texts: Vec<&str> = expected.iter().map(|token| token.text).collect();
        if cursor.is_at(&texts) {
            quantities[place].text = Some(spelling);
            return Ok(declaration);
        }
    }
    Err(cursor.refuse(&format!("the declaration of `{name}`")))
}
