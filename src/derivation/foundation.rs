//! What an expression rests on.

use std::collections::BTreeSet;

use super::scope::{Meaning, Scope};
use super::syntax::{Expression, Name, Node, Place};

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
        let mut define = |left, right, arguments| {
            self.open.push(Step::Expression(right, arguments));
            self.open.push(Step::Definition(left, right));
        };
        match self.scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Definition { expression, .. }) => {
                define(Expression::name(name.clone()), expression, &[]);
            }
            Some(Meaning::Template {
                arguments,
                expression,
            }) => {
                let names = arguments.iter().cloned().map(Expression::name).collect();
                define(
                    Expression::call(name.clone(), 0, names),
                    expression,
                    arguments,
                );
            }
            Some(Meaning::Substitution {
                replacements,
                sources,
                ..
            }) => {
                let sources = sources.iter().map(|source| Step::Expression(source, &[]));
                self.open.extend(sources);
                for replacement in replacements {
                    let place = Place::named(name.clone());
                    let target = Box::new(replacement.target.clone());
                    let left = Expression::made(Node::At(target, place));
                    self.open.push(Step::Expression(&replacement.value, &[]));
                    self.open.push(Step::Definition(left, &replacement.value));
                }
            }
            _ => {}
        }
        self.open[first..].reverse();
    }
}
