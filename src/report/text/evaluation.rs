//! Evaluators and their values, for a terminal.

use sextic_codegen::evaluator::Quantity;
use unicode_width::UnicodeWidthStr;

use crate::compile::specification::Specification;
use crate::report::evaluation::Evaluation;

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
pub fn evaluators(specifications: &[Specification]) -> String {
    let paragraphs = specifications.iter().map(|specification| {
        let evaluator = &specification.evaluator;
        let equations: Vec<String> = evaluator
            .equations
            .iter()
            .map(|number| format!(" ({number})"))
            .collect();
        let mut lines = vec![format!(
            "{}{}: {}",
            evaluator.name,
            equations.concat(),
            evaluator.title
        )];
        lines.push(format!("  needs {}", names(specification.quantities())));
        lines.push(format!("  gives {}", names(evaluator.outputs.iter())));
        if !evaluator.assumptions.is_empty() {
            lines.push(format!("  assumes {}", evaluator.assumptions.join(", ")));
        }
        if !evaluator.conditions.is_empty() {
            lines.push(format!("  valid where {}", evaluator.conditions.join(", ")));
        }
        lines.join("\n") + "\n"
    });
    paragraphs.collect::<Vec<_>>().join("\n")
}

fn names<'a>(quantities: impl Iterator<Item = &'a Quantity>) -> String {
    let named = quantities.map(|quantity| format!("{}{}", quantity.name, unit(quantity)));
    named.collect::<Vec<_>>().join(", ")
}

/// ` kg/m`, and nothing for a pure number.
fn unit(quantity: &Quantity) -> String {
    match quantity.unit.as_str() {
        "" | "1" => String::new(),
        unit => format!(" {unit}"),
    }
}
