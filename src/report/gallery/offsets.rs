//! Figures against the offset of the mass centre, with that of the case marked.

use crate::report::figure::{Curve, Figure, Own};
use crate::report::stability::{given, significant};
use crate::report::stability_figure::{set, titled, without_gaps};
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Comparison, FollowedMode, angle};
use crate::stability::input::{InputError, Place};
use crate::stability::offset::{OffsetPoint, against_offset};
use crate::stability::sections::Sections;
use crate::stability::tuned_modes::TunedSection;

use super::{DAMPING, FREQUENCY, Gallery, MODES, by_mode};

const OFFSET: &str = "offset of the mass centre, L_{g} / r";

/// Steps of the eccentricity, and the largest where the case has none that is larger: in the wind, and without.
const STEPS: usize = 400;
const LARGEST: f64 = 0.6;
const STEPS_WITHOUT_WIND: usize = 180;
const LARGEST_WITHOUT_WIND: f64 = 0.9;

/// L_g/r.
pub(super) fn eccentricity(case: &Case) -> f64 {
    case.parameters.small_quantities().e
}

/// The eccentricity of a case, marked.
fn own_offset(case: &Case) -> Own {
    let value = eccentricity(case);
    Own {
        value,
        label: format!("the case: L_{{g}}/r = {}", significant(value, 4)),
    }
}

/// The usual largest eccentricity, or one between that of the case and 1.
fn largest_offset(usual: f64, case: &Case) -> f64 {
    let own = eccentricity(case);
    match own < usual {
        true => usual,
        false => (own + 1.0) / 2.0,
    }
}

/// Fig. 11: the frequencies of Eq. (15) against the eccentricity.
pub(super) fn frequencies(case: &Case) -> Figure {
    let largest = largest_offset(LARGEST_WITHOUT_WIND, case);
    let offsets =
        (0..=STEPS_WITHOUT_WIND).map(|step| largest * step as f64 / STEPS_WITHOUT_WIND as f64);
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
        own: Some(own_offset(case)),
        ..Figure::default()
    }
}

/// As Fig. 7: S and frequency of every mode against the offset of G, at the angle with the least S.
pub(super) fn offset(
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
    let (section, _) = Sections::new(case, table)?.at(worst, table)?;
    let points = against_offset(&section, largest_offset(LARGEST, case), STEPS)
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
            without_gaps(&points.iter().map(value).collect::<Vec<_>>())
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
        own: Some(own_offset(case)),
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
        own: Some(own_offset(case)),
        ..Figure::default()
    };
    gallery.add("damping_against_offset", damping);
    gallery.add("frequencies_against_offset", frequency);
    Ok(())
}
