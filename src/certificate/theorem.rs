//! Statements with their proofs, as text of Coq.

/// A part of the file.
#[derive(Clone, Debug)]
pub enum Part {
    /// A declaration, a definition, a comment.
    Text(String),
    /// A theorem of the claim with this number.
    Theorem(usize, Theorem),
    /// What is refuted, or only approximate, as if it held: Coq must refuse it.
    Control(Theorem),
}

/// A statement with its proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Theorem {
    /// `claim_21`
    pub name: String,
    /// `given … |= λ_1 == …`
    pub statement: String,
    /// The assignment by which something is refuted, and the places of functions; nothing for what always holds.
    pub point: Option<(String, String)>,
}

impl Theorem {
    /// What proves it.
    pub(super) fn proof(&self) -> String {
        match &self.point {
            None => "by_check".into(),
            Some((point, references)) => format!("by_point {point} {references}"),
        }
    }

    /// The same, tried at once.
    pub(super) fn trial(&self) -> String {
        match &self.point {
            None => "accepts".into(),
            Some((point, references)) => format!("accepts_point {point} {references}"),
        }
    }
}

/// A text that can stand in a comment of Coq.
pub fn comment(text: &str) -> String {
    text.replace("(*", "( *")
        .replace("*)", "* )")
        .replace('"', "'")
}
