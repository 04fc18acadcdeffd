//! A table of force coefficients against the angle of attack, as a wind tunnel gives it.

mod cells;
pub mod remarks;

use csv::{ReaderBuilder, StringRecord, Trim};

use super::input::{InputError, Place, meant_among, quoted, shortened};

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
}

/// The columns of a table.
const COLUMNS: [&str; 4] = ["alpha_deg", "CL", "CD", "CM"];

/// Columns that may be there.
const SLOPES: [&str; 3] = ["dCL", "dCD", "dCM"];

/// The fewest rows that make a curve with a slope.
pub(super) const FEWEST_ROWS: usize = 4;

/// What is closer to 360° than this, in degrees, is 360°.
const WHOLE: f64 = 1e-9;

/// Larger numbers than any that mean something, and far from where products of them overflow.
const LARGEST: f64 = 1e30;

impl CoefficientTable {
    /// Reads the text of a table; `file` is its name in messages.
    ///
    /// The first row names the columns `alpha_deg`, `CL`, `CD` and `CM`, in any order. They are
    /// separated by commas, semicolons or tabs; a number may have a decimal comma unless commas separate.
    /// A byte-order mark and Windows line ends are read over, and so are empty rows and lines that begin with `#`.
    ///
    /// Linear in the length of the text.
    ///
    /// # Errors
    ///
    /// Columns that are missing, unknown or there twice, what is no finite number, fewer than four rows,
    /// and angles that do not increase or go over more than 360°, with the line.
    pub fn read(file: &str, text: &str) -> Result<Self, InputError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().map(str::trim);
        let heading = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
        let separator = match heading {
            Some(heading) if heading.contains(';') => b';',
            Some(heading) if heading.contains('\t') => b'\t',
            _ => b',',
        };
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .comment(Some(b'#'))
            .delimiter(separator)
            .from_reader(text.as_bytes());
        let mut records = reader.records();
        let Some((line, heading)) = next(file, text, &mut records)? else {
            let help = "the first row names the columns alpha_deg, CL, CD, CM";
            return Err(InputError::new(
                Place::file(file),
                "the table is empty",
                help,
            ));
        };
        let columns = Columns::read(file, line, &heading)?;
        let mut table = CoefficientTable {
            file: file.into(),
            rows: Vec::new(),
            given_slopes: columns.given_slopes(),
            joined: None,
        };
        while let Some((line, record)) = next(file, text, &mut records)? {
            table.add(&columns, line, &record, separator)?;
        }
        table.check()?;
        table.join_ends();
        table.check_reach()?;
        Ok(table)
    }

    /// The rows, their angles increasing.
    pub fn rows(&self) -> &[Row] {
        &self.rows
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
        line: usize,
        record: &StringRecord,
        separator: u8,
    ) -> Result<(), InputError> {
        let place = Place::line(&self.file, line);
        if record.len() != columns.count {
            let what = format!("{} cells below {} columns", record.len(), columns.count);
            let help = if separator == b',' && record.len() > columns.count {
                "if the comma is a decimal comma, write decimal points, or separate the columns with semicolons"
            } else {
                "each row has a number for each column"
            };
            return Err(InputError::new(place, what, help));
        }
        let number = |column: usize, name: &str| number(&place, name, &record[column]);
        let [angle, lift, drag, moment] = columns.places;
        self.rows.push(Row {
            angle: number(angle, COLUMNS[0])?,
            lift: number(lift, COLUMNS[1])?,
            drag: number(drag, COLUMNS[2])?,
            moment: number(moment, COLUMNS[3])?,
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
            let what = format!("the table has {} rows of numbers", self.rows.len());
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
                return Err(InputError::new(place, what, "keep one of the rows"));
            }
            if next.angle < one.angle {
                let what = format!(
                    "the angle {}° follows {}°, but angles must increase",
                    next.angle, one.angle
                );
                return Err(InputError::new(place, what, "sort the rows by alpha_deg"));
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

/// Where the columns stand.
struct Columns {
    count: usize,
    /// alpha_deg, CL, CD, CM.
    places: [usize; 4],
    slopes: Vec<(&'static str, usize)>,
}

impl Columns {
    fn read(file: &str, line: usize, heading: &StringRecord) -> Result<Self, InputError> {
        let place = Place::line(file, line);
        let known: Vec<&str> = COLUMNS.into_iter().chain(SLOPES).collect();
        for (position, name) in heading.iter().enumerate() {
            if heading.iter().take(position).any(|before| before == name) {
                let what = format!("the column `{}` is there twice", quoted(name));
                return Err(InputError::new(place, what, "keep one of them"));
            }
            if !known.contains(&name) {
                let (what, help) = if name.parse::<f64>().is_ok() {
                    let number = quoted(name);
                    let what = format!("the first row begins its columns with a number, {number}");
                    (what, "name the columns: alpha_deg,CL,CD,CM".to_string())
                } else if ["alpha", "angle", "alpha_rad"].contains(&name.to_lowercase().as_str()) {
                    let help = "the angle is in degrees, in a column called alpha_deg";
                    (
                        format!("there is no column `{}`", quoted(name)),
                        help.to_string(),
                    )
                } else {
                    let is_there = |known: &&str| heading.iter().any(|own| own == *known);
                    let absent = known.iter().copied().filter(|own| !is_there(own));
                    let help = meant_among(&absent.collect::<Vec<_>>(), name, &known);
                    (format!("there is no column `{}`", quoted(name)), help)
                };
                return Err(InputError::new(place, what, help));
            }
        }
        let find = |name: &str| heading.iter().position(|own| own == name);
        let mut places = [0; 4];
        for (own, name) in places.iter_mut().zip(COLUMNS) {
            let Some(found) = find(name) else {
                let what = format!("the column {name} is missing");
                let help =
                    "the first row names the columns alpha_deg, CL, CD, CM, separated by commas";
                return Err(InputError::new(place, what, help));
            };
            *own = found;
        }
        let slopes = SLOPES
            .into_iter()
            .filter_map(|name| Some((name, find(name)?)));
        Ok(Columns {
            count: heading.len(),
            places,
            slopes: slopes.collect(),
        })
    }

    fn given_slopes(&self) -> Vec<GivenSlopes> {
        let empty = |&(name, _): &(&'static str, usize)| GivenSlopes {
            name,
            values: Vec::new(),
        };
        self.slopes.iter().map(empty).collect()
    }
}

/// A cell as a number; a comma in it is a decimal comma, since it separates no columns.
fn number(place: &Place, column: &str, cell: &str) -> Result<f64, InputError> {
    let wrong = |help: &str| {
        let what = format!("`{}` in the column {column} is no number", quoted(cell));
        InputError::new(place.clone(), what, help)
    };
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

/// The next record that says something, with its line; what the reader refuses is an error with its line.
///
/// The reader's position is where it stood before the empty lines and comments that it passes over.
fn next(
    file: &str,
    text: &str,
    records: &mut impl Iterator<Item = csv::Result<StringRecord>>,
) -> Result<Option<(usize, StringRecord)>, InputError> {
    let record = records.find(|record| !record.as_ref().is_ok_and(is_silent));
    let record = record.transpose().map_err(|error| {
        let place = match error.position() {
            Some(position) => Place::line(file, position.line() as usize),
            None => Place::file(file),
        };
        InputError::new(
            place,
            shortened(&error.to_string()),
            "a table is CSV in UTF-8",
        )
    })?;
    Ok(record.map(|record| {
        let (line, byte) = record.position().map_or((1, 0), |position| {
            (position.line() as usize, position.byte() as usize)
        });
        let is_passed_over = |line: &&str| line.is_empty() || line.starts_with('#');
        let rest = text.get(byte..).unwrap_or_default();
        let passed = rest.lines().take_while(is_passed_over).count();
        (line + passed, record)
    }))
}

/// A row of empty cells, which is how a spreadsheet ends, or a comment behind blanks.
fn is_silent(record: &StringRecord) -> bool {
    record.iter().all(str::is_empty) || record.get(0).is_some_and(|cell| cell.starts_with('#'))
}
