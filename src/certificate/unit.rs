//! What quantities are measured in.

use crate::language::syntax::Spanned;
use crate::language::unit::Unit;

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

    /// The definition of the list of all units so far, unless it was written, and the name of the list.
    pub(super) fn list(&mut self) -> Result<(String, String), Withheld> {
        if let Some(unit) = &self.unsaid {
            return Err(format!("the exponents of the unit {unit} are not whole"));
        }
        let pending = std::mem::take(&mut self.pending);
        let before = match self.lists {
            0 => String::new(),
            number => format!("units_{number} ++ "),
        };
        // Where nothing has a unit, the list is empty.
        self.lists += usize::from(self.lists == 0 || !pending.is_empty());
        let name = format!("units_{}", self.lists);
        let definition = match pending.is_empty() && !before.is_empty() {
            true => String::new(),
            false => format!(
                "Definition {name} : units := {before}[{}].\n",
                pending.join("; ")
            ),
        };
        Ok((definition, name))
    }
}
