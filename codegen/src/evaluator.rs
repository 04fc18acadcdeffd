//! What is known of a function that is to be written: everything that a template places.

mod origin;

pub use origin::{Angle, Circular, Fixed, Function, Input, Origin};

use crate::cost::Cost;
use crate::optimiser::hoist::{Hoisted, hoist};
use crate::program::Program;

/// An input or an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name in the program: ASCII, an identifier.
    pub name: String,
    /// Its name in the document.
    pub symbol: String,
    /// Its unit as text; empty where it has none.
    pub unit: String,
    /// What it is; may be empty.
    pub description: String,
}

impl Quantity {
    /// A quantity without unit and description, which the document calls as the program does.
    pub fn plain(name: impl Into<String>) -> Self {
        let name = name.into();
        Quantity {
            symbol: name.clone(),
            name,
            unit: String::new(),
            description: String::new(),
        }
    }
}

/// How far the strict evaluation was from the exact one, as measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounding {
    /// At how many points every output has an exact value, at least.
    pub points: usize,
    /// Where they were drawn.
    pub domain: String,
    /// Of each output, the largest error in units in the last place of the exact value.
    pub largest: Vec<f64>,
    /// Of each output, what the error exceeds at one point of a hundred. Where an output crosses zero its
    /// largest error says little.
    pub percentile_99: Vec<f64>,
}

/// A function that is to be written in some language.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluator {
    /// Its name: ASCII, an identifier in snake case.
    pub name: String,
    /// What it computes, in a line.
    pub title: String,
    /// What it computes, in a paragraph; may be empty.
    pub description: String,
    /// The formulas of the outputs, and what they rest on, each as text; may be empty.
    pub formula: Vec<String>,
    /// The numbers of the equations of the source, without parentheses; may be empty.
    pub equations: Vec<String>,
    /// Where the equations stand; may be empty.
    pub source: String,
    /// The inputs in the order of the program.
    pub inputs: Vec<Input>,
    /// The angles whose sines and cosines are inputs.
    pub angles: Vec<Angle>,
    /// The outputs in the order of the program.
    pub outputs: Vec<Quantity>,
    /// What the derivation assumes, each as text.
    pub assumptions: Vec<String>,
    /// When the result means something, each as text.
    pub conditions: Vec<String>,
    /// What is computed.
    pub program: Program,
    /// The command that writes it.
    pub command: String,
    /// The document that it was derived in.
    pub document: String,
    /// The SHA-256 of that document, in hexadecimal digits.
    pub hash: String,
    /// What is proven of the text, if anything.
    pub proof: Option<String>,
    /// What was measured, if anything.
    pub rounding: Option<Rounding>,
}

impl Evaluator {
    /// An evaluator of a program of which nothing else is known.
    pub fn plain(name: impl Into<String>, program: Program) -> Self {
        let name = name.into();
        Evaluator {
            title: name.clone(),
            name,
            description: String::new(),
            formula: Vec::new(),
            equations: Vec::new(),
            source: String::new(),
            inputs: program.inputs().iter().map(Input::plain).collect(),
            angles: Vec::new(),
            outputs: program
                .outputs()
                .iter()
                .map(|(name, _)| Quantity::plain(name))
                .collect(),
            assumptions: Vec::new(),
            conditions: Vec::new(),
            program,
            command: String::new(),
            document: String::new(),
            hash: String::new(),
            proof: None,
            rounding: None,
        }
    }

    /// What it costs.
    pub fn cost(&self) -> Cost {
        Cost::of(&self.program)
    }

    /// The inputs that the caller gives at every point, in order.
    pub fn free_inputs(&self) -> impl Iterator<Item = &Input> {
        self.inputs.iter().filter(|input| input.fixed().is_none())
    }

    /// Whether it is asked for nothing: its outputs are numbers.
    pub fn is_constant(&self) -> bool {
        self.free_inputs().next().is_none()
    }

    /// The program in two parts: what rests on fixed inputs alone, and what is computed at each point.
    pub fn hoisted(&self) -> Hoisted {
        let names = self.free_inputs().map(|input| input.quantity.name.clone());
        hoist(&self.program, &names.collect())
    }

    /// The angles that inputs which are not fixed are made of, in order.
    pub fn open_angles(&self) -> impl Iterator<Item = &Angle> {
        let is_open = |angle: &&Angle| {
            let circular = self.inputs.iter().filter_map(Input::circular);
            let mut parts = circular.flat_map(|circular| &circular.angle);
            parts.any(|(_, name)| *name == angle.quantity.name)
        };
        self.angles.iter().filter(is_open)
    }

    /// The angle of this name.
    pub fn angle(&self, name: &str) -> Option<&Angle> {
        self.angles.iter().find(|angle| angle.quantity.name == name)
    }
}
