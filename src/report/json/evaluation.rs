//! `{"evaluator", "description", "inputs": {…}, "outputs": {…}, "unused": […]}`, and what can be evaluated.

use serde::Serialize;
use sextic_codegen::evaluator::Quantity;

use crate::compile::specification::Specification;
use crate::report::evaluation::Evaluation;

use super::pairs::Pairs;
use super::write;

#[derive(Serialize)]
struct Evaluated<'a> {
    evaluator: &'a str,
    description: &'a str,
    inputs: Pairs<f64>,
    outputs: Pairs<f64>,
    unused: &'a [String],
}

/// An evaluator at one point.
pub fn evaluation(evaluation: &Evaluation) -> String {
    let outputs = evaluation.outputs.iter();
    write(&Evaluated {
        evaluator: &evaluation.evaluator,
        description: &evaluation.description,
        inputs: Pairs(evaluation.inputs.clone()),
        outputs: Pairs(
            outputs
                .map(|(what, value)| (what.name.clone(), *value))
                .collect(),
        ),
        unused: &evaluation.unused,
    })
}

#[derive(Serialize)]
struct Evaluators<'a> {
    evaluators: Vec<Listed<'a>>,
}

#[derive(Serialize)]
struct Listed<'a> {
    evaluator: &'a str,
    equations: &'a [String],
    description: &'a str,
    inputs: Vec<Described<'a>>,
    outputs: Vec<Described<'a>>,
    assumptions: &'a [String],
    conditions: &'a [String],
}

#[derive(Serialize)]
struct Described<'a> {
    name: &'a str,
    symbol: &'a str,
    unit: &'a str,
    description: &'a str,
}

/// What can be evaluated.
pub fn evaluators(specifications: &[Specification]) -> String {
    let listed = specifications.iter().map(|specification| {
        let evaluator = &specification.evaluator;
        Listed {
            evaluator: &evaluator.name,
            equations: &evaluator.equations,
            description: &evaluator.title,
            inputs: specification.quantities().map(described).collect(),
            outputs: evaluator.outputs.iter().map(described).collect(),
            assumptions: &evaluator.assumptions,
            conditions: &evaluator.conditions,
        }
    });
    write(&Evaluators {
        evaluators: listed.collect(),
    })
}

fn described(quantity: &Quantity) -> Described<'_> {
    Described {
        name: &quantity.name,
        symbol: &quantity.symbol,
        unit: &quantity.unit,
        description: &quantity.description,
    }
}
