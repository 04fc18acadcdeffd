//! What the parts of an evaluator are called in a language.

use std::collections::BTreeSet;

use serde::Serialize;

use super::Error;
use super::documentation::{self, Comments};
use super::names::{distinct, is_temporary, safe};
use super::taken::Vocabulary;
use crate::evaluator::{Evaluator, Quantity};

/// A field of a structure, as a template places it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// The lines that describe it.
    pub documentation: Vec<String>,
}

/// What names are safe for the quantities of an evaluator.
pub struct Safety {
    vocabulary: Vocabulary,
    fields: BTreeSet<String>,
    variables: BTreeSet<String>,
}

impl Safety {
    fn of(vocabulary: &Vocabulary, function: &str) -> Self {
        Safety {
            vocabulary: vocabulary.clone(),
            fields: vocabulary.fields(function),
            variables: vocabulary.variables(function),
        }
    }

    /// Names of fields.
    pub fn fields<'a>(
        &self,
        names: impl IntoIterator<Item = &'a str>,
    ) -> Result<Vec<String>, Error> {
        safe(names, |name| {
            self.fields.contains(name) || self.vocabulary.is_temporary_field(name)
        })
    }

    /// Names of variables.
    pub fn variables<'a>(
        &self,
        names: impl IntoIterator<Item = &'a str>,
    ) -> Result<Vec<String>, Error> {
        safe(names, |name| {
            self.variables.contains(name) || is_temporary(name)
        })
    }
}

/// The names of an evaluator in a language.
pub struct Named {
    /// Its function.
    pub function: String,
    /// The fields of its inputs, with those that are fixed.
    pub inputs: Vec<String>,
    /// The variables that they are read into.
    pub variables: Vec<String>,
    /// The fields of its outputs.
    pub outputs: Vec<String>,
    /// What the values of the outputs are called in the body, where that name is free.
    pub values: Vec<Option<String>>,
    /// What other names of this evaluator are safe.
    pub safety: Safety,
}

impl Named {
    /// Of each evaluator.
    pub fn all(evaluators: &[Evaluator], vocabulary: &Vocabulary) -> Result<Vec<Self>, Error> {
        refuse_alike(evaluators)?;
        let pairs = evaluators.iter().zip(functions(evaluators, vocabulary)?);
        pairs
            .map(|(evaluator, function)| Named::of(evaluator, function, vocabulary))
            .collect()
    }

    fn of(evaluator: &Evaluator, function: String, vocabulary: &Vocabulary) -> Result<Self, Error> {
        let safety = Safety::of(vocabulary, &function);
        let inputs = evaluator.inputs.iter();
        let inputs: Vec<&str> = inputs.map(|input| input.quantity.name.as_str()).collect();
        let outputs = evaluator.outputs.iter();
        let outputs: Vec<&str> = outputs.map(|what| what.name.as_str()).collect();
        let variables = safety.variables(inputs.iter().copied())?;
        let free = |name: String| (!variables.contains(&name)).then_some(name);
        let values = safety.variables(outputs.iter().copied())?;
        Ok(Named {
            function,
            values: values.into_iter().map(free).collect(),
            inputs: safety.fields(inputs)?,
            outputs: safety.fields(outputs)?,
            variables,
            safety,
        })
    }

    /// The fields of the structures of inputs and outputs; what is fixed is no field.
    pub fn fields(&self, evaluator: &Evaluator, comments: &Comments) -> (Vec<Field>, Vec<Field>) {
        let field = |name: &String, what: &Quantity| Field {
            name: name.clone(),
            documentation: documentation::field(what, name, comments),
        };
        let inputs = self.inputs.iter().zip(&evaluator.inputs);
        let free = inputs.filter(|(_, input)| input.fixed().is_none());
        let outputs = self.outputs.iter().zip(&evaluator.outputs);
        (
            free.map(|(name, input)| field(name, &input.quantity))
                .collect(),
            outputs.map(|(name, what)| field(name, what)).collect(),
        )
    }
}

/// Names that would make one file or one type of two evaluators.
fn refuse_alike(evaluators: &[Evaluator]) -> Result<(), Error> {
    let plain = |evaluator: &Evaluator| evaluator.name.replace('_', "").to_ascii_lowercase();
    for (place, evaluator) in evaluators.iter().enumerate() {
        let mut others = evaluators[..place].iter();
        let alike =
            others.find(|other| other.name != evaluator.name && plain(other) == plain(evaluator));
        if let Some(other) = alike {
            return Err(Error::Alike(other.name.clone(), evaluator.name.clone()));
        }
    }
    Ok(())
}

/// The functions of evaluators: no name that is made from one of them is another one's.
fn functions(evaluators: &[Evaluator], vocabulary: &Vocabulary) -> Result<Vec<String>, Error> {
    let names: Vec<&str> = evaluators.iter().map(|own| own.name.as_str()).collect();
    let own = distinct(&names)?;
    let mut taken = vocabulary.without_evaluator();
    if vocabulary.is_shared() {
        let types = names.iter().flat_map(|name| vocabulary.types(name));
        taken.extend(types);
    }
    let mut functions = Vec::new();
    for name in names {
        let mut chosen = name.to_owned();
        let mut made = vocabulary.made(name);
        // With more underscores than anything that is taken has letters it is free.
        while (chosen != name && own.contains(&chosen))
            || vocabulary.has_file(&chosen)
            || made.iter().any(|name| taken.contains(name))
        {
            chosen.push('_');
            made = vocabulary.made(&chosen);
        }
        if vocabulary.is_shared() {
            taken.extend(made);
        }
        functions.push(chosen);
    }
    Ok(functions)
}
