//! The names of quantities on the command line: angles also in degrees, frequencies also in hertz.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use sextic_codegen::language::literal::Decimal;

use crate::algebra::number::Rational;
use crate::compile::fixed::Fixed;
use crate::derivation::scope::{Meaning, SymbolKind};
use crate::language::unit::Unit;
use crate::verdict::audit::Audit;

/// The names of the quantities of documents.
#[derive(Default)]
pub struct Vocabulary {
    names: BTreeSet<String>,
    angles: BTreeSet<String>,
    /// Those in 1/s, as circular frequencies are.
    rates: BTreeSet<String>,
}

impl Vocabulary {
    /// All that audited documents declare: constants, angles, and functions with their slopes.
    pub fn of<'a>(audits: impl IntoIterator<Item = &'a Audit>) -> Self {
        let mut own = Vocabulary::default();
        for entry in audits
            .into_iter()
            .flat_map(|audit| audit.elaborator.scope.entries())
        {
            own.add(&entry.name.ascii, &entry.meaning);
        }
        own
    }

    /// Of these names, some of angles and some of rates.
    pub fn new(
        names: impl Iterator<Item = String>,
        angles: impl Iterator<Item = String>,
        rates: impl Iterator<Item = String>,
    ) -> Self {
        Vocabulary {
            names: names.collect(),
            angles: angles.collect(),
            rates: rates.collect(),
        }
    }

    fn add(&mut self, name: &str, meaning: &Meaning) {
        match meaning {
            Meaning::Symbol { kind, unit, .. } => {
                let names = match kind {
                    SymbolKind::Angle => &mut self.angles,
                    SymbolKind::Parameter | SymbolKind::Complex
                        if *unit == Unit::second().inverse() =>
                    {
                        &mut self.rates
                    }
                    SymbolKind::Parameter | SymbolKind::Complex => &mut self.names,
                    _ => return,
                };
                names.insert(name.to_string());
                self.names.insert(name.to_string());
            }
            Meaning::Function { .. } => {
                self.names.extend([name.to_string(), format!("d{name}")]);
            }
            _ => {}
        }
    }

    /// The names.
    pub fn names(&self) -> impl Iterator<Item = &String> {
        self.names.iter()
    }

    /// Whether a quantity has this name.
    pub fn contains(&self, name: &str) -> bool {
        self.names.contains(name)
    }

    /// A quantity by the name of its document and in SI units and radians: for an angle `alpha_g`, `alpha_g_deg` is it in
    /// degrees, and for a rate `omega_x`, `f_x` is it in hertz, as in a case file. What the document calls so itself
    /// stays.
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
            .filter(|own| self.angles.contains(*own));
        let rate = name.strip_prefix("f_").map(|own| format!("omega_{own}"));
        let rate = rate.filter(|own| self.rates.contains(own));
        let angle = angle.map(|own| (own.to_string(), PI / 180.0));
        angle.or_else(|| Some((rate?, TAU)))
    }
}
