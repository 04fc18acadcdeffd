//! What refused statements leave behind: names without a meaning, and what others rest on.

use std::collections::{BTreeMap, BTreeSet};

use crate::derivation::scope::{Meaning, Scope};
use crate::language::built_in;
use crate::language::diagnostic::Diagnostic;
use crate::language::intent::{Intent, MayDeclare};
use crate::language::mention::Mention;
use crate::language::syntax::{Name, Statement};

use super::{Assumption, Basis, Mistake, Place};

/// Why something has no meaning: the mistake at the bottom.
#[derive(Clone, Debug)]
struct Root {
    place: Place,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    /// The refused statement would declare this name.
    Declared(Name),
    /// Nothing declares this name, and what is not understood may do so.
    Doubtful(Name),
    /// Nothing declares this name, and a document that cannot be imported may do so.
    Imported(Name, String),
    /// The sign of something may follow from a refused assumption.
    Assumed,
}

/// A name that has no meaning.
#[derive(Clone, Debug)]
struct Refused {
    root: Root,
    /// Whether its own statement is well, and builds on another.
    is_through: bool,
    is_template: bool,
    /// The symbols and functions that it would rest on; nothing where these are not known.
    symbols: Option<BTreeSet<String>>,
}

/// What may declare names that are not known.
#[derive(Clone, Debug)]
struct Doubt {
    place: Place,
    /// The document that cannot be imported, if it is one.
    import: Option<String>,
}

/// An assumption that is not made.
#[derive(Clone, Debug)]
struct Lost {
    place: Place,
    /// The symbols and functions that it is about; nothing where these are not known.
    symbols: Option<BTreeSet<String>>,
}

/// All mistakes of documents, and what they leave without a meaning.
#[derive(Clone, Debug, Default)]
pub(super) struct Refusals {
    /// The mistakes, in the order in which they were met.
    pub(super) mistakes: Vec<Mistake>,
    names: BTreeMap<String, Refused>,
    compiled: BTreeMap<String, Refused>,
    /// What may have declared anything; the last of what may.
    doubt: Option<Doubt>,
    /// What may have declared these names.
    doubts: BTreeMap<String, Doubt>,
    lost: Vec<Lost>,
}

impl Refusals {
    /// Notes a mistake, and what the statement in which it is was meant to do.
    pub(super) fn refuse(
        &mut self,
        diagnostic: Diagnostic,
        intent: &Intent,
        place: &Place,
        scope: &Scope,
    ) {
        self.note(diagnostic, &place.path);
        self.lose_names(intent, scope, |name| {
            let kind = Kind::Declared(name.clone());
            let place = place.clone();
            (Root { place, kind }, false)
        });
        let doubt = Doubt {
            place: place.clone(),
            import: None,
        };
        match intent.doubtful() {
            None => self.doubt = Some(doubt),
            Some(names) => {
                for name in names {
                    self.doubts.entry(name).or_insert_with(|| doubt.clone());
                }
            }
        }
        self.lose_assumption(intent, place, scope);
    }

    /// Notes a mistake that takes no name its meaning.
    pub(super) fn note(&mut self, diagnostic: Diagnostic, path: &str) {
        self.mistakes.push(Mistake {
            path: path.to_string(),
            diagnostic,
        });
    }

    /// Notes that a document cannot be imported: names that are not known may come from it, and so may
    /// assumptions about those of other documents, which are all that are known so far.
    pub(super) fn lose_import(&mut self, path: &str, place: &Place, scope: &Scope) {
        let names = scope.entries().map(|entry| entry.name.ascii.clone());
        self.lost.push(Lost {
            place: place.clone(),
            symbols: Some(names.collect()),
        });
        self.doubt = Some(Doubt {
            place: place.clone(),
            import: Some(path.to_string()),
        });
    }

    /// Notes that a statement is passed over, which takes the names their meaning that it would declare.
    pub(super) fn pass_over(
        &mut self,
        statement: &Statement,
        reason: &Reason,
        place: &Place,
        scope: &Scope,
    ) {
        let intent = Intent::of(statement);
        self.lose_names(&intent, scope, |_| (reason.root.clone(), true));
        self.lose_assumption(&intent, place, scope);
    }

    /// Where something would be assumed that is refused, or builds on what is.
    pub(super) fn assumptions(&self) -> Vec<Place> {
        let mut places: Vec<Place> = self.lost.iter().map(|lost| lost.place.clone()).collect();
        places.dedup();
        places
    }

