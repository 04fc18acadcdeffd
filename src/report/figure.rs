//! Figures as SVG, in the manner of a journal: axes with units, a legend beside the curves, styles of lines
//! that are told apart without colour.

mod axis;
mod map;
mod patch;
mod stroke;
mod subscript;

use std::error::Error;
use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

use axis::{Axis, extent, tick, to_scale, with_margin};
use stroke::ink;

pub use map::{Map, Panel};
pub use patch::{Fill, Patch};
pub use stroke::Stroke;

/// A curve in pieces, between which there is nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub label: String,
    /// How it is drawn.
    pub stroke: Stroke,
    /// Points (x, y) in order, in pieces.
    pub pieces: Vec<Vec<(f64, f64)>>,
}

/// Curves over an axis. In its texts `L_{g}` is L with the subscript g.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// What is shown.
    pub title: String,
    /// The quantity along the horizontal axis, with its unit.
    pub x_label: String,
    /// Whether the horizontal axis shows degrees, and is marked at parts of a right angle.
    pub is_angle: bool,
    /// The quantity along the vertical axis, with its unit.
    pub y_label: String,
    /// What is shaded below y = 0, as the legend calls it; `None` if nothing is.
    pub shaded: Option<String>,
    /// Two opposite corners; `None` for axes that hold all that is drawn, with a margin.
    pub corners: Option<[(f64, f64); 2]>,
    /// What is filled, below the curves.
    pub patches: Vec<Patch>,
    /// Whether both axes have one scale.
    pub is_to_scale: bool,
    /// The curves, the first below the others.
    pub curves: Vec<Curve>,
}

/// The size in pixels.
const WIDTH: i32 = 900;
const HEIGHT: i32 = 560;
/// Coordinates are whole numbers: so many of them a pixel keep curves smooth.
const FINE: i32 = 4;
/// Room for the title and the legend, above the curves.
const HEAD: i32 = 72;
/// Room on the other sides of the curves.
const LEFT: i32 = 72;
const RIGHT: i32 = 24;
const BOTTOM: i32 = 56;
const FONT: &str = "sans-serif";
const SHADE: RGBColor = RGBColor(222, 222, 222);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

impl Figure {
    /// The figure as SVG.
    ///
    /// # Errors
    ///
    /// What the drawing library says.
    pub fn svg(&self) -> Result<String, String> {
        drawn([WIDTH, HEIGHT], |area| self.draw(area))
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let (head, below) = area.split_vertically(px(HEAD));
        self.draw_head(&head)?;
        let [x, y] = self.ranges();
        let mut chart = ChartBuilder::on(&below)
            .margin_right(px(RIGHT))
            .margin_left(px(8))
            .margin_bottom(px(8))
            .x_label_area_size(px(BOTTOM - 8))
            .y_label_area_size(px(LEFT - 8))
            .build_cartesian_2d(
                Axis::new(x.clone(), self.is_angle),
                Axis::new(y.clone(), false),
            )?;
        if self.shaded.is_some() {
            let corners = [(x.start, y.start), (x.end, 0.0)];
            chart.draw_series([Rectangle::new(corners, SHADE.filled())])?;
        }
        for patch in &self.patches {
            for piece in &patch.pieces {
                let corners = piece.iter().map(|point| chart.backend_coord(point));
                patch.fill.draw(area, &corners.collect::<Vec<_>>())?;
            }
        }
        self.draw_mesh(&mut chart)?;
        if self.shaded.is_some() {
            let zero = [(x.start, 0.0), (x.end, 0.0)];
            chart.draw_series([PathElement::new(zero, ink(BLACK, 1))])?;
        }
        for curve in &self.curves {
            for piece in &curve.pieces {
                let points = piece.iter().map(|point| chart.backend_coord(point));
                curve.stroke.draw(area, &points.collect::<Vec<_>>())?;
            }
        }
        Ok(())
    }

