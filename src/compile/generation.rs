//! From a document to source text: specified, measured, emitted, read back and proven.

use std::collections::BTreeMap;
use std::fmt;

use sextic_codegen::evaluator::Evaluator as Emitted;
use sextic_codegen::language::{self, File, Language, Renamed};
use sextic_codegen::rounding::{self, Domain, Interval, Unmeasured};

use crate::verdict::audit::Audit;

use super::doubt::Doubt;
use super::fixed::{Fixed, written};
use super::input::Input;
use super::proof::{Proof, prove_files};
use super::specification::{Refusal, Specification};

/// The points of every measurement are drawn from this seed.
const SEED: u64 = 6;

/// What is to be generated.
#[derive(Clone, Debug)]
pub struct Order {
    /// The path of the document, unless it comes with the command.
    pub document: Option<String>,
    /// The evaluators by their ASCII names; all of the document if there are none.
    pub names: Vec<String>,
    /// What is fixed.
    pub fixed: Vec<Fixed>,
    /// In what language.
    pub language: Language,
    /// At how many points the rounding error is measured; it is not if this is 0.
    pub points: usize,
}

/// As many points as are measured at if nobody says otherwise.
pub const POINTS: u32 = 100_000;

impl Order {
    /// All that the documents of the command want compiled.
    pub fn of_all(language: Language) -> Self {
        Order {
            document: None,
            names: Vec::new(),
            fixed: Vec::new(),
            language,
            points: POINTS as usize,
        }
    }

    /// The command that orders this, as files quote it: with the folder left open, so that they are the
    /// same wherever they are written.
    pub fn command(&self) -> String {
        let mut words = vec!["sextic generate".to_string()];
        words.extend(self.document.clone());
        words.push(format!("--out DIR --language {}", self.language));
        words.extend(self.names.iter().map(|name| format!("--only {name}")));
        let fixed = self.fixed.iter();
        words.extend(fixed.map(|fixed| format!("--fix {}={}", fixed.name, fixed.text)));
        if self.points != POINTS as usize {
            words.push(format!("--points {}", self.points));
        }
        words.join(" ")
    }
}

/// What was generated.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The evaluators.
    pub specifications: Vec<Specification>,
    /// The files, in the order of their paths.
    pub files: Vec<File>,
    /// What the files call otherwise than the document.
    pub renamed: Vec<Renamed>,
}

impl Generated {
    /// Whether a file belongs to no evaluator alone.
    pub fn is_shared(&self, file: &File) -> bool {
        let stem = file.path.split('.').next();
        let mut evaluators = self.specifications.iter();
        !evaluators.any(|specification| Some(self.called(&specification.evaluator.name)) == stem)
    }

    /// What the files call an evaluator of the document.
    fn called<'g>(&'g self, evaluator: &'g str) -> &'g str {
        let mut renamed = self.renamed.iter();
        let own = renamed.find(|own| own.evaluator == evaluator);
        own.map_or(evaluator, |own| &own.function)
    }
}

/// Why nothing was generated.
#[derive(Clone, Debug)]
pub enum Failure {
    /// The documents want nothing compiled.
    NoEvaluator,
    /// No evaluator has this name; those of the documents.
    UnknownEvaluator(String, Vec<String>),
    /// No evaluator that was ordered rests on this name; those that they rest on.
    UnknownQuantity(String, Vec<String>),
    /// An evaluator of the document of this path cannot be compiled.
    Refused(String, String, Refusal),
    /// An output of an evaluator has no value at any point of the domain.
    NoPoint(String),
    /// An evaluator cannot be written in this language.
    Language(language::Error),
    /// The text of an evaluator is not proven: a mistake of this program.
    Doubted(String, Doubt),
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = |names: &[String]| names.join(", ");
        match self {
            Failure::NoEvaluator => formatter.write_str("the documents want nothing compiled"),
            Failure::UnknownEvaluator(name, names) => {
                write!(
                    formatter,
                    "there is no evaluator `{name}`: there are {}",
                    known(names)
                )
            }
            Failure::UnknownQuantity(name, names) => write!(
                formatter,
                "no evaluator rests on `{name}`: they rest on {}",
                known(names)
            ),
            Failure::Refused(evaluator, path, refusal) => {
                write!(
                    formatter,
                    "`{evaluator}` of {path} cannot be compiled: {refusal}"
                )
            }
            Failure::NoPoint(evaluator) => write!(
                formatter,
                "`{evaluator}` has no value at any point of the domain that is drawn"
            ),
            Failure::Language(error) => error.fmt(formatter),
            Failure::Doubted(evaluator, doubt) => {
                write!(
                    formatter,
                    "the text of `{evaluator}` is not proven: {doubt}"
                )
            }
        }
    }
}

impl std::error::Error for Failure {}

