//! The names of quantities on the command line: angles also in degrees, frequencies also in hertz.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use sextic_codegen::language::literal::Decimal;

use crate::algebra::number::Rational;
use crate::compile::fixed::Fixed;
use crate::derivation::scope::{Meaning, SymbolKind};
use crate::verdict::audit::Audit;

/// The names of the quantities of documents.
pub struct Vocabulary(BTreeSet<String>);

impl Vocabulary {
    /// All that audited documents declare: constants, angles, and functions with their slopes.
    pub fn of<'a>(audits: impl IntoIterator<Item = &'a Audit>) -> Self {
        let mut names = BTreeSet::new();
        for entry in audits
            .into_iter()
            .flat_map(|own| own.elaborator.scope.entries())
        {
            let name = &entry.name.ascii;
            match &entry.meaning {
                Meaning::Symbol {
                    kind: SymbolKind::Parameter | SymbolKind::Complex | SymbolKind::Angle,
                    ..
                } => drop(names.insert(name.clone())),
                Meaning::Function { .. } => names.extend([name.clone(), format!("d{name}")]),
                _ => {}
            }
        }
        Vocabulary(names)
    }

    /// The names.
    pub fn names(&self) -> impl Iterator<Item = &String> {
        self.0.iter()
    }

    /// Whether a quantity has this name.
    pub fn contains(&self, name: &str) -> bool {
        self.0.contains(name)
    }

    /// A quantity by the name of its document and in SI units and radians: `alpha_g_deg` is `alpha_g` in degrees, and
    /// `f_x` is `omega_x` in hertz, as in a case file. What the document calls so itself stays.
    ///
    /// The number is then the double nearest to the product with π/180, or 2π.
    pub fn in_si(&self, given: &Fixed) -> Fixed {
        let renamed = self.renamed(&given.name).and_then(|(name, factor)| {
            let value = Decimal::nearest(&given.value)?.value * factor;
            Some(Fixed {
                name,
                text: value.to_string(),
                value: Rational::try_from(value).ok()?,
            })
        });
        renamed.unwrap_or_else(|| given.clone())
    }

    /// The name in the document, and what a number is to be multiplied with.
    pub fn renamed(&self, name: &str) -> Option<(String, f64)> {
        if self.contains(name) {
            return None;
        }
        let angle = name
            .strip_suffix("_deg")
            .map(|own| (own.to_string(), PI / 180.0));
        let frequency = name
            .strip_prefix("f_")
            .map(|own| (format!("omega_{own}"), TAU));
        let mut both = angle.into_iter().chain(frequency);
        both.find(|(own, _)| self.contains(own))
    }
}
