//! Figures as SVG, in the manner of a journal: axes with units, a legend beside the curves, styles of lines
//! that are told apart without colour.

mod axis;
mod drawing;
mod legend;
mod map;
mod mark;
mod patch;
mod reading;
mod script;
mod stroke;

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;

use axis::{Axis, extent, tick, to_scale, with_margin};
use drawing::{Area, FONT, draw_line, drawn, px};
use legend::{Entry, Legend, Sample};
use reading::Reading;
use stroke::{dashes, ink};

pub use map::{Map, Panel};
pub use mark::{Mark, Own, Side, Sign};
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
    /// What it is shown for, in a line below the title; empty if there is nothing to say.
    pub subtitle: String,
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
    /// Points that are marked, above the curves.
    pub marks: Vec<Mark>,
    /// The value that a case has of the quantity along the horizontal axis.
    pub own: Option<Own>,
}

/// The width in pixels, and the height of what stands below the legend.
const WIDTH: i32 = 900;
const PLOT: i32 = 488;
/// Room above and below all that stands above the curves; for the title, for the line below it, and for the label of
/// the case's own value.
const GAP: i32 = 10;
const TITLE: i32 = 26;
const SUBTITLE: i32 = 24;
const OWN: i32 = 16;
/// Room on the other sides of the curves.
const LEFT: i32 = 72;
const RIGHT: i32 = 24;
const BOTTOM: i32 = 56;
const SHADE: RGBColor = RGBColor(222, 222, 222);

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

impl Figure {
    /// The figure as SVG, with a title and a description for who does not see it.
    ///
    /// # Errors
    ///
    /// What the drawing library says.
    pub fn svg(&self) -> Result<String, String> {
        let height = self.head() + PLOT;
        drawn([WIDTH, height], &self.reading(), |area| self.draw(area))
    }

    /// Whether both draw the same over the same quantities, whatever they call it.
    pub fn draws_the_same(&self, other: &Figure) -> bool {
        let drawn = |own: &Figure| {
            let curves = own.curves.iter().map(|curve| curve.pieces.clone());
            let patches = own.patches.iter().map(|patch| patch.pieces.clone());
            let places: Vec<_> = own.marks.iter().map(|mark| mark.place).collect();
            (
                curves.collect::<Vec<_>>(),
                patches.collect::<Vec<_>>(),
                places,
            )
        };
        [&self.x_label, &self.y_label] == [&other.x_label, &other.y_label]
            && drawn(self) == drawn(other)
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let (head, below) = area.split_vertically(px(self.head()));
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
        if let Some(own) = &self.own {
            let line = [y.start, y.end].map(|end| chart.backend_coord(&(own.value, end)));
            dashes(area, &line, [px(5), px(4)], ink(BLACK, 1))?;
            own.draw_label(area, line[1])?;
        }
        for curve in &self.curves {
            for piece in &curve.pieces {
                let points = piece.iter().map(|point| chart.backend_coord(point));
                curve.stroke.draw(area, &points.collect::<Vec<_>>())?;
            }
        }
        for mark in &self.marks {
            let place = chart.backend_coord(&mark.place);
            mark.sign.draw(area, place)?;
            mark.draw_letter(area, place)?;
        }
        Ok(())
    }

    /// The height of all that stands above the curves.
    fn head(&self) -> i32 {
        let subtitle = if self.subtitle.is_empty() {
            0
        } else {
            SUBTITLE
        };
        let own = if self.own.is_some() { OWN } else { 0 };
        GAP + TITLE + subtitle + self.legend().height() + own + GAP
    }

    /// What x and y go over.
    fn ranges(&self) -> [Range<f64>; 2] {
        let points = || {
            let curves = self.curves.iter().flat_map(|curve| &curve.pieces);
            let patches = self.patches.iter().flat_map(|patch| &patch.pieces);
            let corners = self.corners.iter().flatten();
            let marks = self.marks.iter().map(|mark| &mark.place);
            curves.chain(patches).flatten().chain(corners).chain(marks)
        };
        let own = self.own.iter().map(|own| own.value);
        let x = extent(points().map(|point| point.0).chain(own));
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
        let room = [WIDTH - LEFT - RIGHT, PLOT - BOTTOM];
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

    /// The title, what it is shown for, and the legend.
    fn draw_head(&self, head: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let mut top = GAP;
        for (text, largest, height) in [(&self.title, 19, TITLE), (&self.subtitle, 15, SUBTITLE)] {
            if !text.is_empty() {
                draw_line(head, text, (LEFT, top), WIDTH - LEFT - RIGHT, largest)?;
                top += height;
            }
        }
        self.legend().draw(head, (LEFT, top))
    }

    /// What each curve, region and mark is.
    fn legend(&self) -> Legend<'_> {
        let entry = |sample, label| Entry { sample, label };
        let curves = self.curves.iter();
        let curves = curves.map(|own| entry(Sample::Line(own.stroke), &own.label));
        let shaded = self.shaded.iter();
        let shaded = shaded.map(|label| entry(Sample::Region(Fill::Shaded), label));
        let patches = self.patches.iter();
        let patches = patches.map(|own| entry(Sample::Region(own.fill), &own.label));
        let marks = self.marks.iter();
        let marks = marks.map(|own| entry(Sample::Point(own.sign), &own.label));
        let entries = curves.chain(shaded).chain(patches).chain(marks);
        Legend {
            entries: entries.collect(),
            width: WIDTH - LEFT - RIGHT,
        }
    }

    /// What is read out.
    fn reading(&self) -> Reading {
        let [x, y] = self.ranges();
        let mut reading = Reading::new(&self.title, &self.subtitle);
        reading.axis("Horizontal", &self.x_label, &x);
        reading.axis("Vertical", &self.y_label, &y);
        for Entry { sample, label } in &self.legend().entries {
            reading.say(&format!("{}: {label}", sample.words()));
        }
        if let Some(own) = &self.own {
            reading.say(&format!("Vertical dashed line: {}", own.label));
        }
        reading
    }
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
                title: "T < U".into(),
                subtitle: "of L_{g}".into(),
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
                marks: vec![Mark {
                    place: (0.0, 3.0),
                    sign: Sign::Disc,
                    letter: "G".into(),
                    side: Side::Above,
                    label: "the mass centre".into(),
                }],
                own: Some(Own {
                    value: 2.0,
                    label: "own".into(),
                }),
            };
            let svg = figure.svg().expect("a figure");
            assert!(svg.contains(r#"width="900""#) && svg.contains("a &lt; b"));
            let drawing = roxmltree::Document::parse(&svg).expect("well-formed SVG");
            let texts = drawing.descendants().filter_map(|node| node.text());
            let texts: Vec<&str> = texts.map(str::trim).collect();
            for text in ["T < U", "1", "and x", "2", "G", "own", "the mass centre"] {
                assert!(texts.contains(&text), "{text}: {texts:?}");
            }
            let root = drawing.root_element();
            let read: Vec<_> = root.children().filter(|own| own.is_element()).collect();
            assert!(root.attribute("role") == Some("img") && read[0].has_tag_name("title"));
            let description = texts.iter().find(|own| own.starts_with("of L_g."));
            let description = description.expect("a description");
            assert!(
                description.contains("Horizontal axis: x_1 and x_2"),
                "{description}"
            );
        }
    }
}
