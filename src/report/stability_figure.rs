//! The stability of a case as a figure: S by every method against the angle.

use crate::stability::case::Case;
use crate::stability::comparison::{Comparison, Point};

use super::figure::{Curve, Figure, Fill, Patch, Stroke};
use super::stability::sweep;

/// S against the angle of attack by the state matrix, the companion matrix, the closed forms and the uniform
/// form; what is below 0 is unstable, and shaded.
pub fn figure(comparison: &Comparison) -> Figure {
    let curve = |label: &str, stroke, value: &dyn Fn(&Point) -> Option<f64>| Curve {
        label: label.into(),
        stroke,
        pieces: pieces(comparison, value),
    };
    let curves = vec![
        curve("state matrix", Stroke::Solid, &|point| {
            Some(point.exact.value)
        }),
        curve("companion matrix", Stroke::Circles, &|point| {
            point.companion.map(|own| own.value)
        }),
        curve("closed form (21)–(23)", Stroke::Dashed, &|point| {
            point.closed.value
        }),
        curve("uniform form", Stroke::Crosses, &|point| {
            point.uniform.value
        }),
    ];
    let symbol = match comparison.free().len() {
        1 => "S_{1D}",
        2 => "S_{2D}",
        _ => "S_{3D}",
    };
    Figure {
        title: titled("Stability by every method", &comparison.case),
        subtitle: set(&comparison.case, &sweep(comparison)),
        x_label: angle_axis(&comparison.case),
        is_angle: true,
        y_label: format!("{symbol} = −4m max Re λ / (ρDU), dimensionless"),
        shaded: Some("unstable".into()),
        patches: band(comparison).into_iter().collect(),
        curves: curves
            .into_iter()
            .filter(|curve| !curve.pieces.is_empty())
            .collect(),
        ..Figure::default()
    }
}

/// Where S lies within the errors of the coefficients, in pieces without a gap.
fn band(comparison: &Comparison) -> Option<Patch> {
    let within = comparison.within.as_ref();
    let within = within.filter(|own| own.has_errors())?;
    let values = || comparison.points.iter().map(|point| point.exact.value);
    let (least, most) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    // More than the curve spans is not seen, so that the curve is.
    let [below, above] = [2.0 * least - most, 2.0 * most - least];
    let ends = |place: usize| {
        let ends = within.tolerances[place].damping?;
        Some(ends.map(|own| own.clamp(below, above)))
    };
    let places: Vec<usize> = (0..comparison.points.len()).collect();
    let runs = places.chunk_by(|one, other| ends(*one).is_some() == ends(*other).is_some());
    let around = |run: &[usize]| -> Vec<(f64, f64)> {
        let along = |side: usize| {
            let corner =
                move |place: &usize| Some((comparison.points[*place].angle, ends(*place)?[side]));
            run.iter().filter_map(corner)
        };
        along(0).chain(along(1).rev()).collect()
    };
    let pieces: Vec<Vec<(f64, f64)>> = runs.map(around).filter(|own| own.len() > 2).collect();
    (!pieces.is_empty()).then(|| Patch {
        label: "within the errors".into(),
        fill: Fill::Dark,
        pieces,
    })
}

/// The angle along an axis: a mean twist changes the angle of attack itself.
pub fn angle_axis(case: &Case) -> String {
    let before = match case.is_twisted() {
        true => " before the mean twist",
        false => "",
    };
    format!("angle of attack α{before} (degrees)")
}

/// What a figure shows, and of which case.
pub fn titled(what: &str, case: &Case) -> String {
    format!("{what}: {}", name(case))
}

/// What was set in a case, and what else is to be said of it.
pub fn set(case: &Case, rest: &str) -> String {
    let title = case.title();
    match title.strip_prefix(case.file.as_str()).map(str::trim_start) {
        None | Some("") => rest.to_string(),
        Some(set) => format!("{set}; {rest}"),
    }
}

/// The name of a case without its folder.
pub fn name(case: &Case) -> &str {
    let folder = case.file.rfind(['/', '\\']);
    &case.file[folder.map_or(0, |end| end + 1)..]
}

/// The points that have a value, in pieces without a gap.
pub fn pieces(
    comparison: &Comparison,
    value: &dyn Fn(&Point) -> Option<f64>,
) -> Vec<Vec<(f64, f64)>> {
    let all = comparison.at_all_angles().into_iter();
    let all: Vec<_> = all
        .map(|(angle, point)| Some((angle, value(point?)?)))
        .collect();
    without_gaps(&all)
}

/// Points in pieces without those that are not there.
pub fn without_gaps(points: &[Option<(f64, f64)>]) -> Vec<Vec<(f64, f64)>> {
    let pieces = points.split(|point| point.is_none());
    let pieces = pieces.map(|piece| piece.iter().copied().flatten().collect::<Vec<_>>());
    pieces.filter(|piece| !piece.is_empty()).collect()
}
