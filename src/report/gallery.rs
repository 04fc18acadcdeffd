//! The paper's kinds of figures, on any case; and those that need no coefficients, as they are.

use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Comparison, FollowedMode, Point, Value, angle, compare};
use crate::stability::coordinate::Coordinate;
use crate::stability::grid::{Grid, Methods, Rows};
use crate::stability::input::{InputError, Place};
use crate::stability::offset::{OffsetPoint, against_offset};
use crate::stability::sections::Sections;
use crate::stability::variable::Variable;

use super::figure::{Curve, Figure, Stroke};
use super::{stability_figure, trajectory};

/// A figure and the name of its file, without an extension.
pub type Named = (String, Figure);

/// Styles for as many modes as there can be, told apart without colour: more than three where they do not oscillate.
const MODES: [Stroke; 6] = [
    Stroke::Solid,
    Stroke::Dashed,
    Stroke::Dotted,
    Stroke::Crosses,
    Stroke::Circles,
    Stroke::Thin,
];

const DAMPING: &str = "S of each mode = −4m Re λ / (ρDU), dimensionless";
const FREQUENCY: &str = "frequency (Hz)";

/// Steps of the eccentricity, and the largest.
const STEPS: usize = 400;
const LARGEST: f64 = 0.6;

/// So many sections are computed at once.
const AT_ONCE: u64 = 1024;

/// All figures of a case: the frequencies of Fig. 11 and the trajectories of Fig. 12, which rest on no case;
/// its stability by all methods; with and without inertial coupling, as Figs. 3–6 and 9; modes against the
/// offset of the mass centre at the worst angle, as Fig. 7; and the closed form against the state matrix of the
/// same section, perfectly tuned and without structural damping, as Figs. 13 and 14.
///
/// # Errors
///
/// As [`compare`].
pub fn figures(case: &Case, table: &CoefficientTable) -> Result<Vec<Named>, InputError> {
    let comparison = compare(case, table)?;
    let mut figures = vec![("frequencies_without_wind".to_string(), frequencies())];
    for mode in 1..=3 {
        figures.push((
            format!("trajectory_of_mode_{mode}"),
            trajectory::figure(mode),
        ));
    }
    figures.push(("stability".into(), stability_figure::figure(&comparison)));
    figures.extend(of_case(&comparison, table)?);
    if case.parameters.free.are_all() {
        figures.push(("closed_form".into(), closed_form(case, table)?));
    }
    Ok(figures)
}

/// The figures of a case beside that of its stability by all methods: S and frequency of every mode against
/// the angle; and where the mass centre matters, with and without inertial coupling, and the modes against the
/// offset of the mass centre.
///
/// # Errors
///
/// As [`compare`].
pub fn of_case(
    comparison: &Comparison,
    table: &CoefficientTable,
) -> Result<Vec<Named>, InputError> {
    let mut figures = modes(comparison);
    // The mass centre couples the turn with sway and heave, and nothing else.
    let free = comparison.free();
    if free.len() > 1 && free.contains(&Coordinate::Theta) {
        if comparison.case.parameters.mass_centre_distance > 0.0 {
            let figure = inertial_coupling(comparison, table)?;
            figures.push(("inertial_coupling".into(), figure));
        }
        figures.extend(offset(comparison, table)?);
    }
    Ok(figures)
}

/// S and frequency of every mode against the angle.
fn modes(comparison: &Comparison) -> Vec<Named> {
    let base = stability_figure::figure(comparison);
    let points = || comparison.points.iter();
    let damping = by_mode(|label| {
        points()
            .map(|point| Some((point.angle, point.mode(label)?.damping.value)))
            .collect()
    });
    let frequency = by_mode(|label| {
        points()
            .map(|point| Some((point.angle, point.mode(label)?.frequency)))
            .collect()
    });
    let of_frequency = Figure {
        title: base.title.clone(),
        x_label: base.x_label.clone(),
        is_angle: true,
        y_label: FREQUENCY.into(),
        curves: frequency,
        ..Figure::default()
    };
    let of_damping = Figure {
        y_label: DAMPING.into(),
        curves: damping,
        ..base
    };
    vec![
        ("damping_of_modes".into(), of_damping),
        ("frequencies_of_modes".into(), of_frequency),
    ]
}

/// Fig. 11: the frequencies of Eq. (15) against the eccentricity.
fn frequencies() -> Figure {
    let curve = |label: &str, stroke, frequency: &dyn Fn(f64) -> f64| {
        let point = |step| {
            let e = f64::from(step) * 0.005;
            (e, frequency(e))
        };
        Curve {
            label: label.into(),
            stroke,
            pieces: vec![(0..=180).map(point).collect()],
        }
    };
    Figure {
        title: "Frequencies of a perfectly tuned section without wind".into(),
        x_label: "offset of the mass centre, L_{g} / r".into(),
        y_label: "frequency, ω / ω_{n}".into(),
        curves: vec![
            curve("mode 1", MODES[0], &|e| (1.0 - e).sqrt().recip()),
            curve("mode 2", MODES[1], &|_| 1.0),
            curve("mode 3", MODES[2], &|e| (1.0 + e).sqrt().recip()),
        ],
        ..Figure::default()
    }
}

