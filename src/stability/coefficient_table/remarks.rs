//! What is odd about a coefficient table: looked for before it is used.

use super::angle::ONE_ANGLE;
use super::column::Column;
use super::oddity::{Oddity, oddities};
use super::{CoefficientTable, Row, short};
use crate::stability::input::{Place, Remark};

/// Steps above this, in degrees, are said to distort the range in which a section gallops.
const LONGEST_GOOD_STEP: f64 = 3.0;

/// A coefficient below this share of what it varies by counts as 0.
const NOTHING: f64 = 1e-3;

/// What is odd about a table, in the order in which one should look at it.
///
/// What was not used, sorted or left out as the table was read comes first. Looked for
/// are angles that seem to be in another unit, ends that are read as one angle, holes and cells that are hardly there, drag
/// below 0, numbers that do not fit those beside, derivatives that seem to be per degree, steps too coarse for
/// derivatives, and jumps at 0°, 180° and 360° of a curve that is its own mirror image.
/// n log n in the number of rows.
pub fn remarks(table: &CoefficientTable) -> Vec<Remark> {
    let mut remarks = table.notes.clone();
    remarks.extend(mistaken_unit(table));
    remarks.extend(joined_ends(table));
    remarks.extend(holes(table));
    remarks.extend(narrow_cells(table));
    remarks.extend(drag_below_0(table));
    remarks.extend(odd_numbers(table));
    remarks.extend(given_slopes(table));
    if !table.has_slopes() {
        remarks.extend(coarse_steps(table));
    }
    remarks.extend(jumps(table));
    remarks
}

/// Angles that seem to be in another unit than they are read in.
pub fn mistaken_unit(table: &CoefficientTable) -> Option<Remark> {
    radians(table).or_else(|| table.beyond_a_turn())
}

/// Angles that seem to be in radians.
fn radians(table: &CoefficientTable) -> Option<Remark> {
    let rows = table.rows();
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    let largest = first.angle.abs().max(last.angle.abs());
    let is_pi = |angle: f64| {
        let turns = angle / std::f64::consts::PI;
        (turns - turns.round()).abs() < 2e-3 && turns.round() != 0.0
    };
    (largest < 6.3 && (is_pi(first.angle) || is_pi(last.angle))).then(|| Remark {
        place: Place::line(table.file(), last.line),
        what: format!(
            "alpha_deg goes from {} to {}, which looks like radians; it is read as degrees",
            first.angle, last.angle
        ),
    })
}

/// Columns of derivatives against the slopes of the table: those that are not used, or do not fit.
fn given_slopes(table: &CoefficientTable) -> Vec<Remark> {
    let rows = table.rows();
    let columns = Column::COEFFICIENTS.iter().zip(&Column::SLOPES);
    let given = columns
        .enumerate()
        .filter(|(place, _)| rows[0].slopes[*place].is_some());
    let remark = |(_, (column, slopes)): (usize, (&Column, &Column))| {
        let seen = misfit(column.name, ratio(rows, column, slopes));
        let what = match (table.has_slopes(), seen) {
            (true, None) => return None,
            (true, Some(seen)) => format!("the column {} {seen}", slopes.name),
            (false, seen) => format!(
                "the column {} is not used{}; derivatives are those of the interpolation, per radian, unless the case \
                 has `slopes = true`",
                slopes.name,
                seen.map_or(String::new(), |seen| format!(" and {seen}"))
            ),
        };
        let place = Place::file(table.file());
        Some(Remark { place, what })
    };
    given.filter_map(remark).collect()
}

/// How derivatives that a table gives do not fit.
fn misfit(name: &str, ratio: f64) -> Option<String> {
    if (ratio / 1_f64.to_radians() - 1.0).abs() < 0.25 {
        Some(format!(
            "looks like the derivative per degree: it is {ratio:.4} of that of {name} per radian"
        ))
    } else if (ratio - 1.0).abs() > 0.25 {
        Some(format!(
            "does not fit: it is {ratio:.4} of the derivative of {name} per radian"
        ))
    } else {
        None
    }
}

/// Derivatives that a table gives over the slopes of the table, by least squares.
fn ratio(rows: &[Row], column: &Column, slopes: &Column) -> f64 {
    let (mut product, mut square) = (0.0, 0.0);
    for three in rows.windows(3) {
        let rise = column.of(&three[2]) - column.of(&three[0]);
        let own = rise / (three[2].angle - three[0].angle).to_radians();
        product += own * slopes.of(&three[1]);
        square += own * own;
    }
    product / square
}

/// A drag that points into the wind, as where columns are swapped.
fn drag_below_0(table: &CoefficientTable) -> Option<Remark> {
    let rows = table.rows().iter().filter(|row| table.is_written(row));
    let rows: Vec<&Row> = rows.collect();
    let is_below = |row: &&&Row| row.drag < 0.0;
    let first = rows.iter().find(is_below)?;
    let reason = match rows.iter().all(|row| row.lift > 0.0) {
        true => "CL is above 0 everywhere, so the two columns look swapped",
        false => {
            "look whether columns are swapped, a sign is turned, or the forces are along the axes of the section"
        }
    };
    Some(Remark {
        place: Place::line(table.file(), first.line),
        what: format!(
            "CD is {} at {}°, and below 0 in {} of {} rows; drag is along the wind: {reason}",
            first.drag,
            first.angle,
            rows.iter().filter(is_below).count(),
            rows.len()
        ),
    })
}

