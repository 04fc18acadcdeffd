//! Calls: functions known only through their derivatives, and definitions with arguments.

use crate::algebra::number::Rational;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::{Argument, Key};
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::evaluation::table::{Table, single};
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{Expression, Name};

use super::context::{Change, Context};
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// The value of a call.
    pub(super) fn call(
        &mut self,
        function: &'a Name,
        order: u32,
        arguments: &'a [Expression],
        context: Context,
    ) -> Result<Table, Failure> {
        let scope = self.scope;
        match (scope.get(function).map(|entry| &entry.meaning), arguments) {
            (Some(Meaning::Function { .. }), [argument]) => {
                self.function(function, order, argument, context)
            }
            (
                Some(Meaning::Template {
                    arguments: names,
                    expression,
                }),
                _,
            ) => {
                let names = names.iter().map(|name| name.ascii.as_str());
                let inside = self.called(context, names.zip(arguments).collect());
                self.table(expression, inside)
            }
            (Some(_), _) => Err(format!("{function} is no function")),
            (None, _) => self.built_in(&function.ascii, arguments, context),
        }
    }

    /// f⁽ᵏ⁾(a + n) = Σ f⁽ᵏ⁺ʲ⁾(a) nʲ/j! for a nilpotent n.
    pub(super) fn function(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        context: Context,
    ) -> Result<Table, Failure> {
        let sample = self.scalar(argument, context)?;
        let step = sample.number.step();
        let (mut sum, mut power, mut order) = (Number::default(), Number::from(1), order);
        let mut j = 1;
        while !power.is_zero() {
            let slope = self.function_value(name, order, argument, context)?;
            sum = sum.sum(&self.point.extension.product(&slope, &power));
            power = self.point.extension.product(&power, &step);
            power = power.scale(&(Rational::ONE / Rational::from(j)));
            order += 1;
            j += 1;
        }
        Ok(single(sum))
    }

    /// f⁽ᵏ⁾ at the point itself.
    fn function_value(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        context: Context,
    ) -> Result<Number, Failure> {
        let mut level = context.surrounding;
        while level > 0 {
            let parent = self.surroundings[level].parent;
            if let Change::Replace {
                functions,
                frame: outside,
                ..
            } = &self.surroundings[level].change
            {
                let outside = *outside;
                let replaced = functions
                    .iter()
                    .find(|(known, k, _)| *known == name && *k == order);
                if let Some((known, _, value)) = replaced.copied() {
                    // A replacement names the value that the function has without the replacement.
                    let reference = self.reference(known)?;
                    let lifted = self.lift(context.surrounding, level);
                    let lifted = context.in_surrounding(lifted);
                    let here = argument_of(&self.scalar(argument, lifted)?);
                    let outside = Context::of(parent).in_frame(outside);
                    if here == argument_of(&self.scalar(reference, Context::of(parent))?) {
                        return self.number(value, outside);
                    }
                }
            }
            level = parent;
        }
        let key = self.function_key(name, order, argument, context)?;
        Ok(self.look_up(&key, context.surrounding)?.number)
    }

    /// The key of f⁽ᵏ⁾ at an argument; the reference argument has a key of its own, under which the
    /// value is shown as `C_D`.
    pub(super) fn function_key(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        context: Context,
    ) -> Result<Key, Failure> {
        let here = argument_of(&self.scalar(argument, context)?);
        let reference = argument_of(&self.scalar(self.reference(name)?, Context::default())?);
        let argument = if here == reference {
            Argument::Reference
        } else {
            here
        };
        Ok(Key::Function(name.ascii.clone(), order, argument))
    }

    /// Where the bare name of a function is taken.
    pub(super) fn reference(&self, name: &Name) -> Result<&'a Expression, Failure> {
        let scope = self.scope;
        match scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Function { reference, .. }) => Ok(reference),
            _ => Err(format!("{name} is no function")),
        }
    }
}

fn argument_of(sample: &Sample) -> Argument {
    match &sample.angle {
        Some(tag) => Argument::Angle(tag.clone()),
        None => Argument::Number(sample.number.base()),
    }
}
