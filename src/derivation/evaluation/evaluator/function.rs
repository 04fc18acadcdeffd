//! The values of functions known only through their derivatives.

use crate::algebra::number::Rational;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::{Argument, Key};
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{Expression, Name};

use super::context::{Change, Context};
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// f⁽ᵏ⁾ at an argument: what the innermost change says that gives it a value, or else what it has
    /// at the point itself.
    pub(super) fn function(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        context: Context,
    ) -> Result<Number, Failure> {
        let mut level = context.surrounding;
        while level > 0 {
            if let Some(number) = self.changed_function(name, order, argument, context, level)? {
                return Ok(number);
            }
            level = self.surroundings[level].parent;
        }
        let moved = self.number(argument, context)?.step();
        let key = self.function_key(name, order, argument, context)?;
        let Key::Function(name, _, argument) = key else {
            return Err("this is no function".into());
        };
        self.taylor(&moved, |evaluator, j| {
            let key = Key::Function(name.clone(), order + j, argument.clone());
            Ok(evaluator.free(&key)?.number)
        })
    }

    /// f⁽ᵏ⁾ at an argument where one level of the surroundings gives it a value.
    fn changed_function(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        context: Context,
        level: usize,
    ) -> Result<Option<Number>, Failure> {
        let parent = self.surroundings[level].parent;
        let change = self.surroundings[level].change.clone();
        let concerns =
            |key: &Key| matches!(key, Key::Function(f, k, _) if *f == name.ascii && *k == order);
        let key = match &change {
            Change::Replace { functions, .. } => functions
                .iter()
                .any(|(known, k, _)| *known == name && *k == order)
                .then(|| self.function_key(name, order, self.reference(name)?, Context::of(parent)))
                .transpose()?,
            Change::Set(key, _) | Change::Shift(key, _) => concerns(key).then(|| key.clone()),
            Change::Scale(keys, _) => keys.iter().find(|key| concerns(key)).cloned(),
            Change::None | Change::Time(_) => None,
        };
        let Some(key) = key else { return Ok(None) };
        // What a change names is the value that the function has without the change.
        let lifted = context.in_surrounding(self.lift(context.surrounding, level));
        if self.function_key(name, order, argument, lifted)? != key {
            return Ok(None);
        }
        let value = match change {
            Change::Shift(_, step) => {
                let unchanged = self.function(name, order, argument, lifted)?;
                return Ok(Some(unchanged.sum(&step)));
            }
            Change::Scale(_, step) => {
                let unchanged = self.function(name, order, argument, lifted)?;
                return Ok(Some(self.point.extension.product(&unchanged, &step)));
            }
            Change::Replace {
                functions, frame, ..
            } => {
                let value = functions
                    .iter()
                    .find(|(known, k, _)| *known == name && *k == order);
                let (_, _, value) = value.ok_or("this is not replaced")?;
                self.number(value, Context::of(parent).in_frame(frame))?
            }
            Change::Set(_, value) => value,
            Change::None | Change::Time(_) => return Ok(None),
        };
        // The value belongs to the reference argument, from which inner changes may have moved.
        let reference = self.reference(name)?;
        let here = Context::of(level);
        let moved = self
            .number(argument, context)?
            .difference(&self.number(reference, here)?);
        if !moved.base().is_zero() {
            return Err(format!("{name} is replaced where it is not taken"));
        }
        let number = self.taylor(&moved, |evaluator, j| match j {
            0 => Ok(value.clone()),
            _ => evaluator.function(name, order + j, reference, here),
        })?;
        Ok(Some(number))
    }

    /// f(a + n) = Σ f⁽ʲ⁾(a) nʲ/j! for a nilpotent n.
    fn taylor(
        &mut self,
        moved: &Number,
        mut derivative: impl FnMut(&mut Self, u32) -> Result<Number, Failure>,
    ) -> Result<Number, Failure> {
        let (mut sum, mut power, mut j) = (Number::default(), Number::from(1), 0);
        while !power.is_zero() {
            let slope = derivative(self, j)?;
            sum = sum.sum(&self.point.extension.product(&slope, &power));
            j += 1;
            power = self.point.extension.product(&power, moved);
            power = power.scale(&(Rational::ONE / Rational::from(j)));
        }
        Ok(sum)
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
    match (sample.as_angle(), sample.angle.is_empty()) {
        (Some(angle), _) => Argument::Angle(angle.clone()),
        (None, true) => Argument::Number(sample.rest.clone()),
        (None, false) => Argument::Both(sample.angle.clone(), sample.rest.clone()),
    }
}
