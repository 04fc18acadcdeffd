//! Maps: errors over two quantities, in shades of grey, side by side.

use std::error::Error;

use plotters::prelude::*;

use super::axis::{Axis, power};
use super::mark::Sign;
use super::reading::Reading;
use super::stroke::{Stroke, ink};
use super::{Area, FONT, draw_line, drawn, px, script};

/// Maps over the same two quantities, both on logarithmic axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// What is shown.
    pub title: String,
    /// What it is shown for, in a line below the title.
    pub subtitle: String,
    /// The quantity along the horizontal axes.
    pub x_label: String,
    /// The quantity along the vertical axes.
    pub y_label: String,
    /// What is shaded, as the legend calls it.
    pub shade: String,
    /// What is hatched, as the legend calls it.
    pub hatched: String,
    /// The middles of the columns, evenly spaced in their logarithm.
    pub columns: Vec<f64>,
    /// The middles of the rows, from the lowest on, evenly spaced in their logarithm.
    pub rows: Vec<f64>,
    /// The maps.
    pub panels: Vec<Panel>,
    /// A line y = slope·x, and its name.
    pub line: (f64, String),
    /// A point that is marked in every map, and its name; one with x = 0 stands at the left edge.
    pub mark: ((f64, f64), String),
}

/// One of the maps.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What is shown in it.
    pub title: String,
    /// For each row its columns: a number above 0 that is shaded by its power of ten, and whether the cell is
    /// hatched.
    pub cells: Vec<(f64, bool)>,
}

/// The sizes in pixels.
const PANEL: i32 = 340;
const HEIGHT: i32 = 492;
const HEAD: i32 = 106;
const MARGIN: i32 = 16;

/// Shades from the smallest number on, and the powers of ten between them.
const SHADES: [u8; 6] = [255, 232, 205, 172, 135, 96];
const LOWEST: i32 = -6;

/// How far a mark reaches to all sides.
const MARK: i32 = 8;

impl Map {
    /// The maps as SVG.
    ///
    /// # Errors
    ///
    /// What the drawing library says.
    pub fn svg(&self) -> Result<String, String> {
        drawn([self.width(), HEIGHT], &self.reading(), |area| {
            self.draw(area)
        })
    }

    /// In pixels.
    fn width(&self) -> i32 {
        PANEL * self.panels.len() as i32 + MARGIN
    }

    /// What is read out.
    fn reading(&self) -> Reading {
        let mut reading = Reading::new(&self.title, &self.subtitle);
        for (which, label, middles) in [
            ("Horizontal", &self.x_label, &self.columns),
            ("Vertical", &self.y_label, &self.rows),
        ] {
            let ends = edges(middles);
            let [from, to] = [ends.first(), ends.last()]
                .map(|end| end.map_or(String::new(), |own| format!("{:.1e}", 10_f64.powf(*own))));
            reading.say(&format!(
                "{which} axes: {label}, from {from} to {to}, logarithmic"
            ));
        }
        let panels: Vec<&str> = self.panels.iter().map(|own| own.title.as_str()).collect();
        reading.say(&format!("Maps: {}", panels.join("; ")));
        reading.say(&format!("Shades of grey: {}", self.shade));
        reading.say(&format!("Hatched: {}", self.hatched));
        reading.say(&format!("{}: {}", Stroke::Dashed.words(), self.line.1));
        reading.say(&format!("{}: {}", Sign::Target.words(), self.mark.1));
        reading
    }

    fn draw(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let (head, below) = area.split_vertically(px(HEAD));
        self.draw_head(&head)?;
        for (place, panel) in self.panels.iter().enumerate() {
            let left = px(PANEL) * place as i32;
            let part = below
                .clone()
                .shrink((left, 0), (px(PANEL), px(HEIGHT - HEAD)));
            self.draw_panel(area, &part, panel)?;
        }
        Ok(())
    }

