//! The Greek letters and their ASCII names.

/// The Greek letters with their ASCII names; `lamda` without a `b`, since `lambda` is a keyword of Python.
const GREEK: [(char, char, &str, &str); 24] = [
    ('α', 'Α', "alpha", "Alpha"),
    ('β', 'Β', "beta", "Beta"),
    ('γ', 'Γ', "gamma", "Gamma"),
    ('δ', 'Δ', "delta", "Delta"),
    ('ε', 'Ε', "epsilon", "Epsilon"),
    ('ζ', 'Ζ', "zeta", "Zeta"),
    ('η', 'Η', "eta", "Eta"),
    ('θ', 'Θ', "theta", "Theta"),
    ('ι', 'Ι', "iota", "Iota"),
    ('κ', 'Κ', "kappa", "Kappa"),
    ('λ', 'Λ', "lamda", "Lamda"),
    ('μ', 'Μ', "mu", "Mu"),
    ('ν', 'Ν', "nu", "Nu"),
    ('ξ', 'Ξ', "xi", "Xi"),
    ('ο', 'Ο', "omicron", "Omicron"),
    ('π', 'Π', "pi", "Pi"),
    ('ρ', 'Ρ', "rho", "Rho"),
    ('σ', 'Σ', "sigma", "Sigma"),
    ('τ', 'Τ', "tau", "Tau"),
    ('υ', 'Υ', "upsilon", "Upsilon"),
    ('φ', 'Φ', "phi", "Phi"),
    ('χ', 'Χ', "chi", "Chi"),
    ('ψ', 'Ψ', "psi", "Psi"),
    ('ω', 'Ω', "omega", "Omega"),
];

/// The ASCII name of a Greek letter in any of its shapes: `theta` for both `θ` and `ϑ`.
pub(crate) fn transliterate(character: char) -> Option<&'static str> {
    if character.is_ascii() {
        return None;
    }
    let letter = usual_shape(character);
    GREEK.iter().find_map(|&(lower, upper, name, capitalized)| {
        if letter == lower {
            Some(name)
        } else if letter == upper {
            Some(capitalized)
        } else {
            None
        }
    })
}

/// The Greek letter of an ASCII name; both spellings of lambda are known.
pub(crate) fn greek_letter(name: &str) -> Option<char> {
    let name = match name {
        "lambda" => "lamda",
        "Lambda" => "Lamda",
        _ => name,
    };
    GREEK
        .iter()
        .find_map(|&(lower, upper, small, capitalized)| {
            if name == small {
                Some(lower)
            } else if name == capitalized {
                Some(upper)
            } else {
                None
            }
        })
}

/// Replaces the shapes of a letter that mathematics tells apart and this language does not.
pub(crate) fn usual_shape(character: char) -> char {
    match character {
        'ϕ' => 'φ',
        'ϑ' => 'θ',
        'ϵ' => 'ε',
        'ϖ' => 'π',
        'ϱ' => 'ρ',
        'ϰ' => 'κ',
        'ς' => 'σ',
        '\u{B5}' => 'μ',
        '\u{2126}' => 'Ω',
        '\u{2206}' => 'Δ',
        _ => character,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_has_a_name_and_every_name_a_letter() {
        for (lower, upper, small, capitalized) in GREEK {
            assert_eq!(
                (transliterate(lower), greek_letter(small)),
                (Some(small), Some(lower))
            );
            assert_eq!(transliterate(upper), Some(capitalized));
            assert_eq!(greek_letter(capitalized), Some(upper));
        }
    }
}
