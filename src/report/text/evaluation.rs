//! Evaluators and their values, for a terminal.

use sextic_codegen::evaluator::Quantity;
use unicode_width::UnicodeWidthStr;

use crate::compile::specification::Specification;
use crate::report::evaluation::Evaluation;

use super::page::Page;
use super::palette::{FAINT, PLAIN, STRONG};
use super::run::{Run, column};

/// A line an output.
pub fn evaluation(evaluation: &Evaluation) -> String {
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
    outputs.iter().map(line).collect()
}

/// What can be evaluated: a paragraph an evaluator.
pub fn evaluators(specifications: &[Specification], width: usize) -> String {
    let mut page = Page::new(width);
    for (place, specification) in specifications.iter().enumerate() {
        let evaluator = &specification.evaluator;
        if place > 0 {
            page.gap();
        }
        let equations: Vec<String> = evaluator
            .equations
            .iter()
            .map(|number| format!(" ({number})"))
            .collect();
        let title = format!("{}: {}", equations.concat(), evaluator.title);
        page.prose(
            &[],
            &[
                Run::words(&evaluator.name, STRONG),
                Run::words(title, PLAIN),
            ],
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
