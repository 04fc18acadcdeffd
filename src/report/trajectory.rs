//! Trajectories of the three modes of a perfectly tuned section without wind, as Fig. 12 of the paper.

use std::f64::consts::{FRAC_PI_6, PI};

use super::figure::{Curve, Figure, Stroke};

/// The largest turn that is drawn, in rad; shapes do not depend on it.
const TURN: f64 = 0.4;

/// Positions of the body in half a period.
const SNAPSHOTS: usize = 13;

/// Mode 1, 2 or 3 at α_{{g}} + θ_{{0}} = 30°: the path of the elastic centre O, and the line from O through the mass
/// centre, of the length r, at equal intervals of time; in mode 2 a line across it.
///
/// The eigenvectors below Eq. (15), for φ = 30°: (−r sin φ, −r cos φ, 1), (−cot φ, 1, 0),
/// (r sin φ, r cos φ, 1); they depend on φ alone, not on the offset.
pub fn figure(mode: usize) -> Figure {
    let (sin, cos) = FRAC_PI_6.sin_cos();
    // x/r, y/r, θ; the second one is scaled to the length of the others.
    let (shape, what) = match mode {
        1 => (
            [-sin, -cos, 1.0],
            "turns about the point at r from O, on the side of G",
        ),
        2 => ([-cos, sin, 0.0], "moves along the line from O to G"),
        _ => (
            [sin, cos, 1.0],
            "turns about the point at r from O, opposite to G",
        ),
    };
    let at = |time: f64| shape.map(|own| TURN * own * time.cos());
    let snapshots = (0..SNAPSHOTS).map(|place| at(PI * place as f64 / (SNAPSHOTS - 1) as f64));
    let line = |[x, y, turn]: [f64; 3]| {
        let (sin, cos) = (FRAC_PI_6 + turn).sin_cos();
        match mode {
            // Lines along the path would hide each other.
            2 => vec![
                (x - sin / 4.0, y - cos / 4.0),
                (x + sin / 4.0, y + cos / 4.0),
            ],
            _ => vec![(x, y), (x - cos, y + sin)],
        }
    };
    let line_label = match mode {
        2 => "line through O, across that to G",
        _ => "line from O through G, of length r",
    };
    let path = [at(0.0), at(PI)].map(|[x, y, _]| (x, y)).to_vec();
    Figure {
        title: format!("Mode {mode} {what}; α_{{g}} + θ_{{0}} = 30°"),
        x_label: "x / r".into(),
        y_label: "y / r".into(),
        is_to_scale: true,
        curves: vec![
            Curve {
                label: line_label.into(),
                stroke: Stroke::Thin,
                pieces: snapshots.map(line).collect(),
            },
            Curve {
                label: "path of O".into(),
                stroke: Stroke::Solid,
                pieces: vec![path],
            },
        ],
        ..Figure::default()
    }
}
