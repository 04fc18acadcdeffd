//! The paper's kinds of figures, on any case.

use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Comparison, FollowedMode, Point, Value, angle, compare};
use crate::stability::coordinate::Coordinate;
use crate::stability::grid::{Grid, Methods, Rows};
use crate::stability::input::{InputError, Place};
use crate::stability::interpolation::CoefficientCurves;
use crate::stability::offset::{OffsetPoint, against_offset};
use crate::stability::tuned_modes::TunedSection;
use crate::stability::variable::Variable;

use super::figure::{Curve, Figure, Own, Stroke};
use super::stability::{given, sweep};
use super::stability_figure::{self, name, set, titled};
use super::trajectory;

/// A figure and the name of its file, without an extension.
pub type Named = (String, Figure);

/// Figures, no two of which draw the same.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gallery {
    /// What is drawn.
    pub figures: Vec<Named>,
    /// The names of the others, and why they are left out.
    pub left_out: Vec<(&'static str, String)>,
}

impl Gallery {
    /// Adds a figure, unless an earlier one draws the same.
    fn add(&mut self, name: &'static str, figure: Figure) {
        let earlier = self.figures.iter();
        match earlier.clone().find(|(_, own)| own.draws_the_same(&figure)) {
            Some((same, _)) => {
                let why = format!("it would draw the same as {same}");
                self.left_out.push((name, why));
            }
            None => self.figures.push((name.into(), figure)),
        }
    }

    fn leave_out(&mut self, names: &[&'static str], why: &str) {
        let names = names.iter();
        self.left_out.extend(names.map(|own| (*own, why.to_string())));
    }
}

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

const OFFSET: &str = "offset of the mass centre, L_{g} / r";

/// Steps of the eccentricity, and the largest where the case has none that is larger: in the wind, and without.
const STEPS: usize = 400;
const LARGEST: f64 = 0.6;
const STEPS_WITHOUT_WIND: usize = 180;
const LARGEST_WITHOUT_WIND: f64 = 0.9;

/// So many sections are computed at once.
const AT_ONCE: u64 = 1024;

/// All figures of a case: its stability by all methods, and as Figs. 3 to 6, 7, 9 and 11 to 14 of the paper. What it
/// has nothing to show for is left out, and what would draw the same as another one.
///
/// # Errors
///
/// As [`compare`].
pub fn figures(case: &Case, table: &CoefficientTable) -> Result<Gallery, InputError> {
    let comparison = compare(case, table)?;
    let mut gallery = Gallery::default();
    without_wind(case, &mut gallery);
    gallery.add("stability", stability_figure::figure(&comparison));
    add_of_case(&comparison, table, &mut gallery)?;
    match case.parameters.free.are_all() {
        true => gallery.add("closed_form", closed_form(case, table)?),
        false => gallery.leave_out(&["closed_form"], ALL_FREE),
    }
    Ok(gallery)
}

const ALL_FREE: &str = "it is for sections of which x, y and theta are free";

/// The figures of a case beside that of its stability by all methods: S and frequency of every mode against
/// the angle; and where the mass centre matters, with and without inertial coupling, and the modes against the
/// offset of the mass centre.
///
/// # Errors
///
/// As [`compare`].
pub fn of_case(comparison: &Comparison, table: &CoefficientTable) -> Result<Gallery, InputError> {
    let mut gallery = Gallery::default();
    add_of_case(comparison, table, &mut gallery)?;
    Ok(gallery)
}

fn add_of_case(
    comparison: &Comparison,
    table: &CoefficientTable,
    gallery: &mut Gallery,
) -> Result<(), InputError> {
    modes(comparison, gallery);
    // The mass centre couples the turn with sway and heave, and nothing else.
    let free = comparison.free();
    let is_coupled = free.len() > 1 && free.contains(&Coordinate::Theta);
    match is_coupled && comparison.case.parameters.mass_centre_distance > 0.0 {
        true => gallery.add("inertial_coupling", inertial_coupling(comparison, table)?),
        false => gallery.leave_out(
            &["inertial_coupling"],
            match is_coupled {
                true => "L_g = 0: there is no such coupling",
                false => UNCOUPLED,
            },
        ),
    }
    match is_coupled {
        true => offset(comparison, table, gallery)?,
        false => gallery.leave_out(
            &["damping_against_offset", "frequencies_against_offset"],
            UNCOUPLED,
        ),
    }
    Ok(())
}

const UNCOUPLED: &str = "the mass centre couples theta with x and y, and these are not free";

/// As Figs. 11 and 12: a section that is perfectly tuned, without wind.
fn without_wind(case: &Case, gallery: &mut Gallery) {
    let trajectories = [
        "trajectory_of_mode_1",
        "trajectory_of_mode_2",
        "trajectory_of_mode_3",
    ];
    if !case.parameters.free.are_all() {
        gallery.leave_out(&["frequencies_without_wind"], ALL_FREE);
        gallery.leave_out(&trajectories, ALL_FREE);
        return;
    }
    gallery.add("frequencies_without_wind", frequencies(case));
    let eccentricity = eccentricity(case);
    if eccentricity == 0.0 {
        let why = "L_g = 0: the three frequencies are one, and every motion is a mode";
        gallery.leave_out(&trajectories, why);
        return;
    }
    for (place, own) in trajectories.into_iter().enumerate() {
        gallery.add(own, trajectory::figure(place + 1, eccentricity, name(case)));
    }
}

/// L_g/r.
fn eccentricity(case: &Case) -> f64 {
    case.parameters.small_quantities().e
}

/// The eccentricity of a case, marked.
fn own_offset(case: &Case) -> Option<Own> {
    let value = eccentricity(case);
    Some(Own {
        value,
        label: format!("the case: L_{{g}}/r = {}", given((value * 1e4).round() / 1e4)),
    })
}

/// The usual largest eccentricity, or one between that of the case and 1.
fn largest_offset(usual: f64, case: &Case) -> f64 {
    let own = eccentricity(case);
    match own < usual {
        true => usual,
        false => (own + 1.0) / 2.0,
    }
}

/// S and frequency of every mode against the angle.
fn modes(comparison: &Comparison, gallery: &mut Gallery) {
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
        title: titled(
            "Frequency of every mode against the angle of attack",
            &comparison.case,
        ),
        subtitle: base.subtitle.clone(),
        x_label: base.x_label.clone(),
        is_angle: true,
        y_label: FREQUENCY.into(),
        curves: frequency,
        ..Figure::default()
    };
    match damping.len() {
        1 => gallery.leave_out(
            &["damping_of_modes"],
            "there is one mode, and stability has its damping by the state matrix",
        ),
        _ => gallery.add(
            "damping_of_modes",
            Figure {
                title: titled(
                    "Damping of every mode against the angle of attack",
                    &comparison.case,
                ),
                y_label: DAMPING.into(),
                curves: damping,
                ..base
            },
        ),
    }
    gallery.add("frequencies_of_modes", of_frequency);
}

