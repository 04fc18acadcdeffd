//! `sextic generate`: what a document derives, as source text.

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

use clap::builder::TypedValueParser;
use clap::error::ErrorKind;
use clap::{Arg, Args, Command};
use indicatif::{ProgressBar, ProgressStyle};
use sextic_codegen::language::{File, Language};

use crate::compile::fixed::{Fixed, Unfixed};
use crate::compile::generation::{Failure, Generated, Order, POINTS, generate};
use crate::compile::proof::{Proof, prove_files};
use crate::compile::specification::{Refusal, Specification};
use crate::language::diagnostic::{nearest, render};
use crate::report::advice::Advice;
use crate::report::text;
use crate::verdict::audit::Audit;

use super::Outcome;
use super::folder::{self, State, Trouble, Written};
use super::output::{complain, finish, wrong};
use super::source::{Audited, audit_all};
use super::vocabulary::Vocabulary;

/// Writes what a document derives as source text, proven equal to the derivation
///
/// Every evaluator of the document becomes a file (in C two): a function of named inputs with its
/// documentation, one for many points at once, and a twin that bounds its own rounding error. In Python
/// and Octave it is one function, which takes arrays. The text is read back by a parser of its own and
/// executed over the exact algebra of the document before it is written; its header says what was proven
/// and how far its rounding goes.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A Markdown document; without one, those that come with the command
    #[arg(value_name = "DOC")]
    document: Option<String>,

    /// The folder for the files; it is made if need be
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// rust, c, python or octave, which is for MATLAB too
    #[arg(long, value_parser = language)]
    language: Language,

    /// Only this evaluator of the document; may be given several times
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,

    /// Fix a quantity: an exact decimal or fraction in SI units, angles in radians; may be given several
    /// times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    fix: Vec<Fixed>,

    /// At how many points the rounding error is measured; 0 measures nothing, which the text then says
    #[arg(long, value_name = "COUNT", default_value_t = POINTS, value_parser = clap::value_parser!(u32).range(..=10_000_000))]
    points: u32,

    /// Write nothing: prove the files in the folder, and compare them with what would be written
    #[arg(long)]
    check: bool,

    /// Overwrite files of the same names even if they were not generated
    #[arg(long, conflicts_with = "check")]
    force: bool,
}

const EXAMPLES: &str = "\
Examples:
  sextic generate --out here --language rust             all that the documents compile
  sextic generate --out here --language c --only closed_form --fix m=3.5 --fix r=0.0178
  sextic generate --out here --language rust --check     are these files proven, and up to date?
  sextic generate plate.md --out here --language python  a document of your own";

fn language(text: &str) -> Result<Language, String> {
    text.parse().map_err(|_| {
        let names = Language::ALL.map(Language::name);
        match nearest(text, names) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the languages are {}", names.join(", ")),
        }
    })
}

/// Reads `r=0.0178`; what is wrong with a long text is said without all of it.
#[derive(Clone, Debug)]
pub(super) struct FixedParser;

impl TypedValueParser for FixedParser {
    type Value = Fixed;

    fn parse_ref(
        &self,
        command: &Command,
        argument: Option<&Arg>,
        value: &OsStr,
    ) -> Result<Fixed, clap::Error> {
        /// So much of a text is repeated.
        const SHOWN: usize = 60;
        let text = value.to_string_lossy();
        fixed(&text).map_err(|reason| {
            let mut shown: String = text.chars().take(SHOWN).collect();
            if shown.len() < text.len() {
                shown.push('…');
            }
            let option = argument.map_or(String::new(), |own| format!(" for '{own}'"));
            let message = format!("invalid value '{shown}'{option}: {reason}\n");
            clap::Error::raw(ErrorKind::ValueValidation, message).with_cmd(command)
        })
    }
}

fn fixed(text: &str) -> Result<Fixed, String> {
    text.parse().map_err(|error| match error {
        Unfixed::Form => "write `name=value`, such as `r=0.0178`".to_string(),
        Unfixed::Number(_) => {
            "the value must be an exact decimal or fraction of at most 400 digits, such as 0.0178, 1e-3 or 1/3"
                .to_string()
        }
    })
}

/// Nothing is computed from a document in which there is a mistake, which has been told.
pub(super) fn mistaken(outcome: Outcome) -> Outcome {
    complain("Nothing is compiled from a document in which there is a mistake.\n");
    outcome
}

