//! Where a caller comes in who knows angles, and not their sines and cosines.

use super::Error;
use super::body::nearest;
use super::documentation::{self, Comments};
use super::literal::Decimal;
use super::named::{Field, Named};
use super::notation::{Binding, Sign, Text, infix, plain_literal, prefix};
use crate::evaluator::{Circular, Evaluator, Function, Origin, Quantity};

/// What the inputs of an evaluator are made of.
#[derive(Clone, Debug)]
pub struct Door<'a> {
    /// What is asked for: the inputs that are no sines and cosines, and the angles.
    pub fields: Vec<Field>,
    /// What is asked for, by its name in the document and by that of its field.
    pub called: Vec<(&'a str, String)>,
    /// The angles that are asked for: their fields, and the variables that they are read into.
    pub angles: Vec<(String, String)>,
    /// The angles that are fixed, as variables, and their numbers.
    pub fixed: Vec<(String, Decimal)>,
    /// The inputs, and what each of them is.
    pub inputs: Vec<(String, Source)>,
}

/// What an input is made of.
#[derive(Clone, Debug)]
pub enum Source {
    /// What is asked for under this name.
    Given(String),
    /// The circular function of an expression of angles.
    Circular(Function, Text),
}

impl<'a> Door<'a> {
    /// The door of an evaluator, if it has sines or cosines among its inputs.
    pub fn of(
        evaluator: &'a Evaluator,
        named: &Named,
        comments: &Comments,
    ) -> Result<Option<Self>, Error> {
        if evaluator
            .free_inputs()
            .all(|input| input.circular().is_none())
        {
            return Ok(None);
        }
        let asked = asked(evaluator);
        let mut fixed = Vec::new();
        for angle in evaluator.open_angles() {
            if let Some(known) = &angle.fixed {
                fixed.push((angle.quantity.name.as_str(), nearest(&known.value)?));
            }
        }
        let names = asked.iter().map(|(what, _)| what.name.as_str());
        let names: Vec<&str> = names.chain(fixed.iter().map(|(name, _)| *name)).collect();
        let fields = named.safety.fields(names.iter().copied())?;
        let variables = named.safety.variables(names.iter().copied())?;
        let called = |written: &[String], wanted: &str| {
            let place = names.iter().position(|name| *name == wanted);
            place.map_or_else(|| wanted.to_owned(), |place| written[place].clone())
        };
        let name = |wanted: &str| called(&fields, wanted);
        let variable = |wanted: &str| called(&variables, wanted);

        let field = |(what, _): &(&Quantity, bool)| Field {
            documentation: documentation::field(what, &name(&what.name), comments),
            name: name(&what.name),
        };
        let pairs = named.inputs.iter().zip(&evaluator.inputs);
        let inputs = pairs.filter_map(|(own, input)| {
            let source = match &input.origin {
                Origin::Given => Source::Given(name(&input.quantity.name)),
                Origin::Circular(circular) => {
                    Source::Circular(circular.function, sum(circular, &variable))
                }
                Origin::Fixed(_) => return None,
            };
            Some((own.clone(), source))
        });
        let angles = asked.iter().filter(|(_, is_angle)| *is_angle);
        let called = asked.iter().map(|(what, _)| what.name.as_str());
        Ok(Some(Door {
            called: called.map(|wanted| (wanted, name(wanted))).collect(),
            fields: asked.iter().map(field).collect(),
            angles: angles
                .map(|(what, _)| (name(&what.name), variable(&what.name)))
                .collect(),
            inputs: inputs.collect(),
            fixed: fixed
                .into_iter()
                .map(|(angle, number)| (variable(angle), number))
                .collect(),
        }))
    }
}

/// What is asked for, each once, in the order in which the inputs need it; and whether it is an angle.
fn asked(evaluator: &Evaluator) -> Vec<(&Quantity, bool)> {
    let mut asked: Vec<(&Quantity, bool)> = Vec::new();
    let mut add = |what, is_angle| {
        let name = |quantity: &Quantity| quantity.name.clone();
        match asked
            .iter_mut()
            .find(|(known, _)| name(known) == name(what))
        {
            Some((_, known)) => *known |= is_angle,
            None => asked.push((what, is_angle)),
        }
    };
    for input in &evaluator.inputs {
        match &input.origin {
            Origin::Given => add(&input.quantity, false),
            Origin::Circular(circular) => {
                let angles = circular.angle.iter();
                for angle in angles.filter_map(|(_, name)| evaluator.angle(name)) {
                    if angle.fixed.is_none() {
                        add(&angle.quantity, true);
                    }
                }
            }
            Origin::Fixed(_) => {}
        }
    }
    asked
}

/// `2.0 * alpha - beta`
fn sum(circular: &Circular, name: &impl Fn(&str) -> String) -> Text {
    let mut sum: Option<Text> = None;
    for (count, angle) in &circular.angle {
        let angle = Text::new(name(angle), Binding::Atom);
        let times = |factor: f64| match factor {
            1.0 => angle.clone(),
            _ => {
                let factor = Decimal {
                    text: format!("{factor:?}"),
                    value: factor,
                };
                infix(Sign::Multiply, &plain_literal(&factor), &angle)
            }
        };
        let count = f64::from(*count);
        sum = Some(match sum {
            Some(sum) if count < 0.0 => infix(Sign::Subtract, &sum, &times(-count)),
            Some(sum) => infix(Sign::Add, &sum, &times(count)),
            None if count == -1.0 => prefix(&angle),
            None => times(count),
        });
    }
    // There is one: an empty sum is refused.
    sum.unwrap_or_else(|| Text::new("0.0", Binding::Atom))
}