    fn lose_names(&mut self, intent: &Intent, scope: &Scope, root: impl Fn(&Name) -> (Root, bool)) {
        let symbols = self.symbols(intent, scope);
        let refused = |name| {
            let (root, is_through) = root(name);
            Refused {
                root,
                is_through,
                is_template: intent.is_template,
                symbols: symbols.clone(),
            }
        };
        for name in &intent.declares {
            let key = name.ascii.clone();
            self.names.entry(key).or_insert_with(|| refused(name));
        }
        if let Some(name) = &intent.compiled {
            let key = name.ascii.clone();
            self.compiled.entry(key).or_insert_with(|| refused(name));
        }
    }

    fn lose_assumption(&mut self, intent: &Intent, place: &Place, scope: &Scope) {
        if intent.may_assume {
            self.lost.push(Lost {
                place: place.clone(),
                symbols: self.symbols(intent, scope),
            });
        }
    }

    /// The symbols and functions that a statement rests on; nothing where these are not known.
    fn symbols(&self, intent: &Intent, scope: &Scope) -> Option<BTreeSet<String>> {
        // What is not understood at all mentions words that are no names.
        let are_names = matches!(intent.may_declare, MayDeclare::Nothing);
        let mut symbols = BTreeSet::new();
        for name in intent.mentions.as_ref()? {
            let is_built_in = built_in::is_built_in(&name.ascii);
            let refused = self.names.get(&name.ascii);
            if let Some(refused) = refused {
                symbols.extend(refused.symbols.clone()?);
            }
            let entry = scope.get(name);
            symbols.extend(
                entry
                    .iter()
                    .flat_map(|entry| entry.rests_on().map(str::to_string)),
            );
            let is_known = is_built_in || refused.is_some() || entry.is_some();
            if are_names && !is_known {
                return None;
            }
        }
        Some(symbols)
    }

    /// Why a statement has no meaning although it is well: a name that it builds on, or declares again,
    /// has none.
    pub(super) fn reason(&self, statement: &Statement, scope: &Scope) -> Option<Reason> {
        if self.mistakes.is_empty() {
            return None;
        }
        let intent = Intent::of(statement);
        let bases = statement.compiled_bases();
        let mut compiled = bases.iter().chain(&intent.compiled);
        let refused = compiled.find_map(|name| Some((name, self.compiled.get(&name.ascii)?)));
        let refused = refused.or_else(|| {
            let mut declared = intent.declares.iter();
            declared.find_map(|name| Some((name, self.names.get(&name.ascii)?)))
        });
        match refused {
            Some((name, refused)) => Some(Reason::of(name, refused)),
            None => self.reason_of(statement.mentions(), scope),
        }
    }

    fn reason_of(&self, mut open: Vec<Mention>, scope: &Scope) -> Option<Reason> {
        let mut begun: BTreeSet<String> = BTreeSet::new();
        open.reverse();
        while let Some(mention) = open.pop() {
            if let Some(reason) = self.reason_of_mention(&mention, scope) {
                return Some(reason);
            }
            // A template is not computed before it is used.
            if let Some(entry) = scope.get(&mention.name)
                && let Meaning::Template {
                    arguments,
                    expression,
                } = &entry.meaning
                && begun.insert(mention.name.ascii.clone())
            {
                let mut inner = Vec::new();
                expression.collect_mentions(&mut inner);
                inner.retain(|mention| !arguments.contains(&mention.name));
                open.extend(inner.into_iter().rev());
            }
        }
        None
    }

    fn reason_of_mention(&self, mention: &Mention, scope: &Scope) -> Option<Reason> {
        let name = &mention.name;
        let is_built_in = built_in::is_built_in(&name.ascii);
        if let Some(refused) = self.names.get(&name.ascii) {
            // `det := 3` does not take the function `det` its meaning.
            let is_another = is_built_in && mention.is_called && !refused.is_template;
            return (!is_another).then(|| Reason::of(name, refused));
        }
        if is_built_in || scope.get(name).is_some() {
            return None;
        }
        let doubt = self.doubts.get(&name.ascii).or(self.doubt.as_ref())?;
        let kind = match &doubt.import {
            Some(path) => Kind::Imported(name.clone(), path.clone()),
            None => Kind::Doubtful(name.clone()),
        };
        let place = doubt.place.clone();
        Some(Reason {
            through: None,
            root: Root { place, kind },
        })
    }

