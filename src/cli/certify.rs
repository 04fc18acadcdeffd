//! `sextic certify`: claims as theorems that Coq checks.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use clap::Args;
use sextic_codegen::language::{File, MARK};

use crate::certificate::document::Certificate;
use crate::certificate::kernel;
use crate::certificate::theorem::comment;
use crate::report::{json, text};

use super::Outcome;
use super::folder::{self, Trouble};
use super::output::{Results, complain, finish, reason, wrong};
use super::source::{Audited, audit_all};

/// Writes theorems that Coq checks without believing this program
///
/// Each document becomes a file for Coq with its declarations, its definitions and a theorem for each
/// claim, beside a kernel that proves how they are checked. What a certificate cannot say is withheld,
/// with the reason. With --check, Coq (coqc, of Debian's package coq) checks all of it at once.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Markdown documents; without any, those that come with the command
    #[arg(value_name = "DOC")]
    documents: Vec<String>,

    /// The folder to write to; it is made if need be
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// Let Coq check every theorem; one that it refuses is withheld, and makes the exit status 1
    #[arg(long)]
    check: bool,

    /// How the ledger is written
    #[arg(long, value_enum, default_value_t = Results::Text)]
    format: Results,
}

const EXAMPLES: &str = "\
Examples:
  sextic certify --out certificates              the documents that come with the command
  sextic certify paper.md --out coq --check      one of your own, checked by Coq
  sextic certify --out coq --format json | jq '.claims[] | select(.certificate == null)'";

/// Writes certificates, lets Coq check them, and says what is certified.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        audits, outcome, ..
    } = audit_all(&arguments.documents);
    if audits.is_empty() {
        return outcome;
    }
    let mut certificates: Vec<Certificate> = audits.iter().map(Certificate::of).collect();
    let mut outcome = outcome;
    if arguments.check {
        match check(&arguments.out, &mut certificates) {
            Ok(checked) => outcome = outcome.max(checked),
            Err(trouble) => return outcome.max(trouble),
        }
    } else if let Err(trouble) = write(&arguments.out, &files(&certificates)) {
        return outcome.max(trouble);
    }
    let written = match arguments.format {
        Results::Text => text::ledger(&certificates, arguments.check),
        Results::Json => json::ledger(&certificates),
    };
    finish(&written, outcome)
}

fn file(path: String, text: String) -> File {
    File { path, text }
}

fn certified(certificate: &Certificate, text: String) -> File {
    file(
        format!("{}.v", certificate.name),
        format!("(* {MARK} from {} *)\n{text}", comment(&certificate.path)),
    )
}

/// The kernel, the certificates, and what tells Coq where they are.
fn files(certificates: &[Certificate]) -> Vec<File> {
    let kernel = kernel::FILES.iter().map(|(path, text)| {
        file(
            (*path).into(),
            format!("(* {MARK}: a part of the kernel of certificates *)\n{text}"),
        )
    });
    let own = certificates
        .iter()
        .map(|own| certified(own, own.text(|_| true)));
    let names = kernel::FILES.iter().map(|(path, _)| (*path).to_owned());
    let names = names.chain(certificates.iter().map(|own| format!("{}.v", own.name)));
    let project = names.fold(format!("-Q . {}\n", kernel::LIBRARY), |text, name| {
        text + &name + "\n"
    });
    kernel
        .chain(own)
        .chain([file("_CoqProject".into(), format!("# {MARK}\n{project}"))])
        .collect()
}

fn write(folder: &Path, files: &[File]) -> Result<(), Outcome> {
    match folder::write(folder, files, false) {
        Ok(_) => Ok(()),
        Err(Trouble::Disk(path, error)) => {
            let what = format!("{} cannot be written: {}", path.display(), reason(&error));
            Err(wrong(&what, "let it go where there is room"))
        }
        Err(Trouble::Foreign(paths)) => {
            let paths: Vec<String> = paths
                .iter()
                .map(|path| path.display().to_string())
                .collect();
            let what = format!(
                "not written by sextic, and not overwritten: {}",
                paths.join(", ")
            );
            Err(wrong(&what, "choose another folder"))
        }
    }
}

