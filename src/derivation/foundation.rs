//! What an expression rests on.

use std::collections::BTreeSet;

use super::scope::{Meaning, Scope};
use crate::language::syntax::{Expression, Name, Node, Place};

/// The definitions that expressions rest on, left and right of `:=`, each before those that use it.
pub struct Foundation<'a> {
    scope: &'a Scope,
    found: Vec<(Expression, Expression)>,
    begun: BTreeSet<String>,
    /// What is still to be done, the next last: chains of definitions may be longer than the stack.
    open: Vec<Step<'a>>,
}

/// A step of the search.
enum Step<'a> {
    /// Look at what a name means.
    Name(Name),
    /// Look at the names of an expression, but for the arguments of the template it stands in.
    Expression(&'a Expression, &'a [Name]),
    /// Note a definition; what it rests on has been noted.
    Definition(Expression, &'a Expression),
}

impl<'a> Foundation<'a> {
    /// The definitions that some expressions rest on.
    pub fn of<'e>(
        scope: &'a Scope,
        expressions: impl IntoIterator<Item = &'e Expression>,
    ) -> Vec<(Expression, Expression)> {
        let mut foundation = Foundation {
            scope,
            found: Vec::new(),
            begun: BTreeSet::new(),
            open: Vec::new(),
        };
        for expression in expressions {
            foundation.add_names(expression, &[]);
            foundation.finish();
        }
        foundation.found
    }

    fn finish(&mut self) {
        while let Some(step) = self.open.pop() {
            match step {
                Step::Name(name) => self.add_meaning(&name),
                Step::Expression(expression, arguments) => self.add_names(expression, arguments),
                Step::Definition(left, right) => self.found.push((left, right.clone())),
            }
        }
    }

    fn add_names(&mut self, expression: &Expression, arguments: &[Name]) {
        let first = self.open.len();
        expression.visit_names(&mut |name| {
            if !arguments.contains(name) {
                self.open.push(Step::Name(name.clone()));
            }
        });
        self.open[first..].reverse();
    }

    fn add_meaning(&mut self, name: &Name) {
        if !self.begun.insert(name.ascii.clone()) {
            return;
        }
        let first = self.open.len();
        let scope = self.scope;
        if let Some(Meaning::Substitution { sources, .. }) = meaning(name, scope) {
            let sources = sources.iter().map(|source| Step::Expression(source, &[]));
            self.open.extend(sources);
        }
        for Definition {
            left,
            right,
            arguments,
        } in definitions(name, scope)
        {
            self.open.push(Step::Expression(right, arguments));
            self.open.push(Step::Definition(left, right));
        }
        self.open[first..].reverse();
    }
}

/// The definitions that expressions rest on, left and right of `:=`, each after those that use it: by
/// the number of steps to them, as long as there are no more than so many.
///
/// Whether these are all comes with them.
pub fn nearest<'e>(
    scope: &Scope,
    expressions: impl IntoIterator<Item = &'e Expression>,
    most: usize,
) -> (Vec<(Expression, Expression)>, bool) {
    let mut found: Vec<(Expression, Expression)> = Vec::new();
    let mut begun: BTreeSet<String> = BTreeSet::new();
    let mut names: Vec<Name> = Vec::new();
    for expression in expressions {
        expression.visit_names(&mut |name| names.push(name.clone()));
    }
    while !names.is_empty() {
        let new = names.iter().filter(|name| begun.insert(name.ascii.clone()));
        let level: Vec<Definition<'_>> = new.flat_map(|name| definitions(name, scope)).collect();
        if found.len() + level.len() > most {
            return (found, false);
        }
        names.clear();
        for definition in &level {
            let arguments = definition.arguments;
            definition.right.visit_names(&mut |name| {
                if !arguments.contains(name) {
                    names.push(name.clone());
                }
            });
        }
        let written = level
            .into_iter()
            .map(|each| (each.left, each.right.clone()));
        found.extend(written);
    }
    (found, true)
}

/// What a document wrote left and right of `:=`.
struct Definition<'a> {
    left: Expression,
    right: &'a Expression,
    /// Names that the right side does not take from the document.
    arguments: &'a [Name],
}

fn meaning<'a>(name: &Name, scope: &'a Scope) -> Option<&'a Meaning> {
    scope.get(name).map(|entry| &entry.meaning)
}

/// What a name was defined as; replacements under a name are several definitions.
fn definitions<'a>(name: &Name, scope: &'a Scope) -> Vec<Definition<'a>> {
    match meaning(name, scope) {
        Some(Meaning::Definition { expression, .. }) => vec![Definition {
            left: Expression::name(name.clone()),
            right: expression,
            arguments: &[],
        }],
        Some(Meaning::Template {
            arguments,
            expression,
        }) => {
            let names = arguments.iter().cloned().map(Expression::name).collect();
            vec![Definition {
                left: Expression::call(name.clone(), 0, names),
                right: expression,
                arguments,
            }]
        }
        Some(Meaning::Substitution { replacements, .. }) => {
            let replaced = replacements.iter().map(|replacement| {
                let place = Place::named(name.clone());
                let target = Box::new(replacement.target.clone());
                Definition {
                    left: Expression::made(Node::At(target, place)),
                    right: &replacement.value,
                    arguments: &[],
                }
            });
            replaced.collect()
        }
        Some(Meaning::Symbol { .. } | Meaning::Function { .. }) | None => Vec::new(),
    }
}