/// Generates what is ordered from audited documents; `report` is told what is being worked on.
///
/// # Errors
///
/// [`Failure`]
pub fn generate(
    audits: &[Audit],
    order: &Order,
    report: &mut dyn FnMut(&str),
) -> Result<Generated, Failure> {
    let mut specifications = specifications(audits, &order.names, &order.fixed)?;
    for specification in &mut specifications {
        let intervals = document_of(specification, audits).map(intervals);
        let evaluator = &mut specification.evaluator;
        evaluator.command = order.command();
        if order.points > 0 {
            report(&format!("measuring the rounding of {}", evaluator.name));
            let domain = domain(evaluator, intervals.unwrap_or_default());
            // Without an interval for every input there is no figure, which the text says.
            evaluator.rounding = match rounding::measure(evaluator, &domain, order.points, SEED) {
                Ok(rounding) => Some(rounding),
                Err(Unmeasured::NoPoint) => {
                    return Err(Failure::NoPoint(evaluator.name.clone()));
                }
                Err(Unmeasured::Domain | Unmeasured::Constant) => None,
            };
        }
    }
    // Proven twice: what is written says that it is proven, and is proven as it is written.
    let drafts = emit(&specifications, order.language)?;
    for specification in &mut specifications {
        report(&format!("proving {}", specification.evaluator.name));
        let proof = proven(&drafts, specification, order.language)?;
        specification.evaluator.proof = Some(proof.to_string());
    }
    let files = emit(&specifications, order.language)?;
    let emitted = evaluators(&specifications);
    let renamed = language::renamed(&emitted, order.language).map_err(Failure::Language)?;
    for specification in &specifications {
        proven(&files, specification, order.language)?;
    }
    Ok(Generated {
        specifications,
        files,
        renamed,
    })
}

/// The document that an evaluator was specified from.
fn document_of<'a>(specification: &Specification, audits: &'a [Audit]) -> Option<&'a Audit> {
    let path = &specification.evaluator.document;
    audits.iter().find(|audit| audit.path == *path)
}

/// The evaluators of documents by name, or all of them, with quantities fixed.
///
/// # Errors
///
/// [`Failure`]
pub fn specifications(
    audits: &[Audit],
    names: &[String],
    fixed: &[Fixed],
) -> Result<Vec<Specification>, Failure> {
    let all = audits.iter().flat_map(|audit| &audit.evaluators);
    check_names(names, all.map(|evaluator| evaluator.name.ascii.as_str()))?;
    let mut specifications: Vec<Specification> = Vec::new();
    for audit in audits {
        for evaluator in &audit.evaluators {
            if names.is_empty() || names.contains(&evaluator.name.ascii) {
                let specification = Specification::of(evaluator, audit, fixed);
                specifications.push(specification.map_err(|refusal| {
                    let name = evaluator.name.unicode.clone();
                    Failure::Refused(name, audit.path.clone(), refusal)
                })?);
            }
        }
    }
    let is_used = |fixed: &Fixed| {
        let mut all = specifications.iter();
        all.any(|specification: &Specification| specification.fixed.contains(&fixed.name))
    };
    match fixed.iter().find(|fixed| !is_used(fixed)) {
        None => Ok(specifications),
        Some(unused) => {
            let known = specifications.iter().flat_map(Specification::names);
            let mut known: Vec<String> = known.map(str::to_string).collect();
            known.sort();
            known.dedup();
            Err(Failure::UnknownQuantity(unused.name.clone(), known))
        }
    }
}

fn check_names<'a>(names: &[String], known: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
    let known: Vec<String> = known.map(str::to_string).collect();
    if known.is_empty() {
        return Err(Failure::NoEvaluator);
    }
    match names.iter().find(|name| !known.contains(name)) {
        Some(name) => Err(Failure::UnknownEvaluator(name.clone(), known)),
        None => Ok(()),
    }
}

fn evaluators(specifications: &[Specification]) -> Vec<Emitted> {
    let evaluators = specifications.iter();
    evaluators
        .map(|specification| specification.evaluator.clone())
        .collect()
}

fn emit(specifications: &[Specification], language: Language) -> Result<Vec<File>, Failure> {
    language::emit(&evaluators(specifications), language).map_err(Failure::Language)
}

fn proven(
    files: &[File],
    specification: &Specification,
    language: Language,
) -> Result<Proof, Failure> {
    prove_files(files, specification, language)
        .map_err(|doubt| Failure::Doubted(specification.evaluator.name.clone(), doubt))
}

/// The intervals that the document states for the inputs of an evaluator.
fn domain(evaluator: &Emitted, intervals: BTreeMap<String, Interval>) -> Domain {
    let mut parts: Vec<String> = Vec::new();
    for input in evaluator.free_inputs() {
        if let Some(Interval { from, to }) = intervals.get(&input.quantity.name) {
            let symbol = &input.quantity.symbol;
            parts.push(format!("{symbol} in [{}, {}]", written(from), written(to)));
        }
    }
    if evaluator.open_angles().next().is_some() {
        parts.push("angles all around the circle".to_string());
    }
    Domain {
        intervals,
        text: parts.join(", "),
    }
}

/// The intervals that a document states, by the names that programs have for the quantities.
pub fn intervals(audit: &Audit) -> BTreeMap<String, Interval> {
    let (ring, scope) = (&audit.elaborator.ring, &audit.elaborator.scope);
    let named = audit.domain.intervals().filter_map(|(symbol, interval)| {
        let input = Input::of(symbol, ring, scope)?;
        let (from, to) = (interval.from.clone(), interval.to.clone());
        Some((input.name, Interval { from, to }))
    });
    named.collect()
}