/// Nothing is computed from a document that is not as it says.
pub(super) fn differs(audit: &Audit) -> Outcome {
    let Advice { message, help } = Advice::differs(audit);
    complain(&format!("Error: {message}\nHelp: {help}\n"));
    Outcome::Differs
}

/// Generates, and writes or checks.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        audits, outcome, ..
    } = audit_all(arguments.document.as_slice());
    if outcome != Outcome::AsExpected {
        return mistaken(outcome);
    }
    if let Some(audit) = audits.iter().find(|audit| !audit.as_expected()) {
        return differs(audit);
    }
    let known = Vocabulary::of(&audits);
    let fixes: Vec<Fixed> = arguments.fix.iter().map(|own| known.in_si(own)).collect();
    for (place, fixed) in fixes.iter().enumerate() {
        if fixes[..place].iter().any(|known| known.name == fixed.name) {
            return wrong(&format!("`{}` is fixed twice", fixed.name), "fix it once");
        }
    }
    let order = Order {
        document: arguments.document.clone(),
        names: arguments.only.clone(),
        fixed: fixes,
        language: arguments.language,
        points: arguments.points as usize,
    };
    let progress = ProgressBar::new_spinner();
    let style = ProgressStyle::with_template("{spinner} {msg} ({elapsed})");
    progress.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    progress.enable_steady_tick(std::time::Duration::from_millis(100));
    let generated = generate(&audits, &order, &mut |step| {
        progress.set_message(step.to_string());
    });
    progress.finish_and_clear();
    match generated {
        Err(failure) => refuse(&failure, &audits, arguments),
        Ok(generated) if arguments.check => {
            check(&generated, arguments).unwrap_or_else(|outcome| outcome)
        }
        Ok(generated) => write(&generated, arguments),
    }
}

fn write(generated: &Generated, arguments: &Arguments) -> Outcome {
    match folder::write(&arguments.out, &generated.files, arguments.force) {
        Ok(written) => {
            let mut report = text::generated(generated);
            report.push_str(&summary(&written, &arguments.out));
            finish(&report, Outcome::AsExpected)
        }
        Err(Trouble::Foreign(paths)) => {
            let paths: Vec<String> = paths
                .iter()
                .map(|path| format!("`{}`", path.display()))
                .collect();
            wrong(
                &format!(
                    "not generated by this command: {}; nothing was written",
                    paths.join(", ")
                ),
                "choose another folder, or overwrite with `--force`",
            )
        }
        Err(Trouble::Disk(path, error)) => wrong(
            &format!("`{}` cannot be written: {error}", path.display()),
            "nothing is left half-written; mend the folder, or choose another with `--out`",
        ),
    }
}

fn summary(written: &Written, out: &Path) -> String {
    let total = written.changed + written.unchanged;
    let files = if total == 1 { "file" } else { "files" };
    let mut summary = match (written.changed, written.unchanged) {
        (_, 0) => format!("{total} {files} written to {}\n", out.display()),
        (0, _) => format!("{total} {files} in {} were up to date\n", out.display()),
        (changed, _) => format!(
            "{changed} of {total} {files} in {} written, the others were up to date\n",
            out.display()
        ),
    };
    for name in &written.stale {
        summary.push_str(&format!(
            "{name} was generated, but not by this command; it is left alone\n"
        ));
    }
    summary
}

/// Files as they stand on the disk, beside those that would be written.
#[derive(Default)]
struct Standing<'g> {
    /// Those that are there.
    found: Vec<File>,
    /// What differs, in words.
    differences: Vec<String>,
    /// What evaluators share and is not as it would be written.
    changed_support: Vec<&'g str>,
}

impl<'g> Standing<'g> {
    fn of(generated: &'g Generated, out: &Path) -> Result<Self, Outcome> {
        let mut standing = Standing::default();
        for file in &generated.files {
            let path = out.join(&file.path);
            match folder::state(&path, &file.text).map_err(|error| unreadable(&path, &error))? {
                State::Same => {
                    standing.found.push(file.clone());
                    continue;
                }
                State::Different(text) => {
                    let difference = text::difference(&file.path, &text, &file.text);
                    standing.differences.push(difference);
                    let path = file.path.clone();
                    standing.found.push(File { path, text });
                }
                State::Missing => {
                    let missing = format!("{} is missing\n", file.path);
                    standing.differences.push(missing);
                }
            }
            if generated.is_shared(file) {
                standing.changed_support.push(&file.path);
            }
        }
        Ok(standing)
    }

