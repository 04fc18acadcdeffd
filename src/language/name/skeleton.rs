//! What a name looks like: names that a reader cannot tell apart have one skeleton.

use std::collections::BTreeSet;

use crate::language::syntax::Name;

/// How many parts of a name are written in every way; longer names have a look in each spelling.
const MOST_PARTS: usize = 6;

/// Greek letters and the Latin ones that are drawn in the same way, or so nearly that a reader who looks
/// for one sees it in the other. ρ and κ are told from p and k: papers have both of them in one place.
const LOOK_ALIKES: [(char, char); 19] = [
    ('Α', 'A'),
    ('Β', 'B'),
    ('Ε', 'E'),
    ('Ζ', 'Z'),
    ('Η', 'H'),
    ('Ι', 'I'),
    ('Κ', 'K'),
    ('Μ', 'M'),
    ('Ν', 'N'),
    ('Ο', 'O'),
    ('Ρ', 'P'),
    ('Τ', 'T'),
    ('Υ', 'Y'),
    ('Χ', 'X'),
    ('ο', 'o'),
    ('ι', 'i'),
    ('ν', 'v'),
    ('υ', 'u'),
    ('χ', 'x'),
];

/// A spelling with one letter for all that look like it, and without the `_` that LaTeX does not show.
pub(crate) fn skeleton(spelling: &str) -> String {
    parts(spelling).join("_")
}

/// Everything that a name looks like: each part may be written in Greek letters or in ASCII.
pub(crate) fn looks(name: &Name) -> BTreeSet<String> {
    let (unicode, ascii) = (parts(&name.unicode), parts(&name.ascii));
    let whole = [&name.unicode, &name.ascii].map(|spelling| skeleton(spelling));
    if unicode.len() != ascii.len() || unicode.len() > MOST_PARTS {
        return BTreeSet::from(whole);
    }
    let mut looks = BTreeSet::from([String::new()]);
    for (unicode, ascii) in unicode.iter().zip(&ascii) {
        let add = |begun: &String| [unicode, ascii].map(|part| format!("{begun}_{part}"));
        looks = looks.iter().flat_map(add).collect();
    }
    let behind = |look: &String| look.trim_start_matches('_').to_owned();
    looks.iter().map(behind).collect()
}

/// The parts of a spelling, with one letter for all that look like it.
fn parts(spelling: &str) -> Vec<String> {
    let parts = spelling.split('_').filter(|part| !part.is_empty());
    parts
        .map(|part| part.chars().map(prototype).collect())
        .collect()
}

/// The letter for all that look like it.
fn prototype(character: char) -> char {
    match character {
        '0' => 'O',
        '1' => 'l',
        _ => latin_double(character).unwrap_or(character),
    }
}

/// The Latin letter that a Greek one looks like.
fn latin_double(character: char) -> Option<char> {
    let mut pairs = LOOK_ALIKES.iter();
    pairs.find_map(|&(greek, latin)| (greek == character).then_some(latin))
}

/// A Greek letter among Latin ones in one part of a name that nobody can tell from a Latin one.
pub(crate) fn disguised(spelling: &str) -> Option<(char, char)> {
    let mixed = spelling
        .split('_')
        .filter(|part| part.contains(|letter: char| letter.is_ascii_alphabetic()));
    // Of the small ones only ο is the same everywhere, and S_xν is no disguise.
    let is_same = |letter: &char| *letter == 'ο' || letter.is_uppercase();
    let mut letters = mixed.flat_map(str::chars).filter(is_same);
    letters.find_map(|letter| Some((letter, latin_double(letter)?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_looks_the_same_has_one_skeleton() {
        for (one, other) in [
            ("A", "Α"),
            ("T_0", "Τ_O"),
            ("x_1", "x__1"),
            ("x_1", "x_l"),
            ("u_", "υ"),
            ("ν_n", "v_n"),
        ] {
            assert_eq!(skeleton(one), skeleton(other), "{one} {other}");
        }
        for (one, other) in [
            ("x1", "x_1"),
            ("C_D", "C_d"),
            ("ρ", "p"),
            ("ω_n", "w_n"),
            ("α", "a"),
            ("I", "l"),
        ] {
            assert_ne!(skeleton(one), skeleton(other), "{one} {other}");
        }
    }

    #[test]
    fn parts_are_written_in_either_spelling() {
        let looks = looks(&Name::new("xi_Α_n"));
        let expected = ["xi_A_n", "xi_Alpha_n", "ξ_A_n", "ξ_Alpha_n"];
        assert_eq!(looks, expected.map(str::to_owned).into());
    }

    #[test]
    fn a_part_in_two_scripts_hides_no_letter() {
        for name in ["ω_n", "S_xθ", "C_D", "α_g", "ΔT", "Δx", "Α_D", "ΔΤ", "S_xν"] {
            assert_eq!(disguised(name), None, "{name}");
        }
        for (name, letters) in [
            ("cοs", ('ο', 'o')),
            ("C_Dο", ('ο', 'o')),
            ("xΤ", ('Τ', 'T')),
        ] {
            assert_eq!(disguised(name), Some(letters), "{name}");
        }
    }
}
