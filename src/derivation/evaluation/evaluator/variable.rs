//! What can be replaced or differentiated by.

use std::collections::BTreeMap;

use crate::derivation::evaluation::point::{Argument, Key};
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{Expression, Name, Node, Place, Replacement, Spanned};

use super::context::{Change, Context, Frame};
use super::{Evaluator, Failure};

/// A variable: a symbol, or the value of a function at its reference argument.
enum Variable<'a> {
    Symbol(Key),
    Function(&'a Name, u32),
}

impl<'a> Evaluator<'a> {
    /// The change that replacements make.
    pub(super) fn replacements(
        &self,
        place: &'a Place,
        frame: usize,
    ) -> Result<Change<'a>, Failure> {
        let scope = self.scope;
        let (replacements, frame): (&'a [Replacement], usize) = match place {
            Place::Replacements(replacements) => (replacements, frame),
            Place::Named(Spanned { value: name, .. }) => {
                match scope.get(name).map(|entry| &entry.meaning) {
                    Some(Meaning::Substitution { replacements, .. }) => (replacements, 0),
                    _ => return Err(format!("{name} is no substitution")),
                }
            }
        };
        let (mut symbols, mut functions) = (BTreeMap::new(), Vec::new());
        for Replacement { target, value } in replacements {
            match self.variable(target, frame)? {
                Variable::Symbol(key) => {
                    symbols.insert(key, value);
                }
                Variable::Function(name, order) => functions.push((name, order, value)),
            }
        }
        Ok(Change::Replace {
            symbols,
            functions,
            frame,
        })
    }

    /// The variable that an expression names.
    fn variable(&self, variable: &'a Expression, frame: usize) -> Result<Variable<'a>, Failure> {
        let scope = self.scope;
        if let Some((argument, caller)) = self.argument(variable, frame) {
            return self.variable(argument, caller);
        }
        match &variable.node {
            Node::Name(name) => match scope.get(name).map(|entry| &entry.meaning) {
                Some(Meaning::Symbol { .. }) => {
                    Ok(Variable::Symbol(Key::Symbol(name.ascii.clone(), 0)))
                }
                Some(Meaning::Function { .. }) => Ok(Variable::Function(name, 0)),
                Some(Meaning::Definition { expression, .. }) => self.variable(expression, 0),
                _ => Err(format!("{name} is no variable")),
            },
            Node::Derivative(name, order) => Ok(Variable::Function(name, *order)),
            Node::Call {
                function,
                arguments,
                ..
            } if function.ascii == "dt" => {
                match arguments
                    .first()
                    .map(|inner| self.variable(inner, frame))
                    .transpose()?
                {
                    Some(Variable::Symbol(Key::Symbol(name, order))) => {
                        Ok(Variable::Symbol(Key::Symbol(name, order + 1)))
                    }
                    _ => Err("this is no variable".into()),
                }
            }
            _ => Err("this is no variable".into()),
        }
    }

    /// The key of a variable that is given by its ASCII name.
    pub(super) fn key_of(&self, ascii: &str) -> Result<Key, Failure> {
        let reference =
            |name: &str, order| Key::Function(name.to_string(), order, Argument::Reference);
        let scope = self.scope;
        match scope.get(&Name::new(ascii)).map(|entry| &entry.meaning) {
            Some(Meaning::Symbol { .. }) => Ok(Key::Symbol(ascii.to_string(), 0)),
            Some(Meaning::Function { .. }) => Ok(reference(ascii, 0)),
            Some(Meaning::Definition { expression, .. }) => match self.variable(expression, 0)? {
                Variable::Symbol(key) => Ok(key),
                Variable::Function(name, order) => Ok(reference(&name.ascii, order)),
            },
            _ => Err(format!("{ascii} is no variable")),
        }
    }

    /// What an argument of the frame's call stands for, and the frame in which that is read.
    fn argument(&self, name: &Expression, frame: usize) -> Option<(&'a Expression, usize)> {
        let Node::Name(name) = &name.node else {
            return None;
        };
        let Frame { arguments, caller } = &self.frames[frame];
        arguments
            .get(name.ascii.as_str())
            .map(|argument| (*argument, *caller))
    }

    /// The key of something that is differentiated by.
    pub(super) fn key(
        &mut self,
        variable: &'a Expression,
        context: Context,
    ) -> Result<Key, Failure> {
        match self.variable(variable, context.frame)? {
            Variable::Symbol(key) => Ok(key),
            Variable::Function(name, order) => {
                let reference = self.reference(name)?;
                self.function_key(name, order, reference, context.outside_calls())
            }
        }
    }

    /// The keys of the entries of a vector of variables.
    pub(super) fn keys(
        &mut self,
        variables: &'a Expression,
        context: Context,
    ) -> Result<Vec<Key>, Failure> {
        let scope = self.scope;
        if let Some((argument, caller)) = self.argument(variables, context.frame) {
            return self.keys(argument, context.in_frame(caller));
        }
        match &variables.node {
            Node::Matrix(rows) => {
                let mut keys = Vec::new();
                for entry in rows.iter().flatten() {
                    keys.extend(self.keys(entry, context)?);
                }
                Ok(keys)
            }
            Node::Name(name) => match scope.get(name).map(|entry| &entry.meaning) {
                Some(Meaning::Definition { expression, .. }) => {
                    self.keys(expression, context.outside_calls())
                }
                _ => Ok(vec![self.key(variables, context)?]),
            },
            _ => Ok(vec![self.key(variables, context)?]),
        }
    }
}