/// Fig. 11: the frequencies of Eq. (15) against the eccentricity.
fn frequencies(case: &Case) -> Figure {
    let largest = largest_offset(LARGEST_WITHOUT_WIND, case);
    let offsets = (0..=STEPS_WITHOUT_WIND)
        .map(|step| largest * step as f64 / STEPS_WITHOUT_WIND as f64);
    // The angle of the mass centre does not matter.
    let modes: Vec<_> = offsets
        .map(|offset| (offset, TunedSection::new(offset, 0.0).modes()))
        .collect();
    let curve = |place: usize| Curve {
        label: format!("mode {}", place + 1),
        stroke: MODES[place],
        pieces: vec![
            modes
                .iter()
                .map(|(offset, modes)| (*offset, modes[place].frequency))
                .collect(),
        ],
    };
    Figure {
        title: titled(
            "Frequencies without wind against the offset of the mass centre",
            case,
        ),
        subtitle: set(
            case,
            "perfectly tuned: all three natural frequencies are ω_{n}",
        ),
        x_label: OFFSET.into(),
        y_label: "frequency, ω / ω_{n}".into(),
        curves: (0..3).map(curve).collect(),
        own: own_offset(case),
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
    let e = eccentricity(&comparison.case);
    let with = format!("with inertial coupling, L_{{g}}/r = {e:.3}");
    let without = "without, L_{g} = 0".to_string();
    Ok(Figure {
        title: titled(
            "Stability with and without inertial coupling",
            &comparison.case,
        ),
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
fn offset(
    comparison: &Comparison,
    table: &CoefficientTable,
    gallery: &mut Gallery,
) -> Result<(), InputError> {
    let case = &comparison.case;
    let worst = comparison
        .points
        .iter()
        .min_by(|one, other| one.exact.value.total_cmp(&other.exact.value));
    let Some(worst) = worst.map(|point| point.angle) else {
        return Ok(());
    };
    let wrong = |what: String| {
        let help = "correct the case or its table";
        InputError::new(Place::file(&case.file), what, help)
    };
    let curves = CoefficientCurves::new(table, case.interpolation)?;
    let coefficients = curves.at(worst).map_err(|error| wrong(error.to_string()))?;
    let largest = largest_offset(LARGEST, case);
    let points = against_offset(case, coefficients, worst, largest, STEPS)
        .map_err(|error| wrong(error.to_string()))?;
    let subtitle = set(
        case,
        &format!(
            "at the worst angle, α = {}°, and U = {} m/s; modes are numbered at L_{{g}} = 0",
            angle(worst),
            given(case.parameters.wind_speed)
        ),
    );
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
        title: titled(
            "Damping of every mode against the offset of the mass centre",
            case,
        ),
        subtitle: subtitle.clone(),
        x_label: OFFSET.into(),
        y_label: DAMPING.into(),
        shaded: Some("unstable".into()),
        curves: of_modes(|mode| mode.damping.value),
        own: own_offset(case),
        ..Figure::default()
    };
    let frequency = Figure {
        title: titled(
            "Frequency of every mode against the offset of the mass centre",
            case,
        ),
        subtitle,
        x_label: OFFSET.into(),
        y_label: FREQUENCY.into(),
        curves: of_modes(|mode| mode.frequency),
        own: own_offset(case),
        ..Figure::default()
    };
    gallery.add("damping_against_offset", damping);
    gallery.add("frequencies_against_offset", frequency);
    Ok(())
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
    let comparison = compare(&tuned, table)?;
    Ok(Figure {
        title: titled(
            "Closed form beside the state matrix, tuned and undamped",
            case,
        ),
        subtitle: set(
            case,
            &format!(
                "all natural frequencies f_{{y}}, no structural damping; {}",
                sweep(&comparison)
            ),
        ),
        ..stability_figure::figure(&comparison)
    })
}
