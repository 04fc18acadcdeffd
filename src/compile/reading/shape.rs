//! What stands around the bodies of an emitted file, token for token.
//!
//! A shape is the text of such a file with holes. Where a line has `$input` or `$output` it stands there
//! once for each of them, in order, and so with `$asked`, which is what angles and other inputs are called
//! where angles are asked for; only evaluators with such have the lines with a question mark, those with
//! inputs the lines with a plus, and those without the lines with a minus. `$function`, `$Function` and
//! `$GUARD` are the name of the evaluator, `$first` is the first input and `$leader` the first output. The
//! other words with a dollar sign are holes for what is computed.

use std::collections::BTreeSet;

use super::body::Unreadable;
use super::cursor::{Cursor, is_word};
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
        let Some(line) = line_of(line, names) else {
            continue;
        };
        let line = of_function(line, names);
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

/// A line of a shape, if an evaluator has it.
fn line_of<'s>(line: &'s str, names: &Names) -> Option<&'s str> {
    let marks = [
        ('?', !names.asked.is_empty()),
        ('+', !names.inputs.is_empty()),
        ('-', names.inputs.is_empty()),
    ];
    for (mark, is_there) in marks {
        if let Some(line) = line.strip_prefix(mark) {
            return is_there.then_some(line);
        }
    }
    Some(line)
}

/// The words of a shape that a variable must not have for a name: it would have another meaning there, or
/// none. Members, lifetimes, attributes and directives are no such words, and the function is hidden where
/// it is not needed.
///
/// # Errors
///
/// [`Unreadable`] if the shape itself cannot be read.
pub(super) fn taken(
    shape: &str,
    dialect: Dialect,
    names: &Names,
) -> Result<BTreeSet<String>, Unreadable> {
    let mut taken = BTreeSet::new();
    for line in shape.lines() {
        let line = of_function(line.trim_start_matches(['?', '+', '-']), names);
        if line.trim_start().starts_with('#') {
            continue;
        }
        let tokens = tokens(&line, dialect)?;
        for (place, token) in tokens.iter().enumerate() {
            let before = place
                .checked_sub(1)
                .map_or("", |before| tokens[before].text);
            let is_start = tokens.get(place + 1).is_some_and(|next| {
                next.text.starts_with('$') && next.start == token.start + token.text.len()
            });
            let is_member = before.ends_with('.') || ["->", "'"].contains(&before);
            let is_name = is_word(token.text) && !is_member && !is_start;
            if is_name && token.text != names.function {
                taken.insert(token.text.to_string());
            }
        }
    }
    Ok(taken)
}

fn of_function(line: &str, names: &Names) -> String {
    if !line.contains('$') {
        return line.to_string();
    }
    let first = names.inputs.first().and_then(|name| name.text.as_deref());
    let leader = names.outputs.first().and_then(|name| name.text.as_deref());
    let guard = format!("SEXTIC_{}_H", names.function.to_ascii_uppercase());
    line.replace("$GUARD", &guard)
        .replace("$function", &names.function)
        .replace("$Function", &names.type_prefix())
        .replace("$first", first.unwrap_or_default())
        .replace("$leader", leader.unwrap_or_default())
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