/// As Figs. 3–6 and 9: the case as it is, and with G at O.
fn inertial_coupling(
    comparison: &Comparison,
    table: &CoefficientTable,
) -> Result<Figure, InputError> {
    let mut centred = comparison.case.clone();
    centred.parameters.mass_centre_distance = 0.0;
    let offset = Variable::MASS_CENTRE_DISTANCE;
    centred.set.retain(|own| !own.variable.clashes(offset));
    let centred = exact(&centred, table)?;
    let points = || comparison.points.iter();
    let own = points().map(|point| (point.angle, point.exact.value));
    let centred: Vec<_> = points().zip(centred).collect();
    // The curve has a gap where there is no answer.
    let pieces = centred.chunk_by(|one, other| one.1.is_some() == other.1.is_some());
    let piece = |run: &[(&Point, Option<Value>)]| -> Vec<(f64, f64)> {
        let known = run.iter();
        known
            .filter_map(|(point, exact)| Some((point.angle, exact.as_ref()?.value)))
            .collect()
    };
    let mut pieces: Vec<Vec<(f64, f64)>> = pieces.map(piece).collect();
    pieces.retain(|own| !own.is_empty());
    let curve = |label: String, stroke, pieces: Vec<Vec<(f64, f64)>>| Curve {
        label,
        stroke,
        pieces,
    };
    let e = comparison.case.parameters.small_quantities().e;
    let with = format!("with inertial coupling, L_{{g}}/r = {e:.3}");
    let without = "without, L_{g} = 0".to_string();
    Ok(Figure {
        curves: vec![
            curve(with, Stroke::Solid, vec![own.collect()]),
            curve(without, Stroke::Dashed, pieces),
        ],
        ..stability_figure::figure(comparison)
    })
}

/// S of a case at each of its angles by the exact eigenvalues.
fn exact(case: &Case, table: &CoefficientTable) -> Result<Vec<Option<Value>>, InputError> {
    let methods = Methods {
        exact: true,
        ..Methods::default()
    };
    let grid = Grid::new(case, table, Vec::new(), Rows::Points, methods)?;
    let starts = (0..grid.rows()).step_by(AT_ONCE as usize);
    let blocks = starts.map(|start| start..grid.rows().min(start + AT_ONCE));
    Ok(blocks.flat_map(|block| grid.rows_at(block).exact).collect())
}

/// As Fig. 7: S and frequency of every mode against the offset of G, at the angle with the least S.
fn offset(comparison: &Comparison, table: &CoefficientTable) -> Result<Vec<Named>, InputError> {
    let case = &comparison.case;
    let worst = comparison
        .points
        .iter()
        .min_by(|one, other| one.exact.value.total_cmp(&other.exact.value));
    let Some(worst) = worst.map(|point| point.angle) else {
        return Ok(Vec::new());
    };
    let wrong = |what: String| {
        let help = "correct the case or its table";
        InputError::new(Place::file(&case.file), what, help)
    };
    let (section, _) = Sections::new(case, table)?.at(worst, table)?;
    let points =
        against_offset(&section, LARGEST, STEPS).map_err(|error| wrong(error.to_string()))?;
    let title = format!(
        "{} at the worst angle, α = {}°; modes are numbered at L_{{g}} = 0",
        stability_figure::name(case),
        angle(worst)
    );
    let x_label = "offset of the mass centre, L_{g} / r".to_string();
    let of_modes = |value: fn(&FollowedMode) -> f64| {
        by_mode(|label| {
            let value = |point: &OffsetPoint| {
                let mode = point.modes.iter().find(|mode| mode.label == label)?;
                Some((point.eccentricity, value(mode)))
            };
            points.iter().map(value).collect()
        })
    };
    let damping = Figure {
        title: title.clone(),
        x_label: x_label.clone(),
        y_label: DAMPING.into(),
        shaded: Some("unstable".into()),
        curves: of_modes(|mode| mode.damping.value),
        ..Figure::default()
    };
    let frequency = Figure {
        title,
        x_label,
        y_label: FREQUENCY.into(),
        curves: of_modes(|mode| mode.frequency),
        ..Figure::default()
    };
    Ok(vec![
        ("damping_against_offset".into(), damping),
        ("frequencies_against_offset".into(), frequency),
    ])
}

/// A curve a mode, in pieces where it is not there.
fn by_mode(points: impl Fn(usize) -> Vec<Option<(f64, f64)>>) -> Vec<Curve> {
    let curve = |(place, stroke): (usize, Stroke)| {
        let points = points(place + 1);
        let pieces = points.split(|point| point.is_none());
        let pieces = pieces.map(|piece| piece.iter().copied().flatten().collect::<Vec<_>>());
        Curve {
            label: format!("mode {}", place + 1),
            stroke,
            pieces: pieces.filter(|piece| !piece.is_empty()).collect(),
        }
    };
    let curves = MODES.into_iter().enumerate().map(curve);
    curves.filter(|curve| !curve.pieces.is_empty()).collect()
}

/// As Figs. 13 and 14: all frequencies those of heave, no structural damping and no aerodynamic stiffness.
fn closed_form(case: &Case, table: &CoefficientTable) -> Result<Figure, InputError> {
    let mut tuned = case.clone();
    tuned.parameters.natural_frequencies = [case.parameters.natural_frequencies[1]; 3];
    tuned.parameters.damping_ratios = [0.0; 3];
    tuned.parameters.aerodynamic_stiffness = false;
    let is_changed = tuned != *case;
    let figure = stability_figure::figure(&compare(&tuned, table)?);
    let title = match is_changed {
        true => format!(
            "{}; tuned to f_{{y}}, without structural damping",
            figure.title
        ),
        false => figure.title,
    };
    Ok(Figure { title, ..figure })
}
