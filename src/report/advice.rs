//! What is wrong with what was asked, and what to do about it, in the words of the command.

use crate::compile::specification::Refusal;
use crate::language::diagnostic::nearest;
use crate::verdict::audit::Audit;

/// What is wrong, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Advice {
    /// What is wrong, in a sentence without a full stop.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

impl Advice {
    /// What is wrong, and what to do.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Advice {
            message: message.into(),
            help: help.into(),
        }
    }

    /// That nothing is called so, and what may be meant.
    pub fn unknown(message: impl Into<String>, name: &str, known: &[String]) -> Self {
        // `CD` is `C_D` rather than `D`.
        let letters = |own: &str| own.replace('_', "").to_lowercase();
        let same = known.iter().find(|own| letters(own) == letters(name));
        let near = same.map(String::as_str);
        let help = match near.or_else(|| nearest(name, known.iter().map(String::as_str))) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", known.join(", ")),
        };
        Advice::new(message, help)
    }

    /// That nothing is computed from a document that is not as it says.
    pub fn differs(audit: &Audit) -> Self {
        let path = &audit.path;
        Advice::new(
            format!("not every verdict on {path} is as it expects: nothing is compiled from it"),
            "`sextic audit` shows which",
        )
    }

    /// Why there is no evaluator; nothing where its document is wrong, which a diagnostic says with its place.
    pub fn refused(evaluator: &str, refusal: &Refusal) -> Option<Self> {
        match refusal {
            Refusal::Document(_) => None,
            Refusal::Program(reason) => Some(Advice::new(
                format!("`{evaluator}` cannot be compiled: {reason}"),
                "let its outputs rest on parameters, angles and functions",
            )),
            Refusal::Number(names, reason) => Some(Advice::new(
                format!("`{evaluator}` does not allow this value of {names}: {reason}"),
                "give another value; where only one evaluator forbids it, `--only` generates the others",
            )),
        }
    }
}
