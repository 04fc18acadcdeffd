//! The inputs of programs: what is free in a document.

use sextic_codegen::evaluator::{Angle as EmittedAngle, Circular, Function, Origin, Quantity};

use crate::algebra::angle::Angle;
use crate::algebra::generator::Generator;
use crate::algebra::ring::Ring;
use crate::algebra::symbol::Symbol;
use crate::derivation::presentation::Presenter;
use crate::derivation::scope::{Meaning, Scope};
use crate::language::notation::Notation;
use crate::language::syntax::Name;
use crate::language::unit::Unit;
use crate::language::visit::primed;

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
    /// Where its value comes from.
    pub origin: Origin,
    /// The angles that it is the sine or cosine of.
    pub angles: Vec<EmittedAngle>,
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
                    origin: Origin::Given,
                    angles: Vec::new(),
                })
            }
            Generator::Cosine { angle } => circular(Function::Cosine, angle, ring, scope),
            Generator::Sine { angle } => circular(Function::Sine, angle, ring, scope),
            Generator::FunctionValue { name, order, .. } => {
                let entry = scope.spelled(name)?;
                let Meaning::Function { unit, .. } = &entry.meaning else {
                    return None;
                };
                // At another argument than its own it is shown with that.
                let shown = Presenter { ring, scope }.symbol(symbol).ok()?;
                Some(Input {
                    name: primed(&entry.name.ascii, *order),
                    shown: Notation::Unicode.expression(&shown),
                    unit: unit.clone(),
                    description: derived(&entry.name.unicode, *order, &entry.description),
                    origin: Origin::Given,
                    angles: Vec::new(),
                })
            }
            Generator::Coordinate { .. }
            | Generator::ImaginaryUnit
            | Generator::Root { .. }
            | Generator::Direction { .. } => None,
        }
    }
}

/// What the derivative of a function by its angle is: tables often have it by degrees.
fn derived(function: &str, order: u32, description: &Option<String>) -> Option<String> {
    let what = match order {
        0 => return description.clone(),
        1 => format!("derivative of {function} by its angle in radians"),
        _ => format!("derivative of {function} of order {order} by its angle in radians"),
    };
    Some(match description {
        Some(description) => format!("{what}; {description}"),
        None => what,
    })
}

/// The sine or cosine of a sum of declared angles.
fn circular(function: Function, angle: &Angle, ring: &Ring, scope: &Scope) -> Option<Input> {
    let (mut name, mut shown) = (String::new(), String::new());
    let (mut sum, mut angles) = (Vec::new(), Vec::new());
    for (symbol, count) in angle.coefficients() {
        let Generator::Angle { name: own } = ring.generator(symbol) else {
            return None;
        };
        let entry = scope.spelled(own)?;
        let (ascii, unicode) = (&entry.name.ascii, &entry.name.unicode);
        let count = i32::try_from(count).ok()?;
        let (word, sign) = match (sum.is_empty(), count < 0) {
            (true, false) => ("", ""),
            (true, true) => ("minus_", "−"),
            (false, false) => ("_plus_", " + "),
            (false, true) => ("_minus_", " − "),
        };
        match count.unsigned_abs() {
            1 => {
                name.push_str(&format!("{word}{ascii}"));
                shown.push_str(&format!("{sign}{unicode}"));
            }
            times => {
                name.push_str(&format!("{word}{times}_{ascii}"));
                shown.push_str(&format!("{sign}{times}·{unicode}"));
            }
        }
        sum.push((count, ascii.clone()));
        angles.push(EmittedAngle {
            quantity: Quantity {
                name: ascii.clone(),
                symbol: unicode.clone(),
                unit: "rad".to_string(),
                description: entry.description.clone().unwrap_or_default(),
            },
            fixed: None,
        });
    }
    let function_name = match function {
        Function::Cosine => "cos",
        Function::Sine => "sin",
    };
    Some(Input {
        name: format!("{function_name}_{name}"),
        shown: format!("{function_name}({shown})"),
        unit: Unit::one(),
        description: None,
        origin: Origin::Circular(Circular {
            function,
            angle: sum,
        }),
        angles,
    })
}
