//! A table of force coefficients against the angle of attack, as a wind tunnel gives it.

mod cells;
mod heading;
pub mod remarks;
pub mod scatter;
mod sheet;

use self::heading::{Columns, Unit};
use self::sheet::{Separator, Sheet};
use super::input::{InputError, Place, Remark, quoted};

/// A row of a table: C_D, C_L and C_M at an angle of attack in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// α, in degrees.
    pub angle: f64,
    /// C_D.
    pub drag: f64,
    /// C_L.
    pub lift: f64,
    /// C_M.
    pub moment: f64,
    /// C_D, C_L and C_M may be as far from these; 0 where nothing is said.
    pub errors: [f64; 3],
    /// The line of the file, from 1.
    pub line: usize,
}

/// A column of derivatives that a table brings along: it is compared, and not used.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenSlopes {
    /// Its name: `dCL`.
    pub name: &'static str,
    /// A value a row, in whatever unit.
    pub values: Vec<f64>,
}

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
/// assert!(error.to_string().starts_with("table.csv:1: the column CM is missing"));
/// # Ok::<(), sextic::stability::input::InputError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoefficientTable {
    file: String,
    rows: Vec<Row>,
    given_slopes: Vec<GivenSlopes>,
    /// The first and the last angle as they are written, where they are read as one.
    joined: Option<[f64; 2]>,
    /// What was not used, sorted or left out.
    notes: Vec<Remark>,
}

/// The fewest rows that make a curve with a slope.
pub(super) const FEWEST_ROWS: usize = 4;

/// What is closer to 360° than this, in degrees, is 360°.
const WHOLE: f64 = 1e-9;

/// How the columns of errors are called.
const ERRORS: [&str; 3] = ["CD_error", "CL_error", "CM_error"];

