//! Evaluators and their values, for a terminal.

use sextic_codegen::evaluator::Quantity;
use unicode_width::UnicodeWidthStr;

use crate::compile::specification::Specification;
use crate::report::evaluation::Evaluation;

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column};

/// What the document says of it, then a line an output.
pub fn evaluation(evaluation: &Evaluation, width: usize) -> String {
    let mut page = Page::new(width);
    let Evaluation {
        evaluator,
        equations,
        description,
        ..
    } = evaluation;
    head(&mut page, evaluator, equations, description);
    let outputs = &evaluation.outputs;
    let width = outputs
        .iter()
        .map(|(output, _)| output.symbol.width())
        .max();
    let line = |(output, value): &(Quantity, f64)| {
        let gap = " ".repeat(width.unwrap_or(0) - output.symbol.width());
        let unit = unit(output);
        format!("{}{gap} = {value:?}{unit}\n", output.symbol)
    };
    let lines: String = outputs.iter().map(line).collect();
    format!("{}\n{lines}", page.finish())
}

/// The name of an evaluator, its equations, and what the document says of it.
fn head(page: &mut Page, name: &str, equations: &[String], description: &str) {
    let equations: String = equations
        .iter()
        .map(|number| format!(" ({number})"))
        .collect();
    let words = format!("{equations}: {description}");
    page.prose(&[], &[Run::words(name, STRONG), Run::words(words, PLAIN)]);
}

/// What can be evaluated: a paragraph an evaluator.
pub fn evaluators(specifications: &[Specification], width: usize) -> String {
    let mut page = Page::new(width);
    for (place, specification) in specifications.iter().enumerate() {
        let evaluator = &specification.evaluator;
        if place > 0 {
            page.gap();
        }
        head(
            &mut page,
            &evaluator.name,
            &evaluator.equations,
            &evaluator.title,
        );
        let mut line = |word: &str, list: Vec<String>| {
            if !list.is_empty() {
                let list = Run::words(list.join(", "), PLAIN);
                page.prose(&column(&format!("  {word}"), COLUMN, FAINT), &[list]);
            }
        };
        line("needs", specification.quantities().map(named).collect());
        line("gives", evaluator.outputs.iter().map(named).collect());
        line("assumes", evaluator.assumptions.clone());
        line("where", evaluator.conditions.clone());
    }
    page.finish()
}

/// As wide as the widest of the words in front of a list.
const COLUMN: usize = 10;

/// `m in kg/m`; nothing breaks between the name and the unit.
fn named(quantity: &Quantity) -> String {
    let unit = unit(quantity).replace(' ', "\u{a0}");
    format!("{}{unit}", quantity.name)
}

/// ` kg/m`, and nothing for a pure number.
fn unit(quantity: &Quantity) -> String {
    match quantity.unit.as_str() {
        "" | "1" => String::new(),
        unit => format!(" {unit}"),
    }
}
