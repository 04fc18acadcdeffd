//! Reads emitted Python.

use std::collections::BTreeSet;

use super::body::{Door, Reading, Source, Unreadable};
use super::cursor::Cursor;
use super::infix::{Words, expression};
use super::names::{Name, Names, quantity};
use super::reader::Reader;
use super::shape::{Hole, follow, taken};
use super::source::circular;
use super::token::{Dialect, tokens};

/// What a module is.
const MODULE: &str = include_str!("shapes/python.txt");

/// The usual signs, and the tokens of a square root.
const WORDS: Words = Words::usual(&["np", ".", "sqrt"]);

/// The start of a line of the function.
const LINE: &str = "\n    ";

/// The start of a line of the method that takes angles.
const INNER_LINE: &str = "\n        ";

/// Modules of a package.
pub(super) const READER: Reader = Reader {
    ending: "py",
    read: |texts, names| {
        let (reading, door) = texts.read("py", |text| read(text, names))?;
        Ok((
            vec![(texts.place("py", ""), reading)],
            (texts.place("py", ".at_angles"), door),
        ))
    },
};

/// Reads a module: two classes with exactly the fields of the evaluator, and a function.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
fn read(text: &str, names: &mut Names) -> Result<(Reading, Door), Unreadable> {
    let tokens = tokens(text, Dialect::Python)?;
    let mut cursor = Cursor::new(&tokens);
    let taken = taken(MODULE, Dialect::Python, names)?;
    let (mut reading, mut door) = (Reading::default(), Door::default());
    follow(
        MODULE,
        Dialect::Python,
        names,
        &mut cursor,
        &mut |hole, names, cursor| match hole {
            Hole::Body => {
                let read: [&str; 2] = ["inputs", "."];
                statements(
                    cursor,
                    [LINE, "shape", "="],
                    &read,
                    &names.inputs,
                    &taken,
                    &mut reading,
                )
            }
            Hole::Result(place) => {
                let output = names.outputs[place].quantity.clone();
                reading.outputs.push((output, expression(cursor, &WORDS)?));
                Ok(())
            }
            Hole::Door => {
                let end = [INNER_LINE, "return", "cls"];
                statements(cursor, end, &[], &names.asked, &taken, &mut door.angles)
            }
            Hole::Source(place) => {
                let input = names.inputs[place].quantity.clone();
                door.inputs.push((input, source(cursor, &names.asked)?));
                Ok(())
            }
            Hole::BoundedBody | Hole::BoundedResult(_) => Err(cursor.refuse("one body")),
        },
    )?;
    Ok((reading, door))
}

/// `t1 = a * b`, a line each, until what stands behind them is found; `read` are the tokens in front of
/// the name of a field that is read.
fn statements(
    cursor: &mut Cursor<'_, '_>,
    end: [&str; 3],
    read: &[&str],
    names: &[Name],
    taken: &BTreeSet<String>,
    reading: &mut Reading,
) -> Result<(), Unreadable> {
    // The hole stands behind the line before its first one.
    while !cursor.is_at(&end) {
        cursor.expect(&end[..1])?;
        if cursor.peek().is_some_and(|word| taken.contains(word)) {
            return Err(cursor.refuse("a free name"));
        }
        let variable = cursor.word()?.to_string();
        cursor.expect(&["="])?;
        if cursor.accept(&["np", ".", "asarray", "("]) {
            cursor.expect(read)?;
            let line = cursor.line();
            // An argument keeps its name, so that no other one is taken for it later.
            if read.is_empty() && cursor.peek() != Some(variable.as_str()) {
                return Err(cursor.refuse(&format!("`{variable}`")));
            }
            let field = cursor.word()?;
            cursor.expect(&[",", "dtype", "=", "np", ".", "float64", ")"])?;
            reading.load(names, field, variable, line)?;
        } else if read.is_empty() && quantity(names, &variable).is_some() {
            return Err(cursor.refuse("an array"));
        } else {
            reading
                .assignments
                .push((variable, expression(cursor, &WORDS)?));
        }
    }
    Ok(())
}

/// `m`, `np.cos(alpha + beta)`
fn source(cursor: &mut Cursor<'_, '_>, asked: &[Name]) -> Result<Source, Unreadable> {
    if let Some(name) = cursor.peek().and_then(|word| quantity(asked, word)) {
        cursor.advance();
        return Ok(Source::Given(name.to_string()));
    }
    cursor.expect(&["np", "."])?;
    circular(cursor, &WORDS)
}