    /// Why an evaluator is not proven by what stands there.
    fn doubt(&self, specification: &Specification, language: Language) -> Result<Proof, String> {
        let proof = prove_files(&self.found, specification, language);
        let proof = proof.map_err(|doubt| doubt.to_string())?;
        match self.changed_support.is_empty() {
            true => Ok(proof),
            false => Err(format!(
                "it rests on {}, see below",
                self.changed_support.join(", ")
            )),
        }
    }
}

fn unreadable(path: &Path, error: &io::Error) -> Outcome {
    wrong(
        &format!("`{}` cannot be read: {error}", path.display()),
        "name the folder of the files with `--out`",
    )
}

/// Proves the files as they stand on the disk, and compares them with what would be written.
///
/// What the evaluators share is not derived, and not proven: it has to be what would be written.
fn check(generated: &Generated, arguments: &Arguments) -> Result<Outcome, Outcome> {
    let standing = Standing::of(generated, &arguments.out)?;
    let mut report = String::new();
    let mut is_good = standing.differences.is_empty();
    for specification in &generated.specifications {
        let name = &specification.evaluator.name;
        match standing.doubt(specification, arguments.language) {
            Ok(proof) => report += &format!("{name}: proven. {proof}\n"),
            Err(doubt) => {
                is_good = false;
                report += &format!("{name}: NOT proven: {doubt}\n");
            }
        }
    }
    report += &standing.differences.concat();
    let others = folder::others(&arguments.out, &generated.files)
        .map_err(|error| unreadable(&arguments.out, &error))?;
    is_good &= others.stale.is_empty() && others.namesakes.is_empty();
    for name in others.stale {
        report += &format!("{name} was generated, but this command does not write it\n");
    }
    for name in others.namesakes {
        report += &format!(
            "{name} may be taken for a file of this command by a compiler, Python or Octave\n"
        );
    }
    let (outcome, ending) = match is_good {
        true => (
            Outcome::AsExpected,
            "All files are as this command writes them.\n",
        ),
        false => (
            Outcome::Differs,
            "The same command without `--check` writes its files anew.\n",
        ),
    };
    Ok(finish(&(report + ending), outcome))
}

/// Says why nothing was generated.
pub(super) fn refuse(failure: &Failure, audits: &[Audit], arguments: &Arguments) -> Outcome {
    match failure {
        Failure::NoEvaluator => wrong(
            &format!("{} wants nothing compiled", paths(audits)),
            "say what with `evaluator (1) name: output = expression`",
        ),
        Failure::UnknownEvaluator(name, known) => {
            unknown(&format!("there is no evaluator `{name}`"), name, known)
        }
        Failure::UnknownQuantity(name, known) => unknown(
            &format!("no evaluator that is generated rests on `{name}`"),
            name,
            known,
        ),
        Failure::Refused(evaluator, path, refusal) => refused(evaluator, path, refusal, audits),
        Failure::NoPoint(evaluator) => wrong(
            &format!("`{evaluator}` has no value at any point of the domain that is drawn"),
            "fix less, or state another `domain`: a divisor is 0 there, or a root imaginary",
        ),
        Failure::Language(error) => wrong(
            &format!("this cannot be written in {}: {error}", arguments.language),
            "rename it in the document, fix less, or give numbers that a double can hold",
        ),
        Failure::Doubted(evaluator, doubt) => {
            complain(&format!(
                "Error: the text of `{evaluator}` is not proven: {doubt}\n\
                 Help: this is a mistake of this program; nothing was written\n"
            ));
            Outcome::Differs
        }
    }
}

fn paths(audits: &[Audit]) -> String {
    let paths: Vec<&str> = audits.iter().map(|audit| audit.path.as_str()).collect();
    paths.join(" or ")
}

pub(super) fn refused(evaluator: &str, path: &str, refusal: &Refusal, audits: &[Audit]) -> Outcome {
    match (refusal, Advice::refused(evaluator, refusal)) {
        (_, Some(advice)) => advised(&advice),
        (Refusal::Document(diagnostic), None) => {
            let audit = audits.iter().find(|audit| audit.path == path);
            let source = audit.and_then(|audit| audit.sources.last());
            let shown = source.map(|source| render(diagnostic, source, true));
            complain(&shown.unwrap_or_default());
            Outcome::WrongInput
        }
        (_, None) => Outcome::WrongInput,
    }
}

pub(super) fn unknown(message: &str, name: &str, known: &[String]) -> Outcome {
    advised(&Advice::unknown(message, name, known))
}

fn advised(advice: &Advice) -> Outcome {
    wrong(&advice.message, &advice.help)
}
