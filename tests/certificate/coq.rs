//! Coq itself, where it is installed: it accepts a certificate, and refuses one that was changed by hand.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use sextic::certificate::document::Certificate;
use sextic::certificate::kernel;
use sextic::certificate::theorem::Rule;
use sextic::language::diagnostic::SourceFile;

use super::certificate;

/// A folder with the kernel, compiled; nothing where Coq is not installed.
fn folder(name: &str) -> Option<PathBuf> {
    if Command::new("coqc").arg("--version").output().is_err() {
        eprintln!("skipped: coqc is not installed");
        return None;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("certificate-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    for (path, text) in kernel::FILES {
        compiled(&folder, path, text);
    }
    Some(folder)
}

fn coqc(folder: &Path, path: &str, text: &str) -> Output {
    fs::write(folder.join(path), text).expect("a file");
    let mut command = Command::new("coqc");
    let command = command.args(["-q", "-w", "none", "-Q", ".", kernel::LIBRARY, path]);
    command.current_dir(folder).output().expect("coqc runs")
}

/// What Coq says of a file that it compiles.
fn compiled(folder: &Path, path: &str, text: &str) -> String {
    let output = coqc(folder, path, text);
    assert!(
        output.status.success(),
        "{path}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn two_degrees() -> Certificate {
    let text = include_str!("../../derivations/two-degrees.md");
    certificate(&SourceFile::new("two-degrees.md", text))
}

/// Every text with one word of it exchanged.
fn exchanged(text: &str, from: &str, to: &str) -> Vec<String> {
    let places = text.match_indices(from);
    places
        .map(|(place, _)| format!("{}{to}{}", &text[..place], &text[place + from.len()..]))
        .collect()
}

/// What always holds, with one sign, one name or one hypothesis changed.
fn changes(certificate: &Certificate) -> Vec<(String, String)> {
    let mut changes = Vec::new();
    for (_, theorem) in certificate
        .theorems()
        .filter(|(_, own)| own.rule == Rule::Check)
    {
        let (given, said) = theorem.statement.split_once("|=").expect("a statement");
        let exchanges = [
            (" + ", " - "),
            (" - ", " + "),
            ("*", "/"),
            ("^2", "^3"),
            ("cos ", "sin "),
            ("omega", "r"),
            ("rho", "D"),
        ];
        for (from, to) in exchanges {
            for changed in exchanged(said, from, to) {
                let what = format!(
                    "{}: {from}→{to} in{}",
                    theorem.name,
                    changed.replace('\n', "")
                );
                changes.push((what, format!("{given}|={changed}")));
            }
        }
        let bare = given
            .replace("declared_1", "[]")
            .replace("declared_2", "[]");
        changes.push((
            format!("{}: without declarations", theorem.name),
            format!("{bare}|={said}"),
        ));
    }
    changes
}

/// A certificate is accepted as it is, its controls are refused, and so is every change by hand but those that are
/// true as well.
#[test]
fn coq_refuses_a_certificate_that_was_changed() {
    let Some(folder) = folder("changed") else {
        return;
    };
    let own = two_degrees();
    let changes = changes(&own);
    assert!(changes.len() > 60, "{}", changes.len());
    let mut probe = own.probe(true);
    for (number, (_, statement)) in changes.iter().enumerate() {
        probe += &format!(
            "Goal {statement}.\nProof. first [accepts; idtac \"accepted {number}\" | idtac \"refused {number}\"]. Abort.\n"
        );
    }
    let said = compiled(&folder, "Probe.v", &probe);
    let accepted: BTreeSet<&str> = said
        .lines()
        .filter_map(|line| line.strip_prefix("accepted "))
        .collect();
    for (_, theorem) in own.theorems() {
        assert!(accepted.contains(theorem.name.as_str()), "{}", theorem.name);
    }
    assert_eq!(own.controls().count(), 5);
    for control in own.controls() {
        assert!(
            !accepted.contains(control.name.as_str()),
            "{}",
            control.name
        );
    }
    let survivors: Vec<&str> = changes
        .iter()
        .enumerate()
        .filter(|(number, _)| accepted.contains(number.to_string().as_str()))
        .map(|(_, (what, _))| what.as_str())
        .collect();
    super::lock("changes_that_are_true_as_well", &survivors.join("\n"));
}

/// The proof is the kernel's: a certificate rests on the axioms of Coq's real numbers and on nothing else, and
/// without its proof Coq does not take it.
#[test]
fn a_certificate_rests_on_no_axiom_of_its_own() {
    let Some(folder) = folder("axioms") else {
        return;
    };
    let own = two_degrees();
    let text = own.text(|_| true);
    let said = compiled(&folder, "Own.v", &text);
    assert_eq!(kernel::further_axioms(&said), Vec::<&str>::new(), "{said}");
    let admitted = text.replacen("Proof. by_check. Qed.", "Admitted.", 1);
    let said = compiled(&folder, "Admitted.v", &admitted);
    assert_eq!(kernel::further_axioms(&said), ["claim_1"], "{said}");
    let changed = text.replacen("- (dt theta)^2*sin theta", "+ (dt theta)^2*sin theta", 1);
    assert_ne!(changed, text);
    assert!(!coqc(&folder, "Changed.v", &changed).status.success());
}

/// What is ill-formed differs in its units, and Coq refuses it where it does not: with equal units, with 0, which has
/// every unit, and where a quantity is declared in another.
#[test]
fn coq_knows_units() {
    let Some(folder) = folder("units") else {
        return;
    };
    let blocks = "parameter m : kg > 0\nparameter L : m\ncoordinate y : m\n\
                  ill-formed (1): m*sqrt(L^2 + y^2)*dt(y) == m*L\nill-formed (2): [m, L] == [m; L]";
    let own = super::written(blocks);
    let mut probe = own.probe(true);
    for (number, statement) in [
        "differ_in_unit units_1 (m*L) (2*L*m)",
        "differ_in_unit units_1 (m*L) (0*m)",
        "differ_in_unit units_1 (sin L) m",
        "differ_in_unit [(m, [0; 1; 0; 0; 0]%Z); (L, [0; 1; 0; 0; 0]%Z)] m L",
        "without_value (blocks [[m; L]] - blocks [[L; m]])",
    ]
    .into_iter()
    .enumerate()
    {
        let rule = if statement.starts_with("without") {
            "by_shapes"
        } else {
            "accepts_units"
        };
        probe += &format!(
            "Goal {statement}.\nProof. first [{rule}; idtac \"accepted {number}\" | idtac \"refused {number}\"]. Abort.\n"
        );
    }
    let said = compiled(&folder, "Probe.v", &probe);
    let accepted: Vec<&str> = said
        .lines()
        .filter_map(|line| line.strip_prefix("accepted "))
        .collect();
    assert_eq!(accepted, ["claim_1", "claim_2"], "{said}");
}

/// A difference that is a square has a sign, and a root that is a fraction refutes.
#[test]
fn coq_follows_squares_and_roots() {
    let Some(folder) = folder("squares") else {
        return;
    };
    let own = super::written(
        "parameter a, b, c : 1\nparameter s : 1 >= 0\nclaim (1): a^4 + b^4 >= 2*a^2*b^2\n\
         claim (2): (a + b)^2*s >= (4*a*b - 1)*s + s\nrefute (3): sqrt(a^2 + b^2) == a + b\nrefute (4): a^2 + b^2 >= 3*a*b",
    );
    let said = compiled(&folder, "Probe.v", &own.probe(true));
    let accepted: Vec<&str> = said
        .lines()
        .filter_map(|line| line.strip_prefix("accepted "))
        .collect();
    assert_eq!(
        accepted,
        ["claim_1", "claim_2", "claim_3", "claim_4"],
        "{said}"
    );
}
