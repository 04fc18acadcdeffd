//! What other languages and papers write, and how it is written here: messages say so.

use super::built_in::is_built_in;
use super::diagnostic::Diagnostic;
use super::syntax::{Span, Spanned};
use super::unit::Unit;

/// A mistake, with the way it is written here where something else is known to be meant.
pub(crate) fn cured(diagnostic: Diagnostic, text: &str) -> Diagnostic {
    let Some(line) = Line::around(text, &diagnostic.span) else {
        return diagnostic;
    };
    match SPELLINGS.iter().find_map(|spelling| spelling(&line)) {
        Some(help) => diagnostic.with_help(help),
        None => diagnostic,
    }
}

/// The line in which a mistake is: what stands before it, what is marked, and what stands behind it.
struct Line<'a> {
    before: &'a str,
    marked: &'a str,
    behind: &'a str,
}

impl<'a> Line<'a> {
    fn around(text: &'a str, span: &Span) -> Option<Self> {
        let (before, rest) = (text.get(..span.start)?, text.get(span.end..)?);
        Some(Line {
            before: before.rsplit('\n').next()?,
            marked: text.get(span.clone())?,
            behind: rest.split('\n').next()?,
        })
    }

    /// The last word before the mark, without blanks between.
    fn word_before(&self) -> &'a str {
        let before = self.before.trim_end();
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
        before
            .rsplit(|letter| !is_part(letter))
            .next()
            .unwrap_or("")
    }
}

/// Says how it is written here, if a line has one spelling of elsewhere at its mark.
type Spelling = fn(&Line) -> Option<String>;

/// The first that is found counts.
const SPELLINGS: [Spelling; 13] = [
    comment,
    end,
    approximation,
    transposition,
    product_of_units,
    unit_of_number,
    loose_replacement,
    assumed_equation,
    quotient_of_differentials,
    power_of_function,
    function_without_brackets,
    inequation,
    degrees,
];

fn comment(line: &Line) -> Option<String> {
    let is_slashed = line.marked.contains("//")
        || line.marked.starts_with('/') && line.behind.starts_with('/')
        || line.marked == "/" && line.before.ends_with('/');
    (is_slashed || line.marked.starts_with('%'))
        .then(|| "a comment begins with `#` and goes to the end of the line".to_string())
}

fn end(line: &Line) -> Option<String> {
    let is_last = line.behind.trim().is_empty();
    (is_last && line.marked.ends_with(';'))
        .then(|| "a statement ends with its line: leave `;` out".to_string())
}

fn approximation(line: &Line) -> Option<String> {
    let is_fence = line.before.trim().is_empty() && line.behind.starts_with("~~");
    let is_meant = line.marked.starts_with('~') || ["∼", "≃", "≅"].contains(&line.marked);
    (is_meant && !is_fence).then(|| {
        "what is equal up to an order is written `approximate (1): a ≈ b to order 1 in x`"
            .to_string()
    })
}

fn transposition(line: &Line) -> Option<String> {
    let is_letter = |text: &str| {
        let mut letters = text.chars();
        letters.next() == Some('T')
            && !letters
                .next()
                .is_some_and(|next| next.is_alphanumeric() || next == '_')
    };
    let is_method = line.marked == "." && is_letter(line.behind);
    let is_output = line.marked.ends_with(".T");
    let is_power = line.marked == "T" && line.before.trim_end().ends_with('^');
    let is_prime = line.marked == "'" && line.before.ends_with([']', ')']);
    (is_method || is_output || is_power || is_prime)
        .then(|| "a transposed matrix is written `transpose(A)`".to_string())
}

fn product_of_units(line: &Line) -> Option<String> {
    let is_between = |text: &str| text.starts_with(|own: char| own.is_ascii_alphabetic());
    let is_unit = unit(line.word_before()).is_some();
    (line.marked == "." && is_unit && is_between(line.behind))
        .then(|| "a product of units is written with `*` or `·`: `N*s/m`".to_string())
}

