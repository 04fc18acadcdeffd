//! What names mean to this route: expressions, and never an element of the ring.

use std::collections::BTreeMap;

use crate::algebra::sign::Signs;
use crate::language::syntax::{Expression, Name, Replacement};

use super::graph::Kind;

/// What a name means.
#[derive(Clone, Copy, Debug)]
pub enum Meaning<'a> {
    /// A variable, and what is declared or assumed of its sign.
    Variable(Kind, Signs),
    /// i
    ImaginaryUnit,
    /// A function, and where its bare name is taken.
    Function(&'a Expression),
    /// A definition.
    Definition(&'a Expression),
    /// A definition with arguments.
    Template(&'a [Name], &'a Expression),
    /// Replacements under a name.
    Substitution(&'a [Replacement]),
}

/// What the names of a document mean, by ASCII name.
pub type Meanings<'a> = BTreeMap<&'a str, Meaning<'a>>;
