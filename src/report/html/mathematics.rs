//! Formulas as MathML.

use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

use super::escape;
use crate::language::notation::Notation;
use crate::language::syntax::Expression;
use crate::report::phrase::Phrase;

/// Shorter formulas are never broken.
const LONGEST_UNBROKEN: usize = 40;
/// The signs at which a line may be broken, as the LaTeX notation writes them between operands; a formula
/// goes on with the sign.
const BREAKS: [&str; 10] = [
    " + ",
    " - ",
    " = ",
    r" \coloneqq ",
    r" \approx ",
    r" \cdot ",
    " < ",
    " > ",
    r" \le ",
    r" \ge ",
];
/// Behind a matrix the sign of a product is a space.
const BEHIND_A_MATRIX: &str = r"\end{bmatrix}\,";

/// A formula in LaTeX as MathML. A browser does not break a formula: a long one becomes several, one
/// behind the other, which go on the next line where they have to.
pub fn formula(latex: &str) -> String {
    let pieces = pieces(latex);
    let written: Option<Vec<String>> = pieces.iter().map(|piece| mathml(piece)).collect();
    match written {
        Some(written) => written.join("<wbr/>"),
        // What cannot be set is shown as it is written.
        None => format!("<code>{}</code>", escape(latex)),
    }
}

/// An expression as MathML.
pub fn expression(expression: &Expression) -> String {
    formula(&Notation::Latex.expression(expression))
}

/// Words and formulas as HTML.
pub fn phrase(phrase: &Phrase) -> String {
    phrase.render(escape, formula)
}

/// One formula that is not broken; `None` if its LaTeX is not understood.
fn mathml(latex: &str) -> Option<String> {
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let events = events.ok()?.into_iter();
    let mut written = String::new();
    let certain = events.map(Ok::<_, std::convert::Infallible>);
    push_mathml(&mut written, certain, RenderConfig::default()).ok()?;
    // The library leaves the sign of a relation as it is, forgets a space, counts the space before cos²
    // to its base, and makes an accent an identifier.
    let written = written.replace("><<", ">&lt;<");
    let written = written.replace(r#""minsize"#, r#"" minsize"#);
    let written = written.replace(
        r#"<msup><mspace width="0.1667em" />"#,
        r#"<mspace width="0.1667em" /><msup>"#,
    );
    let written = ["˙", "¨"].iter().fold(written, |written, accent| {
        let (own, better) = (
            format!("<mi>{accent}</mi></mover>"),
            format!(r#"<mo stretchy="false">{accent}</mo></mover>"#),
        );
        written.replace(&own, &better)
    });
    Some(together(&together(&written, UPRIGHT), SLANTED))
}

/// How the library begins an upright letter, and how a word of such letters begins.
const UPRIGHT: (&str, &str) = (r#"<mi mathvariant="normal">"#, "<mi>");
/// The same of a slanted one, which has a code of its own.
const SLANTED: (&str, &str) = ("<mi>", r#"<mi class="word">"#);

/// The letters of a word in one element, as a browser sets and reads a word.
fn together(mathml: &str, (letter, word): (&str, &str)) -> String {
    let mut written = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(start) = rest.find(letter) {
        let mut end = start;
        let mut letters = String::new();
        while let Some(own) = one_letter(&rest[end..], letter, word != UPRIGHT.1) {
            letters.push(own.0);
            end += own.1;
        }
        if letters.chars().count() > 1 {
            written += &rest[..start];
            written += &format!("{word}{letters}</mi>");
            rest = &rest[end..];
        } else {
            let end = end.max(start + letter.len());
            written += &rest[..end];
            rest = &rest[end..];
        }
    }
    written + rest
}

/// The letter that a text begins with as an element of its own, and the length of that.
fn one_letter(text: &str, opening: &str, is_slanted: bool) -> Option<(char, usize)> {
    let inner = text.strip_prefix(opening)?;
    let letter = inner.chars().next()?;
    inner[letter.len_utf8()..].strip_prefix("</mi>")?;
    let length = opening.len() + letter.len_utf8() + "</mi>".len();
    if is_slanted {
        return Some((plain(letter)?, length));
    }
    Some((letter, length))
}

/// The Latin letter of a mathematical italic one.
fn plain(letter: char) -> Option<char> {
    let code = u32::from(letter);
    let (first, capital) = match code {
        // The place of the italic h is taken by Planck's constant.
        0x210E => return Some('h'),
        0x1D434..=0x1D44D => (0x1D434, 'A'),
        0x1D44E..=0x1D467 => (0x1D44E, 'a'),
        _ => return None,
    };
    char::from_u32(u32::from(capital) + code - first)
}

/// The parts of a formula between which a line may be broken; each but the first begins with a sign.
fn pieces(latex: &str) -> Vec<String> {
    if latex.len() <= LONGEST_UNBROKEN {
        return vec![latex.to_owned()];
    }
    let mut pieces = Vec::new();
    let (mut start, mut depth) = (0, 0_usize);
    for (place, _) in latex.char_indices() {
        let rest = &latex[place..];
        let is_escaped = latex[..place].ends_with('\\');
        if rest.starts_with('{') && !is_escaped
            || rest.starts_with(r"\left")
            || rest.starts_with(r"\begin")
        {
            depth += 1;
        } else if rest.starts_with('}') && !is_escaped
            || rest.starts_with(r"\right")
            || rest.starts_with(r"\end")
        {
            depth = depth.saturating_sub(1);
        }
        let sign = BREAKS.iter().find(|sign| rest.starts_with(**sign));
        let is_behind = rest.starts_with(r"\,") && latex[..place + 2].ends_with(BEHIND_A_MATRIX);
        if depth == 0 && place > start && (sign.is_some() || is_behind) {
            pieces.push(piece(&latex[start..place], start));
            start = place;
        }
    }
    pieces.push(piece(&latex[start..], start));
    pieces
}

/// Behind an empty operand a sign has the space of one between operands.
fn piece(part: &str, start: usize) -> String {
    match start {
        0 => part.to_owned(),
        _ => format!("{{}}{part}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_formulas_are_broken_at_signs_outside_of_brackets() {
        let sum = format!(
            r"{} = a + \left(b + c\right) - \frac{{d + e}}{{f}}",
            "x".repeat(40)
        );
        let rest = [
            "{} = a",
            r"{} + \left(b + c\right)",
            r"{} - \frac{d + e}{f}",
        ];
        assert_eq!(pieces(&sum)[1..], rest);
        assert_eq!(pieces("a + b"), ["a + b"]);
        let matrices =
            r"\begin{bmatrix} a + b & c \end{bmatrix}\,\begin{bmatrix} d \\ e \end{bmatrix}";
        assert_eq!(pieces(matrices).len(), 2);
    }

    #[test]
    fn words_are_one_element() {
        for (latex, expected) in [
            (r"\mathit{rest}", r#"<mi class="word">rest</mi>"#),
            (r"\mathit{the}", r#"<mi class="word">the</mi>"#),
            (r"a_{\mathrm{xy}}", "<mi>xy</mi>"),
            (r"\mathrm{d}t", r#"<mi mathvariant="normal">d</mi>"#),
            ("a\\,b", "<mi>a</mi>"),
        ] {
            let set = formula(latex);
            assert!(set.contains(expected), "{latex}: {set}");
        }
    }

    #[test]
    fn what_is_not_understood_is_shown_as_it_is_written() {
        assert_eq!(formula(r"\nothing<"), r"<code>\nothing&lt;</code>");
        let set = formula("a < b");
        assert!(set.starts_with("<math") && set.contains("&lt;"), "{set}");
    }
}