/// Larger numbers than any that mean something, and far from where products of them overflow.
const LARGEST: f64 = 1e30;

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
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let sheet = Sheet::read(file, text)?;
        let columns = Columns::read(&Place::line(file, sheet.line), &sheet.heading)?;
        let named = sheet
            .units
            .get(columns.places[0])
            .and_then(|own| Unit::of(own));
        let unit = columns.unit.or(named);
        let mut table = CoefficientTable {
            file: file.into(),
            rows: Vec::new(),
            given_slopes: columns.given_slopes(),
            joined: None,
            notes: Vec::new(),
        };
        table.note_heading(&sheet, &columns, unit);
        let unit = unit.unwrap_or(Unit::Degrees);
        for (line, cells) in &sheet.rows {
            table.add(&columns, unit, *line, cells, sheet.separator)?;
        }
        table.sort();
        table.drop_repeated_rows();
        table.check()?;
        table.join_ends();
        table.check_reach()?;
        Ok(table)
    }

    /// What of the heading, and before it, is not used or not said.
    fn note_heading(&mut self, sheet: &Sheet, columns: &Columns, unit: Option<Unit>) {
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
        match unit {
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

    /// The rows of these places, in this order.
    fn take(&mut self, places: &[usize]) {
        self.rows = places.iter().map(|&own| self.rows[own]).collect();
        for slopes in &mut self.given_slopes {
            slopes.values = places.iter().map(|&own| slopes.values[own]).collect();
        }
    }

    /// The rows, their angles increasing.
    pub fn rows(&self) -> &[Row] {
        &self.rows
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

    /// The columns of derivatives that the table brings along.
    pub fn given_slopes(&self) -> &[GivenSlopes] {
        &self.given_slopes
    }

    /// The file as the user named it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Whether the last row is at the angle of the first one, with other coefficients: by more than a thousandth of
    /// what one of them varies by.
    pub fn has_a_jump_at_its_end(&self) -> bool {
        let (first, last) = (&self.rows[0], &self.rows[self.rows.len() - 1]);
        let columns: [fn(&Row) -> f64; 3] = [|row| row.drag, |row| row.lift, |row| row.moment];
        let differs = |column: &fn(&Row) -> f64| {
            (column(first) - column(last)).abs() > 1e-3 * self.span(column)
        };
        self.is_closed() && columns.iter().any(differs)
    }

    /// From the least to the largest number of a column: the scale of what may be neglected in it.
    pub(super) fn span(&self, column: impl Fn(&Row) -> f64) -> f64 {
        let numbers = self.rows.iter().map(column);
        let ends = numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], own| {
            [least.min(own), most.max(own)]
        });
        ends[1] - ends[0]
    }

    fn add(
        &mut self,
        columns: &Columns,
        unit: Unit,
        line: usize,
        cells: &[String],
        separator: Separator,
    ) -> Result<(), InputError> {
        let place = Place::line(&self.file, line);
        if cells.len() != columns.count {
            let what = format!("{} cells below {} columns", cells.len(), columns.count);
            let help = if separator == Separator::Comma && cells.len() > columns.count {
                "if the comma is a decimal comma, write decimal points, or separate the columns with semicolons"
            } else {
                "each row has a number for each column"
            };
            return Err(InputError::new(place, what, help));
        }
        let number = |column: usize, name: &str| number(&place, name, &cells[column]);
        let [angle, lift, drag, moment] = columns.places;
        let mut errors = [0.0; 3];
        for ((own, column), name) in errors.iter_mut().zip(columns.errors).zip(ERRORS) {
            if let Some(column) = column {
                *own = number(column, name)?;
                if *own < 0.0 {
                    let what = format!("{name} is {own}, below 0");
                    let help = "an error is how far a coefficient may be off, to both sides";
                    return Err(InputError::new(place, what, help));
                }
            }
        }
        self.rows.push(Row {
            angle: unit.degrees(number(angle, "alpha_deg")?),
            lift: number(lift, "CL")?,
            drag: number(drag, "CD")?,
            moment: number(moment, "CM")?,
            errors,
            line,
        });
        for (slopes, (name, column)) in self.given_slopes.iter_mut().zip(&columns.slopes) {
            slopes.values.push(number(*column, name)?);
        }
        Ok(())
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

    fn check_reach(&self) -> Result<(), InputError> {
        if self.reach() <= 360.0 + WHOLE {
            return Ok(());
        }
        let what = format!("the angles go over {}°, more than the circle", self.reach());
        let help = "keep 360° of them: the table is continued round the circle";
        Err(InputError::new(Place::file(&self.file), what, help))
    }
}

impl Columns {
    fn given_slopes(&self) -> Vec<GivenSlopes> {
        let empty = |&(name, _): &(&'static str, usize)| GivenSlopes {
            name,
            values: Vec::new(),
        };
        self.slopes.iter().map(empty).collect()
    }
}

/// `1 line`, `3 lines`.
fn counted(count: usize, word: &str) -> String {
    match count {
        1 => format!("1 {word}"),
        more => format!("{more} {word}s"),
    }
}

/// A cell as a number; a comma in it is a decimal comma, since it separates no columns.
fn number(place: &Place, column: &str, cell: &str) -> Result<f64, InputError> {
    let wrong = |help: &str| {
        let what = format!("`{}` in the column {column} is no number", quoted(cell));
        InputError::new(place.clone(), what, help)
    };
    // Signs that typesetting programs write, and a unit that the heading says.
    let cell = cell.replace(['−', '–'], "-");
    let cell = cell.trim_end_matches('°').trim();
    let has_comma = cell.contains(',');
    if has_comma && (cell.contains('.') || cell.matches(',').count() > 1) {
        return Err(wrong(
            "it may have a decimal point or a decimal comma, and nothing between thousands",
        ));
    }
    let text = if has_comma {
        cell.replace(',', ".")
    } else {
        cell.to_string()
    };
    match text.parse::<f64>() {
        Ok(number) if number.abs() <= LARGEST => Ok(number),
        Ok(number) if number.is_finite() => {
            let cell = quoted(cell);
            let what = format!("{cell} in the column {column} is too large to be computed with");
            let help = "coefficients are dimensionless, angles in degrees";
            Err(InputError::new(place.clone(), what, help))
        }
        Ok(_) => Err(wrong("give a finite number, or leave the row out")),
        Err(_) if cell.is_empty() => Err(wrong(
            "the cell is empty: give a number, or leave the row out",
        )),
        Err(_) => Err(wrong(
            "give a number such as -0.25 or 2.5e-1, without a unit",
        )),
    }
}
