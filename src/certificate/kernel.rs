//! The files of the kernel, which come with the command.

/// Names and texts, in the order in which they build on each other.
pub const FILES: [(&str, &str); 10] = [
    ("Term.v", include_str!("../../certificates/Term.v")),
    ("Calculus.v", include_str!("../../certificates/Calculus.v")),
    ("Normal.v", include_str!("../../certificates/Normal.v")),
    ("Sign.v", include_str!("../../certificates/Sign.v")),
    ("Rewrite.v", include_str!("../../certificates/Rewrite.v")),
    ("Check.v", include_str!("../../certificates/Check.v")),
    ("Analysis.v", include_str!("../../certificates/Analysis.v")),
    ("Refute.v", include_str!("../../certificates/Refute.v")),
    ("Unit.v", include_str!("../../certificates/Unit.v")),
    ("Document.v", include_str!("../../certificates/Document.v")),
];

/// How the kernel is called in `From … Require`.
pub const LIBRARY: &str = "Certificate";

/// The axioms of Coq's real numbers and of its arc functions, on which certificates may rest.
pub const AXIOMS: [&str; 4] = [
    "Classical_Prop.classic",
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
];

/// What Coq names as an axiom and is none of [`AXIOMS`], from what `Print Assumptions` says.
pub fn further_axioms(said: &str) -> Vec<&str> {
    let is_name =
        |line: &&str| !line.starts_with(char::is_whitespace) && !line.ends_with("Axioms:");
    let names = said
        .lines()
        .filter(is_name)
        .filter_map(|line| line.split_whitespace().next());
    names.filter(|name| !AXIOMS.contains(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axiom_more_is_seen() {
        let said = "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P : Prop,\n  {P}\nclaim_1 : False\n";
        assert_eq!(further_axioms(said), ["claim_1"]);
        assert!(further_axioms("Axioms:\n").is_empty());
        assert!(further_axioms("").is_empty());
    }
}
