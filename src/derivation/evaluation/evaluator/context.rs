//! Where an expression is evaluated: in a surrounding, which gives symbols their values, and in a
//! frame, which gives the arguments of a call theirs.

use std::collections::{BTreeMap, BTreeSet};

use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::Key;
use crate::derivation::scope::Entry;
use crate::derivation::syntax::{Expression, Name};

use super::Evaluator;

/// A surrounding and a frame, by their numbers; those numbered 0 are the point itself, and the
/// document outside of every call.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Context {
    pub(super) surrounding: usize,
    pub(super) frame: usize,
}

impl Context {
    /// The document outside of every call, in a surrounding.
    pub(super) const fn of(surrounding: usize) -> Self {
        Context {
            surrounding,
            frame: 0,
        }
    }

    /// The same surrounding, outside of every call.
    pub(super) const fn outside_calls(self) -> Self {
        Context::of(self.surrounding)
    }

    /// The same surrounding, in another frame.
    pub(super) const fn in_frame(self, frame: usize) -> Self {
        Context { frame, ..self }
    }

    /// The same frame, in another surrounding.
    pub(super) const fn in_surrounding(self, surrounding: usize) -> Self {
        Context {
            surrounding,
            ..self
        }
    }
}

/// The arguments of a call, by name, and the frame in which they are to be read.
#[derive(Default, PartialEq)]
pub(super) struct Frame<'a> {
    pub(super) arguments: BTreeMap<&'a str, &'a Expression>,
    pub(super) caller: usize,
}

/// How the values of symbols differ from those of the point, on top of another surrounding.
#[derive(Default, PartialEq)]
pub(super) struct Surrounding<'a> {
    pub(super) parent: usize,
    pub(super) change: Change<'a>,
}

/// A change of the values of symbols.
#[derive(Clone, Default, PartialEq)]
pub(super) enum Change<'a> {
    #[default]
    None,
    /// Every coordinate moves with time: q + q̇ε.
    Time(Number),
    /// One symbol moves: q + ε.
    Shift(Key, Number),
    /// One symbol has another value.
    Set(Key, Number),
    /// Symbols, and values of functions at their reference arguments, have other values, which are
    /// read in the parent surrounding and the given frame.
    Replace {
        symbols: BTreeMap<Key, &'a Expression>,
        functions: Vec<(&'a Name, u32, &'a Expression)>,
        frame: usize,
    },
    /// Symbols are multiplied by something small.
    Scale(BTreeSet<Key>, Number),
}

impl<'a> Evaluator<'a> {
    /// The context with a change on top of its surrounding.
    pub(super) fn changed(&mut self, context: Context, change: Change<'a>) -> Context {
        context.in_surrounding(self.within(context.surrounding, change))
    }

    /// The context inside of a call.
    pub(super) fn called(
        &mut self,
        context: Context,
        arguments: BTreeMap<&'a str, &'a Expression>,
    ) -> Context {
        let caller = context.frame;
        let frame = Frame { arguments, caller };
        context.in_frame(index_of(&mut self.frames, frame))
    }

    /// The surrounding that a change makes of another; the same change makes the same surrounding, so
    /// that what is known there is known once.
    fn within(&mut self, parent: usize, change: Change<'a>) -> usize {
        index_of(&mut self.surroundings, Surrounding { parent, change })
    }

    /// The surrounding without the change of one of its levels.
    pub(super) fn lift(&mut self, surrounding: usize, level: usize) -> usize {
        let parent = self.surroundings[surrounding].parent;
        if surrounding == level {
            return parent;
        }
        let parent = self.lift(parent, level);
        let change = self.surroundings[surrounding].change.clone();
        self.within(parent, change)
    }

    /// The surrounding with only those changes that some names feel, which become the names that these
    /// rest on in what is left.
    pub(super) fn felt(&mut self, names: &mut BTreeSet<&'a str>, surrounding: usize) -> usize {
        let Surrounding { parent, change } = &self.surroundings[surrounding];
        let (parent, feels) = (*parent, |key: &Key| names.contains(key.name()));
        let felt = match change {
            Change::None => return surrounding,
            Change::Time(_) => names.iter().any(|name| self.is_coordinate(name)),
            Change::Shift(key, _) | Change::Set(key, _) => feels(key),
            Change::Scale(keys, _) => keys.iter().any(feels),
            Change::Replace {
                symbols,
                functions,
                frame,
            } => {
                let symbols = symbols
                    .iter()
                    .filter(|(key, _)| feels(key))
                    .map(|(_, value)| *value);
                let functions = functions
                    .iter()
                    .filter(|(name, ..)| names.contains(&*name.ascii));
                let values: Vec<&Expression> = symbols
                    .chain(functions.map(|(_, _, value)| *value))
                    .collect();
                if *frame > 0 && !values.is_empty() {
                    // The values may mention arguments.
                    return surrounding;
                }
                let scope = self.scope;
                for value in &values {
                    value.visit_names(&mut |name| {
                        names.extend(scope.get(name).into_iter().flat_map(Entry::rests_on));
                    });
                }
                !values.is_empty()
            }
        };
        match self.felt(names, parent) {
            below if !felt => below,
            below if below == parent => surrounding,
            below => self.within(below, self.surroundings[surrounding].change.clone()),
        }
    }
}

/// Where an item stands in a list, which it joins if it is new.
fn index_of<T: PartialEq>(list: &mut Vec<T>, item: T) -> usize {
    list.iter()
        .position(|known| *known == item)
        .unwrap_or_else(|| {
            list.push(item);
            list.len() - 1
        })
}
