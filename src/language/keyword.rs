//! The words that statements begin with.

/// The words a statement can begin with; anywhere else they are names like others.
pub(crate) const KEYWORDS: [&str; 19] = [
    "parameter",
    "complex",
    "angle",
    "coordinate",
    "function",
    "imaginary",
    "assume",
    "substitution",
    "claim",
    "refute",
    "approximate",
    "ill-formed",
    "eigenpair",
    "match",
    "system",
    "evaluator",
    "domain",
    "show",
    "import",
];

/// Whether a statement can begin with this word.
pub(crate) fn is_keyword(word: &str) -> bool {
    // `ill-formed` is three tokens to the lexer.
    word == "ill" || KEYWORDS.contains(&word)
}