    fn draw_panel(
        &self,
        area: &Area<'_>,
        part: &Area<'_>,
        panel: &Panel,
    ) -> Result<(), Box<dyn Error>> {
        let (x, y) = (edges(&self.columns), edges(&self.rows));
        let [left, right] = [x[0], x[x.len() - 1]];
        let [bottom, top] = [y[0], y[y.len() - 1]];
        let mut chart = ChartBuilder::on(part)
            .caption(&panel.title, (FONT, px(15)))
            .margin_right(px(12))
            .margin_left(px(4))
            .margin_bottom(px(6))
            .x_label_area_size(px(48))
            .y_label_area_size(px(56))
            .build_cartesian_2d(Axis::of_powers(left..right), Axis::of_powers(bottom..top))?;
        let at = |x: f64, y: f64| chart.backend_coord(&(x, y));
        for (row, cells) in panel.cells.chunks(self.columns.len()).enumerate() {
            let mut column = 0;
            // Neighbours of one shade are one rectangle.
            for run in cells.chunk_by(|one, other| shade(one.0) == shade(other.0)) {
                let mut corners = [at(x[column], y[row + 1]), at(x[column + run.len()], y[row])];
                // Farther, under what is drawn next: no seam is seen between them.
                corners[0].1 -= px(1);
                corners[1].0 += px(1);
                column += run.len();
                area.draw(&Rectangle::new(corners, shade(run[0].0).filled()))?;
            }
            for (column, _) in cells.iter().enumerate().filter(|(_, cell)| cell.1) {
                let ends = [at(x[column], y[row]), at(x[column + 1], y[row + 1])];
                area.draw(&PathElement::new(ends, ink(BLACK, 1)))?;
            }
        }
        let slope = self.line.0.log10();
        let (from, to) = (left.max(bottom - slope), right.min(top - slope));
        if from < to {
            let ends = [at(from, from + slope), at(to, to + slope)];
            Stroke::Dashed.draw(area, &ends)?;
        }
        let (x, y) = self.mark.0;
        let place = match x > 0.0 {
            true => at(x.log10(), y.log10()),
            // The whole of it within the frame.
            false => {
                let (edge, height) = at(left, y.log10());
                (edge + px(MARK), height)
            }
        };
        Sign::Target.draw(area, place)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .x_label_formatter(&power)
            .y_label_formatter(&power)
            .set_all_tick_mark_size(px(5))
            .axis_desc_style((FONT, px(15)))
            .label_style((FONT, px(14)))
            .axis_style(ink(BLACK, 1))
            .draw()?;
        Ok(())
    }

    /// The title, and what it is shown for; shades and signs below them.
    fn draw_head(&self, head: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let text =
            |text: String, place, pixels| head.draw(&Text::new(text, place, (FONT, px(pixels))));
        let room = self.width() - 2 * MARGIN;
        draw_line(head, &self.title, (MARGIN, 10), room, 19)?;
        draw_line(head, &self.subtitle, (MARGIN, 36), room, 15)?;
        let (top, bottom) = (px(62), px(76));
        text(self.shade.clone(), (px(MARGIN), top), 14)?;
        let mut left = px(MARGIN + 12 + 7 * script::length(&self.shade) as i32);
        for (place, grey) in SHADES.into_iter().enumerate() {
            let corners = [(left, top), (left + px(34), bottom)];
            head.draw(&Rectangle::new(
                corners,
                RGBColor(grey, grey, grey).filled(),
            ))?;
            head.draw(&Rectangle::new(corners, ink(BLACK, 1)))?;
            left += px(34);
            if place + 1 < SHADES.len() {
                let exponent = f64::from(LOWEST + 1 + place as i32);
                text(power(&exponent), (left - px(10), bottom + px(4)), 12)?;
            }
        }
        left += px(24);
        let label = |left: &mut i32, label: &str| {
            let place = (*left + px(34), top);
            *left += px(58 + 7 * script::length(label) as i32);
            text(label.to_string(), place, 14)
        };
        for shift in [0, 7, 14] {
            let ends = [(left + px(shift), bottom), (left + px(shift + 12), top)];
            head.draw(&PathElement::new(ends, ink(BLACK, 1)))?;
        }
        label(&mut left, &self.hatched)?;
        let middle = (top + bottom) / 2;
        Stroke::Dashed.draw(head, &[(left, middle), (left + px(26), middle)])?;
        label(&mut left, &self.line.1)?;
        Sign::Target.draw(head, (left + px(14), middle))?;
        Ok(label(&mut left, &self.mark.1)?)
    }
}

/// The shade of a number.
fn shade(number: f64) -> RGBColor {
    let above = (number.log10() - f64::from(LOWEST)).floor();
    let place = above.clamp(0.0, (SHADES.len() - 1) as f64) as usize;
    RGBColor(SHADES[place], SHADES[place], SHADES[place])
}

/// The exponents between evenly spaced middles, and at the ends.
fn edges(middles: &[f64]) -> Vec<f64> {
    let exponents: Vec<f64> = middles.iter().map(|own| own.log10()).collect();
    let step = match exponents.as_slice() {
        [first, .., last] => (last - first) / (exponents.len() - 1) as f64,
        _ => 1.0,
    };
    let first = exponents.first().map(|own| own - step / 2.0);
    let others = exponents.iter().map(|own| own + step / 2.0);
    first.into_iter().chain(others).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shaded_by_their_powers_of_ten() {
        let grey = |number: f64| shade(number).0;
        assert_eq!([grey(0.0), grey(1e-9), grey(9e-6)], [SHADES[0]; 3]);
        assert_eq!([grey(2e-5), grey(2e-2), grey(0.2)], [232, 135, 96]);
        assert_eq!([grey(50.0), grey(f64::INFINITY)], [SHADES[5]; 2]);
    }

    #[test]
    fn edges_lie_between_middles() {
        assert_eq!(edges(&[0.01, 0.1, 1.0]), [-2.5, -1.5, -0.5, 0.5]);
        assert_eq!(edges(&[10.0]), [0.5, 1.5]);
    }
}