fn unit_of_number(line: &Line) -> Option<String> {
    let before = line.before.trim_end();
    let number = before
        .rsplit(|own: char| !own.is_ascii_digit() && own != '.')
        .next()?;
    let rest = before.strip_suffix(number)?;
    // `x_1 m` is a name, and `to order 1 s` lacks a word.
    let is_other = rest.ends_with(|own: char| own.is_alphanumeric() || own == '_')
        || rest.trim_end().ends_with("order");
    let is_number = number.starts_with(|own: char| own.is_ascii_digit()) && !is_other;
    (is_number && unit(line.marked).is_some()).then(|| {
        let name = line.marked;
        format!(
            "numbers have no units: declare a quantity, as `parameter a : {name}`, and give it a number \
             with `domain`, `--set` or `at (a = {number})`; a product is written `{number}*{name}`"
        )
    })
}

fn unit(text: &str) -> Option<Unit> {
    let text = Spanned {
        value: text.to_string(),
        span: 0..0,
    };
    let is_name = text.value.starts_with(|own: char| own.is_alphabetic());
    is_name.then(|| Unit::parse(&text).ok()).flatten()
}

fn loose_replacement(line: &Line) -> Option<String> {
    let before = line.before.trim_end();
    let name = line.word_before();
    let rest = before.strip_suffix(name)?.trim_end();
    let is_loose = rest.ends_with(" at") && !name.is_empty() && line.marked == "=";
    is_loose.then(|| format!("replacements stand in brackets: `at ({name} = …)`"))
}

fn assumed_equation(line: &Line) -> Option<String> {
    let is_assumption = line.before.trim_start().starts_with("assume ");
    (is_assumption && line.marked == "=").then(|| {
        "only inequalities are assumed: define one side by the other, `a := b`, or replace it where \
         it counts, `at (a = b)`"
            .to_string()
    })
}

fn quotient_of_differentials(line: &Line) -> Option<String> {
    let variable = line
        .marked
        .strip_prefix('d')
        .or(line.marked.strip_prefix('∂'))?;
    let by = line.behind.trim_start().strip_prefix('/')?.trim_start();
    let by = by.strip_prefix('d').or(by.strip_prefix('∂'))?;
    // `damping/density` is no such quotient.
    let is_short = |own: &str| {
        let mut letters = own.chars();
        letters.next().is_none_or(char::is_alphabetic)
            && letters.next().is_none_or(|next| !next.is_alphanumeric())
    };
    (is_short(variable) && is_short(by)).then(|| match by.starts_with('t') {
        true => "a derivative by time is written `dt(y)` or `ẏ`".to_string(),
        false => "a derivative by a name is written `d(f, x)`".to_string(),
    })
}

fn power_of_function(line: &Line) -> Option<String> {
    let before = [line.before, line.marked].concat();
    let before = match line.marked.starts_with('(') {
        true => line.before,
        false => &before,
    };
    let (head, power) = before.trim_end().rsplit_once('^')?;
    let is_power = !power.is_empty() && power.chars().all(|own| own.is_ascii_digit());
    let function = head.rsplit(|own: char| !own.is_alphabetic()).next()?;
    let is_function = matches!(function, "sin" | "cos" | "tan" | "cot");
    (is_power && is_function)
        .then(|| format!("the power of a sine stands behind its brackets: `{function}(x)^{power}`"))
}

fn function_without_brackets(line: &Line) -> Option<String> {
    let function = line.word_before();
    let is_argument = line.marked.starts_with(char::is_alphanumeric);
    let are_apart = line.before.ends_with(char::is_whitespace);
    (is_built_in(function) && is_argument && are_apart).then(|| {
        let argument = line.marked;
        format!("a function is called with brackets: `{function}({argument})`")
    })
}

fn inequation(line: &Line) -> Option<String> {
    ["!=", "≠", "<>", "!"]
        .contains(&line.marked)
        .then(|| "that two sides are not always equal is written `refute (1): a == b`".to_string())
}

fn degrees(line: &Line) -> Option<String> {
    let is_angle = line.before.ends_with(|own: char| own.is_ascii_digit());
    (line.marked == "°" && is_angle).then(|| {
        "angles are in radians here; on the command line and in case files names with `_deg` are in degrees"
            .to_string()
    })
}
