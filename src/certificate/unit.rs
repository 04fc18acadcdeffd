//! What quantities are measured in, and that two expressions differ in it.

use crate::derivation::assertion::Misfit;
use crate::language::syntax::{Expression, Spanned};
use crate::language::unit::Unit;

use super::composer::Composer;
use super::expression::Withheld;

/// The units of what is declared.
#[derive(Clone, Debug, Default)]
pub(super) struct Units {
    /// Those that were not written yet, such as `(m, [1; -1; 0; 0; 0]%Z)`.
    pending: Vec<String>,
    /// How many lists of them were written.
    lists: usize,
    /// A unit that the kernel cannot say.
    unsaid: Option<String>,
}

impl Units {
    /// Names that are measured in a unit.
    pub(super) fn add<'a>(&mut self, names: impl Iterator<Item = &'a str>, unit: &Spanned<String>) {
        let parsed = Unit::parse(unit).ok();
        let Some(exponents) = parsed.and_then(|own| own.exponents()) else {
            self.unsaid = Some(unit.value.clone());
            return;
        };
        if exponents != [0; 5] {
            let exponents = exponents.map(|own| own.to_string()).join("; ");
            self.pending
                .extend(names.map(|name| format!("({name}, [{exponents}]%Z)")));
        }
    }
}

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
        if let Some(unit) = &self.units.unsaid {
            return Err(format!("the exponents of the unit {unit} are not whole"));
        }
        let pending = std::mem::take(&mut self.units.pending);
        if !pending.is_empty() {
            let before = match self.units.lists {
                0 => String::new(),
                number => format!("units_{number} ++ "),
            };
            self.units.lists += 1;
            let (number, new) = (self.units.lists, pending.join("; "));
            self.text(format!(
                "Definition units_{number} : units := {before}[{new}].\n"
            ));
        }
        Ok(match self.units.lists {
            0 => "[]".into(),
            number => format!("units_{number}"),
        })
    }
}
