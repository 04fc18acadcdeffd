//! The names that a statement builds on.

use super::syntax::{
    EvaluatorBody, Expression, Name, Node, Place, Relation, Replacement, Statement, StatementKind,
    SystemBody, SystemStatement,
};

/// A name that is mentioned.
#[derive(Clone, Debug, PartialEq)]
pub struct Mention {
    /// The name.
    pub name: Name,
    /// Whether it is given arguments.
    pub is_called: bool,
}

impl Mention {
    fn bare(name: &Name) -> Self {
        Mention {
            name: name.clone(),
            is_called: false,
        }
    }
}

impl Statement {
    /// The names that it builds on, in their order; those of evaluators and systems are none of them.
    pub fn mentions(&self) -> Vec<Mention> {
        let mut found = Vec::new();
        match &self.kind {
            StatementKind::Import { .. }
            | StatementKind::Parameter { .. }
            | StatementKind::Complex { .. }
            | StatementKind::Angle { .. }
            | StatementKind::Coordinate { .. }
            | StatementKind::Imaginary { .. } => {}
            StatementKind::Function { reference, .. } => reference.collect_mentions(&mut found),
            StatementKind::Show { expression, .. } => expression.collect_mentions(&mut found),
            StatementKind::Assume { relation, .. } => of_relation(relation, &mut found),
            StatementKind::Definition {
                arguments, values, ..
            } => {
                of_all(values, &mut found);
                found.retain(|mention| !arguments.iter().any(|own| own.value == mention.name));
            }
            StatementKind::Substitution { replacements, .. }
            | StatementKind::Domain(replacements) => of_replacements(replacements, &mut found),
            StatementKind::Assertion {
                relation,
                difference,
                order,
                ..
            } => {
                of_relation(relation, &mut found);
                of_all(difference, &mut found);
                let small = order.iter().flat_map(|order| &order.small);
                found.extend(small.map(|name| Mention::bare(&name.value)));
            }
            StatementKind::Eigenpair {
                stiffness,
                mass,
                value,
                vector,
                ..
            } => of_all([stiffness, mass, value, vector], &mut found),
            StatementKind::Match(matching) => {
                of_all([&matching.exact, &matching.assumed], &mut found);
                let names = [&matching.variable].into_iter().chain(&matching.unknowns);
                let names = names.chain(&matching.small);
                found.extend(names.map(|name| Mention::bare(&name.value)));
                of_all(&matching.neglected, &mut found);
            }
            StatementKind::System(system) => of_system(system, &mut found),
            StatementKind::Evaluator {
                body,
                approximated,
                conditions,
                ..
            } => {
                let place = approximated.as_ref().and_then(|own| own.place.as_ref());
                place
                    .into_iter()
                    .for_each(|place| of_place(place, &mut found));
                of_body(body, &mut found);
                for condition in conditions {
                    of_relation(condition, &mut found);
                }
            }
        }
        found
    }

    /// The evaluators and systems that it builds on: that of which it is a special case, that which it approximates, and
    /// those whose outputs it names.
    pub fn compiled_bases(&self) -> Vec<Name> {
        let (general, system) = match &self.kind {
            StatementKind::Evaluator {
                body, approximated, ..
            } => {
                let general = match body {
                    EvaluatorBody::Special { general, .. } => Some(general),
                    EvaluatorBody::Outputs(_) => None,
                };
                (general, approximated.as_ref().map(|own| &own.system))
            }
            _ => (None, None),
        };
        let bases = general
            .into_iter()
            .chain(system)
            .map(|own| own.value.clone());
        let outputs = self.mentions().into_iter();
        let owners = outputs.filter_map(|own| Some(own.name.of_output()?.0));
        bases.chain(owners).collect()
    }
}

impl Expression {
    /// Adds the names that it builds on, also those that it replaces.
    pub fn collect_mentions(&self, found: &mut Vec<Mention>) {
        match &self.node {
            Node::Number(_) => {}
            Node::Name(name) | Node::Derivative(name, _) => found.push(Mention::bare(name)),
            Node::Negative(inner) => inner.collect_mentions(found),
            Node::Binary(_, left, right) => of_all([&**left, &**right], found),
            Node::Call {
                function,
                arguments,
                ..
            } => {
                found.push(Mention {
                    name: function.clone(),
                    is_called: true,
                });
                of_all(arguments, found);
            }
            Node::Matrix(rows) => of_all(rows.iter().flatten(), found),
            Node::Index(matrix, indices) => {
                matrix.collect_mentions(found);
                of_all(indices, found);
            }
            Node::At(inner, place) => {
                inner.collect_mentions(found);
                of_place(place, found);
            }
        }
    }
}

fn of_all<'a>(expressions: impl IntoIterator<Item = &'a Expression>, found: &mut Vec<Mention>) {
    for expression in expressions {
        expression.collect_mentions(found);
    }
}

fn of_relation(relation: &Relation, found: &mut Vec<Mention>) {
    of_all([&relation.left, &relation.right], found);
}

fn of_replacements(replacements: &[Replacement], found: &mut Vec<Mention>) {
    for replacement in replacements {
        of_all([&replacement.target, &replacement.value], found);
    }
}

fn of_place(place: &Place, found: &mut Vec<Mention>) {
    match place {
        Place::Named(name) => found.push(Mention::bare(&name.value)),
        Place::Replacements(replacements) => of_replacements(replacements, found),
    }
}

fn of_system(system: &SystemStatement, found: &mut Vec<Mention>) {
    let coordinates = system.coordinates.iter();
    found.extend(coordinates.map(|name| Mention::bare(&name.value)));
    match &system.body {
        SystemBody::Matrices {
            mass,
            damping,
            stiffness,
        } => {
            let parts = damping.iter().chain(stiffness).map(|part| &part.matrix);
            of_all([mass].into_iter().chain(parts), found);
        }
        SystemBody::Equations { equations, rest } => {
            equations.collect_mentions(found);
            of_place(rest, found);
        }
    }
}

fn of_body(body: &EvaluatorBody, found: &mut Vec<Mention>) {
    match body {
        EvaluatorBody::Outputs(outputs) => {
            of_all(outputs.iter().map(|(_, value)| value), found);
        }
        EvaluatorBody::Special { place, .. } => of_place(place, found),
    }
}
