//! What an expression rests on.

use super::scope::{Meaning, Scope};
use super::syntax::{Expression, Name, Node, Place};

/// The definitions that expressions rest on, left and right of `:=`, each before those that use it.
pub struct Foundation<'a> {
    scope: &'a Scope,
    found: Vec<(Expression, Expression)>,
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
        };
        expressions
            .into_iter()
            .for_each(|expression| foundation.add(expression, &[]));
        foundation.found
    }

    /// Adds what an expression rests on, but for the arguments of the template it stands in.
    fn add(&mut self, expression: &Expression, arguments: &[Name]) {
        expression.visit_names(&mut |name| {
            if !arguments.contains(name) {
                self.add_name(name);
            }
        });
    }

    fn add_name(&mut self, name: &Name) {
        let scope = self.scope;
        let bare = Expression::name(name.clone());
        match scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Definition { expression, .. }) => {
                self.add_definition(bare, expression, &[])
            }
            Some(Meaning::Template {
                arguments,
                expression,
            }) => {
                let names = arguments.iter().cloned().map(Expression::name).collect();
                let call = Expression::call(name.clone(), 0, names);
                self.add_definition(call, expression, arguments);
            }
            Some(Meaning::Substitution {
                replacements,
                sources,
                ..
            }) => {
                for source in sources {
                    self.add(source, &[]);
                }
                for replacement in replacements {
                    let place = Place::Named(name.clone());
                    let target = Box::new(replacement.target.clone());
                    let left = Expression::made(Node::At(target, place));
                    self.add_definition(left, &replacement.value, &[]);
                }
            }
            _ => {}
        }
    }

    fn add_definition(&mut self, left: Expression, right: &Expression, arguments: &[Name]) {
        if self.found.iter().any(|(known, _)| *known == left) {
            return;
        }
        self.add(right, arguments);
        self.found.push((left, right.clone()));
    }
}
