//! What all verdicts on a document stand under: declared signs, assumptions, and what is imported.

use crate::language::notation::Notation;
use crate::language::syntax::{Name, Sign};
use crate::verdict::audit::{Assumption, Audit, Declaration};

use super::phrase::Phrase;
use super::words;

/// What one document declares of signs, and assumes.
#[derive(Clone, Debug)]
pub struct Premises<'a> {
    /// The document.
    pub path: &'a str,
    /// The signs, in the order in which they are first declared, each with its quantities.
    pub signs: Vec<(Sign, Vec<&'a Name>)>,
    /// What it assumes beside.
    pub assumptions: Vec<&'a Assumption>,
    /// The lines of what it would assume, and what is refused.
    pub refused: Vec<usize>,
}

impl<'a> Premises<'a> {
    /// Those of a document that an audit has read.
    fn of(path: &'a str, audit: &'a Audit) -> Self {
        let mut signs: Vec<(Sign, Vec<&Name>)> = Vec::new();
        let declared = audit.declarations.iter();
        for Declaration { names, sign, .. } in declared.filter(|own| own.place.path == path) {
            match signs.iter_mut().find(|(known, _)| known == sign) {
                Some((_, known)) => known.extend(names),
                None => signs.push((*sign, names.iter().collect())),
            }
        }
        let assumptions = audit.assumptions.iter();
        let refused = audit.refused_assumptions.iter();
        let refused = refused.filter(|place| place.path == path);
        Premises {
            path,
            signs,
            assumptions: assumptions.filter(|own| own.place.path == path).collect(),
            refused: refused.map(|place| place.line).collect(),
        }
    }

    /// `m, r > 0; n ≠ 0`; nothing where no sign is declared.
    fn declared(&self, notation: Notation) -> Option<Phrase> {
        let groups = self.signs.iter().map(|(sign, names)| {
            let names: Vec<String> = names.iter().map(|name| notation.name(name)).collect();
            format!("{} {}", names.join(", "), words::sign(*sign, notation))
        });
        (!self.signs.is_empty()).then(|| Phrase::default().list(groups, "; "))
    }

    /// What it assumes in one phrase; nothing where it assumes nothing.
    fn assumed(&self, notation: Notation) -> Option<Phrase> {
        let relations = self.assumptions.iter();
        let relations = relations.map(|own| notation.relation(&own.relation));
        (!self.assumptions.is_empty()).then(|| Phrase::default().list(relations, ", "))
    }

    /// `what lines 4 and 7 would assume`; nothing where all is assumed that is written.
    fn refused(&self) -> Option<String> {
        let lines = match self.refused.as_slice() {
            [] => return None,
            [line] => format!("line {line}"),
            [one, other] => format!("lines {one} and {other}"),
            [one, other, rest @ ..] => format!("lines {one}, {other} and {} more", rest.len()),
        };
        Some(format!("what {lines} would assume"))
    }
}

/// The premises of a document, and those of its imports behind it.
pub fn premises(audit: &Audit) -> (Premises<'_>, Vec<Premises<'_>>) {
    let imports = audit.sources.iter().rev().skip(1).rev();
    let imports = imports.map(|source| Premises::of(&source.path, audit));
    (Premises::of(&audit.path, audit), imports.collect())
}

/// The head of a report: keywords and phrases, a line each.
pub fn lines(audit: &Audit, notation: Notation) -> Vec<(&'static str, Phrase)> {
    let (own, imports) = premises(audit);
    let mut lines = Vec::new();
    lines.extend(own.declared(notation).map(|phrase| ("declares", phrase)));
    for assumption in &own.assumptions {
        let phrase = Phrase::of_mathematics(notation.relation(&assumption.relation));
        let phrase = match &assumption.description {
            Some(description) => phrase.words(format!(": {description}")),
            None => phrase,
        };
        lines.push(("assumes", phrase));
    }
    let refused = own.refused().map(Phrase::of_words);
    if own.assumptions.is_empty() && refused.is_none() {
        let words = match (own.signs.is_empty(), imports.is_empty()) {
            (true, true) => "nothing, and no sign is declared",
            (true, false) => "nothing itself, and declares no sign",
            (false, true) => "nothing beside the signs",
            (false, false) => "nothing itself beside the signs",
        };
        lines.push(("assumes", Phrase::of_words(words)));
    }
    lines.extend(refused.map(|phrase| ("refused", phrase)));
    let imports = imports.iter();
    lines.extend(imports.map(|import| ("imports", imported(import, notation))));
    lines
}

/// `springs.md, which declares k > 0, and assumes k < 1; what line 9 would assume is refused`
fn imported(import: &Premises<'_>, notation: Notation) -> Phrase {
    let phrase = Phrase::of_words(import.path);
    let phrase = match (import.declared(notation), import.assumed(notation)) {
        (None, None) => phrase.words(", which declares no sign and assumes nothing"),
        (Some(declared), None) => phrase.words(", which declares ").then(declared),
        (None, Some(assumed)) => phrase.words(", which assumes ").then(assumed),
        (Some(declared), Some(assumed)) => phrase
            .words(", which declares ")
            .then(declared)
            .words(", and assumes ")
            .then(assumed),
    };
    match import.refused() {
        Some(refused) => phrase.words(format!("; {refused} is refused")),
        None => phrase,
    }
}
