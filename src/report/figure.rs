//! Figures as SVG, in the manner of a journal: axes with units, a legend beside the curves, styles of lines
//! that are told apart without colour.

use std::error::Error;
use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A black line.
    Solid,
    /// A blue line of dashes.
    Dashed,
    /// Hollow circles without a line, at some of the points.
    Circles,
    /// Orange crosses without a line, between the circles.
    Crosses,
    /// A grey line of dots.
    Dotted,
    /// A thin grey line.
    Thin,
}

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

/// Curves over an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// What is shown.
    pub title: String,
    /// The quantity along the horizontal axis, with its unit.
    pub x_label: String,
    /// The quantity along the vertical axis, with its unit.
    pub y_label: String,
    /// What is shaded below y = 0, as the legend calls it; `None` if nothing is.
    pub shaded: Option<String>,
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
const BLUE_INK: RGBColor = RGBColor(0, 70, 160);
const GREY_INK: RGBColor = RGBColor(80, 80, 80);
const ORANGE_INK: RGBColor = RGBColor(200, 80, 0);
/// Circles or crosses on a curve, at most.
const MOST_MARKS: usize = 45;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

impl Figure {
    /// The figure as SVG.
    ///
    /// # Errors
    ///
    /// What the drawing library says.
    pub fn svg(&self) -> Result<String, String> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| error.to_string())?;
        // It is drawn finely, and shown in its size.
        let size = |width: i32, height: i32| format!(r#"width="{width}" height="{height}""#);
        Ok(svg.replacen(&size(px(WIDTH), px(HEIGHT)), &size(WIDTH, HEIGHT), 1))
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let area =
            SVGBackend::with_string(svg, (px(WIDTH) as u32, px(HEIGHT) as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        let (head, below) = area.split_vertically(px(HEAD));
        self.draw_head(&head)?;
        let (x, y) = (self.extent(|point| point.0), self.extent(|point| point.1));
        let y = if self.shaded.is_some() {
            y.start.min(0.0)..y.end.max(0.0)
        } else {
            y
        };
        let margin = 0.05 * (y.end - y.start);
        let y = y.start - margin..y.end + margin;
        let (x, y) = if self.is_to_scale {
            to_scale(x, y)
        } else {
            (x, y)
        };
        let mut chart = ChartBuilder::on(&below)
            .margin_right(px(RIGHT))
            .margin_left(px(8))
            .margin_bottom(px(8))
            .x_label_area_size(px(BOTTOM - 8))
            .y_label_area_size(px(LEFT - 8))
            .build_cartesian_2d(x.clone(), y.clone())?;
        if self.shaded.is_some() {
            let corners = [(x.start, y.start), (x.end, 0.0)];
            chart.draw_series([Rectangle::new(corners, SHADE.filled())])?;
        }
        chart
            .configure_mesh()
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .x_labels(10)
            .y_labels(9)
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .set_all_tick_mark_size(px(5))
            .axis_desc_style((FONT, px(17)))
            .label_style((FONT, px(15)))
            .axis_style(ink(BLACK, 1))
            .bold_line_style(BLACK.mix(0.12).stroke_width(px(1) as u32))
            .light_line_style(TRANSPARENT)
            .draw()?;
        if self.shaded.is_some() {
            let zero = [(x.start, 0.0), (x.end, 0.0)];
            chart.draw_series([PathElement::new(zero, ink(BLACK, 1))])?;
        }
        for curve in &self.curves {
            for piece in &curve.pieces {
                let points = piece.iter().copied();
                match curve.stroke {
                    Stroke::Circles => {
                        let every = piece.len().div_ceil(MOST_MARKS).max(1);
                        let circle = |point| Circle::new(point, px(4), ink(BLACK, 1));
                        chart.draw_series(points.step_by(every).map(circle))?;
                    }
                    Stroke::Crosses => {
                        let every = piece.len().div_ceil(MOST_MARKS).max(1);
                        let cross = |point| Cross::new(point, px(4), ink(ORANGE_INK, 2));
                        chart.draw_series(points.skip(every / 2).step_by(every).map(cross))?;
                    }
                    Stroke::Solid => {
                        chart.draw_series(LineSeries::new(points, ink(BLACK, 2)))?;
                    }
                    Stroke::Thin => {
                        chart.draw_series(LineSeries::new(points, ink(GREY_INK, 1)))?;
                    }
                    stroke => {
                        let (dash, gap, style) = dashes(stroke);
                        chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?;
                    }
                }
            }
        }
        area.present()?;
        Ok(())
    }

    /// The title, and the legend in one line below it.
    fn draw_head(&self, head: &Area<'_>) -> Result<(), Box<dyn Error>> {
        head.draw(&Text::new(
            self.title.clone(),
            (px(72), px(12)),
            (FONT, px(19)),
        ))?;
        let (mut left, middle) = (px(72), px(52));
        let length = px(36);
        let label = |left: &mut i32, text: &str| -> Result<(), Box<dyn Error>> {
            let place = (*left + length + px(8), middle - px(6));
            head.draw(&Text::new(text.to_string(), place, (FONT, px(15))))?;
            // Fonts are the viewer's: room for wide letters.
            *left += length + px(32) + px(7) * text.chars().count() as i32;
            Ok(())
        };
        for curve in &self.curves {
            let line = [(left, middle), (left + length, middle)];
            match curve.stroke {
                Stroke::Circles => {
                    for place in [px(6), px(30)] {
                        let centre = (left + place, middle);
                        head.draw(&Circle::new(centre, px(4), ink(BLACK, 1)))?;
                    }
                }
                Stroke::Crosses => {
                    for place in [px(6), px(30)] {
                        let centre = (left + place, middle);
                        head.draw(&Cross::new(centre, px(4), ink(ORANGE_INK, 2)))?;
                    }
                }
                Stroke::Solid => head.draw(&PathElement::new(line, ink(BLACK, 2)))?,
                Stroke::Thin => head.draw(&PathElement::new(line, ink(GREY_INK, 1)))?,
                stroke => {
                    let (dash, gap, style) = dashes(stroke);
                    for start in (0..length).step_by((dash + gap) as usize) {
                        let end = (start + dash).min(length);
                        let part = [(left + start, middle), (left + end, middle)];
                        head.draw(&PathElement::new(part, style))?;
                    }
                }
            }
            label(&mut left, &curve.label)?;
        }
        if let Some(shaded) = &self.shaded {
            let corners = [(left, middle - px(8)), (left + length, middle + px(8))];
            head.draw(&Rectangle::new(corners, SHADE.filled()))?;
            label(&mut left, shaded)?;
        }
        Ok(())
    }

    /// From the least to the largest, and a little of both if they are one.
    fn extent(&self, part: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let points = self
            .curves
            .iter()
            .flat_map(|curve| curve.pieces.iter().flatten());
        let (least, largest) = points.map(part).fold(
            (f64::INFINITY, f64::NEG_INFINITY),
            |(least, largest), own| (least.min(own), largest.max(own)),
        );
        if largest > least {
            least..largest
        } else if least.is_finite() {
            least - 1.0..least + 1.0
        } else {
            0.0..1.0
        }
    }
}

/// Ranges around the same middles, of one scale, so that both fit.
fn to_scale(x: Range<f64>, y: Range<f64>) -> (Range<f64>, Range<f64>) {
    let (width, height) = (
        f64::from(WIDTH - LEFT - RIGHT),
        f64::from(HEIGHT - HEAD - BOTTOM),
    );
    let pixel = ((x.end - x.start) / width).max((y.end - y.start) / height);
    let around = |range: Range<f64>, pixels: f64| {
        let (middle, half) = ((range.start + range.end) / 2.0, pixels * pixel / 2.0);
        middle - half..middle + half
    };
    (around(x, width), around(y, height))
}

/// So many pixels in the units of the drawing.
fn px(pixels: i32) -> i32 {
    FINE * pixels
}

fn ink(colour: RGBColor, pixels: i32) -> ShapeStyle {
    colour.stroke_width(px(pixels) as u32)
}

/// Lengths of dashes and gaps.
fn dashes(stroke: Stroke) -> (i32, i32, ShapeStyle) {
    match stroke {
        Stroke::Dotted => (px(2), px(3), ink(GREY_INK, 2)),
        _ => (px(9), px(5), ink(BLUE_INK, 2)),
    }
}

/// A number on an axis: no zeros at its end, and a minus sign as wide as a plus.
fn tick(number: &f64) -> String {
    let text = format!("{:.6}", number + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" => "0".to_string(),
        _ => text.replace('-', "\u{2212}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_have_the_digits_that_say_something() {
        for (number, text) in [
            (0.0, "0"),
            (-1e-9, "0"),
            (20.0, "20"),
            (-0.5, "\u{2212}0.5"),
            (0.30000000000000004, "0.3"),
        ] {
            assert_eq!(tick(&number), text);
        }
    }

    #[test]
    fn figures_of_nothing_and_of_one_point_are_drawn() {
        for pieces in [vec![], vec![vec![(1.0, 2.0)]]] {
            let stroke = Stroke::Dashed;
            let label = "a < b".into();
            let figure = Figure {
                title: "T".into(),
                x_label: "x".into(),
                y_label: "y".into(),
                shaded: Some("s".into()),
                is_to_scale: true,
                curves: vec![Curve {
                    label,
                    stroke,
                    pieces,
                }],
            };
            let svg = figure.svg().expect("a figure");
            assert!(svg.contains(r#"width="900" height="560""#) && svg.contains("a &lt; b"));
        }
    }
}
