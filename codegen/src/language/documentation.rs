//! What every emitted function says of itself.

mod sentence;

pub use sentence::flat;
use sentence::{capital, listed, sentence, wrapped};

use super::literal::Decimal;
use crate::cost::Cost;
use crate::evaluator::{Evaluator, Fixed, Input, Quantity, Rounding};

/// How a language's comments are written.
#[derive(Clone, Copy, Debug)]
pub struct Comments {
    /// Makes prose harmless.
    pub prose: fn(&str) -> String,
    /// Makes what stands between backticks harmless.
    pub code: fn(&str) -> String,
    /// A heading.
    pub heading: fn(&str) -> String,
    /// What becomes of operations on constants alone.
    pub constants: &'static str,
    /// Whether a reader of a function finds its inputs and outputs beside it, as the fields of its
    /// structures, and need not be told twice.
    pub shows_fields: bool,
}

impl Comments {
    fn code(&self, text: &str) -> String {
        // A backtick would end it.
        format!("`{}`", (self.code)(&flat(text)).replace('`', "'"))
    }

    fn prose(&self, text: &str) -> String {
        (self.prose)(text)
    }
}

/// What a quantity is, without its name: description, symbol, unit.
fn quantity(what: &Quantity, comments: &Comments) -> String {
    let mut parts = Vec::new();
    let description = flat(&what.description);
    let description = description.trim_end_matches('.');
    let symbol = (what.symbol != what.name).then(|| comments.prose(&flat(&what.symbol)));
    match (description.is_empty(), symbol) {
        (false, Some(symbol)) => parts.push(format!(
            "{} ({symbol})",
            comments.prose(&capital(description))
        )),
        (false, None) => parts.push(comments.prose(&capital(description))),
        (true, Some(symbol)) => parts.push(symbol),
        (true, None) => {}
    }
    match what.unit.as_str() {
        // 0 has any unit.
        "" if parts.is_empty() => parts.push("no unit".to_owned()),
        "" => {}
        "1" => parts.push("dimensionless".to_owned()),
        unit => parts.push(format!("in {}", comments.code(unit))),
    }
    if let ([only], true) = (parts.as_mut_slice(), description.is_empty()) {
        *only = capital(only);
    }
    parts.join(", ")
}

/// The lines that describe one field of a structure.
pub fn field(what: &Quantity, name: &str, comments: &Comments) -> Vec<String> {
    let mut text = quantity(what, comments);
    if name != what.name {
        text.push_str(&format!("; {}", renamed(&what.name, comments)));
    }
    wrapped(&format!("{text}."), "", "")
}

/// What is said of a name that is not that of the document.
fn renamed(name: &str, comments: &Comments) -> String {
    let name = comments.code(name);
    format!("called {name} in the document, which is no safe name here")
}

/// The first sentence: what is computed, and by which equation.
pub fn title(evaluator: &Evaluator, comments: &Comments) -> String {
    let title = comments.prose(&capital(&evaluator.title));
    let title = title.trim_end_matches('.');
    let number = |number: &String| format!("({})", comments.prose(&flat(number)));
    let numbers: Vec<String> = evaluator.equations.iter().map(number).collect();
    match numbers.as_slice() {
        [] => format!("{title}."),
        [one] => format!("{title}, Eq. {one}."),
        several => format!("{title}, Eqs. {}.", several.join(", ")),
    }
}

/// The first sentence, on lines.
pub fn opening(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    wrapped(&title(evaluator, comments), "", "")
}

/// The names and numbers that a language gives the parts of an evaluator.
pub struct Parts<'a> {
    /// The function.
    pub function: &'a str,
    /// The inputs that are asked for.
    pub inputs: Vec<(&'a str, &'a Input)>,
    /// The inputs and angles that are fixed, and the numbers that are written for them.
    pub fixed: Vec<(&'a str, &'a Quantity, &'a Fixed, Decimal)>,
    /// The outputs.
    pub outputs: &'a [String],
}

/// The whole documentation of a function.
pub fn function(evaluator: &Evaluator, parts: &Parts<'_>, comments: &Comments) -> Vec<String> {
    let mut lines = opening(evaluator, comments);
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
    if parts.function != evaluator.name {
        let renamed = capital(&renamed(&evaluator.name, comments));
        paragraph(None, wrapped(&sentence(&renamed), "", ""));
    }
    let description = comments.prose(&sentence(&evaluator.description));
    paragraph(None, wrapped(&description, "", ""));
    if !evaluator.source.is_empty() {
        let source = format!("Source: {}", flat(&evaluator.source));
        paragraph(None, wrapped(&comments.prose(&sentence(&source)), "", ""));
    }
    let formula = evaluator.formula.iter().map(|line| comments.code(line));
    paragraph(Some("Formula"), listed(formula));
    let item = |name: &str, what: &Quantity| format!("`{name}`: {}.", quantity(what, comments));
    let listed_here = |items: Vec<String>| match comments.shows_fields {
        true => Vec::new(),
        false => listed(items),
    };
    let inputs = parts.inputs.iter();
    let inputs = inputs.map(|(name, input)| item(name, &input.quantity));
    paragraph(Some("Inputs"), listed_here(inputs.collect()));
    paragraph(Some("Fixed"), fixed(parts, comments));
    let outputs = parts.outputs.iter().zip(&evaluator.outputs);
    let outputs = outputs.map(|(name, what)| item(name, what));
    paragraph(Some("Outputs"), listed_here(outputs.collect()));
    paragraph(Some("Conditions"), conditions(evaluator, comments));
    let cost = cost(evaluator, comments);
    paragraph(Some("Cost"), wrapped(&cost, "", ""));
    let proof = comments.prose(&proof(evaluator));
    paragraph(Some("Proof"), wrapped(&proof, "", ""));
    let rounding = match &evaluator.rounding {
        Some(rounding) if evaluator.is_constant() => alone(rounding, parts.outputs),
        Some(rounding) => measured(rounding, parts.outputs, comments),
        None => vec!["Not measured.".to_owned()],
    };
    paragraph(Some("Rounding"), rounding);
    paragraph(Some("Origin"), origin(evaluator, comments));
    lines
}

