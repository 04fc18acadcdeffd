//! Certificates: what they state, what they withhold, and that Coq refuses what was changed.

mod coq;

use std::fmt::Write;

use insta::Settings;
use sextic::certificate::document::Certificate;
use sextic::documents::{ShippedLibrary, shipped};
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::audit;

fn certificate(source: &SourceFile) -> Certificate {
    let audit = audit(source, &ShippedLibrary);
    Certificate::of(&audit.unwrap_or_else(|rejected| panic!("{rejected}")))
}

fn written(blocks: &str) -> Certificate {
    certificate(&SourceFile::new(
        "own.md",
        format!("```sextic\n{blocks}\n```\n"),
    ))
}

fn lock(name: &str, text: &str) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../../snapshots/certificate");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// The part of a text from a beginning to the next empty line.
fn paragraph<'a>(text: &'a str, beginning: &str) -> &'a str {
    let start = text.find(beginning);
    let start = start.unwrap_or_else(|| panic!("{beginning} is not there"));
    let rest = &text[start..];
    &rest[..rest.find("Qed.").map_or(rest.len(), |end| end + 4)]
}

/// A person lays these beside the paper: a change of any of them is reviewed.
#[test]
fn statements_read_like_the_equations() {
    let paper = shipped().next().expect("the paper");
    let text = certificate(&paper).text(|_| true);
    let mut sample = String::new();
    for name in [
        "M",
        "C_a",
        "C_w",
        "p",
        "d_1",
        "d_2",
        "lamda_1",
        "closed_form",
    ] {
        let beginning = format!("Definition {name} :");
        let line = text.lines().find(|line| line.starts_with(&beginning));
        writeln!(sample, "{}", line.expect("a definition")).expect("a text");
    }
    let headings = [
        "(* (2) ",
        "(* (5) ",
        "(* (9) ",
        "(* (12) ",
        "(* (12, printed) ",
        "(* (15, mode 1) ",
        "(* (19) ",
        "(* (20, first order) ",
        "(* (21) ",
        "(* [mode 1 rises] ",
        "(* [amplitude ratio of mode 1] ",
        "(* [never to the stable side] ",
        "(* [Den Hartog] ",
    ];
    for heading in headings {
        writeln!(sample, "\n{}", paragraph(&text, heading)).expect("a text");
    }
    lock("statements", &sample);
}

#[test]
fn every_claim_is_stated_or_withheld_with_a_reason() {
    let mut ledger = String::new();
    for source in shipped() {
        let certificate = certificate(&source);
        writeln!(ledger, "{}", certificate.path).expect("a text");
        for entry in &certificate.entries {
            let found = match &entry.certificate {
                Ok(kind) => kind.text().to_owned(),
                Err(reason) => format!("withheld: {reason}"),
            };
            writeln!(
                ledger,
                "  {} · {} · {found}",
                entry.label,
                entry.subject.text()
            )
            .expect("a text");
        }
    }
    lock("ledger", &ledger);
}

#[test]
fn what_the_kernel_has_no_words_for_is_withheld() {
    for (statements, reason) in [
        (
            "parameter x, y : 1\nclaim (1): [x, y]*kernel([x, y]) == 0",
            "`kernel` is not in the kernel's vocabulary",
        ),
        (
            "parameter m : kg^0.5\nill-formed (1): m == m^2",
            "the exponents of the unit kg^0.5 are not whole",
        ),
        (
            "parameter m : kg\nadded(x) := x + x^2\nill-formed (1): added(m) == 0",
            "the units differ inside of a definition",
        ),
    ] {
        let certificate = written(statements);
        let [entry] = certificate.entries.as_slice() else {
            panic!("one claim")
        };
        assert_eq!(entry.certificate, Err(reason.to_owned()), "{statements}");
        assert_eq!(certificate.theorems().count(), 0, "{statements}");
    }
}

/// An evaluator whose terms are too many, multiplied out, takes the claims with it that name its outputs.
#[test]
fn an_evaluator_of_too_many_terms_is_withheld() {
    let certificate = written(
        "parameter a, b, c, f : 1 > 0\nparameter m : 1 > 0\n\
         evaluator [large] large: y = (a/(m + b) + c/(m + f))^2*(a + b*m)^8*(b + c*m)^8\nclaim (1): large.y == large.y",
    );
    let found: Vec<_> = certificate
        .entries
        .iter()
        .map(|own| own.certificate.is_ok())
        .collect();
    assert_eq!(found, [false, false], "{:?}", certificate.entries);
}

/// A definition that cannot be said takes the claims with it that rest on it.
#[test]
fn what_rests_on_what_is_withheld_is_withheld() {
    let certificate = written(
        "parameter x, y : 1\nN := kernel([x, y])\nclaim (1): [x, y]*N == 0\nclaim (2): x + y == y + x",
    );
    let [first, second] = certificate.entries.as_slice() else {
        panic!("two claims")
    };
    let reason = "`N` is withheld: `kernel` is not in the kernel's vocabulary";
    assert_eq!(first.certificate, Err(reason.to_owned()));
    assert!(second.certificate.is_ok());
}

/// What an assumption that cannot be said would exclude must not be said to be possible.
#[test]
fn nothing_is_refuted_where_an_assumption_is_left_out() {
    let certificate = written(
        "parameter x : 1\nparameter n : 1\nh := kernel([1, 2])[1]\nassume x > h\nrefute (1): x == x + n",
    );
    let [entry] = certificate.entries.as_slice() else {
        panic!("one claim")
    };
    let reason = "an assumption of the document is left out";
    assert_eq!(entry.certificate, Err(reason.to_owned()));
}

#[test]
fn words_of_coq_and_letters_beyond_ascii_are_renamed() {
    let text = written(
        "parameter Set : 1 \"with a \"\nparameter ω_θ : 1 > 0\nclaim (1): Set + ω_θ == ω_θ + Set",
    )
    .text(|_| true);
    assert!(
        text.is_ascii()
            || !text
                .lines()
                .any(|line| line.starts_with("Definition") && !line.is_ascii())
    );
    assert!(text.contains("Definition Set_ := parameter 2."), "{text}");
    assert!(
        text.contains("Set_ + omega_theta\n  == omega_theta + Set_"),
        "{text}"
    );
}

/// A comment that a document closes would let it write commands of Coq.
#[test]
fn a_comment_of_a_document_stays_one() {
    let text = written("parameter x : 1 \"ends *) Axiom a : False. (* here\"\nclaim (1): x == x")
        .text(|_| true);
    assert!(
        text.contains("ends * ) Axiom a : False. ( * here"),
        "{text}"
    );
    assert!(!text.contains("ends *)"), "{text}");
}
