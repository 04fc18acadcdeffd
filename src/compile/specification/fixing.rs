//! What becomes of a specification when quantities are given numbers.

use sextic_codegen::evaluator::{Angle, Circular, Fixed as FixedInput, Function, Origin};

use crate::algebra::number::Rational;
use crate::compile::circle::{Enclosure, cosine, sine};
use crate::compile::constant::Constant;
use crate::compile::fixed::Fixed;
use crate::derivation::presentation::Presenter;
use crate::language::syntax::{Expression, Name, Replacement};

use super::{Refusal, Specification};

/// More than a full turn is taken for degrees.
const FULL_TURN: (i64, i64) = (6_284, 1000);

/// The replacements of the quantities that make a program simpler; all of them are looked at first.
pub(super) fn replacements(
    fixed: &[&Fixed],
    general: &mut Specification,
) -> Result<Vec<Replacement>, Refusal> {
    general.admit(fixed)?;
    let is_simple = |fixed: &&&Fixed| {
        let is_angle = general.evaluator.angle(&fixed.name).is_some();
        fixed.value.is_zero() || (!is_angle && magnitude(&fixed.value).is_one())
    };
    let simple = fixed.iter().filter(is_simple);
    simple.map(|fixed| general.replacement(fixed)).collect()
}

impl Specification {
    /// Whether numbers are allowed by the assumptions of the document, and none of them makes a divisor
    /// zero; those of names that it does not rest on are not looked at.
    ///
    /// # Errors
    ///
    /// [`Refusal::Number`]
    pub fn admit(&mut self, numbers: &[&Fixed]) -> Result<(), Refusal> {
        let full_turn = Rational::from(FULL_TURN.0) / Rational::from(FULL_TURN.1);
        let mut replacements = Vec::new();
        for number in numbers.iter().filter(|number| self.rests_on(&number.name)) {
            if self.evaluator.angle(&number.name).is_none() {
                replacements.push(self.replacement(number)?);
            } else if magnitude(&number.value) > full_turn {
                let reason = "this is more than a full turn, and angles are given in radians";
                return Err(Refusal::Number(number.name.clone(), reason.to_string()));
            }
        }
        self.admit_replacements(&replacements)
    }

    /// A number in the place of what its name stands for in the document.
    fn replacement(&self, number: &Fixed) -> Result<Replacement, Refusal> {
        let mut inputs = self.evaluator.inputs.iter();
        let target = match inputs.position(|input| input.quantity.name == number.name) {
            // An angle, of which only the sine and cosine are inputs.
            None => Expression::name(Name::new(&number.name)),
            Some(place) => {
                let presenter = Presenter {
                    ring: &self.elaborator.ring,
                    scope: &self.elaborator.scope,
                };
                let written = presenter.symbol(self.symbols[place]);
                written.map_err(|error| Refusal::Program(error.to_string()))?
            }
        };
        Ok(Replacement {
            target,
            value: Expression::number(number.value.clone()),
        })
    }

    /// Gives fixed quantities their numbers, where the program has them.
    pub(super) fn fix(&mut self, fixed: &[&Fixed]) {
        self.fixed = fixed.iter().map(|fixed| fixed.name.clone()).collect();
        let find = |name: &str| fixed.iter().find(|fixed| fixed.name == name);
        for angle in &mut self.evaluator.angles {
            angle.fixed = find(&angle.quantity.name).map(|fixed| FixedInput {
                value: fixed.value.clone(),
                text: format!("{} = {}", angle.quantity.symbol, fixed.text),
            });
        }
        let angles = &self.evaluator.angles;
        for input in &mut self.evaluator.inputs {
            let quantity = &input.quantity;
            let known = match &input.origin {
                Origin::Given => find(&quantity.name).map(|fixed| {
                    let text = format!("{} = {}", quantity.symbol, fixed.text);
                    (Enclosure::exact(fixed.value.clone()), text)
                }),
                Origin::Circular(circular) => value_of(circular, angles)
                    .map(|(value, at)| (value, format!("{} at {at}", quantity.symbol))),
                Origin::Fixed(_) => None,
            };
            let Some((value, text)) = known else {
                continue;
            };
            let place = self
                .inputs
                .iter()
                .position(|(name, _)| *name == quantity.name);
            if let Some(place) = place {
                let (name, element) = self.inputs.remove(place);
                self.constants.push(Constant {
                    name,
                    element,
                    lower: value.lower.clone(),
                    upper: value.upper.clone(),
                });
            }
            let value = (value.lower + value.upper) / Rational::from(2);
            input.origin = Origin::Fixed(FixedInput { value, text });
        }
    }
}

/// The value of a circular function of angles that are all fixed, and at what.
fn value_of(circular: &Circular, angles: &[Angle]) -> Option<(Enclosure, String)> {
    let mut sum = Rational::ZERO;
    let mut texts = Vec::new();
    for (count, name) in &circular.angle {
        let angle = angles.iter().find(|angle| angle.quantity.name == *name)?;
        let fixed = angle.fixed.as_ref()?;
        sum += Rational::from(*count) * &fixed.value;
        texts.push(fixed.text.clone());
    }
    let value = match circular.function {
        Function::Cosine => cosine(&sum),
        Function::Sine => sine(&sum),
    };
    Some((value, texts.join(", ")))
}

fn magnitude(value: &Rational) -> Rational {
    match *value < Rational::ZERO {
        true => -value.clone(),
        false => value.clone(),
    }
}
