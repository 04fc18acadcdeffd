//! Reads emitted Octave.

use std::collections::BTreeSet;

use super::body::{Door, Reading, Unreadable};
use super::cursor::Cursor;
use super::infix::{Words, expression};
use super::names::{Name, Names};
use super::reader::Reader;
use super::shape::{Hole, follow, taken};
use super::source::source;
use super::token::{Dialect, tokens};

/// What a function file is.
const FUNCTION: &str = include_str!("shapes/octave.txt");

/// The signs of elements, and the function of the file that gives a root.
const ELEMENTS: Words = Words {
    products: [".*", "./"],
    root: &["square_root"],
};

/// Words of bodies that stand in no shape, and that no variable may have for a name.
const TAKEN: [&str; 3] = ["cos", "double", "sin"];

/// The start of a line, which ends a statement.
const LINE: &str = "\n";

/// Function files.
pub(super) const READER: Reader = Reader {
    ending: "m",
    read: |texts, names| {
        let (reading, door) = texts.read("m", |text| read(text, names))?;
        Ok((
            vec![(texts.place("m", ""), reading)],
            (texts.place("m", ", at_angles"), door),
        ))
    },
};

/// Reads a file: the function, what it computes, and what checks its inputs.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
fn read(text: &str, names: &mut Names) -> Result<(Reading, Door), Unreadable> {
    let tokens = tokens(text, Dialect::Octave)?;
    let mut cursor = Cursor::new(&tokens);
    let mut taken = taken(FUNCTION, Dialect::Octave, names)?;
    taken.extend(TAKEN.map(String::from));
    let (mut reading, mut door) = (Reading::default(), Door::default());
    follow(
        FUNCTION,
        Dialect::Octave,
        names,
        &mut cursor,
        &mut |hole, names, cursor| match hole {
            Hole::Body => {
                let wiring = ["given", "values"];
                statements(cursor, wiring, &names.inputs, &taken, &mut reading)
            }
            Hole::Result(place) => {
                let output = names.outputs[place].quantity.clone();
                let value = expression(cursor, &ELEMENTS)?;
                reading.outputs.push((output, value));
                Ok(())
            }
            Hole::Door => {
                let wiring = ["angles", "inputs"];
                statements(cursor, wiring, &names.asked, &taken, &mut door.angles)
            }
            Hole::Source(place) => {
                let input = names.inputs[place].quantity.clone();
                door.inputs
                    .push((input, source(cursor, &names.asked, &["angles", "."])?));
                Ok(())
            }
            Hole::BoundedBody | Hole::BoundedResult(_) => Err(cursor.refuse("one body")),
        },
    )?;
    Ok((reading, door))
}

/// `t1 = a .* b;`, a line each, until a field of what is returned is assigned; what is read, and what is
/// returned, are structures.
fn statements(
    cursor: &mut Cursor<'_, '_>,
    [read, returned]: [&str; 2],
    names: &[Name],
    taken: &BTreeSet<String>,
    reading: &mut Reading,
) -> Result<(), Unreadable> {
    // The hole stands behind the line before its first one.
    while !cursor.is_at(&[LINE, returned, "."]) {
        cursor.expect(&[LINE])?;
        if cursor.peek().is_some_and(|word| taken.contains(word)) {
            return Err(cursor.refuse("a free name"));
        }
        let variable = cursor.word()?.to_string();
        cursor.expect(&["="])?;
        if cursor.accept(&["double", "("]) {
            cursor.expect(&[read, "."])?;
            let line = cursor.line();
            let field = cursor.word()?;
            cursor.expect(&[")"])?;
            reading.load(names, field, variable, line)?;
        } else {
            let value = expression(cursor, &ELEMENTS)?;
            reading.assignments.push((variable, value));
        }
        cursor.expect(&[";"])?;
    }
    Ok(())
}