fn fixed(parts: &Parts<'_>, comments: &Comments) -> Vec<String> {
    if parts.fixed.is_empty() {
        return Vec::new();
    }
    let item = |(name, what, fixed, decimal): &(&str, &Quantity, &Fixed, Decimal)| {
        let code = format!("{name} = {}", decimal.text);
        let mut text = format!("{}: {}.", comments.code(&code), quantity(what, comments));
        let meaning = flat(&fixed.text);
        if !meaning.is_empty() && meaning != code {
            text.push_str(&format!(" It stands for {}.", comments.prose(&meaning)));
        }
        text
    };
    let mut lines = wrapped(
        "These are no inputs. They are taken as the doubles that are written here, also in the bounds of \
         the rounding error:",
        "",
        "",
    );
    lines.push(String::new());
    lines.extend(listed(parts.fixed.iter().map(item)));
    lines
}

fn conditions(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    let mut lines = Vec::new();
    let mut list = |text: &str, items: &[String]| {
        if !lines.is_empty() {
            lines.push(String::new());
        }
        lines.extend(wrapped(text, "", ""));
        if !items.is_empty() {
            lines.push(String::new());
            lines.extend(listed(items.iter().map(|item| comments.code(item))));
        }
    };
    let (assumptions, conditions) = (&evaluator.assumptions, &evaluator.conditions);
    if !assumptions.is_empty() {
        list("The derivation assumes:", assumptions);
    }
    match (assumptions.is_empty(), conditions.is_empty()) {
        (_, false) => list(
            "Valid where all of these hold; elsewhere a result may be infinite, NaN or without meaning:",
            conditions,
        ),
        (false, true) => list("It needs no further condition.", &[]),
        (true, true) => list(
            "No assumption and no condition is recorded; inputs without physical meaning are not \
             refused.",
            &[],
        ),
    }
    let range =
        "A value on the way that leaves the range of doubles may make a result infinite or NaN.";
    list(range, &[]);
    lines
}

fn cost(evaluator: &Evaluator, comments: &Comments) -> String {
    let hoisted = evaluator.hoisted();
    match Cost::of(&hoisted.preparation).total() {
        0 => format!("{}.", evaluator.cost()),
        _ if evaluator.is_constant() => format!(
            "{}, all of them on constants, {}.",
            evaluator.cost(),
            comments.constants
        ),
        once => format!(
            "{} at each point, and {once} on constants alone, {}.",
            Cost::of(&hoisted.sweep),
            comments.constants
        ),
    }
}

fn proof(evaluator: &Evaluator) -> String {
    let proof = evaluator.proof.as_deref().unwrap_or_default();
    match flat(proof).is_empty() {
        true => "Nothing is proven of this text.".to_owned(),
        false => sentence(proof),
    }
}

/// A number of units: two places, or powers of ten where an output crosses zero.
fn units(number: f64) -> String {
    match number < 1000.0 {
        true => format!("{number:.2}"),
        false => format!("{number:.1e}"),
    }
}

fn measured(rounding: &Rounding, outputs: &[String], comments: &Comments) -> Vec<String> {
    let text = format!(
        "Distance of the strict evaluation from the exact value, in units in the last place of that value, \
         at {} points of {}:",
        rounding.points,
        comments.prose(&flat(&rounding.domain))
    );
    let mut lines = wrapped(&text, "", "");
    lines.push(String::new());
    let errors = rounding.largest.iter().zip(&rounding.percentile_99);
    let errors = outputs.iter().zip(errors).map(|(name, (largest, most))| {
        let (largest, most) = (units(*largest), units(*most));
        format!("`{name}`: at most {largest}; at 99 of 100 points at most {most}.")
    });
    lines.extend(listed(errors));
    lines
}

/// The errors of numbers.
fn alone(rounding: &Rounding, outputs: &[String]) -> Vec<String> {
    let text = "Distance of the strict evaluation from the exact value, in units in the last place of that \
         value:";
    let mut lines = wrapped(text, "", "");
    lines.push(String::new());
    let errors = outputs.iter().zip(&rounding.largest);
    lines.extend(listed(
        errors.map(|(name, error)| format!("`{name}`: {}.", units(*error))),
    ));
    lines
}

/// In short, what is proven and measured.
pub fn summary(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    let rounding = match &evaluator.rounding {
        Some(rounding) => {
            let most = |errors: &[f64]| units(errors.iter().copied().fold(0.0, f64::max));
            let largest = most(&rounding.largest);
            if evaluator.is_constant() {
                format!("largest error {largest} units in the last place.")
            } else {
                format!(
                    "largest error {largest} units in the last place; at 99 of 100 points at most {}.",
                    most(&rounding.percentile_99)
                )
            }
        }
        None => "not measured.".to_owned(),
    };
    listed([
        format!("Proof: {}", comments.prose(&proof(evaluator))),
        format!("Rounding: {rounding}"),
    ])
}

/// Which command made it from which document.
pub fn origin(evaluator: &Evaluator, comments: &Comments) -> Vec<String> {
    let parts = [
        ("Command", &evaluator.command),
        ("Document", &evaluator.document),
        ("SHA-256 of the document", &evaluator.hash),
    ];
    let known = parts.into_iter().filter(|(_, text)| !text.is_empty());
    listed(known.map(|(what, text)| format!("{what}: {}", comments.code(text))))
}
