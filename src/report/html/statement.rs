//! The statements of a block that assert nothing: declarations, definitions, and what is compiled.

use serde::Serialize;

use super::escape;
use super::mathematics::{expression, formula};
use super::unit;
use crate::language::notation::Notation;
use crate::language::syntax::{
    Approximated, EvaluatorBody, Expression, Name, Node, Part, Place, Quantities, Replacement,
    Spanned, StatementKind, SystemBody, SystemStatement,
};
use crate::report::words;

const NOTATION: Notation = Notation::Latex;

/// A row of a table of quantities.
#[derive(Serialize)]
pub struct QuantityView {
    /// HTML.
    symbol: String,
    kind: &'static str,
    /// HTML.
    unit: String,
    meaning: String,
}

/// A statement in a line or more: a word, and formulas.
#[derive(Serialize)]
pub struct LineView {
    keyword: String,
    /// HTML, each in a line of its own.
    formulas: Vec<String>,
    description: Option<String>,
}

/// What a statement declares, if it declares quantities.
pub fn quantity(statement: &StatementKind) -> Option<QuantityView> {
    let view = |names: &[Spanned<Name>], more: &str, kind, unit: &str, words: &Option<String>| {
        let names: Vec<String> = names
            .iter()
            .map(|name| NOTATION.name(&name.value))
            .collect();
        QuantityView {
            symbol: formula(&format!("{}{more}", names.join(", "))),
            kind,
            unit: unit::set(unit),
            meaning: words.clone().unwrap_or_default(),
        }
    };
    Some(match statement {
        StatementKind::Parameter {
            names,
            unit,
            sign,
            description,
        } => {
            let sign = sign.map_or(String::new(), |sign| {
                format!(" {}", words::sign(sign, NOTATION))
            });
            view(names, &sign, "parameter", &unit.value, description)
        }
        StatementKind::Complex {
            names,
            unit,
            description,
        } => view(names, "", "complex", &unit.value, description),
        StatementKind::Angle { names, description } => view(names, "", "angle", "rad", description),
        StatementKind::Coordinate {
            names,
            unit,
            description,
        } => view(names, "(t)", "coordinate", &unit.value, description),
        StatementKind::Function {
            names,
            reference,
            unit,
            description,
        } => {
            let argument = format!(r"\left({}\right)", NOTATION.expression(reference));
            view(names, &argument, "function", &unit.value, description)
        }
        StatementKind::Imaginary { name } => view(
            std::slice::from_ref(name),
            "^{2} = -1",
            "imaginary unit",
            "1",
            &None,
        ),
        _ => return None,
    })
}

/// A statement that neither declares quantities nor asserts or matches anything.
pub fn line(statement: &StatementKind) -> Option<LineView> {
    let view = |keyword: &str, formulas, description: &Option<String>| LineView {
        keyword: keyword.to_owned(),
        formulas,
        description: description.clone(),
    };
    Some(match statement {
        StatementKind::Import { path } => view("import", vec![escape(&path.value)], &None),
        StatementKind::Assume {
            relation,
            description,
        } => view(
            "assume",
            vec![formula(&NOTATION.relation(relation))],
            description,
        ),
        StatementKind::Definition {
            names,
            arguments,
            values,
        } => {
            let arguments: Vec<String> = arguments
                .iter()
                .map(|name| NOTATION.name(&name.value))
                .collect();
            let arguments = match arguments.as_slice() {
                [] => String::new(),
                some => format!(r"\left({}\right)", some.join(", ")),
            };
            let definitions = names.iter().zip(values).map(|(name, value)| {
                let (name, value) = (NOTATION.name(&name.value), NOTATION.expression(value));
                formula(&format!("{name}{arguments} \\coloneqq {value}"))
            });
            view("", definitions.collect(), &None)
        }
        StatementKind::Substitution { name, replacements } => view(
            &format!("substitution {}", name.value),
            vec![list(replacements.iter().map(replacement))],
            &None,
        ),
        StatementKind::System(system) => {
            let keyword = format!(
                "system {} {}",
                words::label(&system.label),
                system.name.value.ascii
            );
            view(&keyword, matrices(system), &system.description)
        }
        StatementKind::Evaluator {
            label,
            name,
            body,
            approximated,
            conditions,
            description,
        } => {
            let mut formulas = outputs(body);
            if let Some(approximated) = approximated {
                formulas.push(beside(approximated));
            }
            if !conditions.is_empty() {
                let conditions = conditions
                    .iter()
                    .map(|own| formula(&NOTATION.relation(own)));
                formulas.push(format!("where {}", list(conditions)));
            }
            let keyword = format!("evaluator {} {}", words::label(label), name.value.ascii);
            view(&keyword, formulas, description)
        }
        StatementKind::Domain(ranges) => {
            view("domain", vec![list(ranges.iter().map(range))], &None)
        }
        _ => return None,
    })
}

