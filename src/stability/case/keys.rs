//! The keys of a case file: what is known, what is not, what is missing, and on which line.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

use crate::stability::coefficient_table::KEYS;
use crate::stability::coordinate::FreeCoordinates;
use crate::stability::input::{InputError, Place, meant, quoted, shortened};
use crate::stability::quantity::{Key, Quantity, Source, Unit};

/// The tables of a case file.
const TABLES: [&str; 4] = ["section", "structure", "wind", "sweep"];

/// How the angles of a sweep are written.
pub(super) const SWEEP: &str =
    "write alpha_deg = { from = 0, to = 180, step = 0.5 }, in degrees; one angle has from = to";

/// How reference lengths are written.
pub(super) const REFERENCE: &str = "write reference = { CD = 0.05, CL = 0.3, CM = [0.3, 0.3] }: lengths in m, for CM the two whose product it stands over; \
     what is left out has D";

/// How columns are named.
const COLUMNS: &str =
    "write columns = { alpha_deg = \"its name\", CL = \"its name\" } for those with unusual names";

/// The keys of `alpha_deg` in `[sweep]`.
const STEPS: [&str; 3] = ["from", "to", "step"];

/// The keys that are no quantities.
const OTHERS: [Key; 12] = [
    Key::new("section", "coefficients", Some("the file of the table")),
    Key::new(
        "section",
        "interpolation",
        Some("\"cubic\", \"linear\" or, for what was measured, \"smooth\""),
    ),
    Key::new("section", "columns", None),
    Key::new("section", "mirror", None),
    Key::new("section", "slopes", None),
    Key::new("section", "errors", None),
    Key::new("section", "reference", None),
    Key::new("structure", "free", None),
    Key::new("wind", "aerodynamic_stiffness", None),
    Key::new("wind", "mean_twist", None),
    Key::new(
        "sweep",
        "alpha_deg",
        Some("{ from = 0, to = 180, step = 0.5 }"),
    ),
    Key::new(
        "sweep",
        "turn",
        Some("\"section\" or \"wind\", what turns with alpha"),
    ),
];

/// All keys, each table's in their order.
fn keys() -> impl Iterator<Item = Key> {
    let quantities = Quantity::ALL.iter().filter_map(|own| own.key());
    quantities.chain(OTHERS)
}

/// The keys that are needed with these free coordinates, in their order: a frequency and a ratio for each coordinate.
fn needed(free: FreeCoordinates) -> Vec<Key> {
    let is_needed = |own: &Quantity| own.acts(free);
    let mut quantities: Vec<_> = Quantity::ALL.iter().copied().filter(is_needed).collect();
    quantities.sort_by_key(|own| own.row().owner);
    let keys = quantities.into_iter().filter_map(Quantity::key);
    let mut keys: Vec<Key> = keys.chain(OTHERS).collect();
    keys.retain(|key| key.holds.is_some());
    keys.sort_by_key(|key| TABLES.iter().position(|table| *table == key.table));
    keys
}

/// What to write instead of a name that leaves a unit open or means another one.
fn instead(name: &str) -> Option<String> {
    let named = |name: &str| Quantity::named(name).map(|own| (own.row().unit, own.row().source));
    let angle = || named(name.strip_suffix("_rad")?);
    let in_degrees = angle().filter(|own| matches!(own, (Unit::Degree, Source::Key(_))));
    match named(name).or(in_degrees) {
        Some((Unit::Degree, Source::Key(key))) => Some(format!("{}, in degrees", key.name)),
        Some((Unit::Hertz, Source::Key(key))) => Some(format!("{}, in Hz", key.name)),
        Some((_, Source::Sweep(turn))) => {
            Some(format!("turn = \"{turn}\" in [sweep], which sweeps it"))
        }
        _ if matches!(name, "alpha" | "alpha_rad") => Some("alpha_deg, in degrees".into()),
        _ => None,
    }
}

/// The lines of the keys of a case file, from 1.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines(BTreeMap<(String, String), usize>);

impl Lines {
    /// The line of a key; that of a table has no name.
    fn line(&self, table: &str, key: &str) -> Option<usize> {
        self.0.get(&(table.to_string(), key.to_string())).copied()
    }

    /// The line of a key, or of its table, as a place in a file.
    pub(super) fn place(&self, file: &str, table: &str, key: &str) -> Place {
        let line = self.line(table, key).or_else(|| self.line(table, ""));
        line.map_or_else(|| Place::file(file), |line| Place::line(file, line))
    }

