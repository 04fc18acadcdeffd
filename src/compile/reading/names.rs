//! What an emitted text calls the quantities of an evaluator.

use sextic_codegen::evaluator::{Evaluator, Origin};

/// How many underscores a name that is not free in a language may get.
const MOST_UNDERSCORES: usize = 16;

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
    /// What is asked for instead of sines and cosines; empty where there are none.
    pub(super) asked: Vec<Name>,
}

impl Names {
    /// The names of an evaluator that a text calls like this, before its declarations have been read.
    pub(super) fn new(evaluator: &Evaluator, function: &str) -> Self {
        let unknown = |quantity: &String| Name {
            quantity: quantity.clone(),
            text: None,
        };
        let inputs = evaluator.free_inputs().map(|input| &input.quantity.name);
        let outputs = evaluator.outputs.iter().map(|output| &output.name);
        Names {
            function: function.to_string(),
            inputs: inputs.map(unknown).collect(),
            outputs: outputs.map(unknown).collect(),
            asked: asked(evaluator).into_iter().map(unknown).collect(),
        }
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

/// Angles that are not fixed in the place of their sines and cosines, each once, in the order of the
/// inputs; nothing if no input is a sine or cosine.
fn asked(evaluator: &Evaluator) -> Vec<&String> {
    let mut asked: Vec<&String> = Vec::new();
    let mut add = |name| {
        if !asked.contains(&name) {
            asked.push(name);
        }
    };
    for input in evaluator.free_inputs() {
        match &input.origin {
            Origin::Given => add(&input.quantity.name),
            Origin::Circular(circular) => {
                let angles = circular
                    .angle
                    .iter()
                    .filter_map(|(_, name)| evaluator.angle(name));
                let open = angles.filter(|angle| angle.fixed.is_none());
                open.for_each(|angle| add(&angle.quantity.name));
            }
            Origin::Fixed(_) => {}
        }
    }
    match evaluator
        .free_inputs()
        .any(|input| input.circular().is_some())
    {
        true => asked,
        false => Vec::new(),
    }
}

/// The quantity that a text calls like this.
pub(super) fn quantity<'n>(names: &'n [Name], field: &str) -> Option<&'n str> {
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
