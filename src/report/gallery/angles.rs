//! Figures against the angle of attack.

use crate::report::figure::{Curve, Figure, Stroke};
use crate::report::stability::sweep;
use crate::report::stability_figure::{self, pieces, set, titled, without_gaps};
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Comparison, Value, compare};
use crate::stability::grid::{Grid, Methods, Rows};
use crate::stability::input::InputError;
use crate::stability::variable::Variable;

use super::offsets::eccentricity;
use super::{DAMPING, FREQUENCY, Gallery, by_mode};

/// So many sections are computed at once.
const AT_ONCE: u64 = 1024;

/// S and frequency of every mode against the angle.
pub(super) fn modes(comparison: &Comparison, gallery: &mut Gallery) {
    let base = stability_figure::figure(comparison);
    let damping =
        by_mode(|label| pieces(comparison, &|point| Some(point.mode(label)?.damping.value)));
    let frequency =
        by_mode(|label| pieces(comparison, &|point| Some(point.mode(label)?.frequency)));
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

/// As Figs. 3–6 and 9: the case as it is, and with G at O.
pub(super) fn inertial_coupling(
    comparison: &Comparison,
    table: &CoefficientTable,
) -> Result<Figure, InputError> {
    let mut centred = comparison.case.clone();
    centred.parameters.mass_centre_distance = 0.0;
    let offset = Variable::MASS_CENTRE_DISTANCE;
    centred.set.retain(|own| !own.variable.clashes(offset));
    let centred = exact(&centred, table)?;
    let own = pieces(comparison, &|point| Some(point.exact.value));
    let angles = comparison.at_all_angles().into_iter().zip(centred);
    // The curve has a gap where there is no answer.
    let centred: Vec<_> = angles
        .map(|((angle, _), exact)| Some((angle, exact?.value)))
        .collect();
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
            curve(with, Stroke::Solid, own),
            curve(without, Stroke::Dashed, without_gaps(&centred)),
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

/// As Figs. 13 and 14: all frequencies those of heave, no structural damping and no aerodynamic stiffness.
pub(super) fn closed_form(case: &Case, table: &CoefficientTable) -> Result<Figure, InputError> {
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
