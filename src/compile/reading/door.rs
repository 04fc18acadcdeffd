//! How a text makes inputs of angles: their sines and cosines must be those of the right sums.

use std::collections::BTreeMap;

use sextic_codegen::evaluator::{Circular, Evaluator, Function, Origin};

use crate::algebra::number::Rational;
use crate::compile::double::is_nearest;

use super::cursor::Cursor;
use super::infix::expression;
use super::literal::decimal;
use super::names::Names;
use super::token::Dialect;
use super::{Term, Unreadable};

/// No token: sums of angles have no square roots.
const NO_ROOT: [&str; 1] = [" "];

/// What the inputs of an evaluator are made of.
#[derive(Clone, Debug, Default)]
pub(super) struct Door {
    /// The names of what is asked for: given inputs, and angles that are not fixed.
    pub(super) asked: Vec<String>,
    /// The angles among them, by their places.
    pub(super) angles: Vec<usize>,
    /// The angles that are fixed, and their values.
    pub(super) fixed: Vec<(String, Rational)>,
    /// What each input is, in order.
    sources: Vec<Source>,
}

#[derive(Clone, Debug)]
enum Source {
    Given(String),
    Circular(Circular),
}

impl Door {
    /// The door of an evaluator, if it has sines or cosines among its inputs.
    pub(super) fn of(evaluator: &Evaluator) -> Option<Self> {
        let mut door = Door::default();
        for input in evaluator.free_inputs() {
            let name = &input.quantity.name;
            match &input.origin {
                Origin::Given => {
                    door.ask(name);
                    door.sources.push(Source::Given(name.clone()));
                }
                Origin::Circular(circular) => {
                    for (_, angle) in &circular.angle {
                        let known = evaluator
                            .angle(angle)
                            .and_then(|angle| angle.fixed.as_ref());
                        match known {
                            None => {
                                let place = door.ask(angle);
                                if !door.angles.contains(&place) {
                                    door.angles.push(place);
                                }
                            }
                            Some(value) if door.fixed.iter().all(|(known, _)| known != angle) => {
                                door.fixed.push((angle.clone(), value.value.clone()));
                            }
                            Some(_) => {}
                        }
                    }
                    door.sources.push(Source::Circular(circular.clone()));
                }
                Origin::Fixed(_) => {}
            }
        }
        let is_circular = |source: &Source| matches!(source, Source::Circular(_));
        // In the order of the evaluator's angles, and of what is asked for.
        let order = |name: &str| {
            let mut angles = evaluator.angles.iter();
            angles.position(|angle| angle.quantity.name == name)
        };
        door.fixed.sort_by_key(|(name, _)| order(name));
        door.angles.sort_unstable();
        door.sources.iter().any(is_circular).then_some(door)
    }

    /// The place of a name among what is asked for.
    fn ask(&mut self, name: &str) -> usize {
        let known = self.asked.iter().position(|known| known == name);
        known.unwrap_or_else(|| {
            self.asked.push(name.to_string());
            self.asked.len() - 1
        })
    }

    /// Moves over the number of a fixed angle.
    ///
    /// # Errors
    ///
    /// [`Unreadable`] if it is not the double that is nearest to the angle.
    pub(super) fn number(
        &self,
        place: usize,
        cursor: &mut Cursor<'_, '_>,
    ) -> Result<(), Unreadable> {
        let (name, value) = &self.fixed[place];
        let start = *cursor;
        let is_negative = cursor.accept(&["-"]);
        let number = cursor.peek().and_then(decimal);
        let number = number.map(|number| if is_negative { -number } else { number });
        match number.filter(|number| is_nearest(number, value)) {
            Some(_) => {
                cursor.advance();
                Ok(())
            }
            None => Err(start.refuse(&format!("the number of `{name}`"))),
        }
    }

    /// Moves over what an input is made of.
    ///
    /// # Errors
    ///
    /// [`Unreadable`] if that is not what it must be made of.
    pub(super) fn made(
        &self,
        place: usize,
        dialect: Dialect,
        names: &Names,
        cursor: &mut Cursor<'_, '_>,
    ) -> Result<(), Unreadable> {
        let circular = match &self.sources[place] {
            Source::Given(name) => {
                let text = names.asked(name).unwrap_or_default();
                return match dialect {
                    Dialect::Rust => cursor.expect(&["angles", ".", text]),
                    Dialect::C => cursor.expect(&["angles", "->", text]),
                    Dialect::Python => cursor.expect(&[text]),
                };
            }
            Source::Circular(circular) => circular,
        };
        let function = match circular.function {
            Function::Cosine => "cos",
            Function::Sine => "sin",
        };
        let start = *cursor;
        let sum = match dialect {
            Dialect::Rust => {
                let sum = match cursor.accept(&["("]) {
                    true => {
                        let sum = expression(cursor, &NO_ROOT)?;
                        cursor.expect(&[")"])?;
                        sum
                    }
                    false => Term::Name(cursor.word()?.to_string()),
                };
                cursor.expect(&[".", function, "(", ")"])?;
                sum
            }
            Dialect::C | Dialect::Python => {
                if dialect == Dialect::Python {
                    cursor.expect(&["np", "."])?;
                }
                cursor.expect(&[function, "("])?;
                let sum = expression(cursor, &NO_ROOT)?;
                cursor.expect(&[")"])?;
                sum
            }
        };
        let wanted: BTreeMap<String, Rational> = circular
            .angle
            .iter()
            .map(|(count, angle)| (angle.clone(), Rational::from(*count)))
            .collect();
        match counts(&sum, names) {
            Some(found) if found == wanted => Ok(()),
            _ => Err(start.refuse(&format!("the {function} of the right sum of angles"))),
        }
    }
}

/// How often each angle occurs in a sum; none for anything but a sum of multiples of angles.
fn counts(sum: &Term, names: &Names) -> Option<BTreeMap<String, Rational>> {
    let merged = |a: &Term, b: &Term, sign: i32| {
        let mut sum = counts(a, names)?;
        for (angle, count) in counts(b, names)? {
            *sum.entry(angle).or_insert(Rational::ZERO) += Rational::from(sign) * count;
        }
        sum.retain(|_, count| !count.is_zero());
        Some(sum)
    };
    match sum {
        Term::Name(name) => {
            let angle = names.angle(name)?;
            Some(BTreeMap::from([(angle.to_string(), Rational::ONE)]))
        }
        Term::Negative(inner) => merged(&Term::Number(Rational::ZERO), inner, -1),
        Term::Add(a, b) => merged(a, b, 1),
        Term::Subtract(a, b) => merged(a, b, -1),
        Term::Multiply(a, b) => match a.as_ref() {
            Term::Number(factor) => {
                let mut product = counts(b, names)?;
                product.values_mut().for_each(|count| *count *= factor);
                Some(product)
            }
            _ => None,
        },
        Term::Number(number) if number.is_zero() => Some(BTreeMap::new()),
        Term::Number(_) | Term::Divide(..) | Term::SquareRoot(_) => None,
    }
}