    /// Refuses a file in which keys are missing, with all of them.
    pub(super) fn check_needed(&self, file: &str, free: FreeCoordinates) -> Result<(), InputError> {
        let mut missing = needed(free);
        missing.retain(|key| self.line(key.table, key.name).is_none());
        let Some(first) = missing.first() else {
            return Ok(());
        };
        let lacks = |keys: &[Key]| {
            let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
            format!("[{}] lacks {}", keys[0].table, names.join(", "))
        };
        let tables = missing.chunk_by(|one, other| one.table == other.table);
        let what = tables.map(lacks).collect::<Vec<_>>().join("; ");
        let holds = |key: &Key| format!("{}, {}", key.name, key.holds.unwrap_or_default());
        let help = missing.iter().map(holds).collect::<Vec<_>>().join("; ");
        let place = self.place(file, first.table, "");
        Err(InputError::new(place, what, format!("give {help}")))
    }
}

/// Refuses tables and keys that are not known.
pub(super) fn check_keys(
    file: &str,
    text: &str,
    document: &DeTable<'_>,
) -> Result<Lines, InputError> {
    let mut lines = Lines::default();
    for (table, content) in document {
        let (name, line) = (table.get_ref().as_ref(), line_of(text, table.span().start));
        let place = Place::line(file, line);
        if !TABLES.contains(&name) {
            return Err(no_table(place, name));
        }
        let DeValue::Table(content) = content.get_ref() else {
            return Err(InputError::new(
                place,
                format!("`{name}` must be a table"),
                format!("write [{name}] on a line of its own, and its keys below"),
            ));
        };
        lines.0.insert((name.into(), String::new()), line);
        let keys = keys().filter(|key| key.table == name).map(|key| key.name);
        let keys: Vec<&str> = keys.collect();
        check_table(file, text, name, content, &keys, &mut lines)?;
    }
    match TABLES.iter().find(|table| lines.line(table, "").is_none()) {
        None => Ok(lines),
        Some(table) => Err(InputError::new(
            Place::file(file),
            format!("the table [{table}] is missing"),
            "a case file has the tables [section], [structure], [wind] and [sweep]",
        )),
    }
}

/// A table that is not known, or a key outside of its table.
fn no_table(place: Place, name: &str) -> InputError {
    match keys().find(|key| key.name == name) {
        Some(key) => InputError::new(
            place,
            format!("`{name}` stands outside of its table"),
            format!("put it below the line [{}]", key.table),
        ),
        None => InputError::new(
            place,
            format!("there is no table [{}]", quoted(name)),
            meant(name, &TABLES),
        ),
    }
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
            let help = match instead(name) {
                Some(instead) => format!("write {instead}"),
                None => meant(name, keys),
            };
            return Err(InputError::new(Place::line(file, line), what, help));
        }
        lines.0.insert((table.into(), name.into()), line);
        if (table, name) == ("section", "columns") {
            let DeValue::Table(columns) = value.get_ref() else {
                let what = "the columns of the table are not given by what they mean";
                return Err(InputError::new(Place::line(file, line), what, COLUMNS));
            };
            check_table(file, text, "section.columns", columns, &KEYS, lines)?;
        }
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
    if let Some((what, help)) = other_kind(&message) {
        return InputError::new(place, shortened(&what), help);
    }
    let help = if message.ends_with("expected an array of length 2") {
        REFERENCE
    } else if message.starts_with("missing field") {
        "add it below this line"
    } else if message.starts_with("unknown field") {
        "write one of these"
    } else if message.starts_with("unknown variant") {
        "write one of these, in quotation marks"
    } else {
        "write `name = value` below [table]: text in quotation marks, numbers with a decimal point and without \
         a unit"
    };
    InputError::new(place, shortened(&message), help)
}

/// What serde calls a kind of value, what a person calls it, and how it is written.
const KINDS: [[&str; 3]; 7] = [
    [
        "f64",
        "a number",
        "write a number without quotation marks and without a unit, such as 3.5",
    ],
    [
        "a boolean",
        "true or false",
        "write true or false, without quotation marks",
    ],
    ["a string", "text", "write text in quotation marks"],
    [
        "a sequence",
        "a list",
        "write a list, such as [\"x\", \"y\"]",
    ],
    [
        "struct Errors",
        "a table of errors",
        "write errors = { CD = 0.01, CL = 0.02, CM = 0.005 }",
    ],
    ["struct Reference", "a table of lengths", REFERENCE],
    ["struct Steps", "the steps of the sweep", SWEEP],
];

/// A value of another kind than is meant, and how that is written.
fn other_kind(message: &str) -> Option<(String, &'static str)> {
    let (found, expected) = message
        .strip_prefix("invalid type: ")?
        .split_once(", expected ")?;
    let [_, meant, help] = KINDS.iter().find(|[name, ..]| *name == expected)?;
    Some((format!("{found} stands where {meant} is meant"), help))
}

/// The line of a byte, from 1.
fn line_of(text: &str, byte: usize) -> usize {
    1 + text.bytes().take(byte).filter(|&own| own == b'\n').count()
}
