//! The names of a document, as names of Coq.

use std::collections::{BTreeMap, BTreeSet};

/// Words of Coq, and of the kernel's vocabulary, that no document may give another meaning.
const RESERVED: &str = "Axiom CoFixpoint Definition End Fixpoint Goal Hypothesis Inductive Lemma Module Notation \
    Parameter Proof Prop Qed Require SProp Section Set Theorem Type Variable \
    as at by cofix do else end exists exists2 fix for forall fun if in is let match mod return then using where with \
    expr list need term pair fst snd nil cons \
    above accepts accepts_with at_ at_entry below beside blocks check by_check by_check_with by_point by_shapes by_units coefficient_by coefficient_ column_ complex_number component \
    Is IsComplex Takes Turns \
    coordinate d_ declared det_ differ_in_unit diagonal_ dt_ equal fits follows fraction function_ given hurwitz_ identity_ imaginary \
    inverse_ invalid jacobian minus_ negative non_negative non_zero not_above null_ over_ parameter part plus_ positive \
    power_ power_minus put puts row_ real_parts refutes same_shape scalar settled solve_ sqrt_ times_ trace_ transpose_ truncate_ units whole without_value";

fn is_reserved(name: &str) -> bool {
    RESERVED.split_whitespace().any(|word| word == name)
}

/// Which names of Coq stand for which names of the document.
#[derive(Clone, Debug)]
pub struct Names {
    of: BTreeMap<String, String>,
    taken: BTreeSet<String>,
}

impl Default for Names {
    fn default() -> Self {
        Names {
            of: BTreeMap::new(),
            taken: RESERVED.split_whitespace().map(str::to_owned).collect(),
        }
    }
}

impl Names {
    /// A name that nothing else has: the wanted one, or the first of `wanted_`, `wanted__`, … that is free.
    pub fn fresh(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        name
    }

    /// Gives a name of the document, by its ASCII spelling, a name of Coq.
    pub fn declare(&mut self, ascii: &str) -> String {
        // An output of an evaluator has a dot in its name, which Coq keeps for its modules.
        let name = self.fresh(&ascii.replace('.', "__"));
        self.of.insert(ascii.to_owned(), name.clone());
        name
    }

    /// The name of Coq for a name of the document, if it was declared.
    pub fn get(&self, ascii: &str) -> Option<&str> {
        self.of.get(ascii).map(String::as_str)
    }

    /// Whether a name of Coq stands for another name of the document.
    fn means_another(&self, name: &str, ascii: &str) -> bool {
        let mut all = self.of.iter();
        all.any(|(own, known)| known == name && own != ascii)
    }

    /// The same names, and local ones for the arguments of a definition.
    pub fn with_arguments<'a>(
        &self,
        arguments: impl Iterator<Item = &'a str>,
    ) -> (Self, Vec<String>) {
        let mut names = self.clone();
        let locals = arguments.map(|argument| {
            let mut local = argument.to_owned();
            while is_reserved(&local) || names.means_another(&local, argument) {
                local.push('_');
            }
            names.of.insert(argument.to_owned(), local.clone());
            local
        });
        let locals = locals.collect();
        (names, locals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_coq_are_renamed_visibly() {
        let mut names = Names::default();
        assert_eq!(names.declare("omega_n"), "omega_n");
        assert_eq!(names.declare("at"), "at__");
        assert_eq!(names.declare("forall"), "forall_");
        assert_eq!(names.declare("forall_"), "forall__");
        assert_eq!(names.get("at"), Some("at__"));
        assert_eq!(names.get("unknown"), None);
    }

    /// An argument hides the name that it has, and no other.
    #[test]
    fn an_argument_hides_no_other_name() {
        let mut names = Names::default();
        names.declare("forall");
        names.declare("x");
        let (inner, locals) = names.with_arguments(["x", "forall_", "in"].into_iter());
        assert_eq!(locals, ["x", "forall__", "in_"]);
        assert_eq!(inner.get("forall"), Some("forall_"));
    }
}