/// Single numbers, and jumps, that do not fit those beside.
fn odd_numbers(table: &CoefficientTable) -> Vec<Remark> {
    let rows = table.rows();
    // At the axes of what mirrors itself jumps are looked for below.
    let is_mirrored = is_mirrored(table);
    let is_new = |own: &Oddity| {
        let is_known = |row| is_mirrored && is_at_an_axis(row);
        let mut own = rows[own.rows()].iter();
        own.all(|row| table.is_written(row) && !is_known(row))
    };
    let remark = |column: &Column, own: Oddity| {
        let (row, next) = (&rows[own.row()], &rows[own.row() + 1]);
        let (line, what) = match own {
            Oddity::Spike { off, .. } => (row.line, spike(column.name, column.of(row), row, off)),
            Oddity::Jump { by, .. } => (next.line, jump(column.name, row, next, by)),
        };
        let place = Place::line(table.file(), line);
        Remark { place, what }
    };
    let all = table.curves().flat_map(|column| {
        let odd = oddities(rows, column).into_iter().filter(is_new);
        odd.map(move |own| remark(column, own))
    });
    limited(all.collect())
}

fn spike(name: &str, value: f64, row: &Row, off: f64) -> String {
    format!(
        "{name} is {value} at {}°, about {off:.2} off the curve of the rows beside: correct it if it is a slip, which \
         bends the curve around it",
        row.angle
    )
}

fn jump(name: &str, row: &Row, next: &Row, by: f64) -> String {
    format!(
        "{name} jumps by about {by:.2} from {}° to {}° (lines {} and {}): derivatives between them, and next to them, \
         mean little",
        row.angle, next.angle, row.line, next.line
    )
}

/// The first five remarks, with how many there are more.
fn limited(mut remarks: Vec<Remark>) -> Vec<Remark> {
    let more = remarks.len().saturating_sub(MOST_NAMED);
    remarks.truncate(MOST_NAMED);
    if let (Some(last), true) = (remarks.last_mut(), more > 0) {
        last.what += &format!("; and so in {more} places more");
    }
    remarks
}

/// The slopes of a column in the cells of a table, per radian.
fn slopes(rows: &[Row], column: &Column) -> Vec<f64> {
    rows.windows(2)
        .map(|pair| {
            (column.of(&pair[1]) - column.of(&pair[0]))
                / (pair[1].angle - pair[0].angle).to_radians()
        })
        .collect()
}

/// First and last angles that are read as one.
fn joined_ends(table: &CoefficientTable) -> Option<Remark> {
    let [from, to] = table.joined?;
    let [angle, _] = table.ends();
    let [first, last] = [table.rows.first()?.line, table.rows.last()?.line];
    Some(Remark {
        place: Place::line(table.file(), last),
        what: format!(
            "{to}° is {from}° (line {first}) once round the circle but for {}°, less than {} % of the steps beside: both \
             are read as {angle}°",
            short((360.0 - (to - from)).abs()),
            100.0 * ONE_ANGLE
        ),
    })
}

/// So many cells are named one by one.
const MOST_NAMED: usize = 5;

fn holes(table: &CoefficientTable) -> Vec<Remark> {
    let (holes, widths) = (table.holes(), table.widths());
    named(table, &holes, |from, to, place| {
        let width = short(widths[place]);
        format!(
            "the table has a hole of {width}° from {from}° to {to}°, beside steps far narrower or wider than a quarter \
             of the circle: angles within are outside of the table"
        )
    })
}

fn narrow_cells(table: &CoefficientTable) -> Vec<Remark> {
    let (narrow, widths) = (table.narrow_cells(), table.widths());
    named(table, &narrow, |from, to, place| {
        let width = short(widths[place]);
        format!(
            "from {from}° to {to}° it is {width}°, far less than the steps beside: the difference of two rows so close \
             says little of a slope, and bends a curve around them; keep one of them"
        )
    })
}

/// A remark for each of some cells, but for no more than five.
fn named(
    table: &CoefficientTable,
    cells: &[usize],
    what: impl Fn(f64, f64, usize) -> String,
) -> Vec<Remark> {
    let remark = |place: usize| {
        let [(line, from), (next, to)] = table.cell(place);
        let what = what(from, to, place);
        Remark {
            place: Place::line(table.file(), next),
            what: format!("{what} (lines {line} and {next})"),
        }
    };
    let mut remarks: Vec<Remark> = cells
        .iter()
        .take(MOST_NAMED)
        .map(|own| remark(*own))
        .collect();
    if let (Some(last), true) = (remarks.last_mut(), cells.len() > MOST_NAMED) {
        last.what += &format!("; and so in {} cells more", cells.len() - MOST_NAMED);
    }
    remarks
}

