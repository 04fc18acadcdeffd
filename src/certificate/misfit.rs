//! What does not fit together in an ill-formed claim, in the words of the kernel.

use crate::derivation::assertion::Misfit;
use crate::language::syntax::Expression;

use super::composer::Composer;
use super::expression::Withheld;

impl Composer<'_> {
    /// What an ill-formed relation says: two of its parts differ in their units, or it has no value at all.
    pub(super) fn misfit(
        &mut self,
        left: &Expression,
        right: &Expression,
        misfit: &Misfit,
    ) -> Result<String, Withheld> {
        let Misfit::Units(parts) = misfit else {
            let (left, right) = (self.writer.argument(left)?, self.writer.argument(right)?);
            return Ok(format!("without_value ({left} - {right})"));
        };
        let parts = parts
            .as_ref()
            .ok_or("the units differ inside of a definition")?;
        let (one, other) = self.entries_that_differ(&parts.0, &parts.1)?;
        let (one, other) = (self.writer.argument(&one)?, self.writer.argument(&other)?);
        Ok(format!(
            "differ_in_unit {}\n  {one}\n  {other}",
            self.units()?
        ))
    }

    /// Two numbers themselves, or the first entries of two matrices that differ in their units.
    fn entries_that_differ(
        &self,
        one: &Expression,
        other: &Expression,
    ) -> Result<(Expression, Expression), Withheld> {
        let mut elaborator = self.audit.elaborator.clone();
        elaborator.fresh();
        let mut value = |own: &Expression| elaborator.value(own).map_err(|error| error.message);
        let (a, b) = (value(one)?, value(other)?);
        let mut units = a.entries().iter().zip(b.entries());
        let place =
            units.position(|(a, b)| a.unit.is_some() && b.unit.is_some() && a.unit != b.unit);
        let place = place.ok_or("the units do not differ entry by entry")?;
        let entry = |own: &Expression| own.entries(a.shape())[place].clone();
        Ok((entry(one), entry(other)))
    }

    /// The list of all units so far.
    fn units(&mut self) -> Result<String, Withheld> {
        let (definition, name) = self.units.list()?;
        self.text(definition);
        Ok(name)
    }
}
