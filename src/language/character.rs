//! Which characters a document may hold: those that a reader sees, where they stand.

/// Why a character may stand in no document, prose and descriptions included.
pub(crate) fn fault(character: char) -> Option<&'static str> {
    if (' '..='~').contains(&character) {
        return None;
    }
    Some(match character {
        '\n' | '\r' | '\t' => return None,
        '\u{B}' | '\u{C}' | '\u{85}' | '\u{2028}' | '\u{2029}' => {
            "ends a line for some programs and not for others"
        }
        _ if character.is_control() => "is a control character",
        '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => {
            "changes the direction in which the text around it is shown"
        }
        _ if is_invisible(character) => "cannot be seen",
        _ if is_without_meaning(character) => "looks different everywhere, or is not shown",
        _ => return None,
    })
}

/// The characters that Unicode calls formats or ignorable by default, and those that are blank though
/// they are no space.
fn is_invisible(character: char) -> bool {
    matches!(
        character,
        '\u{AD}'
            | '\u{34F}'
            | '\u{600}'..='\u{605}'
            | '\u{6DD}'
            | '\u{70F}'
            | '\u{890}'..='\u{891}'
            | '\u{8E2}'
            | '\u{115F}'..='\u{1160}'
            | '\u{17B4}'..='\u{17B5}'
            | '\u{180B}'..='\u{180F}'
            | '\u{200B}'..='\u{200D}'
            | '\u{2060}'..='\u{206F}'
            | '\u{2800}'
            | '\u{3164}'
            | '\u{FE00}'..='\u{FE0F}'
            | '\u{FEFF}'
            | '\u{FFA0}'
            | '\u{FFF0}'..='\u{FFFC}'
            | '\u{110BD}'
            | '\u{110CD}'
            | '\u{13430}'..='\u{1345F}'
            | '\u{16FE4}'
            | '\u{1BCA0}'..='\u{1BCA3}'
            | '\u{1D159}'
            | '\u{1D173}'..='\u{1D17A}'
            | '\u{E0000}'..='\u{E0FFF}'
    )
}

/// Private and unused places, which every font fills in its own way.
fn is_without_meaning(character: char) -> bool {
    let place = u32::from(character) & 0xFFFF;
    matches!(
        character,
        '\u{E000}'..='\u{F8FF}' | '\u{FDD0}'..='\u{FDEF}' | '\u{F0000}'..
    ) || place >= 0xFFFE
}

/// Whether a character belongs to a script that is written from right to left.
pub(crate) fn is_right_to_left(character: char) -> bool {
    matches!(
        character,
        '\u{590}'..='\u{8FF}'
            | '\u{FB1D}'..='\u{FDFF}'
            | '\u{FE70}'..='\u{FEFE}'
            | '\u{10800}'..='\u{10FFF}'
            | '\u{1E800}'..='\u{1EFFF}'
    )
}

/// Whether a character is of a block of Unicode that the language has a use for: Latin and Greek,
/// their marks, punctuation, and signs of mathematics.
pub(crate) fn is_known(character: char) -> bool {
    matches!(
        character,
        '\t' | ' '..='~'
            | '\u{A0}'..='\u{24F}'
            | '\u{300}'..='\u{3FF}'
            | '\u{1E00}'..='\u{1FFF}'
            | '\u{2000}'..='\u{209F}'
            | '\u{2100}'..='\u{22FF}'
    )
}

/// `U+202E`
pub(crate) fn code(character: char) -> String {
    format!("U+{:04X}", u32::from(character))
}

/// A text as messages quote it, with a sign of as many bytes for whatever may stand in no document.
pub(crate) fn visible(text: &str) -> String {
    let sign = |character: char| match character.len_utf8() {
        _ if fault(character).is_none() => character,
        1 => '?',
        2 => '¿',
        3 => char::REPLACEMENT_CHARACTER,
        _ => '\u{1F533}',
    };
    text.chars().map(sign).collect()
}
