//! Subscripts: what a label writes as `L_{g}` is set lower and smaller.

/// How far a subscript is set lower, and its size, in units of its line and of itself.
const DROP: f64 = 0.2;
const SIZE: f64 = 0.75;

/// The text of a drawing with its subscripts set.
pub(super) fn set(svg: &str) -> String {
    let mut parts = svg.split("_{");
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        match part.split_once('}') {
            Some((subscript, rest)) => {
                text += &format!(
                    r#"<tspan dy="{:.2}em" font-size="{}%">{subscript}</tspan><tspan dy="-{DROP}em">"#,
                    DROP / SIZE,
                    SIZE * 100.0
                );
                // What follows goes up again, as far as the text goes.
                match rest.split_once('<') {
                    Some((follows, markup)) => text += &format!("{follows}</tspan><{markup}"),
                    None => text += &format!("{rest}</tspan>"),
                }
            }
            None => text += &format!("_{{{part}"),
        }
    }
    text
}

/// How many characters of a text are seen.
pub(super) fn length(text: &str) -> usize {
    text.replace("_{", "").replace('}', "").chars().count()
}

/// A text without its marks of subscripts: `L_g`.
pub(super) fn plain(text: &str) -> String {
    text.replace("_{", "_").replace('}', "")
}
