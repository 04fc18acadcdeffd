//! How a curve is drawn: styles of lines and marks that are told apart without colour.

use std::error::Error;

use plotters::prelude::*;

use super::{Area, px};

const BLUE_INK: RGBColor = RGBColor(0, 70, 160);
const GREY_INK: RGBColor = RGBColor(80, 80, 80);
const ORANGE_INK: RGBColor = RGBColor(200, 80, 0);

/// Circles or crosses on a curve, at most.
const MOST_MARKS: usize = 45;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A black line.
    Solid,
    /// A blue line of dashes.
    Dashed,
    /// Hollow circles without a line, at some of the points.
    Circles,
    /// Small discs without a line, at all points.
    Dots,
    /// Orange crosses without a line, between the circles.
    Crosses,
    /// A grey line of dots.
    Dotted,
    /// A thin grey line.
    Thin,
}

impl Stroke {
    /// A curve through points of the drawing.
    pub(super) fn draw(self, area: &Area<'_>, points: &[(i32, i32)]) -> Result<(), Box<dyn Error>> {
        let every = points.len().div_ceil(MOST_MARKS).max(1);
        let line = points.iter().copied();
        match self {
            Stroke::Solid => area.draw(&PathElement::new(points, ink(BLACK, 2)))?,
            Stroke::Thin => area.draw(&PathElement::new(points, ink(GREY_INK, 1)))?,
            Stroke::Dashed => dashes(area, points, [px(9), px(5)], ink(BLUE_INK, 2))?,
            Stroke::Dotted => dashes(area, points, [px(2), px(3)], ink(GREY_INK, 2))?,
            Stroke::Circles => {
                for point in line.step_by(every) {
                    area.draw(&Circle::new(point, px(4), ink(BLACK, 1)))?;
                }
            }
            Stroke::Dots => {
                for point in line {
                    area.draw(&Circle::new(point, px(2), BLACK.filled()))?;
                }
            }
            Stroke::Crosses => {
                for point in line.skip(every / 2).step_by(every) {
                    area.draw(&Cross::new(point, px(4), ink(ORANGE_INK, 2)))?;
                }
            }
        }
        Ok(())
    }

    /// What a reader is told that it looks like.
    pub(super) fn words(self) -> &'static str {
        match self {
            Stroke::Solid => "Solid line",
            Stroke::Thin => "Thin line",
            Stroke::Dashed => "Dashed line",
            Stroke::Dotted => "Dotted line",
            Stroke::Circles => "Circles",
            Stroke::Dots => "Dots",
            Stroke::Crosses => "Crosses",
        }
    }

    /// Where the points of its sample in a legend stand, in pixels from the left, in a width of so many.
    pub(super) fn sample(self, width: i32) -> [i32; 2] {
        match self {
            Stroke::Circles | Stroke::Crosses => [width / 6, width - width / 6],
            _ => [0, width],
        }
    }
}

/// A line in so many pixels.
pub(super) fn ink(colour: RGBColor, pixels: i32) -> ShapeStyle {
    colour.stroke_width(px(pixels) as u32)
}

/// A line of dashes, with the lengths of a dash and of a gap.
pub(super) fn dashes(
    area: &Area<'_>,
    points: &[(i32, i32)],
    [dash, gap]: [i32; 2],
    style: ShapeStyle,
) -> Result<(), Box<dyn Error>> {
    for part in DashedLineSeries::new(points.iter().copied(), dash, gap, style) {
        area.draw(&part)?;
    }
    Ok(())
}
