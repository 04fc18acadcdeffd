//! How names are spelled: `ω_n` and `omega_n` are one name, and `ẋ` is the rate of `x`.

pub(crate) mod greek;
pub(crate) mod skeleton;

use std::collections::BTreeMap;

use unicode_normalization::UnicodeNormalization;

use super::look_alike::Looks;
use super::syntax::Name;
use greek::{greek_letter, transliterate, usual_shape};
use skeleton::disguised;

/// One dot above a letter.
const DOT_ABOVE: char = '\u{307}';
/// Two dots above a letter.
const TWO_DOTS_ABOVE: char = '\u{308}';

impl Name {
    /// The name that is spelled so, in Greek letters or in ASCII.
    ///
    /// Letters other than Latin and Greek stay as they are; [`DottedName::read`] refuses them.
    pub fn new(spelling: &str) -> Self {
        let segments = || spelling.split('_');
        Self {
            ascii: join(segments().map(ascii_segment)),
            unicode: join(segments().map(unicode_segment)),
        }
    }

    /// A name whose ASCII spelling is chosen: `S_xθ as S_xt`.
    pub fn with_ascii(spelling: &str, ascii: &str) -> Self {
        Self {
            ascii: ascii.to_owned(),
            unicode: Self::new(spelling).unicode,
        }
    }
}

impl Name {
    /// `closed_form.λ_R1`: the name of an output behind the name of what has it.
    pub fn output(&self, output: &Name) -> Self {
        Self {
            ascii: format!("{}.{}", self.ascii, output.ascii),
            unicode: format!("{}.{}", self.unicode, output.unicode),
        }
    }

    /// The names of what has an output, and of the output, of the name of one.
    pub fn of_output(&self) -> Option<(Self, Self)> {
        let (owner, output) = self.ascii.split_once('.')?;
        let (shown, shown_output) = self.unicode.split_once('.')?;
        let name = |ascii: &str, unicode: &str| Self {
            ascii: ascii.to_owned(),
            unicode: unicode.to_owned(),
        };
        Some((name(owner, shown), name(output, shown_output)))
    }
}

/// A name and the number of dots above its first letter: `θ̇_d` is `θ_d` with one dot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DottedName {
    /// The name without its dots.
    pub name: Name,
    /// 0, 1 or 2: how often the name is differentiated by time.
    pub dots: u32,
}

/// Why a word is no name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InvalidName {
    /// It has letters that are neither Latin nor Greek, or marks other than dots.
    ForeignLetter,
    /// It has a dot above a letter that is not its first.
    MisplacedDot,
    /// It has three dots or more.
    TooManyDots,
    /// A part of it is Latin but for this Greek letter, which looks like the Latin one behind it.
    TwoScripts(char, char),
}

impl DottedName {
    /// Reads a word, splitting `ẋ` into the letter and its dot.
    ///
    /// # Errors
    ///
    /// Why the word is no name.
    pub fn read(word: &str) -> Result<Self, InvalidName> {
        let mut plain = String::with_capacity(word.len());
        let mut letters = 0;
        let mut dots = 0;
        for character in word.nfd() {
            match character {
                DOT_ABOVE | TWO_DOTS_ABOVE if letters != 1 => {
                    return Err(InvalidName::MisplacedDot);
                }
                DOT_ABOVE => dots += 1,
                TWO_DOTS_ABOVE => dots += 2,
                _ if is_plain(character) => {
                    plain.push(character);
                    letters += 1;
                }
                _ => return Err(InvalidName::ForeignLetter),
            }
            if dots > 2 {
                return Err(InvalidName::TooManyDots);
            }
        }
        if let Some((greek, latin)) = disguised(&plain) {
            return Err(InvalidName::TwoScripts(greek, latin));
        }
        Ok(Self {
            name: Name::new(&plain),
            dots,
        })
    }

    /// Writes the dots above the first letter: `ẋ`, `θ̈_d`.
    pub fn write(unicode: &str, dots: u32) -> String {
        let mut characters = unicode.chars();
        let first = characters.next();
        let marks = match dots {
            0 => None,
            1 => Some(DOT_ABOVE),
            _ => Some(TWO_DOTS_ABOVE),
        };
        first
            .into_iter()
            .chain(marks)
            .chain(characters)
            .nfc()
            .collect()
    }
}

/// Which ASCII spellings a document chose for its names: `S_xθ` is `S_xt` where it was declared `as S_xt`;
/// and what all of its names look like.
#[derive(Clone, Debug, Default)]
pub struct Aliases {
    declared: BTreeMap<String, Name>,
    /// What all names look like.
    pub(crate) looks: Looks,
}

