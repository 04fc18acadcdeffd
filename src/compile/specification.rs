//! What an evaluator of a document is to compute, and the program that is to compute it.

mod fixing;
mod formula;
mod validity;

use std::fmt;

use validity::Requirement;

use sextic_codegen::evaluator::{Angle, Evaluator as Emitted, Input as EmittedInput, Quantity};

use crate::algebra::fraction::Fraction;
use crate::algebra::symbol::Symbol;
use crate::derivation::condition::{Condition, Conditions};
use crate::derivation::elaboration::Elaborator;
use crate::derivation::quantity::Value;
use crate::language::diagnostic::Diagnostic;
use crate::language::evaluator::{Evaluator, Output};
use crate::language::syntax::{Expression, Label, Place};
use crate::verdict::audit::Audit;

use super::constant::Constant;
use super::fingerprint::fingerprint;
use super::fixed::Fixed;
use super::input::Input;
use super::translation::{Translated, entry_names, translate};

/// An evaluator with the elements of the ring that its inputs and outputs stand for.
#[derive(Clone, Debug)]
pub struct Specification {
    /// What is emitted.
    pub evaluator: Emitted,
    /// The inputs by name, as elements of the document's ring; those that are fixed are not among them.
    pub inputs: Vec<(String, Fraction)>,
    /// The inputs that are fixed, whose numbers stand in the text.
    pub constants: Vec<Constant>,
    /// The outputs by name, in normal form, as the document derives them.
    pub outputs: Vec<(String, Fraction)>,
    /// The same, as the document writes them.
    pub written: Vec<Expression>,
    /// The names that were fixed, also those that are gone from the program.
    pub fixed: Vec<String>,
    /// The names of the document and the ring of these elements.
    pub elaborator: Elaborator,
    /// The symbols of the ring that the inputs of the program are.
    symbols: Vec<Symbol>,
    /// What its steps divided by and took roots of.
    conditions: Conditions,
    /// What the document says must hold beyond that.
    requirements: Vec<Requirement>,
}

/// Why an evaluator cannot be compiled.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// An output has no value: a mistake of the document.
    Document(Box<Diagnostic>),
    /// No program computes an output.
    Program(String),
    /// A quantity cannot have the number that it is given: its name, and why.
    Number(String, String),
}

impl fmt::Display for Refusal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Document(diagnostic) => diagnostic.fmt(formatter),
            Refusal::Program(reason) => formatter.write_str(reason),
            Refusal::Number(names, reason) => {
                write!(formatter, "this value of {names} is not allowed: {reason}")
            }
        }
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    fn document(error: Diagnostic) -> Self {
        Refusal::Document(Box::new(error))
    }
}

impl Specification {
    /// An evaluator that computes these outputs of these inputs, by name, elements of the ring of this
    /// elaborator, under no condition.
    pub fn new(
        evaluator: Emitted,
        inputs: Vec<(String, Fraction)>,
        outputs: Vec<(String, Fraction)>,
        elaborator: Elaborator,
    ) -> Self {
        Specification {
            evaluator,
            elaborator,
            inputs,
            outputs,
            written: Vec::new(),
            constants: Vec::new(),
            fixed: Vec::new(),
            symbols: Vec::new(),
            conditions: Conditions::default(),
            requirements: Vec::new(),
        }
    }

    /// Works out what an evaluator of an audited document is to compute, and translates it.
    ///
    /// Of the quantities that are fixed, those that it does not rest on change nothing. Where one is 0 or
    /// ±1 the program becomes simpler; the numbers of others are constants of the text.
    ///
    /// # Errors
    ///
    /// [`Refusal`]
    pub fn of(evaluator: &Evaluator, audit: &Audit, fixed: &[Fixed]) -> Result<Self, Refusal> {
        let elaborator = audit.elaborator.clone();
        let mut general = Specification::translated(evaluator, audit, elaborator)?;
        let fixed: Vec<&Fixed> = fixed
            .iter()
            .filter(|fixed| general.rests_on(&fixed.name))
            .collect();
        if fixed.is_empty() {
            return Ok(general);
        }
        let replacements = fixing::replacements(&fixed, &mut general)?;
        let mut special = match replacements.is_empty() {
            true => general,
            false => {
                let place = Place::Replacements(replacements);
                // The caller of the program answers for what the document assumes of all inputs.
                let mut elaborator = general.elaborator;
                elaborator.trusts_replacements = true;
                Specification::translated(&at(evaluator, &place), audit, elaborator)?
            }
        };
        special.elaborator.trusts_replacements = false;
        special.fix(&fixed);
        Ok(special)
    }

