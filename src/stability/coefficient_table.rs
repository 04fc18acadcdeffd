//! A table of force coefficients against the angle of attack, as a wind tunnel gives it.

pub(super) mod angle;
mod cells;
pub(super) mod column;
mod heading;
mod meaning;
mod mirror;
mod names;
mod oddity;
pub mod reading;
pub mod reference;
pub mod remarks;
mod row;
pub mod scatter;
mod sheet;

use self::angle::{ONE_ANGLE, WHOLE};
use self::column::Column;
use self::heading::Columns;
use self::meaning::Unit;
use self::mirror::{Mirror, put_ends_on_axes};
use self::names::Names;
use self::reading::Reading;
use self::reference::Reference;
use self::sheet::Sheet;
use super::input::{InputError, Place, Remark, quoted};

pub(super) use self::names::KEYS;
pub use self::row::Row;

/// A coefficient table: at least four rows, finite, the angles increasing, within 360°.
///
/// It goes round the circle if its last angle is its first one again, or one step short of it. Where they are a
/// hundredth of their steps apart round the circle, as where angles were rounded, they are read as one angle.
///
/// ```
/// use sextic::stability::coefficient_table::CoefficientTable;
///
/// let text = "alpha_deg;CD;CL;CM\r\n0;1,2;0;0\r\n1;1,2;0,1;0\r\n2;1,3;0,2;0\r\n3;1,3;0,2;0\r\n";
/// let table = CoefficientTable::read("table.csv", text)?;
/// assert_eq!(table.rows()[1].lift, 0.1);
///
/// let error = CoefficientTable::read("table.csv", "alpha_deg,CL,CD\n").unwrap_err();
/// assert!(error.to_string().starts_with("table.csv:1: no column means CM"));
/// # Ok::<(), sextic::stability::input::InputError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoefficientTable {
    file: String,
    rows: Vec<Row>,
    /// The columns that are used.
    columns: Vec<String>,
    /// The unit of the angles as they are written.
    unit: Unit,
    /// Whether derivatives are those of columns.
    has_slopes: bool,
    /// By what C_D, C_L and C_M are multiplied so that they stand over D and D².
    factors: [f64; 3],
    /// How the table was continued by symmetry.
    mirror: Option<Mirror>,
    /// The first and the last angle as they are written, where they are read as one.
    joined: Option<[f64; 2]>,
    /// What was not used, sorted or left out.
    notes: Vec<Remark>,
}

/// The fewest rows that make a curve with a slope.
pub(super) const FEWEST_ROWS: usize = 4;

impl CoefficientTable {
    /// Reads the text of a table; `file` is its name in messages.
    ///
    /// A row names the columns, in any order and by their usual names: `alpha_deg`, `AoA`, `alpha [rad]`, `CL`, `Cl`,
    /// `C_D`, `moment`. They are separated by commas, semicolons, tabs or blanks; a number may have a decimal comma
    /// unless commas separate. A row of units may follow. Comments begin with `#`, `!`, `%` or `//`. Rows may stand in
    /// any order, and twice where they agree. What is not used, sorted or left out is among the
    /// [remarks](remarks::remarks).
    ///
    /// n log n in the number n of rows.
    ///
    /// # Errors
    ///
    /// Columns that are missing or there twice, what is no finite number, fewer than four rows, two rows of one angle
    /// that differ, and angles that go over more than 360°, with the line.
    pub fn read(file: &str, text: &str) -> Result<Self, InputError> {
        CoefficientTable::read_as(file, text, &Reading::default())
    }

