//! What is read between the rows of a table.

use crate::report::figure::{Curve, Figure, Stroke};
use crate::report::stability::sweep;
use crate::report::stability_figure::{angle_axis, pieces, set, titled};
use crate::stability::coefficient_table::{CoefficientTable, Row};
use crate::stability::comparison::Comparison;
use crate::stability::forces::Coefficients;

use super::Gallery;

/// A coefficient: its name in a legend, and its values along a curve.
type Named = (&'static str, Stroke, fn(&Coefficients) -> f64);

const COEFFICIENTS: [Named; 3] = [
    ("C_{D}", Stroke::Solid, |own| own.drag),
    ("C_{L}", Stroke::Dashed, |own| own.lift),
    ("C_{M}", Stroke::Dotted, |own| own.moment),
];

const SLOPES: [Named; 3] = [
    ("C_{D}′", Stroke::Solid, |own| own.drag_slope),
    ("C_{L}′", Stroke::Dashed, |own| own.lift_slope),
    ("C_{M}′", Stroke::Dotted, |own| own.moment_slope),
];

/// The coefficients with the rows of the table, and their slopes, on which galloping hangs.
pub(super) fn coefficients(
    comparison: &Comparison,
    table: &CoefficientTable,
    gallery: &mut Gallery,
) {
    let [values, slopes] =
        [COEFFICIENTS, SLOPES].map(|named| named.map(|own| curve(comparison, own)));
    if values.iter().all(|curve| curve.pieces.is_empty()) {
        let why = "the scaled damping matrix is set in place of coefficients";
        return gallery.leave_out(&["coefficients", "slopes"], why);
    }
    let case = &comparison.case;
    let base = Figure {
        subtitle: set(case, &sweep(comparison)),
        x_label: angle_axis(case),
        is_angle: true,
        ..Figure::default()
    };
    let drawn = values.into_iter().chain(rows(comparison, table));
    gallery.add(
        "coefficients",
        Figure {
            title: titled(
                "Coefficients as they are read between the rows of the table",
                case,
            ),
            y_label: "coefficient, dimensionless".into(),
            curves: drawn.collect(),
            ..base.clone()
        },
    );
    gallery.add(
        "slopes",
        Figure {
            title: titled("Slopes of the coefficients", case),
            y_label: "slope of a coefficient (1/rad)".into(),
            curves: slopes.into(),
            ..base
        },
    );
}

fn curve(comparison: &Comparison, (name, stroke, value): Named) -> Curve {
    Curve {
        label: name.into(),
        stroke,
        pieces: pieces(comparison, &|own| own.coefficients.as_ref().map(value)),
    }
}

/// The rows of the table at the angles of the case; nothing where a twist reads the table at other angles.
fn rows(comparison: &Comparison, table: &CoefficientTable) -> Option<Curve> {
    if comparison.case.is_twisted() {
        return None;
    }
    let rows = table.converted_rows();
    let angles = &comparison.case.angles;
    let is_seen = |row: &&Row| angles.from <= row.angle && row.angle <= angles.to;
    let of = |value: fn(&Row) -> f64| {
        let rows = rows.iter().filter(is_seen);
        rows.map(|row| (row.angle, value(row))).collect::<Vec<_>>()
    };
    let pieces = [of(|row| row.drag), of(|row| row.lift), of(|row| row.moment)];
    (!pieces[0].is_empty()).then(|| Curve {
        label: "rows of the table".into(),
        stroke: Stroke::Dots,
        pieces: pieces.into(),
    })
}
