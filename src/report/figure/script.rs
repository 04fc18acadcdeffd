//! Subscripts and exponents: what a label writes as `L_{g}` is set lower and smaller, as `10^{3}` higher.

/// How far a subscript is set lower and an exponent higher, and their size, in units of their line and of itself.
const DROP: f64 = 0.2;
const RISE: f64 = 0.4;
const SIZE: f64 = 0.75;

/// How they begin.
const BEGINNINGS: [&str; 2] = ["_{", "^{"];

/// The text of a drawing with its subscripts and exponents set.
pub(super) fn set(svg: &str) -> String {
    let svg = set_one_kind(svg, BEGINNINGS[0], DROP);
    set_one_kind(&svg, BEGINNINGS[1], -RISE)
}

fn set_one_kind(svg: &str, beginning: &str, drop: f64) -> String {
    let mut parts = svg.split(beginning);
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        match part.split_once('}') {
            Some((script, rest)) => {
                text += &format!(
                    r#"<tspan dy="{:.2}em" font-size="{}%">{script}</tspan><tspan dy="{}em">"#,
                    drop / SIZE,
                    SIZE * 100.0,
                    -drop
                );
                // What follows goes back to the line, as far as the text goes.
                match rest.split_once('<') {
                    Some((follows, markup)) => text += &format!("{follows}</tspan><{markup}"),
                    None => text += &format!("{rest}</tspan>"),
                }
            }
            None => text += &format!("{beginning}{part}"),
        }
    }
    text
}

/// How many characters of a text are seen.
pub(super) fn length(text: &str) -> usize {
    let seen = BEGINNINGS
        .iter()
        .fold(text.to_owned(), |text, own| text.replace(own, ""));
    seen.replace('}', "").chars().count()
}

/// A text without its marks: `L_g`, `10^3`.
pub(super) fn plain(text: &str) -> String {
    let plain = text.replace("_{", "_").replace("^{", "^");
    plain.replace('}', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_leave_the_line_and_come_back() {
        assert_eq!(
            set("<text>10^{3}</text>"),
            r#"<text>10<tspan dy="-0.53em" font-size="75%">3</tspan><tspan dy="0.4em"></tspan></text>"#
        );
        assert_eq!(length("δ_{g} = 10^{−3}"), 9);
        assert_eq!(plain("L_{g}/10^{3}"), "L_g/10^3");
    }
}
