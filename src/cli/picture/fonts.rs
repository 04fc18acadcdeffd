//! The fonts of this machine: none comes with the command.

use std::sync::Arc;

use resvg::usvg::fontdb::{Database, Family, Query};

/// Families without serifs that are found on many machines; the first that is there is taken.
const USUAL: [&str; 6] = [
    "Arial",
    "Helvetica",
    "Liberation Sans",
    "DejaVu Sans",
    "Noto Sans",
    "Open Sans",
];

/// All fonts, with a family for text without serifs.
///
/// # Errors
///
/// In words, if there is no such family.
pub fn installed() -> Result<Arc<Database>, String> {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    with_sans_serif(fonts).map(Arc::new)
}

fn with_sans_serif(mut fonts: Database) -> Result<Database, String> {
    let is_there = |fonts: &Database, family| {
        let families = &[family];
        fonts
            .query(&Query {
                families,
                ..Query::default()
            })
            .is_some()
    };
    if let Some(usual) = USUAL.iter().find(|own| is_there(&fonts, Family::Name(own))) {
        fonts.set_sans_serif_family(*usual);
    }
    match is_there(&fonts, Family::SansSerif) {
        true => Ok(fonts),
        false => Err(format!(
            "no font without serifs is found among the {} of this machine, and text needs one: install {}, or write SVG",
            fonts.len(),
            USUAL[2..5].join(" or "),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn that_no_font_is_found_is_said() {
        let error = with_sans_serif(Database::new()).expect_err("no font");
        assert!(
            error.contains("no font") && error.contains("DejaVu Sans"),
            "{error}"
        );
    }
}