    /// The symbols and functions whose signs may depend on an assumption that is not made, each with the
    /// first of these.
    pub(super) fn uncertain(&self, assumptions: &[Assumption], scope: &Scope) -> Uncertain {
        let mut uncertain = Uncertain::default();
        let mut open: Vec<(String, &Place)> = Vec::new();
        for lost in &self.lost {
            match &lost.symbols {
                None => drop(uncertain.all.get_or_insert(lost.place.clone())),
                Some(own) => open.extend(own.iter().map(|symbol| (symbol.clone(), &lost.place))),
            }
        }
        if open.is_empty() {
            return uncertain;
        }
        // What an assumption ties together is uncertain together.
        let mut tied: BTreeMap<String, Vec<BTreeSet<String>>> = BTreeMap::new();
        for assumption in assumptions {
            let symbols = symbols_of(&assumption.names(), scope);
            for symbol in &symbols {
                tied.entry(symbol.clone())
                    .or_default()
                    .push(symbols.clone());
            }
        }
        open.reverse();
        while let Some((symbol, place)) = open.pop() {
            if uncertain.symbols.contains_key(&symbol) {
                continue;
            }
            let others = tied.remove(&symbol).unwrap_or_default();
            open.extend(others.into_iter().flatten().map(|other| (other, place)));
            uncertain.symbols.insert(symbol, place.clone());
        }
        uncertain
    }
}

/// What may depend on assumptions that are not made.
#[derive(Clone, Debug, Default)]
pub(super) struct Uncertain {
    all: Option<Place>,
    symbols: BTreeMap<String, Place>,
}

impl Uncertain {
    /// The assumption on which something may depend that mentions these names.
    pub(super) fn reason<'n>(
        &self,
        names: impl IntoIterator<Item = &'n Name>,
        scope: &Scope,
    ) -> Option<Reason> {
        let about = || {
            let symbols = symbols_of(names, scope);
            symbols
                .iter()
                .find_map(|own| self.symbols.get(own).cloned())
        };
        let place = self.all.clone().or_else(about)?;
        let kind = Kind::Assumed;
        Some(Reason {
            through: None,
            root: Root { place, kind },
        })
    }
}

/// The symbols and functions that names rest on.
fn symbols_of<'n>(names: impl IntoIterator<Item = &'n Name>, scope: &Scope) -> BTreeSet<String> {
    let entries = names.into_iter().filter_map(|name| scope.get(name));
    entries
        .flat_map(|entry| entry.rests_on().map(str::to_string))
        .collect()
}

/// Why a statement that is well is passed over.
#[derive(Clone, Debug)]
pub(super) struct Reason {
    /// The name in it that itself builds on another.
    through: Option<Name>,
    root: Root,
}

impl Reason {
    fn of(name: &Name, refused: &Refused) -> Self {
        Reason {
            through: refused.is_through.then(|| name.clone()),
            root: refused.root.clone(),
        }
    }

    /// The same for a reader of the document `from`.
    pub(super) fn basis(&self, from: &str) -> Basis {
        let Root { place, kind } = &self.root;
        let line = match place.path == from {
            true => format!("line {}", place.line),
            false => format!("line {} of `{}`", place.line, place.path),
        };
        let bottom = match kind {
            Kind::Declared(name) => format!("`{name}`, which {line} would declare"),
            Kind::Doubtful(name) => {
                format!("`{name}`, which may come from {line}, which is not understood")
            }
            Kind::Imported(name, path) => {
                format!("`{name}`, which may come from `{path}`, which {line} cannot import")
            }
            Kind::Assumed => format!("what {line} would assume, which is refused"),
        };
        let reason = match (&self.through, kind) {
            (Some(name), _) => format!("builds on `{name}`, and so on {bottom}"),
            (None, Kind::Assumed) => format!("may depend on {bottom}"),
            (None, _) => format!("builds on {bottom}"),
        };
        let name = match kind {
            Kind::Declared(name) | Kind::Doubtful(name) | Kind::Imported(name, _) => Some(name),
            Kind::Assumed => None,
        };
        Basis {
            name: name.cloned(),
            place: place.clone(),
            reason,
        }
    }
}
