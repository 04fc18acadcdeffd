//! Trajectories of the three modes of a perfectly tuned section without wind, as Fig. 12 of the paper.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

use crate::stability::tuned_modes::{BodyPoint, TunedSection};

use super::figure::{Curve, Figure, Mark, Side, Sign, Stroke};

/// α_g + θ_0 that is drawn, in rad: that of the paper. Another one turns the picture.
const DIRECTION: f64 = FRAC_PI_6;

/// The largest turn that is drawn, in rad; shapes do not depend on it.
const TURN: f64 = 0.4;

/// Positions of the body in half a period.
const SNAPSHOTS: usize = 13;

/// Mode 1, 2 or 3 for e = L_g/r above 0: the path of the elastic centre O, and a line of the body at equal intervals
/// of time, which goes through O and G where the mode turns, and else across that; O, G and the centre of rotation.
///
/// All points move along straight lines, as far as the linear theory moves them.
pub fn figure(mode: usize, eccentricity: f64, name: &str) -> Figure {
    let section = TunedSection::new(eccentricity, DIRECTION);
    let motion = section.modes()[mode - 1].shape.map(|own| TURN * own);
    let point = |distance, angle| section.point(distance, angle, motion);
    let centre = section.centre_of_rotation(motion);
    let (ends, line) = match centre {
        Some(_) => (
            [point(-1.0, 0.0), point(1.0, 0.0)],
            "line of the body through O and G",
        ),
        // Lines along the path would hide each other.
        None => (
            [point(0.25, -FRAC_PI_2), point(0.25, FRAC_PI_2)],
            "line of the body across that from O to G",
        ),
    };
    let snapshots = (0..SNAPSHOTS).map(|place| PI * place as f64 / (SNAPSHOTS - 1) as f64);
    let snapshots = snapshots.map(|time| ends.map(|end| at(&end, time)).to_vec());
    let elastic_centre = point(0.0, 0.0);
    let mark = |place: &BodyPoint, sign, letter: &str, side, label: &str| Mark {
        place: place.at_rest.into(),
        sign,
        letter: letter.into(),
        side,
        label: label.into(),
    };
    let mut marks = vec![
        mark(
            &elastic_centre,
            Sign::Ring,
            "O",
            Side::Beside,
            "O, elastic centre",
        ),
        mark(
            &point(eccentricity, 0.0),
            Sign::Disc,
            "G",
            Side::Above,
            "G, mass centre",
        ),
    ];
    marks.extend(centre.map(|distance| {
        let label = "C, centre of rotation";
        mark(&point(distance, 0.0), Sign::Cross, "C", Side::Above, label)
    }));
    Figure {
        title: format!("Mode {mode} without wind {}: {name}", words(centre)),
        subtitle: format!(
            "perfectly tuned, L_{{g}}/r = {eccentricity:.3}, α_{{g}} + θ_{{0}} = 30°; linear, as the theory is; at equal \
             intervals of time"
        ),
        x_label: "x / r".into(),
        y_label: "y / r".into(),
        is_to_scale: true,
        curves: vec![
            Curve {
                label: line.into(),
                stroke: Stroke::Thin,
                pieces: snapshots.collect(),
            },
            Curve {
                label: "path of O".into(),
                stroke: Stroke::Solid,
                pieces: vec![[0.0, PI].map(|time| at(&elastic_centre, time)).to_vec()],
            },
        ],
        marks,
        ..Figure::default()
    }
}

/// Where a point is at a time, in parts of which 2π are a period.
fn at(point: &BodyPoint, time: f64) -> (f64, f64) {
    let along = |axis: usize| point.at_rest[axis] + time.cos() * point.displacement[axis];
    (along(0), along(1))
}

/// What a mode does.
fn words(centre: Option<f64>) -> String {
    match centre {
        Some(distance) => format!(
            "turns about C, {:.2} r from O, {}",
            distance.abs(),
            if distance > 0.0 {
                "towards G"
            } else {
                "away from G"
            }
        ),
        None => "moves along the line from O to G".into(),
    }
}