fn coarse_steps(table: &CoefficientTable) -> Option<Remark> {
    let rows = table.rows();
    let holes = table.holes();
    let is_hole = |place: usize| holes.binary_search(&place).is_ok();
    let width = |place: usize| rows[place + 1].angle - rows[place].angle;
    let cells = (0..rows.len() - 1).filter(|&place| !is_hole(place));
    let longest = cells
        .max_by(|one, other| width(*one).total_cmp(&width(*other)))
        .filter(|place| width(*place) > LONGEST_GOOD_STEP * (1.0 + ONE_ANGLE))?;
    let slopes = slopes(rows, &Column::LIFT);
    let changes = slopes.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let beside_no_hole = |(place, _): &(usize, f64)| !is_hole(*place) && !is_hole(place + 1);
    let most = changes
        .enumerate()
        .filter(beside_no_hole)
        .max_by(|one, other| one.1.total_cmp(&other.1));
    let change = most.map_or(String::new(), |(place, change)| {
        let corner = rows[place + 1];
        format!(
            "; from one cell to the next dCL/dα changes by up to {change:.2} (at {}°, line {})",
            corner.angle, corner.line
        )
    });
    Some(Remark {
        place: Place::line(table.file(), rows[longest + 1].line),
        what: format!(
            "steps of up to {}° are coarse for derivatives, above {LONGEST_GOOD_STEP}° they distort the \
             range in which a section gallops{change}",
            short(width(longest)),
        ),
    })
}

fn jumps(table: &CoefficientTable) -> Vec<Remark> {
    let rows = table.rows();
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    let mut remarks = Vec::new();
    if table.has_a_jump_at_its_end() {
        let parts = large_parts(table, table.curves(), |column| {
            column.of(&first) - column.of(&last)
        });
        let parts: Vec<String> = parts
            .iter()
            .map(|part| part.replace(" is ", " by "))
            .collect();
        remarks.push(Remark {
            place: Place::line(table.file(), last.line),
            what: format!(
                "{}° and {}° are one angle, but the curve jumps there, {}: derivatives in the cells next to it \
                 mean nothing",
                first.angle,
                last.angle,
                parts.join(" and ")
            ),
        });
    }
    if !is_mirrored(table) {
        return remarks;
    }
    let is_known = |row: &Row| table.has_a_jump_at_its_end() && (*row == first || *row == last);
    for row in rows
        .iter()
        .filter(|row| is_at_an_axis(row) && !is_known(row))
    {
        let odd = [Column::LIFT, Column::MOMENT];
        let parts = large_parts(table, &odd, |column| column.of(row));
        if !parts.is_empty() {
            remarks.push(Remark {
                place: Place::line(table.file(), row.line),
                what: format!(
                    "{} at {}° and not 0: the table mirrors itself, lift and moment are odd, and jump there; derivatives in the cells next to it mean nothing",
                    parts.join(" and "),
                    row.angle
                ),
            });
        }
    }
    remarks
}

/// Whether a row is at 0° or 180°.
fn is_at_an_axis(row: &Row) -> bool {
    (row.angle / 180.0 - (row.angle / 180.0).round()).abs() < 1e-11
}

/// Which columns have a size that counts: `CL is 0.23`.
fn large_parts<'a>(
    table: &CoefficientTable,
    columns: impl IntoIterator<Item = &'a Column>,
    size: impl Fn(&Column) -> f64,
) -> Vec<String> {
    let large = columns.into_iter().filter_map(|own| {
        let (size, span) = (size(own), table.span(|row| own.of(row)));
        (size.abs() > NOTHING * span).then(|| format!("{} is {size}", own.name))
    });
    large.collect()
}

/// Whether the curves on both sides of 0° are mirror images: drag even, lift and moment odd.
fn is_mirrored(table: &CoefficientTable) -> bool {
    let rows = table.rows();
    let same = |column: Column, row: &Row, image: &Row, sign: f64| {
        let span = table.span(|row| column.of(row));
        (column.of(row) - sign * column.of(image)).abs() <= 1e-6 * span
    };
    let turned = |angle: f64| angle.rem_euclid(360.0);
    let mut pairs = 0;
    for row in rows {
        let image = turned(-row.angle);
        let is_axis = turned(row.angle + 1e-9) < 2e-9 || (turned(row.angle) - 180.0).abs() < 1e-9;
        // The rows are in order: an image is sought once round either way.
        let mut images = [image - 360.0, image, image + 360.0]
            .into_iter()
            .filter_map(|image| {
                let place = rows.partition_point(|own| own.angle < image - 1e-9);
                rows.get(place)
                    .filter(|own| (own.angle - image).abs() < 1e-9)
            });
        let Some(other) = images.next().filter(|_| !is_axis) else {
            continue;
        };
        let fits = same(Column::DRAG, row, other, 1.0)
            && same(Column::LIFT, row, other, -1.0)
            && same(Column::MOMENT, row, other, -1.0);
        if !fits {
            return false;
        }
        pairs += 1;
    }
    // Each pair is met twice.
    pairs >= 8
}
