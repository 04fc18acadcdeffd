//! What an emitted text calls the quantities of an evaluator.

use sextic_codegen::evaluator::{Evaluator, Quantity};

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
}

impl Names {
    /// The names of an evaluator that a text calls like this, before its declarations have been read.
    pub(super) fn new(evaluator: &Evaluator, function: &str) -> Self {
        let unknown = |quantities: &[Quantity]| {
            let name = |quantity: &Quantity| Name {
                quantity: quantity.name.clone(),
                text: None,
            };
            quantities.iter().map(name).collect()
        };
        Names {
            function: function.to_string(),
            inputs: unknown(&evaluator.inputs),
            outputs: unknown(&evaluator.outputs),
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
