//! Reads emitted C: the header with its declarations, and the source with its two bodies.

use std::collections::BTreeSet;

use super::body::{Door, Reading, Term, Unreadable};
use super::cursor::Cursor;
use super::infix::{Words, expression};
use super::literal::decimal;
use super::names::{Name, Names};
use super::reader::Reader;
use super::shape::{Hole, follow, taken};
use super::source::source;
use super::token::{Dialect, tokens};

/// What a header is.
const HEADER: &str = include_str!("shapes/c_header.txt");

/// What a source is.
const SOURCE: &str = include_str!("shapes/c_source.txt");

/// How deep calls may be nested.
const DEEPEST: usize = 64;

/// Words of bodies that no variable may have for a name.
const TAKEN: [&str; 5] = ["sqrt", "cos", "sin", "sextic_exact", "sextic_square_root"];

/// Headers and sources.
pub(super) const READER: Reader = Reader {
    ending: "c",
    read: |texts, names| {
        // Without a source nothing is read.
        texts.read("c", |_| Ok(()))?;
        texts.read("h", |text| read_header(text, names))?;
        let ([plain, bounded], door) = texts.read("c", |text| read_source(text, names))?;
        let bodies = vec![
            (texts.place("c", "_body"), plain),
            (texts.place("c", "_with_bound"), bounded),
        ];
        Ok((bodies, (texts.place("c", "_inputs_at"), door)))
    },
};

/// Checks the header: its structures have exactly the fields of the evaluator, in order.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
fn read_header(text: &str, names: &mut Names) -> Result<(), Unreadable> {
    let tokens = tokens(text, Dialect::C)?;
    let mut cursor = Cursor::new(&tokens);
    follow(
        HEADER,
        Dialect::C,
        names,
        &mut cursor,
        &mut |_, _, cursor| Err(cursor.refuse("a declaration")),
    )
}

/// Reads the source, whose names are those of the header: the body with the usual signs, and the one
/// whose calls keep a bound of the rounding error.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be.
fn read_source(text: &str, names: &mut Names) -> Result<([Reading; 2], Door), Unreadable> {
    let tokens = tokens(text, Dialect::C)?;
    let mut cursor = Cursor::new(&tokens);
    let taken = taken(SOURCE, Dialect::C, names)?;
    let (mut plain, mut bounded) = (Reading::default(), Reading::default());
    let mut door = Door::default();
    follow(
        SOURCE,
        Dialect::C,
        names,
        &mut cursor,
        &mut |hole, names, cursor| {
            match hole {
                Hole::Body => statements(cursor, &Plain, &names.inputs, &taken, &mut plain)?,
                Hole::BoundedBody => {
                    statements(cursor, &Bounded, &names.inputs, &taken, &mut bounded)?
                }
                Hole::Result(place) => {
                    let output = names.outputs[place].quantity.clone();
                    plain.outputs.push((output, Plain.value(cursor)?));
                }
                Hole::BoundedResult(place) => {
                    let output = names.outputs[place].quantity.clone();
                    bounded.outputs.push((output, Bounded.value(cursor)?));
                }
                Hole::Door => statements(cursor, &Angles, &names.asked, &taken, &mut door.angles)?,
                Hole::Source(place) => {
                    let input = names.inputs[place].quantity.clone();
                    door.inputs
                        .push((input, source(cursor, &names.asked, &["angles", "->"])?));
                }
            }
            Ok(())
        },
    )?;
    Ok(([plain, bounded], door))
}

/// How a body writes types, inputs and values.
trait Notation {
    const TYPE: &'static str;
    /// The tokens around the name of a field that is read.
    const LOAD: (&'static [&'static str], &'static [&'static str]);

    fn value(&self, cursor: &mut Cursor<'_, '_>) -> Result<Term, Unreadable>;
}

/// The usual signs.
struct Plain;

