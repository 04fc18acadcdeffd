//! What the parts of an evaluator are called in a language.

use serde::Serialize;

use super::Error;
use super::documentation::{self, Comments};
use super::names::{self, Names};
use crate::evaluator::{Evaluator, Quantity};

/// A field of a structure, as a template places it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// The lines that describe it.
    pub documentation: Vec<String>,
}

/// The names of an evaluator in a language.
pub struct Named {
    /// Its function.
    pub function: String,
    /// Its inputs, with those that are fixed.
    pub inputs: Names,
    /// Its outputs.
    pub outputs: Names,
    /// What the values of the outputs are called in the body, where that name is free.
    pub values: Vec<Option<String>>,
}

impl Named {
    /// Of each evaluator.
    ///
    /// `modules` are names that only an evaluator must not have.
    pub fn all(
        evaluators: &[Evaluator],
        reserved: &[&str],
        modules: &[&str],
    ) -> Result<Vec<Self>, Error> {
        let plain = |evaluator: &Evaluator| evaluator.name.replace('_', "").to_ascii_lowercase();
        for (place, evaluator) in evaluators.iter().enumerate() {
            let mut others = evaluators[..place].iter();
            let alike = others
                .find(|other| other.name != evaluator.name && plain(other) == plain(evaluator));
            if let Some(other) = alike {
                return Err(Error::Alike(other.name.clone(), evaluator.name.clone()));
            }
        }
        let forbidden: Vec<&str> = reserved.iter().chain(modules).copied().collect();
        let functions = evaluators.iter().map(|evaluator| evaluator.name.as_str());
        let functions = names::safe(functions, &forbidden)?.names;
        let pairs = evaluators.iter().zip(functions);
        pairs
            .map(|(evaluator, function)| Named::of(evaluator, function, reserved))
            .collect()
    }

    fn of(evaluator: &Evaluator, function: String, reserved: &[&str]) -> Result<Self, Error> {
        let inputs = evaluator.inputs.iter();
        let inputs = inputs.map(|input| input.quantity.name.as_str());
        let outputs = evaluator.outputs.iter().map(|what| what.name.as_str());
        let inputs = names::safe(inputs, reserved)?;
        let outputs = names::safe(outputs, reserved)?;
        let free = |name: &String| (!inputs.names.contains(name)).then(|| name.clone());
        Ok(Named {
            function,
            values: outputs.names.iter().map(free).collect(),
            inputs,
            outputs,
        })
    }

    /// The fields of the structures of inputs and outputs; what is fixed is no field.
    pub fn fields(&self, evaluator: &Evaluator, comments: &Comments) -> (Vec<Field>, Vec<Field>) {
        let field = |name: &String, what: &Quantity| Field {
            name: name.clone(),
            documentation: documentation::field(what, name, comments),
        };
        let inputs = self.inputs.names.iter().zip(&evaluator.inputs);
        let free = inputs.filter(|(_, input)| input.fixed().is_none());
        let outputs = self.outputs.names.iter().zip(&evaluator.outputs);
        (
            free.map(|(name, input)| field(name, &input.quantity))
                .collect(),
            outputs.map(|(name, what)| field(name, what)).collect(),
        )
    }
}
