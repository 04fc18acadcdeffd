//! The keys of a case file: what is known, what is not, and on which line.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

use crate::stability::input::{InputError, Place, meant, quoted, shortened};

/// The tables of a case file and their keys.
pub(super) const KEYS: [(&str, &[&str]); 4] = [
    (
        "section",
        &[
            "D",
            "m",
            "r",
            "L_g",
            "alpha_g_deg",
            "L_a",
            "gamma_r_deg",
            "coefficients",
            "interpolation",
        ],
    ),
    (
        "structure",
        &[
            "f_x",
            "f_y",
            "f_theta",
            "zeta_x",
            "zeta_y",
            "zeta_theta",
            "free",
        ],
    ),
    ("wind", &["rho", "U", "aerodynamic_stiffness"]),
    ("sweep", &["alpha_deg", "turn"]),
];

/// How the angles of a sweep are written.
pub(super) const SWEEP: &str =
    "write alpha_deg = { from = 0, to = 180, step = 0.5 }, in degrees; one angle has from = to";

/// The keys of `alpha_deg` in `[sweep]`.
const STEPS: [&str; 3] = ["from", "to", "step"];

/// Names that leave a unit open or mean another one, and what to write instead.
const OTHER_UNITS: [(&str, &str); 11] = [
    ("alpha_g", "alpha_g_deg, in degrees"),
    ("gamma_r", "gamma_r_deg, in degrees"),
    ("alpha", "alpha_deg, in degrees"),
    ("alpha_g_rad", "alpha_g_deg, in degrees"),
    ("gamma_r_rad", "gamma_r_deg, in degrees"),
    ("alpha_rad", "alpha_deg, in degrees"),
    ("omega_x", "f_x, in Hz"),
    ("omega_y", "f_y, in Hz"),
    ("omega_theta", "f_theta, in Hz"),
    ("alpha_0", "turn = \"wind\" in [sweep], which sweeps it"),
    ("theta_0", "turn = \"section\" in [sweep], which sweeps it"),
];

/// The lines of the keys of a case file, from 1.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines(BTreeMap<(String, String), usize>);

impl Lines {
    /// The line of a key, or of its table, as a place in a file.
    pub(super) fn place(&self, file: &str, table: &str, key: &str) -> Place {
        let at = |key: &str| self.0.get(&(table.to_string(), key.to_string()));
        match at(key).or_else(|| at("")) {
            Some(&line) => Place::line(file, line),
            None => Place::file(file),
        }
    }
}

/// Refuses what is no TOML, and tables and keys that are not known.
pub(super) fn check_keys(file: &str, text: &str) -> Result<Lines, InputError> {
    let document = DeTable::parse(text).map_err(|error| not_read(file, text, &error))?;
    let tables: Vec<&str> = KEYS.iter().map(|(table, _)| *table).collect();
    let mut lines = Lines::default();
    for (table, content) in document.get_ref() {
        let (name, line) = (table.get_ref().as_ref(), line_of(text, table.span().start));
        let place = Place::line(file, line);
        let Some((_, keys)) = KEYS.iter().find(|(known, _)| *known == name) else {
            let home = KEYS.iter().find(|(_, keys)| keys.contains(&name));
            return Err(match home {
                Some((home, _)) => InputError::new(
                    place,
                    format!("`{name}` stands outside of its table"),
                    format!("put it below the line [{home}]"),
                ),
                None => InputError::new(
                    place,
                    format!("there is no table [{}]", quoted(name)),
                    meant(name, &tables),
                ),
            });
        };
        let DeValue::Table(content) = content.get_ref() else {
            return Err(InputError::new(
                place,
                format!("`{name}` must be a table"),
                format!("write [{name}] on a line of its own, and its keys below"),
            ));
        };
        lines.0.insert((name.into(), String::new()), line);
        check_table(file, text, name, content, keys, &mut lines)?;
    }
    for (table, _) in KEYS {
        if !lines.0.contains_key(&(table.into(), String::new())) {
            return Err(InputError::new(
                Place::file(file),
                format!("the table [{table}] is missing"),
                "a case file has the tables [section], [structure], [wind] and [sweep]",
            ));
        }
    }
    Ok(lines)
}

fn check_table(
    file: &str,
    text: &str,
    table: &str,
    content: &DeTable<'_>,
    keys: &[&str],
    lines: &mut Lines,
) -> Result<(), InputError> {
    for (key, value) in content {
        let (name, line) = (key.get_ref().as_ref(), line_of(text, key.span().start));
        if !keys.contains(&name) {
            let what = format!("there is no key `{}` in [{table}]", quoted(name));
            let help = match OTHER_UNITS.iter().find(|(other, _)| *other == name) {
                Some((_, instead)) => format!("write {instead}"),
                None => meant(name, keys),
            };
            return Err(InputError::new(Place::line(file, line), what, help));
        }
        lines.0.insert((table.into(), name.into()), line);
        if (table, name) == ("sweep", "alpha_deg") {
            let DeValue::Table(steps) = value.get_ref() else {
                // A list would be read as from, to and step, whatever it means.
                let what = "the angles of the sweep are not given by `from`, `to` and `step`";
                return Err(InputError::new(Place::line(file, line), what, SWEEP));
            };
            // The parts of the sweep have its line.
            check_table(file, text, "sweep.alpha_deg", steps, &STEPS, lines)?;
        }
    }
    Ok(())
}

/// What is wrong with a file that the parser, or serde, refuses.
pub(super) fn not_read(file: &str, text: &str, error: &toml::de::Error) -> InputError {
    let place = match error.span() {
        Some(span) => Place::line(file, line_of(text, span.start)),
        None => Place::file(file),
    };
    let message = error.message().lines().collect::<Vec<_>>().join("; ");
    let help = if message.starts_with("missing field") {
        "add it below this line"
    } else if message.starts_with("unknown variant") {
        "write one of these, in quotation marks"
    } else if message.ends_with("expected a boolean") {
        "write true or false, without quotation marks"
    } else {
        "write `name = value` below [table]: text in quotation marks, numbers with a decimal point and without \
         a unit"
    };
    InputError::new(place, shortened(&message), help)
}

/// The line of a byte, from 1.
fn line_of(text: &str, byte: usize) -> usize {
    1 + text.bytes().take(byte).filter(|&own| own == b'\n').count()
}
