//! What the names of a document mean.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::algebra::symbol::Symbol;

use super::condition::Conditions;
use super::quantity::{Quantity, Value};
use crate::language::built_in::{self, is_built_in};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use crate::language::name::skeleton::skeleton;
use crate::language::syntax::{Expression, Name, Replacement, Span, Spanned};
use crate::language::unit::Unit;

/// What a name means.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// A symbol of the ring: a parameter, an angle, a coordinate or i.
    Symbol {
        /// The symbol.
        symbol: Symbol,
        /// Its unit.
        unit: Unit,
        /// What sort of quantity it is.
        kind: SymbolKind,
    },
    /// A function known only through its derivatives.
    Function {
        /// Where the bare name is taken.
        reference: Expression,
        /// What that is.
        argument: Quantity,
        /// What must hold for it to exist.
        conditions: Conditions,
        /// The unit of its values.
        unit: Unit,
    },
    /// A defined value.
    Definition {
        /// What it was defined as.
        expression: Expression,
        /// What that is.
        value: Value,
        /// What must hold for it to exist.
        conditions: Conditions,
    },
    /// A definition with arguments.
    Template {
        /// The names of its arguments.
        arguments: Vec<Name>,
        /// What it was defined as.
        expression: Arc<Expression>,
    },
    /// Replacements under a name: a `substitution`, or the solution of a `match`.
    Substitution {
        /// What is replaced by what.
        replacements: Vec<Replacement>,
        /// What must hold for the replacements to exist.
        conditions: Conditions,
        /// Of the solution of a `match`: what it was found from.
        sources: Vec<Expression>,
    },
}

/// The sorts of quantities that a document declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// A real constant.
    Parameter,
    /// A constant that need not be real.
    Complex,
    /// A constant angle.
    Angle,
    /// A function of time.
    Coordinate,
    /// A function of time that is an angle.
    AngularCoordinate,
    /// i.
    Imaginary,
}

/// A name, what it means, and where the document says so.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The name as it was declared.
    pub name: Name,
    /// What it means.
    pub meaning: Meaning,
    /// In words.
    pub description: Option<String>,
    /// Where it was declared; nothing for a name that another document declares.
    pub span: Option<Span>,
    /// The ASCII names of the symbols and functions that its value is made of, through other names.
    rests_on: BTreeSet<String>,
}

impl Entry {
    /// The ASCII names of the symbols and functions that its value is made of, through other names.
    pub fn rests_on(&self) -> impl Iterator<Item = &str> {
        self.rests_on.iter().map(String::as_str)
    }
}

/// The names of a document; each has one meaning throughout.
#[derive(Clone, Debug, Default)]
pub struct Scope {
    entries: BTreeMap<String, Entry>,
}

impl Scope {
    /// Gives a name its meaning.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it has one already, or where it is the name of a built-in function.
    pub fn declare(
        &mut self,
        name: &Spanned<Name>,
        meaning: Meaning,
        description: Option<String>,
    ) -> Result<(), Diagnostic> {
        let duplicate = |message: String| {
            Diagnostic::new(DiagnosticKind::Duplicate, name.span.clone(), message)
                .with_label("declared again")
                .with_help("choose another name: a name means one thing in a document")
        };
        if is_built_in(&name.value.ascii) {
            let message = format!("`{}` is the name of a built-in function", name.value);
            return Err(duplicate(message).with_label("taken"));
        }
        if let Some(known) = self.entries.get(&name.value.ascii) {
            let diagnostic = duplicate(format!("`{}` has a meaning already", name.value));
            return Err(match &known.span {
                Some(span) => diagnostic.with_secondary(span.clone(), "first declared here"),
                None => diagnostic,
            });
        }
        let rests_on = self.rests_on(&name.value, &meaning);
        let span = Some(name.span.clone());
        let entry = Entry {
            name: name.value.clone(),
            meaning,
            description,
            span,
            rests_on,
        };
        self.entries.insert(name.value.ascii.clone(), entry);
        Ok(())
    }

