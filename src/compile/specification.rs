//! What an evaluator of a document is to compute, and the program that is to compute it.

use sextic_codegen::evaluator::{Angle, Evaluator as Emitted, Input as EmittedInput, Quantity};

use crate::algebra::fraction::Fraction;
use crate::derivation::audit::Audit;
use crate::derivation::condition::Requirement;
use crate::derivation::diagnostic::Diagnostic;
use crate::derivation::evaluator::Evaluator;
use crate::derivation::notation::Notation;
use crate::derivation::quantity::Value;
use crate::derivation::verdict::Condition;

use super::constant::Constant;
use super::input::Input;
use super::translation::{entry_names, translate};

/// An evaluator with the elements of the ring that its inputs and outputs stand for.
#[derive(Clone, Debug)]
pub struct Specification {
    /// What is emitted.
    pub evaluator: Emitted,
    /// The inputs by name, as elements of the document's ring.
    pub inputs: Vec<(String, Fraction)>,
    /// The inputs that are fixed, whose numbers stand in the text.
    pub constants: Vec<Constant>,
    /// The outputs by name, in normal form, as the document derives them.
    pub outputs: Vec<(String, Fraction)>,
}

/// Why an evaluator cannot be compiled.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// An output has no value: a mistake of the document.
    Document(Box<Diagnostic>),
    /// No program computes an output.
    Program(String),
}

impl Specification {
    /// Works out what an evaluator of an audited document is to compute, and translates it.
    ///
    /// # Errors
    ///
    /// [`Refusal`]
    pub fn of(
        evaluator: &Evaluator,
        audit: &mut Audit,
        hash: &str,
        command: &str,
    ) -> Result<Self, Refusal> {
        let elaborator = &mut audit.elaborator;
        elaborator.fresh();
        let (mut outputs, mut shown) = (Vec::new(), Vec::new());
        for output in &evaluator.outputs {
            let value = elaborator.value(&output.expression);
            let value: Value = value.map_err(|error| Refusal::Document(Box::new(error)))?;
            let ascii = entry_names(&output.name.ascii, value.shape());
            let unicode = entry_names(&output.name.unicode, value.shape());
            for ((name, symbol), entry) in ascii.into_iter().zip(unicode).zip(value.entries()) {
                shown.push(Quantity {
                    name: name.clone(),
                    symbol,
                    unit: entry
                        .unit
                        .as_ref()
                        .map(ToString::to_string)
                        .unwrap_or_default(),
                    description: String::new(),
                });
                outputs.push((name, entry.value.clone()));
            }
        }
        let needed = std::mem::take(&mut elaborator.conditions);
        let conditions = elaborator.present_conditions(&needed, &evaluator.span);
        let conditions = conditions.map_err(|error| Refusal::Document(Box::new(error)))?;
        elaborator.fresh();
        let translated = translate(evaluator, elaborator).map_err(Refusal::Program)?;
        let inputs = translated
            .inputs
            .iter()
            .map(|(symbol, input)| (input.name.clone(), elaborator.ring.element(*symbol)));
        let title = evaluator.description.clone();
        Ok(Specification {
            inputs: inputs.collect(),
            constants: Vec::new(),
            outputs,
            evaluator: Emitted {
                name: evaluator.name.ascii.clone(),
                title: title.unwrap_or_else(|| evaluator.name.unicode.clone()),
                description: String::new(),
                equations: evaluator.label.equation.iter().cloned().collect(),
                source: audit.title.clone().unwrap_or_default(),
                inputs: translated
                    .inputs
                    .iter()
                    .map(|(_, input)| emitted(input))
                    .collect(),
                angles: angles(translated.inputs.iter().map(|(_, input)| input)),
                outputs: shown,
                assumptions: Vec::new(),
                conditions: conditions.iter().map(written).collect(),
                program: translated.program,
                command: command.to_string(),
                document: audit.path.clone(),
                hash: hash.to_string(),
                proof: None,
                rounding: None,
            },
        })
    }
}

/// `L_g ≠ 0`
fn written(condition: &Condition) -> String {
    let expression = Notation::Unicode.expression(&condition.expression);
    match condition.requirement {
        Requirement::NonZero => format!("{expression} ≠ 0"),
        Requirement::Positive => format!("{expression} > 0"),
    }
}

fn emitted(input: &Input) -> EmittedInput {
    EmittedInput {
        quantity: Quantity {
            name: input.name.clone(),
            symbol: input.shown.clone(),
            unit: input.unit.to_string(),
            description: input.description.clone().unwrap_or_default(),
        },
        origin: input.origin.clone(),
    }
}

/// The angles of all inputs, each once.
fn angles<'a>(inputs: impl Iterator<Item = &'a Input>) -> Vec<Angle> {
    let mut angles: Vec<Angle> = Vec::new();
    for angle in inputs.flat_map(|input| &input.angles) {
        if !angles.contains(angle) {
            angles.push(angle.clone());
        }
    }
    angles
}