/// Lets Coq check all files: theorems that it refuses are withheld.
fn check(folder: &Path, certificates: &mut [Certificate]) -> Result<Outcome, Outcome> {
    write(folder, &files(certificates))?;
    for (path, _) in kernel::FILES {
        compile(folder, path)?;
    }
    let outcomes = certificates.iter_mut().map(|own| check_one(folder, own));
    let outcomes = outcomes.collect::<Result<Vec<_>, _>>()?;
    Ok(outcomes.into_iter().max().unwrap_or(Outcome::AsExpected))
}

/// Lets Coq check the theorems, and sees that it refuses the controls; where it refuses a theorem, each is tried by
/// itself, and what is refused is withheld.
fn check_one(folder: &Path, certificate: &mut Certificate) -> Result<Outcome, Outcome> {
    let path = format!("{}.v", certificate.name);
    let controls = tried(folder, certificate, false)?;
    let mut outcome = Outcome::AsExpected;
    for control in certificate
        .controls()
        .filter(|own| controls.contains(&own.name))
    {
        let (path, name) = (&certificate.path, &control.name);
        complain(&format!(
            "{path}: Coq accepts {name}, which does not hold: please report it\n"
        ));
        outcome = Outcome::Differs;
    }
    let mut output = coqc(folder, &path)?;
    if !output.status.success() {
        let accepted = tried(folder, certificate, true)?;
        certificate.withhold(|name| !accepted.contains(name));
        write(
            folder,
            &[certified(certificate, certificate.text(|_| true))],
        )?;
        outcome = Outcome::Differs;
        output = coqc(folder, &path)?;
    }
    let said = said(&output, &path)?;
    for axiom in kernel::further_axioms(&said) {
        let path = &certificate.path;
        complain(&format!(
            "{path}: a theorem rests on {axiom}, which is no axiom of Coq's real numbers\n"
        ));
        outcome = Outcome::Differs;
    }
    Ok(outcome)
}

/// The names of the controls, or of controls and theorems, that the checker accepts.
fn tried(
    folder: &Path,
    certificate: &Certificate,
    with_theorems: bool,
) -> Result<BTreeSet<String>, Outcome> {
    let probe = format!("Probe_{}.v", certificate.name);
    let text = format!("(* {MARK} *)\n{}", certificate.probe(with_theorems));
    write(folder, &[file(probe.clone(), text)])?;
    let said = compile(folder, &probe)?;
    forget(folder, &certificate.name);
    let accepted = said
        .lines()
        .filter_map(|line| line.strip_prefix("accepted "));
    Ok(accepted.map(str::to_owned).collect())
}

/// Removes what was written to try theorems; if that cannot be, it stays.
fn forget(folder: &Path, name: &str) {
    for ending in ["v", "vo", "vok", "vos", "glob"] {
        let _ = std::fs::remove_file(folder.join(format!("Probe_{name}.{ending}")));
    }
    let _ = std::fs::remove_file(folder.join(format!(".Probe_{name}.aux")));
}

/// Compiles a file: what Coq says.
fn compile(folder: &Path, path: &str) -> Result<String, Outcome> {
    said(&coqc(folder, path)?, path)
}

/// What Coq said, if it compiled a file.
fn said(output: &Output, path: &str) -> Result<String, Outcome> {
    if !output.status.success() {
        complain(&String::from_utf8_lossy(&output.stderr));
        complain(&format!("Coq refuses {path}\n"));
        return Err(Outcome::Differs);
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn coqc(folder: &Path, path: &str) -> Result<Output, Outcome> {
    let mut command = Command::new("coqc");
    let command = command.current_dir(folder);
    let command = command.args(["-q", "-w", "none", "-Q", ".", kernel::LIBRARY, path]);
    command.output().map_err(|error| {
        let what = format!("coqc cannot be run: {}", reason(&error));
        wrong(
            &what,
            "install Coq (Debian's package coq), or leave out --check",
        )
    })
}
