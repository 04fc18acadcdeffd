//! What every emitted function says of itself.

use crate::evaluator::{Evaluator, Quantity, Rounding};

/// Lines are no longer than this, before the marks of a comment.
const WIDTH: usize = 92;

/// How a language's comments are written.
#[derive(Clone, Copy, Debug)]
pub struct Comments {
    /// Makes prose harmless.
    pub prose: fn(&str) -> String,
    /// Makes what stands between backticks harmless.
    pub code: fn(&str) -> String,
    /// A heading.
    pub heading: fn(&str) -> String,
}

impl Comments {
    /// Prose on lines of its own.
    pub fn paragraph(&self, text: &str) -> Vec<String> {
        wrapped(&(self.prose)(text), "", "")
    }

    fn code(&self, text: &str) -> String {
        // A backtick would end it.
        format!("`{}`", (self.code)(&flat(text)).replace('`', "'"))
    }
}

/// A text as one line without control characters: what a document says never ends a comment by a line
/// break.
pub fn flat(text: &str) -> String {
    let words: Vec<&str> = text
        .split(|letter: char| letter.is_whitespace() || letter.is_control())
        .filter(|word| !word.is_empty())
        .collect();
    words.join(" ")
}

/// Words on lines that are not too long.
fn wrapped(text: &str, first: &str, next: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = first.to_owned();
    let mut empty = true;
    for word in flat(text).split(' ').filter(|word| !word.is_empty()) {
        let long = line.chars().count() + 1 + word.chars().count() > WIDTH;
        if long && !empty {
            lines.push(std::mem::replace(&mut line, next.to_owned()));
            empty = true;
        }
        if !empty {
            line.push(' ');
        }
        line.push_str(word);
        empty = false;
    }
    if !empty {
        lines.push(line);
    }
    lines
}

/// What a quantity is, without its name: symbol, unit, description.
pub fn quantity(quantity: &Quantity, comments: &Comments) -> String {
    let unit = match quantity.unit.is_empty() {
        true => "no unit".to_owned(),
        false => format!("in {}", comments.code(&quantity.unit)),
    };
    let mut text = match quantity.symbol == quantity.name {
        true => unit,
        false => format!("{}, {unit}", (comments.prose)(&quantity.symbol)),
    };
    if !quantity.description.is_empty() {
        text.push_str(": ");
        text.push_str(&(comments.prose)(&quantity.description));
    }
    flat(&text)
}

/// The lines that describe one field of a structure.
pub fn field(what: &Quantity, renamed: bool, comments: &Comments) -> Vec<String> {
    let mut text = quantity(what, comments);
    if renamed {
        text.push_str(&format!(
            "; called {} in the document, which is no safe name here",
            comments.code(&what.name)
        ));
    }
    // A sentence begins with a capital letter, unless that would change a symbol.
    if what.symbol == what.name && text.starts_with("no unit") {
        text.replace_range(0..1, "N");
    } else if what.symbol == what.name {
        text.replace_range(0..1, "I");
    }
    wrapped(&format!("{text}."), "", "")
}

/// The first line: what is computed, and by which equation.
pub fn title(evaluator: &Evaluator, comments: &Comments) -> String {
    let title = flat(&(comments.prose)(&evaluator.title));
    let title = title.trim_end_matches('.');
    match evaluator.equations.as_slice() {
        [] => format!("{title}."),
        [one] => format!("{title}, Eq. ({}).", flat(&(comments.prose)(one))),
        several => {
            let numbers: Vec<String> = several
                .iter()
                .map(|number| format!("({})", flat(&(comments.prose)(number))))
                .collect();
            format!("{title}, Eqs. {}.", numbers.join(", "))
        }
    }
}

/// The whole documentation of a function.
///
/// `inputs` and `outputs` are the names in the language.
pub fn function(
    evaluator: &Evaluator,
    inputs: &[String],
    outputs: &[String],
    comments: &Comments,
) -> Vec<String> {
    let mut lines = wrapped(&title(evaluator, comments), "", "");
    let mut paragraph = |heading: Option<&str>, body: Vec<String>| {
        if !body.is_empty() {
            lines.push(String::new());
            if let Some(heading) = heading {
                lines.push((comments.heading)(heading));
                lines.push(String::new());
            }
            lines.extend(body);
        }
    };
    paragraph(None, comments.paragraph(&evaluator.description));
    if !evaluator.source.is_empty() {
        let source = format!("Source: {}", (comments.prose)(&evaluator.source));
        paragraph(None, wrapped(&source, "", ""));
    }
    let listed = |quantities: &[Quantity], names: &[String]| -> Vec<String> {
        let items = names.iter().zip(quantities);
        items
            .flat_map(|(name, what)| {
                let text = format!("`{name}`: {}", quantity(what, comments));
                wrapped(&text, "- ", "  ")
            })
            .collect()
    };
    paragraph(Some("Inputs"), listed(&evaluator.inputs, inputs));
    paragraph(Some("Outputs"), listed(&evaluator.outputs, outputs));
    paragraph(Some("Conditions"), conditions(evaluator, comments));
    let cost = format!("{}.", evaluator.cost());
    paragraph(Some("Cost"), wrapped(&cost, "", ""));
    let proof = match &evaluator.proof {
        Some(proof) => (comments.prose)(proof),
        None => "Nothing is proven of this text.".to_owned(),
    };
    paragraph(Some("Proof"), wrapped(&proof, "", ""));
    let rounding = match &evaluator.rounding {
        Some(rounding) => measured(rounding, outputs, comments),
        None => vec!["Not measured.".to_owned()],
    };
    paragraph(Some("Rounding"), rounding);
    paragraph(Some("Origin"), origin(evaluator, comments));
    lines
}

fn conditions(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    if evaluator.conditions.is_empty() {
        return wrapped("None was used in the derivation.", "", "");
    }
    let mut lines = wrapped(
        "Valid where all of these hold; elsewhere a result may be infinite, NaN or without meaning:",
        "",
        "",
    );
    lines.push(String::new());
    for condition in &evaluator.conditions {
        lines.extend(wrapped(&comments.code(condition), "- ", "  "));
    }
    lines
}

fn measured(rounding: &Rounding, outputs: &[String], comments: &Comments) -> Vec<String> {
    let mut lines = wrapped(
        &format!(
            "Largest error of the strict evaluation in units in the last place, measured against \
             exact rational arithmetic at {} points drawn from {}:",
            rounding.points,
            (comments.prose)(&rounding.domain)
        ),
        "",
        "",
    );
    lines.push(String::new());
    for (name, largest) in outputs.iter().zip(&rounding.largest) {
        lines.push(format!("- `{name}`: {largest:.2}"));
    }
    lines
}

/// Which command made it from which document.
pub fn origin(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    let mut lines = Vec::new();
    if !evaluator.command.is_empty() {
        let text = format!("Command: {}", comments.code(&evaluator.command));
        lines.extend(wrapped(&text, "- ", "  "));
    }
    if !evaluator.document.is_empty() {
        let text = format!("Document: {}", comments.code(&evaluator.document));
        lines.extend(wrapped(&text, "- ", "  "));
    }
    if !evaluator.hash.is_empty() {
        let text = format!("Hash of the document: {}", comments.code(&evaluator.hash));
        lines.extend(wrapped(&text, "- ", "  "));
    }
    lines
}