impl Notation for Plain {
    const TYPE: &'static str = "double";
    const LOAD: (&'static [&'static str], &'static [&'static str]) = (&["inputs", "->"], &[]);

    fn value(&self, cursor: &mut Cursor<'_, '_>) -> Result<Term, Unreadable> {
        expression(cursor, &Words::usual(&["sqrt"]))
    }
}

/// Angles that are read, and expressions of them.
struct Angles;

impl Notation for Angles {
    const TYPE: &'static str = "double";
    const LOAD: (&'static [&'static str], &'static [&'static str]) = (&["angles", "->"], &[]);

    fn value(&self, cursor: &mut Cursor<'_, '_>) -> Result<Term, Unreadable> {
        expression(cursor, &Words::usual(&["sqrt"]))
    }
}

/// Calls of the functions of `sextic_bounded.h`.
struct Bounded;

impl Notation for Bounded {
    const TYPE: &'static str = "sextic_bounded";
    const LOAD: (&'static [&'static str], &'static [&'static str]) =
        (&["sextic_exact", "(", "inputs", "->"], &[")"]);

    fn value(&self, cursor: &mut Cursor<'_, '_>) -> Result<Term, Unreadable> {
        call(cursor, 0)
    }
}

/// `const double t1 = a * b;` as often as there are such.
fn statements<N: Notation>(
    cursor: &mut Cursor<'_, '_>,
    notation: &N,
    names: &[Name],
    taken: &BTreeSet<String>,
    reading: &mut Reading,
) -> Result<(), Unreadable> {
    while cursor.accept(&["const"]) {
        cursor.expect(&[N::TYPE])?;
        let is_taken = |word| TAKEN.contains(&word) || taken.contains(word);
        if cursor.peek().is_some_and(is_taken) {
            return Err(cursor.refuse("a free name"));
        }
        let variable = cursor.word()?.to_string();
        cursor.expect(&["="])?;
        if cursor.accept(N::LOAD.0) {
            let line = cursor.line();
            let field = cursor.word()?;
            cursor.expect(N::LOAD.1)?;
            reading.load(names, field, variable, line)?;
        } else {
            reading
                .assignments
                .push((variable, notation.value(cursor)?));
        }
        cursor.expect(&[";"])?;
    }
    Ok(())
}

/// `sextic_add(a, b)`, `sextic_exact(2.0)`, a name.
fn call(cursor: &mut Cursor<'_, '_>, depth: usize) -> Result<Term, Unreadable> {
    if depth > DEEPEST {
        return Err(cursor.refuse("an expression that is less deep"));
    }
    let function = cursor.word()?;
    if !cursor.accept(&["("]) {
        return Ok(Term::Name(function.to_string()));
    }
    let term = match function {
        "sextic_exact" => number(cursor)?,
        "sextic_negative" => Term::Negative(Box::new(call(cursor, depth + 1)?)),
        "sextic_square_root" => Term::SquareRoot(Box::new(call(cursor, depth + 1)?)),
        "sextic_add" | "sextic_subtract" | "sextic_multiply" | "sextic_divide" => {
            let left = Box::new(call(cursor, depth + 1)?);
            cursor.expect(&[","])?;
            let right = Box::new(call(cursor, depth + 1)?);
            match function {
                "sextic_add" => Term::Add(left, right),
                "sextic_subtract" => Term::Subtract(left, right),
                "sextic_multiply" => Term::Multiply(left, right),
                _ => Term::Divide(left, right),
            }
        }
        _ => return Err(cursor.refuse(&format!("no call of `{function}`"))),
    };
    cursor.expect(&[")"])?;
    Ok(term)
}

/// `2.0` or `-2.0`
fn number(cursor: &mut Cursor<'_, '_>) -> Result<Term, Unreadable> {
    let is_negative = cursor.accept(&["-"]);
    let Some(number) = cursor.peek().and_then(decimal) else {
        return Err(cursor.refuse("a decimal number"));
    };
    cursor.advance();
    let number = Term::Number(number);
    Ok(match is_negative {
        true => Term::Negative(Box::new(number)),
        false => number,
    })
}
