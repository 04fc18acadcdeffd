//! What a figure is drawn on.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::reading::Reading;
use super::script;

/// What is drawn on; its coordinates are parts of pixels.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

pub(super) const FONT: &str = "sans-serif";

/// Coordinates are whole numbers: so many of them a pixel keep curves smooth.
const FINE: i32 = 4;

/// A line of text with its upper left corner at a place in pixels, smaller where so many pixels would not hold it.
pub(super) fn draw_line(
    area: &Area<'_>,
    text: &str,
    (left, top): (i32, i32),
    width: i32,
    largest: i32,
) -> Result<(), Box<dyn Error>> {
    // Four ninths as wide as high, letter by letter.
    let fitting = width * 9 / 4 / script::length(text).max(1) as i32;
    let style = (FONT, px(fitting.min(largest)));
    Ok(area.draw(&Text::new(text.to_string(), (px(left), px(top)), style))?)
}

/// A drawing of a width and height in pixels as SVG.
pub(super) fn drawn(
    [width, height]: [i32; 2],
    reading: &Reading,
    draw: impl FnOnce(&Area<'_>) -> Result<(), Box<dyn Error>>,
) -> Result<String, String> {
    let mut svg = String::new();
    let whole = || -> Result<(), Box<dyn Error>> {
        let size = (px(width) as u32, px(height) as u32);
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&WHITE)?;
        draw(&area)?;
        Ok(area.present()?)
    };
    whole().map_err(|error| error.to_string())?;
    // It is drawn finely, and shown in its size.
    let size = |width: i32, height: i32| format!(r#"width="{width}" height="{height}""#);
    let svg = svg.replacen(&size(px(width), px(height)), &size(width, height), 1);
    Ok(reading.within(&script::set(&svg)))
}

/// So many pixels in the units of the drawing.
pub(super) fn px(pixels: i32) -> i32 {
    FINE * pixels
}