    /// Reads the text of a table as a case says.
    ///
    /// ```
    /// use sextic::stability::coefficient_table::{CoefficientTable, reading::Reading};
    ///
    /// let text = "Winkel,ca,CD,CM\n0,0,1,0\n60,1,1,0\n120,1,1,0\n180,0,1,0\n";
    /// let columns = [("alpha_deg", "Winkel"), ("CL", "ca")];
    /// let columns = columns.map(|(key, name)| (key.to_string(), name.to_string()));
    /// let reading = Reading { columns: columns.into(), mirror: true, slopes: false };
    /// let table = CoefficientTable::read_as("table.csv", text, &reading)?;
    /// assert_eq!((table.rows()[1].angle, table.rows()[1].lift), (-120.0, -1.0));
    /// # Ok::<(), sextic::stability::input::InputError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`CoefficientTable::read`]; also where the table is not as the case says: columns that are not there, and a
    /// table that is to be mirrored but ends on no axis, or has both halves.
    pub fn read_as(file: &str, text: &str, reading: &Reading) -> Result<Self, InputError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let names = Names(reading);
        let sheet = Sheet::read(file, text, &names)?;
        let heading = Place::line(file, sheet.line);
        let mut columns = Columns::read(&heading, &sheet.heading, &names)?;
        columns.read_units(&heading, &sheet.units)?;
        if reading.slopes {
            columns.check_slopes(&heading)?;
        }
        let unit = columns.unit.unwrap_or(Unit::Degrees);
        let mut table = CoefficientTable {
            file: file.into(),
            rows: Vec::new(),
            columns: columns.used(&sheet.heading, unit, reading.slopes),
            unit,
            has_slopes: reading.slopes,
            factors: [1.0; 3],
            mirror: None,
            joined: None,
            notes: Vec::new(),
        };
        table.note_heading(&sheet, &columns);
        for (line, cells) in &sheet.rows {
            let place = Place::line(file, *line);
            let row = Row::read(&place, &columns, unit, cells, sheet.separator)?;
            table.rows.push(row);
        }
        table.sort();
        table.drop_repeated_rows();
        table.check()?;
        if reading.mirror {
            table.add_images()?;
        }
        table.join_ends();
        table.check_reach()?;
        Ok(table)
    }

    /// What of the heading, and before it, is not used or not said.
    fn note_heading(&mut self, sheet: &Sheet, columns: &Columns) {
        if let [first, ..] = sheet.before.as_slice() {
            let what = format!(
                "{} before the columns are named in line {} are not read",
                counted(sheet.before.len(), "line"),
                sheet.line
            );
            self.note(*first, what);
        }
        let others: Vec<String> = columns
            .others
            .iter()
            .map(|own| format!("`{}`", quoted(own)))
            .collect();
        if !others.is_empty() {
            let what = match others.as_slice() {
                [own] => format!("the column {own} is not used"),
                more => format!("the columns {} are not used", more.join(", ")),
            };
            self.note(sheet.line, what);
        }
        let angle = &sheet.heading[columns.places[0]];
        match columns.unit {
            None => self.note(
                sheet.line,
                format!("`{}` names no unit: it is read in degrees", quoted(angle)),
            ),
            Some(Unit::Radians) => {
                self.note(
                    sheet.line,
                    format!(
                        "`{}` is in radians; angles are shown in degrees",
                        quoted(angle)
                    ),
                );
            }
            Some(Unit::Degrees) => {}
        }
    }

    fn note(&mut self, line: usize, what: String) {
        let place = Place::line(&self.file, line);
        self.notes.push(Remark { place, what });
    }

    /// Sorts the rows by their angles.
    fn sort(&mut self) {
        let mut order: Vec<usize> = (0..self.rows.len()).collect();
        order.sort_by(|&one, &other| self.rows[one].angle.total_cmp(&self.rows[other].angle));
        let Some(moved) = (0..order.len()).find(|&place| order[place] != place) else {
            return;
        };
        self.note(
            self.rows[moved].line,
            "the rows are sorted by their angles".into(),
        );
        self.take(&order);
    }

    /// Leaves out rows that say what the row before says.
    fn drop_repeated_rows(&mut self) {
        let number = |place: usize| Row {
            line: 0,
            ..self.rows[place]
        };
        let is_repeated = |place: &usize| *place > 0 && number(*place) == number(*place - 1);
        let (repeated, kept): (Vec<usize>, Vec<usize>) =
            (0..self.rows.len()).partition(is_repeated);
        let Some(&first) = repeated.first() else {
            return;
        };
        let what = match repeated.len() {
            1 => "the row says again what another one says, and is left out".to_string(),
            more => format!(
                "this row and {more} more say again what others say, and are left out",
                more = more - 1
            ),
        };
        self.note(self.rows[first].line, what);
        self.take(&kept);
    }

    /// Continues half a table by symmetry.
    fn add_images(&mut self) -> Result<(), InputError> {
        let moved = put_ends_on_axes(&self.file, &mut self.rows);
        self.notes.extend(moved);
        let mirror = Mirror::of(&self.file, &self.rows)?;
        mirror.add_images(&mut self.rows);
        self.mirror = Some(mirror);
        Ok(())
    }

    /// The rows of these places, in this order.
    fn take(&mut self, places: &[usize]) {
        self.rows = places.iter().map(|&own| self.rows[own]).collect();
    }

    /// The rows as they are written, their angles increasing.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Whether a row is in the text, and not only an image of one.
    pub(super) fn is_written(&self, row: &Row) -> bool {
        self.mirror.is_none_or(|mirror| mirror.holds(row))
    }

    /// Whether any coefficient has an error.
    pub fn has_errors(&self) -> bool {
        self.rows.iter().any(|row| row.errors != [0.0; 3])
    }

    /// The same table, where C_D, C_L and C_M have these errors at every angle.
    #[must_use]
    pub fn with_errors(mut self, errors: [f64; 3]) -> Self {
        self.rows.iter_mut().for_each(|row| row.errors = errors);
        self
    }

    /// The same table, whose coefficients stand over these lengths, of a section with this D in m.
    #[must_use]
    pub fn with_reference(self, reference: &Reference, dimension: f64) -> Self {
        CoefficientTable {
            factors: reference.factors(dimension),
            ..self
        }
    }

    /// The rows with coefficients, slopes and errors over D and D², as the equations have them.
    pub fn converted_rows(&self) -> Vec<Row> {
        let rows = self.rows.iter();
        rows.map(|row| row.times(self.factors)).collect()
    }

    /// The columns that are used, with the names that they have: `CL`, `CD = `cw``.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Whether derivatives are those of columns, and not those of the curves.
    pub fn has_slopes(&self) -> bool {
        self.has_slopes
    }

    /// The file as the user named it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Whether the last row is at the angle of the first one, with other coefficients: by more than a thousandth of
    /// what one of them varies by.
    pub fn has_a_jump_at_its_end(&self) -> bool {
        let (first, last) = (&self.rows[0], &self.rows[self.rows.len() - 1]);
        let differs = |own: &Column| {
            (own.of(first) - own.of(last)).abs() > 1e-3 * self.span(|row| own.of(row))
        };
        self.is_closed() && self.curves().any(differs)
    }

    /// The columns of which curves are made.
    pub(super) fn curves(&self) -> impl Iterator<Item = &'static Column> {
        let has_slopes = self.has_slopes;
        Column::COEFFICIENTS
            .iter()
            .chain(Column::SLOPES.iter().filter(move |_| has_slopes))
    }

    /// From the least to the largest number of a column: the scale of what may be neglected in it.
    pub(super) fn span(&self, column: impl Fn(&Row) -> f64) -> f64 {
        let numbers = self.rows.iter().map(column);
        let ends = numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], own| {
            [least.min(own), most.max(own)]
        });
        ends[1] - ends[0]
    }

    fn check(&self) -> Result<(), InputError> {
        let file = &self.file;
        if self.rows.len() < FEWEST_ROWS {
            let rows = counted(self.rows.len(), "row");
            let what = format!("the table has {rows} of numbers");
            let help = format!("a curve with a slope needs at least {FEWEST_ROWS}");
            return Err(InputError::new(Place::file(file), what, help));
        }
        for pair in self.rows.windows(2) {
            let (one, next) = (pair[0], pair[1]);
            let place = Place::line(file, next.line);
            if next.angle == one.angle {
                let what = format!(
                    "the angle {}° is there twice, here and in line {}",
                    next.angle, one.line
                );
                return Err(InputError::new(
                    place,
                    what,
                    "keep one of the rows: they differ",
                ));
            }
        }
        Ok(())
    }

    /// Angles that are read in radians, as the heading says, and go beyond a turn.
    fn beyond_a_turn(&self) -> Option<Remark> {
        let is_beyond = |row: &&Row| row.angle.abs() > 360.0 * (1.0 + ONE_ANGLE);
        let row = self.rows.iter().find(is_beyond)?;
        (self.unit == Unit::Radians).then(|| Remark {
            place: Place::line(&self.file, row.line),
            what: format!(
                "the angle is {} rad by the heading, more than a turn, which looks like degrees: correct the heading",
                short(row.angle.to_radians())
            ),
        })
    }

    fn check_reach(&self) -> Result<(), InputError> {
        if self.reach() <= 360.0 + WHOLE {
            return Ok(());
        }
        let what = format!("the angles go over {}°, more than the circle", self.reach());
        let help = match self.beyond_a_turn() {
            Some(remark) => remark.to_string(),
            None => "keep 360° of them: the table is continued round the circle".to_string(),
        };
        Err(InputError::new(Place::file(&self.file), what, help))
    }
}

/// An angle or a width, without the rounding of a difference.
fn short(angle: f64) -> f64 {
    (angle * 1e9).round() / 1e9
}

/// `1 line`, `3 lines`.
fn counted(count: usize, word: &str) -> String {
    match count {
        1 => format!("1 {word}"),
        more => format!("{more} {word}s"),
    }
}
