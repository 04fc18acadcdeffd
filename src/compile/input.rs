//! The inputs of programs: what is free in a document.

use crate::algebra::angle::Angle;
use crate::algebra::generator::Generator;
use crate::algebra::ring::Ring;
use crate::algebra::symbol::Symbol;
use crate::derivation::notation::Notation;
use crate::derivation::presentation::Presenter;
use crate::derivation::scope::{Meaning, Scope};
use crate::derivation::syntax::Name;
use crate::derivation::unit::Unit;
use crate::derivation::visit::primed;

/// An input of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// How programs call it: `m`, `cos_alpha_0`, `dC_D`.
    pub name: String,
    /// As the document writes it: `m`, `cos(α_0)`, `C_D′`.
    pub shown: String,
    /// Its unit.
    pub unit: Unit,
    /// In words.
    pub description: Option<String>,
}

impl Input {
    /// The input that a symbol of the ring is; nothing for a root and for what no number stands for.
    pub fn of(symbol: Symbol, ring: &Ring, scope: &Scope) -> Option<Input> {
        match ring.generator(symbol) {
            Generator::Constant { name } | Generator::Angle { name } => {
                let name = Name::new(name);
                let entry = scope.get(&name)?;
                let unit = match &entry.meaning {
                    Meaning::Symbol { unit, .. } => unit.clone(),
                    _ => Unit::one(),
                };
                Some(Input {
                    name: entry.name.ascii.clone(),
                    shown: entry.name.unicode.clone(),
                    unit,
                    description: entry.description.clone(),
                })
            }
            Generator::Cosine { angle } => circular("cos", angle, ring, scope),
            Generator::Sine { angle } => circular("sin", angle, ring, scope),
            Generator::FunctionValue { name, order, .. } => {
                let entry = scope.get(&Name::new(name))?;
                let Meaning::Function { unit, .. } = &entry.meaning else {
                    return None;
                };
                // At another argument than its own it is shown with that.
                let shown = Presenter { ring, scope }.symbol(symbol).ok()?;
                Some(Input {
                    name: primed(&entry.name.ascii, *order),
                    shown: Notation::Unicode.expression(&shown),
                    unit: unit.clone(),
                    description: entry.description.clone(),
                })
            }
            Generator::Coordinate { .. }
            | Generator::ImaginaryUnit
            | Generator::Root { .. }
            | Generator::Direction { .. } => None,
        }
    }
}

/// The sine or cosine of a sum of declared angles.
fn circular(function: &str, angle: &Angle, ring: &Ring, scope: &Scope) -> Option<Input> {
    let mut parts = Vec::new();
    let mut shown = Vec::new();
    for (symbol, count) in angle.coefficients() {
        let Generator::Angle { name } = ring.generator(symbol) else {
            return None;
        };
        let entry = scope.get(&Name::new(name))?;
        let written = count.to_string();
        match written.as_str() {
            "1" => {
                parts.push(entry.name.ascii.clone());
                shown.push(entry.name.unicode.clone());
            }
            _ => {
                parts.push(format!(
                    "{}_{}",
                    written.replace('-', "minus_"),
                    entry.name.ascii
                ));
                shown.push(format!("{written}·{}", entry.name.unicode));
            }
        }
    }
    let shown = format!("{function}({})", shown.join(" + "));
    Some(Input {
        name: format!("{function}_{}", parts.join("_plus_")),
        description: None,
        shown,
        unit: Unit::one(),
    })
}
