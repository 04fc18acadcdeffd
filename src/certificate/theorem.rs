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
    /// How it is proved.
    pub rule: Rule,
}

/// How a statement is proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rule {
    /// By the checker of what always holds.
    Check,
    /// By that checker, which is told what is squared.
    Squares(String),
    /// At an assignment, with the places of functions.
    Point(String, String),
    /// By the units of two expressions.
    Units,
    /// By the shapes of matrices.
    Shapes,
}

impl Theorem {
    /// What proves it.
    pub(super) fn proof(&self) -> String {
        match &self.rule {
            Rule::Check => "by_check".into(),
            Rule::Squares(squared) => format!("by_check_with {squared}"),
            Rule::Point(point, references) => format!("by_point {point} {references}"),
            Rule::Units => "by_units".into(),
            Rule::Shapes => "by_shapes".into(),
        }
    }

    /// The same, tried at once.
    pub(super) fn trial(&self) -> String {
        match &self.rule {
            Rule::Check => "accepts".into(),
            Rule::Squares(squared) => format!("accepts_with {squared}"),
            Rule::Point(point, references) => format!("accepts_point {point} {references}"),
            Rule::Units => "accepts_units".into(),
            Rule::Shapes => "by_shapes".into(),
        }
    }
}

/// A text that can stand in a comment of Coq.
pub fn comment(text: &str) -> String {
    text.replace("(*", "( *")
        .replace("*)", "* )")
        .replace('"', "'")
}
