//! Forms that TeX can break: it breaks a formula at signs between operands, but not within
//! `\left…\right`, `\frac` or `\sqrt`.

/// How many signs next to each other still fit where no line can be broken.
const MOST_UNBROKEN: usize = 50;
/// Commands that are no signs of their own.
const UNSEEN: [&str; 9] = [
    "left", "right", "frac", "mathrm", "mathit", "mathsf", "dot", "ddot", "sqrt",
];

/// `(a)`, as tall as what is in it if that is short.
pub(super) fn brackets(inner: &str) -> String {
    if is_long(inner) {
        format!("({inner})")
    } else {
        format!(r"\left({inner}\right)")
    }
}

/// `a/b`; `factor` is a, in brackets where a factor needs them.
pub(super) fn quotient(numerator: &str, factor: &str, denominator: &str) -> String {
    match (is_long(numerator), is_long(denominator)) {
        (false, false) => format!(r"\frac{{{numerator}}}{{{denominator}}}"),
        (true, false) => format!(r"\frac{{1}}{{{denominator}}} \cdot {factor}"),
        (_, true) => format!(r"{factor} \cdot ({denominator})^{{-1}}"),
    }
}

/// `√a`
pub(super) fn root(square: &str) -> String {
    if is_long(square) {
        format!("({square})^{{1/2}}")
    } else {
        format!(r"\sqrt{{{square}}}")
    }
}

/// `a` where the place says.
pub(super) fn taken_at(inner: &str, place: &str) -> String {
    if is_long(inner) {
        format!(r"({inner})\bigr|_{{{place}}}")
    } else {
        format!(r"\left.{inner}\right|_{{{place}}}")
    }
}

/// Whether a formula is longer than what may stand unbroken.
pub(super) fn is_long(formula: &str) -> bool {
    // No sign takes less than a byte.
    formula.len() > MOST_UNBROKEN && signs(formula) > MOST_UNBROKEN
}

/// How many letters, digits and other signs a formula shows, one behind the other.
fn signs(formula: &str) -> usize {
    let mut rest = formula;
    let mut count = 0;
    while let Some(first) = rest.chars().next() {
        rest = &rest[first.len_utf8()..];
        match first {
            '\\' => {
                let letters = rest.find(|letter: char| !letter.is_ascii_alphabetic());
                let (command, after) = rest.split_at(letters.unwrap_or(rest.len()));
                rest = match command {
                    "" => after.get(1..).unwrap_or_default(),
                    _ => after,
                };
                count += usize::from(!command.is_empty() && !UNSEEN.contains(&command));
            }
            '{' | '}' | '^' | '_' | ' ' => {}
            _ => count += 1,
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_seen_counts() {
        for (formula, expected) in [
            (r"\frac{a}{\omega_{n}^{2}}", 4),
            (r"a\,\dot{x} + \left(b\right)", 6),
            ("", 0),
        ] {
            assert_eq!(signs(formula), expected, "{formula}");
        }
    }

    #[test]
    fn what_is_long_can_be_broken() {
        let long = ["a"; 40].join(" + ");
        for written in [
            brackets(&long),
            quotient(&long, "(a)", "b"),
            quotient("b", "b", &long),
            root(&long),
            taken_at(&long, "x = 0"),
        ] {
            let is_open = !written.contains(r"\left") && !written.contains(r"\sqrt");
            assert!(is_open && !written.contains(r"\frac{a"), "{written}");
        }
        assert_eq!(quotient("a", "a", "b"), r"\frac{a}{b}");
        assert_eq!(root("a"), r"\sqrt{a}");
    }
}
