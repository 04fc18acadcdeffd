//! An object whose members keep their order.

use serde::{Serialize, Serializer};

use crate::language::syntax::{Expression, Name};

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_is_kept() {
        let pairs = Pairs(vec![("b".into(), 1), ("a".into(), 2)]);
        assert_eq!(serde_json::to_string(&pairs).unwrap(), r#"{"b":1,"a":2}"#);
    }
}