/// The matrices of a system, or its equations, and its coordinates.
fn matrices(system: &SystemStatement) -> Vec<String> {
    let of = |what: &str, part: &Part| {
        let name = part.name.as_ref().map(|name| format!(" {}", name.value));
        let name = escape(&name.unwrap_or_default());
        format!(
            "{what}{name} {}",
            formula(&NOTATION.expression(&part.matrix))
        )
    };
    let mut formulas = match &system.body {
        SystemBody::Matrices {
            mass,
            damping,
            stiffness,
        } => {
            let mass = format!("mass {}", formula(&NOTATION.expression(mass)));
            let damping = damping.iter().map(|part| of("damping", part));
            let stiffness = stiffness.iter().map(|part| of("stiffness", part));
            [mass].into_iter().chain(damping).chain(stiffness).collect()
        }
        SystemBody::Equations { equations, rest } => {
            let equations = formula(&NOTATION.expression(equations));
            vec![format!("equations {equations} at {}", at(rest))]
        }
    };
    let coordinates = system.coordinates.iter();
    let coordinates = coordinates.map(|name| formula(&NOTATION.name(&name.value)));
    formulas.push(format!("in {}", list(coordinates)));
    formulas
}

/// What an evaluator is close to.
fn beside(approximated: &Approximated) -> String {
    let quantities = match approximated.quantities {
        Quantities::RealParts => "real parts",
        Quantities::Eigenvalues => "eigenvalues",
    };
    let system = escape(&approximated.system.value.ascii);
    let place = approximated.place.as_ref();
    let place = place.map(|place| format!(" at {}", at(place)));
    let roots = if approximated.by_roots {
        " by roots"
    } else {
        ""
    };
    format!(
        "approximates {quantities} of {system}{}{roots}",
        place.unwrap_or_default()
    )
}

fn at(place: &Place) -> String {
    match place {
        Place::Named(name) => escape(&name.value.unicode),
        Place::Replacements(all) => list(all.iter().map(replacement)),
    }
}

fn outputs(body: &EvaluatorBody) -> Vec<String> {
    match body {
        EvaluatorBody::Outputs(outputs) => outputs
            .iter()
            .map(|(name, value)| {
                let value = NOTATION.expression(value);
                formula(&format!("{} = {value}", NOTATION.name(&name.value)))
            })
            .collect(),
        EvaluatorBody::Special { general, place } => {
            vec![format!("{} at {}", escape(&general.value.ascii), at(place))]
        }
    }
}

fn replacement(replacement: &Replacement) -> String {
    let (target, value) = (&replacement.target, &replacement.value);
    formula(&format!(
        "{} = {}",
        NOTATION.expression(target),
        NOTATION.expression(value)
    ))
}

/// `m ∈ [1, 50]`
fn range(range: &Replacement) -> String {
    let entries = match &range.value.node {
        Node::Matrix(rows) => rows.concat(),
        _ => vec![range.value.clone()],
    };
    let entries: Vec<String> = entries
        .iter()
        .map(|entry: &Expression| NOTATION.expression(entry))
        .collect();
    format!(
        "{} {}",
        expression(&range.target),
        formula(&format!(r"\in [{}]", entries.join(", ")))
    )
}

fn list(formulas: impl Iterator<Item = String>) -> String {
    formulas.collect::<Vec<_>>().join(", ")
}