    /// The specification of an evaluator of which nothing is fixed.
    fn translated(
        evaluator: &Evaluator,
        audit: &Audit,
        mut elaborator: Elaborator,
    ) -> Result<Self, Refusal> {
        elaborator.fresh();
        let Outputs {
            elements: outputs,
            written,
            shown,
        } = Outputs::of(evaluator, &mut elaborator)?;
        let needed = std::mem::take(&mut elaborator.conditions);
        let conditions = elaborator.present_conditions(&needed, &evaluator.span);
        let conditions = conditions.map_err(Refusal::document)?;
        let requirements = validity::requirements(&evaluator.conditions, &mut elaborator)?;
        let conditions = conditions.iter().map(validity::condition);
        let stated = requirements
            .iter()
            .map(|requirement| requirement.text.clone());
        let conditions: Vec<String> = conditions.chain(stated).collect();
        elaborator.fresh();
        let Translated { program, inputs } =
            translate(evaluator, &mut elaborator).map_err(Refusal::Program)?;
        let title = evaluator.description.clone();
        let formula = formula::of(evaluator, &elaborator.scope);
        let elements = inputs.iter().map(|(symbol, input)| {
            let element = elaborator.ring.element(*symbol);
            (input.name.clone(), element)
        });
        let elements = elements.collect();
        let emitted = Emitted {
            name: evaluator.name.ascii.clone(),
            title: title.unwrap_or_else(|| evaluator.name.unicode.clone()),
            description: String::new(),
            formula,
            equations: equations(&evaluator.label),
            source: audit.title.clone().unwrap_or_default(),
            inputs: inputs.iter().map(|(_, input)| input_of(input)).collect(),
            angles: angles(inputs.iter().map(|(_, input)| input)),
            outputs: shown,
            assumptions: validity::assumptions(&inputs, audit),
            conditions,
            program,
            command: String::new(),
            document: audit.path.clone(),
            hash: fingerprint(&audit.sources),
            proof: None,
            rounding: None,
        };
        Ok(Specification {
            written,
            symbols: inputs.iter().map(|(symbol, _)| *symbol).collect(),
            conditions: needed,
            requirements,
            ..Specification::new(emitted, elements, outputs, elaborator)
        })
    }

    /// The inputs by name, and behind them those that are fixed, as elements of the document's ring.
    pub fn elements(&self) -> impl Iterator<Item = (&str, &Fraction)> {
        let free = self.inputs.iter();
        let free = free.map(|(name, element)| (name.as_str(), element));
        let fixed = self.constants.iter();
        free.chain(fixed.map(|constant| (constant.name.as_str(), &constant.element)))
    }

    /// The inputs as the document writes them: `m`, `cos(α_0)`, `C_D′`.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where one cannot be written.
    pub fn written_inputs(&self) -> Result<Vec<Expression>, Refusal> {
        let elements = self.inputs.iter();
        let written = elements.map(|(_, element)| self.elaborator.present(element, &(0..0)));
        written.collect::<Result<_, _>>().map_err(Refusal::document)
    }

    /// What its outputs need.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where a condition cannot be written.
    pub fn conditions(&self) -> Result<Vec<Condition>, Refusal> {
        let conditions = self
            .elaborator
            .present_conditions(&self.conditions, &(0..0));
        conditions.map_err(Refusal::document)
    }

    /// Whether a name is that of an input, or of an angle that inputs are made of.
    pub fn rests_on(&self, name: &str) -> bool {
        self.names().any(|known| known == name)
    }

    /// The names of what a user gives.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.quantities().map(|quantity| quantity.name.as_str())
    }

    /// What a user gives: inputs, and angles rather than their sines and cosines.
    pub fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        let inputs = self.evaluator.inputs.iter();
        let given = inputs.filter(|input| input.circular().is_none());
        let angles = self.evaluator.angles.iter();
        given
            .map(|input| &input.quantity)
            .chain(angles.map(|angle| &angle.quantity))
    }
}

/// The outputs of an evaluator, entry by entry.
#[derive(Default)]
struct Outputs {
    /// In normal form, by name.
    elements: Vec<(String, Fraction)>,
    /// As the document writes them.
    written: Vec<Expression>,
    /// What is said of each.
    shown: Vec<Quantity>,
}

impl Outputs {
    fn of(evaluator: &Evaluator, elaborator: &mut Elaborator) -> Result<Self, Refusal> {
        let mut outputs = Outputs::default();
        for output in &evaluator.outputs {
            let value = elaborator.value(&output.expression);
            outputs.add(output, &value.map_err(Refusal::document)?);
        }
        Ok(outputs)
    }

    fn add(&mut self, output: &Output, value: &Value) {
        let ascii = entry_names(&output.name.ascii, value.shape());
        let unicode = entry_names(&output.name.unicode, value.shape());
        for ((name, symbol), entry) in ascii.into_iter().zip(unicode).zip(value.entries()) {
            let unit = entry.unit.as_ref().map(ToString::to_string);
            self.shown.push(Quantity {
                name: name.clone(),
                symbol,
                unit: unit.unwrap_or_default(),
                description: String::new(),
            });
            self.elements.push((name, entry.value.clone()));
        }
        self.written
            .extend(output.expression.entries(value.shape()));
    }
}

/// The numbers of a label: 21, 22 and 23 of `(21, 22, 23)`, 19 of `(19, tuned)`.
fn equations(label: &Label) -> Vec<String> {
    let is_number = |part: &&str| {
        let mut letters = part.chars().filter(|letter| letter.is_alphanumeric());
        part.chars().any(|letter| letter.is_ascii_digit())
            && letters.all(|letter| letter.is_ascii_digit() || letter.is_ascii_uppercase())
    };
    let more = label
        .text
        .split(',')
        .skip(1)
        .map(str::trim)
        .filter(is_number);
    let first = label.equation.iter().map(String::as_str);
    let more = more.filter(|_| label.equation.is_some());
    first.chain(more).map(str::to_string).collect()
}

/// The evaluator whose outputs are taken at a place.
fn at(evaluator: &Evaluator, place: &Place) -> Evaluator {
    let output = |output: &Output| Output {
        name: output.name.clone(),
        expression: output.expression.clone().at(place.clone()),
    };
    Evaluator {
        outputs: evaluator.outputs.iter().map(output).collect(),
        ..evaluator.clone()
    }
}

fn input_of(input: &Input) -> EmittedInput {
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