impl Aliases {
    /// Remembers that `spelling` and the ASCII spelling of `name` both mean `name`.
    pub fn declare(&mut self, spelling: &Name, name: &Name) {
        self.declared.insert(spelling.ascii.clone(), name.clone());
        self.declared.insert(name.ascii.clone(), name.clone());
    }

    /// The declared name that is meant by a spelling, or the spelling itself.
    pub fn resolve(&self, spelling: Name) -> Name {
        self.declared
            .get(&spelling.ascii)
            .cloned()
            .unwrap_or(spelling)
    }

    /// Takes over what another document declared.
    pub fn extend(&mut self, other: &Self) {
        let declared = other.declared.iter();
        self.declared
            .extend(declared.map(|(spelling, name)| (spelling.clone(), name.clone())));
        self.looks.extend(&other.looks);
    }

    /// Whether nothing was declared.
    pub fn is_empty(&self) -> bool {
        self.declared.is_empty()
    }
}

fn is_plain(character: char) -> bool {
    character.is_ascii_alphanumeric() || character == '_' || transliterate(character).is_some()
}

/// Splits `theta1` into the letter that it names and its digits.
fn spelled_out(segment: &str) -> Option<(char, &str)> {
    let word = segment.trim_end_matches(|character: char| character.is_ascii_digit());
    Some((greek_letter(word)?, &segment[word.len()..]))
}

fn ascii_segment(segment: &str) -> String {
    if let Some((letter, digits)) = spelled_out(segment) {
        return format!("{}{digits}", transliterate(letter).unwrap_or_default());
    }
    let mut ascii = String::with_capacity(segment.len());
    for character in segment.chars() {
        match transliterate(character) {
            Some(name) => ascii.push_str(name),
            None => ascii.push(character),
        }
    }
    ascii
}

fn unicode_segment(segment: &str) -> String {
    match spelled_out(segment) {
        Some((letter, digits)) => format!("{letter}{digits}"),
        None => segment.chars().map(usual_shape).collect(),
    }
}

fn join(segments: impl Iterator<Item = String>) -> String {
    segments.collect::<Vec<_>>().join("_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_spellings_are_one_name() {
        for (spelling, ascii, unicode) in [
            ("ω_n", "omega_n", "ω_n"),
            ("omega_theta", "omega_theta", "ω_θ"),
            ("λ", "lamda", "λ"),
            ("lambda", "lamda", "λ"),
            ("lamda", "lamda", "λ"),
            ("Lambda_1", "Lamda_1", "Λ_1"),
            ("lambda1", "lamda1", "λ1"),
            ("S_xθ", "S_xtheta", "S_xθ"),
            ("ϕ", "phi", "φ"),
            ("\u{2126}_0", "Omega_0", "Ω_0"),
            ("\u{2206}x", "Deltax", "Δx"),
            ("theta_", "theta_", "θ_"),
            ("beta_alphabet", "beta_alphabet", "β_alphabet"),
        ] {
            let name = Name::new(spelling);
            assert_eq!(
                (name.ascii.as_str(), name.unicode.as_str()),
                (ascii, unicode)
            );
        }
    }

    #[test]
    fn dots_stand_above_the_first_letter() {
        for (word, ascii, dots) in [
            ("ẋ", "x", 1),
            ("x\u{307}", "x", 1),
            ("ẍ", "x", 2),
            ("x\u{307}\u{307}", "x", 2),
            ("θ̈", "theta", 2),
            ("θ̇_d", "theta_d", 1),
            ("x", "x", 0),
        ] {
            let read = DottedName::read(word).unwrap();
            assert_eq!(
                (read.name.ascii.as_str(), read.dots),
                (ascii, dots),
                "{word}"
            );
            assert_eq!(
                DottedName::read(&DottedName::write(&read.name.unicode, dots)),
                Ok(read)
            );
        }
    }

    #[test]
    fn other_marks_and_letters_are_refused() {
        for (word, reason) in [
            ("é", InvalidName::ForeignLetter),
            ("ж_1", InvalidName::ForeignLetter),
            ("ά", InvalidName::ForeignLetter),
            ("L_ẋ", InvalidName::MisplacedDot),
            ("ẍ\u{307}", InvalidName::TooManyDots),
        ] {
            assert_eq!(DottedName::read(word), Err(reason), "{word}");
        }
    }

    #[test]
    fn a_declared_spelling_is_found_by_both_of_its_spellings() {
        let mut aliases = Aliases::default();
        let spelling = Name::new("S_xθ");
        aliases.declare(&spelling, &Name::with_ascii("S_xθ", "S_xt"));
        for word in ["S_xθ", "S_xtheta", "S_xt"] {
            let name = aliases.resolve(Name::new(word));
            assert_eq!(
                (name.ascii.as_str(), name.unicode.as_str()),
                ("S_xt", "S_xθ")
            );
        }
    }
}
