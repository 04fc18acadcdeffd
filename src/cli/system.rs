//! Systems of documents, for the commands that compute them.

use std::collections::BTreeMap;
use std::path::Path;

use clap::Args;

use crate::algebra::number::Rational;
use crate::compile::fixed::Fixed;
use crate::compile::system::CompiledSystem;
use crate::language::syntax::Approximated;
use crate::language::system::System as Stated;
use crate::stability::system::System;
use crate::stability::system::error::SystemError;
use crate::verdict::audit::Audit;

use super::Outcome;
use super::generate::{differs, mistaken, refused, unknown};
use super::output::wrong;
use super::source::{Audited, audit_all};
use super::vocabulary::Vocabulary;

/// Which system of which document.
#[derive(Args, Debug)]
pub struct Which {
    /// A system: the name behind `system` in a document; not needed where there is one only
    #[arg(long, value_name = "NAME")]
    pub system: Option<String>,
}

/// A system of a document, ready to be computed.
pub struct Chosen {
    /// Its program.
    pub system: System,
    /// Its coordinates as the document writes them.
    pub shown: Vec<String>,
    /// The names of the quantities of its document.
    pub vocabulary: Vocabulary,
}

impl Which {
    /// The system of a document, or of those that come with the command; the document must allow the numbers of
    /// each of some points.
    ///
    /// # Errors
    ///
    /// The outcome, after what is wrong was written.
    pub fn choose(&self, document: Option<&str>, points: &[&[Fixed]]) -> Result<Chosen, Outcome> {
        let paths: Vec<String> = document.map(str::to_string).into_iter().collect();
        let Audited {
            audits, outcome, ..
        } = audit_all(&paths);
        if outcome != Outcome::AsExpected {
            return Err(mistaken(outcome));
        }
        let (number, stated) = self.find(&audits)?;
        let audit = &audits[number];
        if !audit.as_expected() {
            return Err(differs(audit));
        }
        let mut compiled = compiled(&stated, None, audit)?;
        let vocabulary = Vocabulary::of([audit]);
        for point in points {
            let point: Vec<Fixed> = point.iter().map(|own| vocabulary.in_si(own)).collect();
            admit(&mut compiled, &point, audit)?;
        }
        let shown = stated.coordinates.iter();
        Ok(Chosen {
            system: in_numbers(compiled),
            shown: shown.map(|name| name.value.unicode.clone()).collect(),
            vocabulary,
        })
    }

    /// The system that is meant, and the number of its document.
    fn find(&self, audits: &[Audit]) -> Result<(usize, Stated), Outcome> {
        let of = |(number, audit): (usize, &Audit)| {
            let systems = audit.systems.clone().into_iter();
            systems
                .map(move |system| (number, system))
                .collect::<Vec<_>>()
        };
        let all: Vec<(usize, Stated)> = audits.iter().enumerate().flat_map(of).collect();
        let names: Vec<String> = all.iter().map(|(_, own)| own.name.ascii.clone()).collect();
        let is_meant = |own: &Stated| match &self.system {
            Some(name) => own.name.ascii == *name || own.name.unicode == *name,
            None => true,
        };
        let mut meant = all.into_iter().filter(|(_, own)| is_meant(own));
        let imported = audits.iter().flat_map(|audit| &audit.all_systems);
        let imported: Vec<&str> = imported.map(|own| own.name.ascii.as_str()).collect();
        match (meant.next(), meant.next(), &self.system) {
            (Some(only), None, _) => Ok(only),
            (Some(first), Some(_), Some(_)) => Ok(first),
            (Some(_), Some(_), None) => Err(wrong(
                &format!("the documents have several systems: {}", names.join(", ")),
                "name one of them with `--system`",
            )),
            (None, _, Some(name)) if !names.is_empty() => Err(unknown(
                &format!("there is no system `{name}`"),
                name,
                &names,
            )),
            (None, ..) if !imported.is_empty() => Err(wrong(
                &format!(
                    "the document imports the system {}, and has none of its own",
                    imported.join(", ")
                ),
                "name the document that states it",
            )),
            (None, ..) => Err(wrong(
                "the document has no system",
                "write `system (1) name: mass M damping C stiffness K in x, y` in a block",
            )),
        }
    }
}

