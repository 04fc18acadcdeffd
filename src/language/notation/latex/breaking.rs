//! Forms that TeX can break: it breaks a formula at signs between operands, but not within
//! `\left…\right`, `\frac` or `\sqrt`.

/// How many signs next to each other still fit where no line can be broken.
const MOST_UNBROKEN: usize = 50;
/// Commands that are no signs of their own.
const UNSEEN: [&str; 9] = [
    "left", "right", "frac", "mathrm", "mathit", "mathsf", "dot", "ddot", "sqrt",
];

/// `(a)`, as tall as what is in it.
pub(super) fn brackets(inner: &str) -> String {
    if is_long(inner) {
        tall_brackets(inner)
    } else {
        format!(r"\left({inner}\right)")
    }
}

/// `(a)` that can be broken: as tall as what can stand in it.
fn tall_brackets(inner: &str) -> String {
    match size(inner) {
        "" => format!("({inner})"),
        size => format!(r"\{size}l({inner}\{size}r)"),
    }
}

/// The size of a bracket around a formula that can be broken.
fn size(inner: &str) -> &'static str {
    match inner {
        _ if inner.contains(MATRIX[0]) => "Bigg",
        _ if inner.contains(r"\frac") => "Big",
        _ => "",
    }
}

/// `a/b`; `factor` is a, in brackets where a factor needs them.
pub(super) fn quotient(numerator: &str, factor: &str, denominator: &str) -> String {
    match (is_long(numerator), is_long(denominator)) {
        (false, false) => format!(r"\frac{{{numerator}}}{{{denominator}}}"),
        (true, false) => format!(r"\frac{{1}}{{{denominator}}} \cdot {factor}"),
        (_, true) => format!(r"{factor} \cdot {}^{{-1}}", tall_brackets(denominator)),
    }
}

/// `√a`
pub(super) fn root(square: &str) -> String {
    if is_long(square) {
        tall_brackets(square) + "^{1/2}"
    } else {
        format!(r"\sqrt{{{square}}}")
    }
}

/// `a` where the place says.
pub(super) fn taken_at(inner: &str, place: &str) -> String {
    if is_long(inner) {
        let size = match size(inner) {
            "" => "big",
            size => size,
        };
        format!(r"{}\{size}r|_{{{place}}}", tall_brackets(inner))
    } else {
        format!(r"\left.{inner}\right|_{{{place}}}")
    }
}

/// Whether a formula is longer than what may stand unbroken.
pub(super) fn is_long(formula: &str) -> bool {
    // No sign takes less than a byte.
    formula.len() > MOST_UNBROKEN && signs(formula) > MOST_UNBROKEN
}

/// How many letters, digits and other signs a formula shows, one behind the other; of a matrix its longest row.
fn signs(formula: &str) -> usize {
    let (mut rest, mut count) = (formula, 0);
    while let Some((before, inner)) = rest.split_once(MATRIX[0]) {
        let end = end_of_matrix(inner);
        let rows = rows(&inner[..end]).into_iter().map(signs);
        count += signs_in_line(before) + rows.max().unwrap_or_default();
        rest = inner[end..].strip_prefix(MATRIX[1]).unwrap_or_default();
    }
    count + signs_in_line(rest)
}

/// How a matrix begins and ends.
const MATRIX: [&str; 2] = [r"\begin{bmatrix}", r"\end{bmatrix}"];

/// Where the matrix ends that has begun before.
fn end_of_matrix(rest: &str) -> usize {
    let mut depth = 1;
    for (place, _) in rest.match_indices('\\') {
        if rest[place..].starts_with(MATRIX[0]) {
            depth += 1;
        } else if rest[place..].starts_with(MATRIX[1]) {
            depth -= 1;
        }
        if depth == 0 {
            return place;
        }
    }
    rest.len()
}

/// The rows of a matrix, but for those of matrices in it.
fn rows(entries: &str) -> Vec<&str> {
    let (mut rows, mut start, mut depth) = (Vec::new(), 0, 0_usize);
    for (place, _) in entries.match_indices('\\') {
        let rest = &entries[place..];
        if rest.starts_with(MATRIX[0]) {
            depth += 1;
        } else if rest.starts_with(MATRIX[1]) {
            depth = depth.saturating_sub(1);
        } else if depth == 0 && rest.starts_with(r"\\ ") {
            rows.push(&entries[start..place]);
            start = place + 2;
        }
    }
    rows.push(&entries[start..]);
    rows
}

fn signs_in_line(formula: &str) -> usize {
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
            '{' | '}' | '^' | '_' | ' ' | '&' => {}
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
            (
                r"a\begin{bmatrix} b & c + d \\ \begin{bmatrix} e \\ f \end{bmatrix} & g \end{bmatrix} h",
                6,
            ),
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
        let tall = format!(r"{long} + \frac{{a}}{{b}}");
        assert_eq!(brackets(&tall), format!(r"\Bigl({tall}\Bigr)"));
        let matrix = format!(r"{long} \begin{{bmatrix}} a \end{{bmatrix}}");
        assert!(taken_at(&matrix, "b").ends_with(r"\Biggr)\Biggr|_{b}"));
        let rows = [r"\begin{bmatrix} a + b + c"; 1].concat()
            + &r" \\ a + b + c".repeat(30)
            + r" \end{bmatrix}";
        assert_eq!(brackets(&rows), format!(r"\left({rows}\right)"));
        assert_eq!(quotient("a", "a", "b"), r"\frac{a}{b}");
        assert_eq!(root("a"), r"\sqrt{a}");
    }
}