    fn rests_on(&self, name: &Name, meaning: &Meaning) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        let mut visit = |name: &Name| {
            names.extend(
                self.get(name)
                    .into_iter()
                    .flat_map(Entry::rests_on)
                    .map(str::to_string),
            );
        };
        match meaning {
            Meaning::Symbol { .. } => {}
            Meaning::Function {
                reference: expression,
                ..
            }
            | Meaning::Definition { expression, .. } => expression.visit_names(&mut visit),
            Meaning::Template { expression, .. } => expression.visit_names(&mut visit),
            Meaning::Substitution {
                replacements,
                sources,
                ..
            } => {
                let values = replacements.iter().map(|each| &each.value);
                values
                    .chain(sources)
                    .for_each(|each| each.visit_names(&mut visit));
            }
        }
        if let Meaning::Symbol { .. } | Meaning::Function { .. } = meaning {
            names.insert(name.ascii.clone());
        }
        names
    }

    /// Forgets where names were declared, because what follows is another document.
    pub fn leave_document(&mut self) {
        for entry in self.entries.values_mut() {
            entry.span = None;
            // Its text is elaborated where it is used, and is no part of what follows.
            if let Meaning::Template { expression, .. } = &mut entry.meaning {
                Arc::make_mut(expression).forget_places();
            }
        }
    }

    /// Forgets the names that were declared at a place, because the statement there is refused.
    pub fn forget(&mut self, place: &Span) {
        let is_elsewhere = |entry: &Entry| {
            let own = entry.span.as_ref();
            own.is_none_or(|own| own.start < place.start || own.end > place.end)
        };
        self.entries.retain(|_, entry| is_elsewhere(entry));
    }

    /// The entry of a name, if it has one.
    pub fn get(&self, name: &Name) -> Option<&Entry> {
        self.spelled(&name.ascii)
    }

    /// The entry of a name in ASCII, if it has one.
    pub fn spelled(&self, ascii: &str) -> Option<&Entry> {
        self.entries.get(ascii)
    }

    /// The entry of a name.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] with the nearest known name where it has none.
    pub fn find(&self, name: &Name, span: &Span) -> Result<&Entry, Diagnostic> {
        self.get(name).ok_or_else(|| {
            let known = self
                .entries
                .values()
                .flat_map(|entry| [entry.name.ascii.as_str(), entry.name.unicode.as_str()]);
            let candidates = known.chain(built_in::names());
            let look = skeleton(&name.unicode);
            let mut entries = self.entries.values();
            let alike = entries.find(|entry| skeleton(&entry.name.unicode) == look);
            let output = name.of_output();
            let help = match (alike, nearest(&name.unicode, candidates)) {
                (Some(Entry { name: alike, .. }), _) => format!(
                    "`{alike}` looks the same: in ASCII it is `{}`, and this one is `{}`",
                    alike.ascii, name.ascii
                ),
                _ if output.is_some() => {
                    "behind the dot stands an output that the evaluator has, or, of a system, `mass`, `damping`, \
                     `stiffness` or a part that has a name of its own"
                        .into()
                }
                _ if name.ascii == "pi" => format!(
                    "numbers are exact, and this one is not known: declare a parameter for it, `parameter {name} : 1 > 0`"
                ),
                (None, Some(near)) => format!("did you mean `{near}`?"),
                (None, None) => {
                    "declare it as a parameter, an angle or a coordinate, or define it with `:=`"
                        .into()
                }
            };
            let message = format!("`{name}` is not known here");
            Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
                .with_label("unknown name")
                .with_help(help)
        })
    }

    /// What sort of quantity a name stands for, if it stands for one.
    pub fn kind_of(&self, ascii: &str) -> Option<SymbolKind> {
        match self.entries.get(ascii)?.meaning {
            Meaning::Symbol { kind, .. } => Some(kind),
            _ => None,
        }
    }

    /// The entries, by ASCII name.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.entries.values()
    }
}