    /// What x and y go over.
    fn ranges(&self) -> [Range<f64>; 2] {
        let points = || {
            let curves = self.curves.iter().flat_map(|curve| &curve.pieces);
            let patches = self.patches.iter().flat_map(|patch| &patch.pieces);
            let corners = self.corners.iter().flatten();
            curves.chain(patches).flatten().chain(corners)
        };
        let x = extent(points().map(|point| point.0));
        // What is shaded ends at 0.
        let zero = self.shaded.iter().map(|_| 0.0);
        let y = extent(points().map(|point| point.1).chain(zero));
        let y = match self.corners {
            None => with_margin(y),
            Some(_) => y,
        };
        if !self.is_to_scale {
            return [x, y];
        }
        let room = [WIDTH - LEFT - RIGHT, HEIGHT - HEAD - BOTTOM];
        to_scale(x, y, room.map(f64::from)).into()
    }

    fn draw_mesh(&self, chart: &mut Chart<'_, '_>) -> Result<(), Box<dyn Error>> {
        chart
            .configure_mesh()
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .set_all_tick_mark_size(px(5))
            .axis_desc_style((FONT, px(17)))
            .label_style((FONT, px(15)))
            .axis_style(ink(BLACK, 1))
            .bold_line_style(BLACK.mix(0.12).stroke_width(px(1) as u32))
            .light_line_style(TRANSPARENT)
            .draw()?;
        Ok(())
    }

    /// The title, and the legend in one line below it.
    fn draw_head(&self, head: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let text = |text: &str, place, pixels| {
            head.draw(&Text::new(text.to_string(), place, (FONT, px(pixels))))
        };
        // Four ninths as wide as high, letter by letter.
        let room = (WIDTH - LEFT - RIGHT) * 9 / 4 / subscript::length(&self.title).max(1) as i32;
        text(&self.title, (px(LEFT), px(12)), room.min(19))?;
        let (mut left, middle, length) = (px(LEFT), px(52), px(36));
        let label = |left: &mut i32, label: &str| {
            let place = (*left + length + px(8), middle - px(6));
            // Fonts are the viewer's: room for wide letters.
            *left += length + px(32) + px(7) * subscript::length(label) as i32;
            text(label, place, 15)
        };
        for curve in &self.curves {
            let sample = curve.stroke.sample(length);
            let points = sample.map(|place| (left + place, middle));
            curve.stroke.draw(head, &points)?;
            label(&mut left, &curve.label)?;
        }
        if let Some(shaded) = &self.shaded {
            let corners = [(left, middle - px(8)), (left + length, middle + px(8))];
            head.draw(&Rectangle::new(corners, SHADE.filled()))?;
            label(&mut left, shaded)?;
        }
        for patch in &self.patches {
            let [right, top, bottom] = [left + length, middle - px(8), middle + px(8)];
            let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
            patch.fill.draw(head, &corners)?;
            label(&mut left, &patch.label)?;
        }
        Ok(())
    }
}

/// A drawing of a width and height in pixels as SVG.
fn drawn(
    [width, height]: [i32; 2],
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
    Ok(subscript::set(&svg))
}

/// So many pixels in the units of the drawing.
fn px(pixels: i32) -> i32 {
    FINE * pixels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_nothing_and_of_one_point_are_drawn() {
        for pieces in [vec![], vec![vec![(1.0, 2.0)]]] {
            let stroke = Stroke::Dashed;
            let label = "a < b".into();
            let figure = Figure {
                title: "T".into(),
                x_label: "x_{1} and x_{2}".into(),
                is_angle: true,
                y_label: "y".into(),
                shaded: Some("s".into()),
                corners: None,
                patches: Vec::new(),
                is_to_scale: true,
                curves: vec![Curve {
                    label,
                    stroke,
                    pieces,
                }],
            };
            let svg = figure.svg().expect("a figure");
            assert!(svg.contains(r#"width="900" height="560""#) && svg.contains("a &lt; b"));
            let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
            let texts = drawing.descendants().filter_map(|node| node.text());
            let texts: Vec<&str> = texts.map(str::trim).collect();
            assert!(texts.contains(&"1") && texts.contains(&"and x") && texts.contains(&"2"));
        }
    }
}
