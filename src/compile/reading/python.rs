//! Reads emitted Python.

use super::cursor::Cursor;
use super::infix::expression;
use super::names::Names;
use super::shape::{Hole, follow};
use super::token::{Dialect, tokens};
use super::{Reading, Unreadable};

/// What a module is.
const MODULE: &str = include_str!("shapes/python.txt");

/// The tokens of a square root.
const ROOT: [&str; 3] = ["np", ".", "sqrt"];

/// The start of a line of the body.
const LINE: &str = "\n    ";

/// Reads a module: two classes with exactly the fields of the evaluator, and a function.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
pub(super) fn read(text: &str, names: &mut Names) -> Result<Reading, Unreadable> {
    let tokens = tokens(text, Dialect::Python)?;
    let mut cursor = Cursor::new(&tokens);
    let mut reading = Reading::default();
    let outputs = names.outputs.clone();
    follow(
        MODULE,
        Dialect::Python,
        names,
        &mut cursor,
        &mut |hole, names, cursor| match hole {
            Hole::Body => statements(cursor, names, &mut reading),
            Hole::Result(place) => {
                let output = outputs[place].quantity.clone();
                reading.outputs.push((output, expression(cursor, &ROOT)?));
                Ok(())
            }
            Hole::BoundedBody | Hole::BoundedResult(_) => Err(cursor.refuse("one body")),
        },
    )?;
    Ok(reading)
}

/// `t1 = a * b`, a line each, until the shape of the outputs is found.
fn statements(
    cursor: &mut Cursor<'_, '_>,
    names: &Names,
    reading: &mut Reading,
) -> Result<(), Unreadable> {
    // The hole stands behind the start of its first line.
    while !cursor.is_at(&[LINE, "shape", "="]) {
        cursor.expect(&[LINE])?;
        let taken = ["np", "inputs", "shape"].map(|word| cursor.is_at(&[word]));
        if taken.contains(&true) {
            return Err(cursor.refuse("a free name"));
        }
        let variable = cursor.word()?.to_string();
        cursor.expect(&["="])?;
        if cursor.accept(&["np", ".", "asarray", "(", "inputs", "."]) {
            let line = cursor.line();
            let field = cursor.word()?;
            cursor.expect(&[",", "dtype", "=", "np", ".", "float64", ")"])?;
            reading.load(names, field, variable, line)?;
        } else {
            reading
                .assignments
                .push((variable, expression(cursor, &ROOT)?));
        }
    }
    Ok(())
}
