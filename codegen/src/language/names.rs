//! Names that are safe in a language.

use std::collections::BTreeSet;

use super::Error;

/// Whether a name is an ASCII identifier that starts with a letter.
pub fn is_identifier(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_alphabetic())
        && name
            .chars()
            .all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}

/// Whether a name is that of a temporary value: t1, t2, ….
pub fn is_temporary(name: &str) -> bool {
    name.strip_prefix('t')
        .is_some_and(|number| number.chars().all(|digit| digit.is_ascii_digit()))
        && name.len() > 1
}

/// `closed_form` as `ClosedForm`.
pub fn camel_case(name: &str) -> String {
    let parts = name.split('_').filter(|part| !part.is_empty());
    let mut camel = String::new();
    for part in parts {
        // Two numbers do not run into one another.
        let digits = camel.ends_with(|last: char| last.is_ascii_digit())
            && part.starts_with(|first: char| first.is_ascii_digit());
        if digits {
            camel.push('_');
        }
        let (first, rest) = part.split_at(1);
        camel.push_str(&first.to_ascii_uppercase());
        camel.push_str(rest);
    }
    camel
}

/// Gives every name a trailing underscore, or more of them, that is unsafe or another one's.
///
/// # Errors
///
/// If a name is no identifier, or occurs twice.
pub fn safe<'a>(
    names: impl IntoIterator<Item = &'a str>,
    is_unsafe: impl Fn(&str) -> bool,
) -> Result<Vec<String>, Error> {
    let names: Vec<&str> = names.into_iter().collect();
    let mut taken = distinct(&names)?;
    let mut safe = Vec::new();
    for name in names {
        let mut chosen = name.to_owned();
        while is_unsafe(&chosen) || (chosen != name && taken.contains(&chosen)) {
            chosen.push('_');
        }
        taken.insert(chosen.clone());
        safe.push(chosen);
    }
    Ok(safe)
}

/// The names, if each is an identifier that occurs once.
///
/// # Errors
///
/// If a name is no identifier, or occurs twice.
pub fn distinct(names: &[&str]) -> Result<BTreeSet<String>, Error> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    for name in names {
        if !is_identifier(name) {
            return Err(Error::Name((*name).to_owned()));
        }
        if !taken.insert((*name).to_owned()) {
            return Err(Error::Twice((*name).to_owned()));
        }
    }
    Ok(taken)
}
