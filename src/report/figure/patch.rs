//! What is filled: regions that are told apart without colour.

use std::error::Error;

use plotters::prelude::*;

use super::stroke::ink;
use super::{Area, SHADE, px};

/// Regions with something in common.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Their name in the legend.
    pub label: String,
    /// How they are drawn.
    pub fill: Fill,
    /// The corners (x, y) of each, around it.
    pub pieces: Vec<Vec<(f64, f64)>>,
}

/// How a region is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// In grey.
    Shaded,
    /// In a darker grey.
    Dark,
    /// With strokes from corner to corner.
    Hatched,
}

const DARK: RGBColor = RGBColor(160, 160, 160);

/// Pixels between the strokes of what is hatched.
const DISTANCE: i32 = 8;

impl Fill {
    /// What a reader is told that it looks like.
    pub(super) fn words(self) -> &'static str {
        match self {
            Fill::Shaded => "Shaded",
            Fill::Dark => "Shaded darker",
            Fill::Hatched => "Hatched",
        }
    }

    /// A region with these corners in the drawing.
    pub(super) fn draw(
        self,
        area: &Area<'_>,
        corners: &[(i32, i32)],
    ) -> Result<(), Box<dyn Error>> {
        match self {
            Fill::Shaded => shade(area, corners, SHADE)?,
            Fill::Dark => shade(area, corners, DARK)?,
            Fill::Hatched => {
                for stroke in hatches(corners, px(DISTANCE)) {
                    area.draw(&PathElement::new(stroke, ink(BLACK, 1)))?;
                }
            }
        }
        Ok(())
    }
}

/// Filled, and drawn around: no seam is seen between neighbours.
fn shade(area: &Area<'_>, corners: &[(i32, i32)], grey: RGBColor) -> Result<(), Box<dyn Error>> {
    area.draw(&Polygon::new(corners, grey.filled()))?;
    let around: Vec<_> = corners.iter().chain(corners.first()).copied().collect();
    area.draw(&PathElement::new(around, ink(grey, 1)))?;
    Ok(())
}

/// The parts of the lines x + y = k·distance that lie within a polygon.
fn hatches(corners: &[(i32, i32)], distance: i32) -> Vec<[(i32, i32); 2]> {
    let sum = |&(x, y): &(i32, i32)| x + y;
    let sums = corners.iter().map(sum);
    let (Some(least), Some(largest)) = (sums.clone().min(), sums.max()) else {
        return Vec::new();
    };
    let next = corners.iter().cycle().skip(1);
    let edges: Vec<_> = corners.iter().zip(next).collect();
    let mut strokes = Vec::new();
    for count in least.div_euclid(distance)..=largest.div_euclid(distance) {
        let line = count * distance;
        let crossing = |(from, to): &(&(i32, i32), &(i32, i32))| {
            let (before, after) = (sum(from) - line, sum(to) - line);
            ((before < 0) != (after < 0)).then(|| {
                let share = f64::from(before) / f64::from(before - after);
                let x = f64::from(from.0) + share * f64::from(to.0 - from.0);
                let x = x.round() as i32;
                (x, line - x)
            })
        };
        let mut crossings: Vec<(i32, i32)> = edges.iter().filter_map(crossing).collect();
        crossings.sort_unstable();
        let within = crossings.chunks_exact(2);
        let own = within.map(|pair| [pair[0], pair[1]]);
        strokes.extend(own.filter(|[from, to]| from != to));
    }
    strokes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_lie_within_what_is_hatched() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)];
        assert_eq!(
            hatches(&square, 5),
            [[(0, 5), (5, 0)], [(0, 10), (10, 0)], [(5, 10), (10, 5)]]
        );
        // Both arms, and nothing between them.
        let fork = [
            (0, 0),
            (12, 0),
            (12, 12),
            (8, 12),
            (8, 4),
            (4, 4),
            (4, 12),
            (0, 12),
        ];
        assert!(hatches(&fork, 10).contains(&[(0, 10), (4, 6)]));
        assert!(hatches(&fork, 10).contains(&[(6, 4), (10, 0)]));
        assert!(hatches(&[], 5).is_empty() && hatches(&[(1, 1)], 5).is_empty());
    }
}