/// The program of a system, as an evaluator approximates it if one does.
///
/// # Errors
///
/// The outcome, after what is wrong was written.
pub fn compiled(
    stated: &Stated,
    approximated: Option<&Approximated>,
    audit: &Audit,
) -> Result<CompiledSystem, Outcome> {
    CompiledSystem::of(stated, approximated, audit).map_err(|refusal| {
        let name = &stated.name.unicode;
        refused(name, &audit.path, &refusal, std::slice::from_ref(audit))
    })
}

/// A compiled system, for numbers.
pub fn in_numbers(compiled: CompiledSystem) -> System {
    System {
        evaluator: compiled.specification.evaluator,
        coordinates: compiled.coordinates,
        damping: compiled.damping,
        stiffness: compiled.stiffness,
    }
}

/// Refuses numbers that the document excludes by a declared sign or an assumption.
fn admit(compiled: &mut CompiledSystem, set: &[Fixed], audit: &Audit) -> Result<(), Outcome> {
    let specification = &mut compiled.specification;
    // What the system does not rest on is told with the names of what it rests on.
    let known = set.iter().filter(|own| specification.rests_on(&own.name));
    let known: Vec<&Fixed> = known.collect();
    specification.admit(&known).map_err(|refusal| {
        let name = &specification.evaluator.name;
        refused(name, &audit.path, &refusal, std::slice::from_ref(audit))
    })
}

/// Whether a system of a document is meant, and not a case file.
pub fn is_document(input: Option<&Path>, which: &Which) -> bool {
    let is_case = input.is_some_and(|path| path.extension().is_some_and(|own| own == "toml"));
    let is_markdown = input.is_none_or(|path| path.extension().is_some_and(|own| own == "md"));
    is_markdown || which.system.is_some() && !is_case
}

impl Chosen {
    /// The numbers by the names of the document, in SI units and radians; others are given in another way.
    ///
    /// # Errors
    ///
    /// As [`numbers`].
    pub fn numbers(
        &self,
        set: &[Fixed],
        moving: &[&str],
    ) -> Result<BTreeMap<String, Rational>, Outcome> {
        let set: Vec<Fixed> = set.iter().map(|own| self.vocabulary.in_si(own)).collect();
        numbers(&set, moving)
    }
}

/// The numbers by name; others are given in another way.
///
/// # Errors
///
/// The outcome, after it was written that one is set twice, or moves.
pub fn numbers(set: &[Fixed], moving: &[&str]) -> Result<BTreeMap<String, Rational>, Outcome> {
    let mut values = BTreeMap::new();
    if let Some(both) = set.iter().find(|own| moving.contains(&own.name.as_str())) {
        let name = &both.name;
        return Err(wrong(
            &format!("`{name}` has a value by `--set`, and moves"),
            "give one of both",
        ));
    }
    for Fixed { name, value, .. } in set {
        if values.insert(name.clone(), value.clone()).is_some() {
            return Err(wrong(&format!("`{name}` is set twice"), "set it once"));
        }
    }
    Ok(values)
}

/// Numbers and one more.
pub fn with(set: &[Fixed], name: &str, value: &Rational) -> Vec<Fixed> {
    set.iter().cloned().chain([named(name, value)]).collect()
}

/// A number with a name.
pub fn named(name: &str, value: &Rational) -> Fixed {
    Fixed {
        name: name.to_string(),
        value: value.clone(),
        text: value.to_string(),
    }
}

/// Writes why a system has no numbers.
pub fn refuse(error: &SystemError) -> Outcome {
    let help = match error {
        SystemError::Missing { .. } | SystemError::Unknown { .. } => {
            "`--set name=value`, in SI units and radians; `name_deg` is in degrees"
        }
        _ => "quantities are in SI units, angles in radians",
    };
    wrong(&error.to_string(), help)
}
