//! An object whose members keep their order.

use serde::{Serialize, Serializer};

use crate::language::syntax::{Expression, Name};
#[cfg(feature = "stability")]
use crate::stability::{case::Case, forces::Coefficients};

use super::ascii;

/// Names and values, written as one object in this order.
pub struct Pairs<T = String>(pub Vec<(String, T)>);

impl<T: Serialize> Serialize for Pairs<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// Names and what they are.
pub fn pairs(named: &[(Name, Expression)]) -> Pairs {
    let named = named.iter();
    Pairs(
        named
            .map(|(name, value)| (name.ascii.clone(), ascii(value)))
            .collect(),
    )
}

/// What is defined, and as what.
pub fn definitions(definitions: &[(Expression, Expression)]) -> Pairs {
    let definitions = definitions.iter();
    Pairs(
        definitions
            .map(|(left, right)| (ascii(left), ascii(right)))
            .collect(),
    )
}

/// Coefficients and their derivatives by name.
#[cfg(feature = "stability")]
pub fn coefficients(own: &Coefficients) -> Pairs<f64> {
    let named = own.named().into_iter();
    Pairs(
        named
            .map(|(name, value)| (name.to_string(), value))
            .collect(),
    )
}

/// What was set in place of what a case says.
#[cfg(feature = "stability")]
pub fn settings(case: &Case) -> Pairs<f64> {
    let set = case.set.iter();
    Pairs(
        set.map(|own| (own.variable.name.to_string(), own.value))
            .collect(),
    )
}

/// Whether there is none.
#[cfg(feature = "stability")]
pub fn is_empty<T>(pairs: &Pairs<T>) -> bool {
    pairs.0.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_is_kept() {
        let pairs = Pairs(vec![("b".into(), 1), ("a".into(), 2)]);
        assert_eq!(serde_json::to_string(&pairs).unwrap(), r#"{"b":1,"a":2}"#);
    }
}
