//! What stands around the bodies of an emitted file, token for token.
//!
//! A shape is the text of such a file with holes. Where a line has `$input`, `$output`, `$asked`, `$angle`
//! or `$fixed` it stands there once for each of them, in order; `$function`, `$Function` and `$GUARD` are
//! the name of the evaluator, `$first` is the first input. The other words with a dollar sign are holes for
//! what is computed. Lines behind a question mark stand there if inputs can be made of angles.

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
}

/// The lists whose members have a line each.
#[derive(Clone, Copy)]
enum List {
    Inputs,
    Outputs,
    Asked,
    Fixed,
}

impl List {
    /// The words for a member, and the list it is of; the angles are some of what is asked for.
    const ALL: [(&'static str, List); 5] = [
        ("$input", List::Inputs),
        ("$output", List::Outputs),
        ("$asked", List::Asked),
        ("$angle", List::Asked),
        ("$fixed", List::Fixed),
    ];

    fn of(self, names: &mut Names) -> &mut Vec<Name> {
        match self {
            List::Inputs => &mut names.inputs,
            List::Outputs => &mut names.outputs,
            List::Asked => &mut names.asked,
            List::Fixed => &mut names.fixed,
        }
    }
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
    let door = names.door.clone();
    for line in shape.lines() {
        let line = match (line.strip_prefix("? "), &door) {
            (Some(line), Some(_)) => line,
            (Some(_), None) => continue,
            (None, _) => line,
        };
        let line = of_function(line, names);
        let word = List::ALL.into_iter().find(|(word, _)| line.contains(word));
        let places = match (word, &door) {
            (Some(("$angle", _)), Some(door)) => door.angles.clone(),
            (Some((_, list)), _) => (0..list.of(names).len()).collect(),
            (None, _) => vec![0],
        };
        for place in places {
            let line = match word {
                Some((word, list)) => {
                    of_quantity(&line, word, list.of(names), place, dialect, cursor)?
                }
                None => line.clone(),
            };
            for token in tokens(&line, dialect)? {
                let hole = match (token.text, &door) {
                    ("$body", _) => Hole::Body,
                    ("$bounded_body", _) => Hole::BoundedBody,
                    ("$result", _) => Hole::Result(place),
                    ("$bounded_result", _) => Hole::BoundedResult(place),
                    ("$made", Some(door)) => {
                        door.made(place, dialect, names, cursor)?;
                        continue;
                    }
                    ("$number", Some(door)) => {
                        door.number(place, cursor)?;
                        continue;
                    }
                    (text, _) => {
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
    let first = names.inputs.first().and_then(|name| name.text.as_deref());
    let guard = format!("SEXTIC_{}_H", names.function.to_ascii_uppercase());
    line.replace("$GUARD", &guard)
        .replace("$function", &names.function)
        .replace("$Function", &names.type_prefix())
        .replace("$first", first.unwrap_or_default())
}

/// The line for the member of a list at a place.
fn of_quantity(
    line: &str,
    word: &str,
    quantities: &mut [Name],
    place: usize,
    dialect: Dialect,
    cursor: &Cursor<'_, '_>,
) -> Result<String, Unreadable> {
    if let Some(text) = &quantities[place].text {
        return Ok(line.replace(word, text));
    }
    let name = quantities[place].quantity.clone();
    let taken: Vec<String> = quantities
        .iter()
        .map(|other| other.quantity.clone())
        .collect();
    let is_taken = |spelling: &str| taken.iter().any(|name| name == spelling);
    for spelling in spellings(&name, is_taken) {
        let declaration = line.replace(word, &spelling);
        let expected = tokens(&declaration, dialect)?;
        let texts = expected.iter().map(|token| token.text);
        // Up to a hole, if there is one.
        let texts: Vec<&str> = texts.take_while(|text| !text.starts_with('$')).collect();
        if cursor.is_at(&texts) {
            quantities[place].text = Some(spelling);
            return Ok(declaration);
        }
    }
    Err(cursor.refuse(&format!("the declaration of `{name}`")))
}
