//! What an emitted text calls the quantities of an evaluator.

use sextic_codegen::evaluator::{Evaluator, Quantity};

use super::door::Door;

/// How many underscores a name that is not free in a language may get.
const MOST_UNDERSCORES: usize = 3;

/// A name of the document, and what the text calls it.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub(super) quantity: String,
    /// Nothing until the text declares it.
    pub(super) text: Option<String>,
}

/// The names of an evaluator in a text: as the text declares them, in the order of the evaluator.
#[derive(Clone, Debug)]
pub struct Names {
    pub(super) function: String,
    pub(super) inputs: Vec<Name>,
    pub(super) outputs: Vec<Name>,
    /// What the inputs are made of, if they can be made of angles.
    pub(super) door: Option<Door>,
    /// What the door asks for.
    pub(super) asked: Vec<Name>,
    /// The angles that the door does not ask for.
    pub(super) fixed: Vec<Name>,
}

impl Names {
    /// The names of an evaluator that a text calls like this, before its declarations have been read.
    pub(super) fn new(evaluator: &Evaluator, function: &str) -> Self {
        let unknown = |quantity: &Quantity| Name {
            quantity: quantity.name.clone(),
            text: None,
        };
        let named = |quantity: &String| Name {
            quantity: quantity.clone(),
            text: None,
        };
        let inputs = evaluator.free_inputs().map(|input| &input.quantity);
        let door = Door::of(evaluator);
        let asked = door.iter().flat_map(|door| &door.asked);
        let fixed = door.iter().flat_map(|door| &door.fixed);
        Names {
            function: function.to_string(),
            inputs: inputs.map(unknown).collect(),
            outputs: evaluator.outputs.iter().map(unknown).collect(),
            asked: asked.map(named).collect(),
            fixed: fixed.map(|(name, _)| named(name)).collect(),
            door,
        }
    }

    /// The quantity of a field of the inputs.
    pub(super) fn input(&self, field: &str) -> Option<&str> {
        quantity(&self.inputs, field)
    }

    /// The quantity of a field of the outputs.
    pub(super) fn output(&self, field: &str) -> Option<&str> {
        quantity(&self.outputs, field)
    }

    /// What the door calls a quantity that it asks for.
    pub(super) fn asked(&self, quantity: &str) -> Option<&str> {
        let found = self.asked.iter().find(|name| name.quantity == quantity);
        found.and_then(|name| name.text.as_deref())
    }

    /// The angle of a variable of the door.
    pub(super) fn angle(&self, text: &str) -> Option<&str> {
        let angles = self.door.iter().flat_map(|door| &door.angles);
        let asked = angles.map(|place| &self.asked[*place]);
        let mut all = asked.chain(&self.fixed);
        let found = all.find(|name| name.text.as_deref() == Some(text));
        found.map(|name| name.quantity.as_str())
    }

    /// `ClosedForm` for `closed_form`; two numbers do not run into one another.
    pub(super) fn type_prefix(&self) -> String {
        let mut prefix = String::new();
        for part in self.function.split('_') {
            let mut letters = part.chars();
            let Some(first) = letters.next() else {
                continue;
            };
            if first.is_ascii_digit() && prefix.ends_with(|last: char| last.is_ascii_digit()) {
                prefix.push('_');
            }
            prefix.push(first.to_ascii_uppercase());
            prefix.extend(letters);
        }
        prefix
    }
}

fn quantity<'n>(names: &'n [Name], field: &str) -> Option<&'n str> {
    let found = names
        .iter()
        .find(|name| name.text.as_deref() == Some(field));
    found.map(|name| name.quantity.as_str())
}

/// What a text may call one of some names: the name itself, or with underscores behind it as long as
/// that is not another one of them.
pub(super) fn spellings<'n>(
    name: &'n str,
    all: impl Fn(&str) -> bool + 'n,
) -> impl Iterator<Item = String> + 'n {
    (0..=MOST_UNDERSCORES)
        .map(move |count| format!("{name}{}", "_".repeat(count)))
        .filter(move |spelling| spelling == name || !all(spelling))
}

/// Whether a text may call a name like this, although it has others.
pub fn is_spelling(text: &str, name: &str, all: impl Fn(&str) -> bool) -> bool {
    spellings(name, all).any(|spelling| spelling == text)
}
