//! What surrounds an expression and changes its value: replacements, a variable, the arguments of a call.

use std::collections::BTreeMap;

use sextic_codegen::program::Node;

use crate::algebra::generator::Generator;
use crate::algebra::symbol::Symbol;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::presentation::Presenter;
use crate::derivation::scope::Meaning;
use crate::language::syntax::{Expression, Node as Syntax, Place, Replacement};

use super::{Obstacle, Table, Translator, scalar};

/// Where an expression is read: a surrounding and a frame, by their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::compile) struct Context {
    pub(super) surrounding: usize,
    pub(super) frame: usize,
}

/// What symbols stand for in a part of the document.
#[derive(Clone, Debug, Default)]
pub(super) struct Surrounding {
    /// What replaces symbols, by ASCII name.
    pub(super) replaced: BTreeMap<String, Table>,
    /// The places that do so, the innermost first.
    places: Vec<Place>,
    /// The variable whose powers are kept apart, by ASCII name.
    pub(super) variable: Option<String>,
}

/// The arguments of a call, by ASCII name, and the frame in which they are to be read.
#[derive(Clone, Debug, Default)]
pub(super) struct Frame {
    pub(super) arguments: BTreeMap<String, Expression>,
    pub(super) caller: usize,
}

impl Translator<'_> {
    /// The value of a symbol of the ring: what the surroundings replace it by, or else an input.
    pub(in crate::compile) fn symbol(
        &mut self,
        symbol: Symbol,
        context: Context,
    ) -> Result<Node, Obstacle> {
        let Surrounding {
            places, variable, ..
        } = &self.surroundings[context.surrounding];
        if places.is_empty() {
            return self.input(symbol);
        }
        let Elaborator { ring, scope, .. } = &*self.elaborator;
        let presenter = Presenter { ring, scope };
        let mut written = presenter.symbol(symbol).map_err(|_| Obstacle::Structure)?;
        let value = match ring.generator(symbol) {
            // What replaces it has a structure to keep.
            Generator::Constant { .. } | Generator::Angle { .. } => {
                self.structure(&written, context)?
            }
            _ => {
                let outside = Surrounding {
                    variable: variable.clone(),
                    ..Surrounding::default()
                };
                for place in places {
                    let node = Syntax::At(Box::new(written), place.clone());
                    written = Expression { node, span: 0..0 };
                }
                let outside = self.inside(outside, Context::default());
                let value = self.elaborator.scalar(&written);
                let value = value.map_err(|error| Obstacle::Refused(error.message))?;
                scalar(self.element(&value.value, outside)?)
            }
        };
        match value.at(0, 0).constant() {
            Some(Some(node)) => Ok(node),
            Some(None) => Ok(self.program.constant(0.into())),
            None => Err(Obstacle::Structure),
        }
    }

    /// The context inside of replacements.
    pub(super) fn at(&mut self, at: &Place, context: Context) -> Result<Context, Obstacle> {
        let (replacements, frame) = match at {
            Place::Replacements(replacements) => (replacements.clone(), context.frame),
            Place::Named(name) => {
                match self
                    .elaborator
                    .scope
                    .get(&name.value)
                    .map(|entry| &entry.meaning)
                {
                    Some(Meaning::Substitution { replacements, .. }) => (replacements.clone(), 0),
                    _ => return Err(Obstacle::Structure),
                }
            }
        };
        let mut inside = self.surroundings[context.surrounding].clone();
        inside.places.insert(0, at.clone());
        for Replacement { target, value } in &replacements {
            let Syntax::Name(name) = &target.node else {
                return Err(Obstacle::Structure);
            };
            let value = self.table(value, Context { frame, ..context })?;
            inside.replaced.insert(name.ascii.clone(), value);
        }
        Ok(self.inside(inside, context))
    }

    /// The context in which the powers of a variable are kept apart.
    pub(super) fn with_variable(
        &mut self,
        variable: &Expression,
        context: Context,
    ) -> Result<Context, Obstacle> {
        let Syntax::Name(name) = self.passed(variable, context.frame).node else {
            return Err(Obstacle::Structure);
        };
        let mut inside = self.surroundings[context.surrounding].clone();
        if inside.variable.is_some() {
            return Err(Obstacle::Structure);
        }
        inside.replaced.remove(&name.ascii);
        inside.variable = Some(name.ascii);
        Ok(self.inside(inside, context))
    }

    /// The variable whose powers are kept apart, by ASCII name.
    pub(in crate::compile) fn variable(&self, context: Context) -> Option<&str> {
        self.surroundings[context.surrounding].variable.as_deref()
    }

    fn inside(&mut self, surrounding: Surrounding, context: Context) -> Context {
        self.surroundings.push(surrounding);
        let surrounding = self.surroundings.len() - 1;
        Context {
            surrounding,
            ..context
        }
    }
}
