//! The paper's kinds of figures, on any case.

mod angles;
mod coefficients;
mod offsets;

use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Comparison, compare};
use crate::stability::coordinate::Coordinate;
use crate::stability::input::InputError;

use super::figure::{Curve, Figure, Stroke};
use super::{stability_figure, trajectory};
use angles::{closed_form, inertial_coupling, modes};
use coefficients::coefficients;
use offsets::{eccentricity, frequencies, offset};

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
        self.left_out
            .extend(names.map(|own| (*own, why.to_string())));
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
    match (case.parameters.free.are_all(), case.is_twisted()) {
        (true, false) => gallery.add("closed_form", closed_form(case, table)?),
        // Another stiffness of the turn has another twist.
        (true, true) => {
            gallery.leave_out(&["closed_form"], "the tuned section has another mean twist")
        }
        (false, _) => gallery.leave_out(&["closed_form"], ALL_FREE),
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
    coefficients(comparison, table, gallery);
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
        gallery.add(
            own,
            trajectory::figure(place + 1, eccentricity, stability_figure::name(case)),
        );
    }
}

/// A curve a mode, in pieces where it is not there.
fn by_mode(pieces: impl Fn(usize) -> Vec<Vec<(f64, f64)>>) -> Vec<Curve> {
    let curve = |(place, stroke): (usize, Stroke)| Curve {
        label: format!("mode {}", place + 1),
        stroke,
        pieces: pieces(place + 1),
    };
    let curves = MODES.into_iter().enumerate().map(curve);
    curves.filter(|curve| !curve.pieces.is_empty()).collect()
}
