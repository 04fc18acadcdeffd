//! Legends: samples with their names, in as many rows as they need.

use std::error::Error;

use plotters::prelude::*;

use super::mark::Sign;
use super::patch::Fill;
use super::stroke::Stroke;
use super::{Area, FONT, px, script};

/// Samples with their names.
pub(super) struct Legend<'a> {
    pub entries: Vec<Entry<'a>>,
    /// The room for a row, in pixels.
    pub width: i32,
}

/// A sample and its name.
pub(super) struct Entry<'a> {
    pub sample: Sample,
    pub label: &'a str,
}

/// What a name belongs to.
#[derive(Clone, Copy)]
pub(super) enum Sample {
    Line(Stroke),
    Region(Fill),
    Point(Sign),
}

/// The height of a row, the length of a sample, and the gaps behind a sample and a name, in pixels.
const ROW: i32 = 24;
const LENGTH: i32 = 36;
const GAPS: [i32; 2] = [8, 24];

impl Legend<'_> {
    /// In pixels.
    pub fn height(&self) -> i32 {
        let last = self.places().last().map_or(0, |(_, row)| row + 1);
        ROW * last
    }

    /// Draws all entries, the upper left corner at a place in pixels.
    pub fn draw(&self, area: &Area<'_>, (left, top): (i32, i32)) -> Result<(), Box<dyn Error>> {
        for (entry, (column, row)) in self.entries.iter().zip(self.places()) {
            entry.draw(area, (left + column, top + ROW * row + ROW / 2))?;
        }
        Ok(())
    }

    /// Where each entry begins, in pixels, and its row: as many in a row as fit, and one that is too long.
    fn places(&self) -> Vec<(i32, i32)> {
        let (mut left, mut row) = (0, 0);
        let place = |entry: &Entry<'_>| {
            let width = entry.width();
            if left > 0 && left + width - GAPS[1] > self.width {
                (left, row) = (0, row + 1);
            }
            left += width;
            (left - width, row)
        };
        self.entries.iter().map(place).collect()
    }
}

impl Entry<'_> {
    /// In pixels. Fonts are the viewer's: room for wide letters.
    fn width(&self) -> i32 {
        LENGTH + GAPS[0] + 7 * script::length(self.label) as i32 + GAPS[1]
    }

    /// Draws it from a place in pixels on, which lies in the middle of its height.
    fn draw(&self, area: &Area<'_>, (left, middle): (i32, i32)) -> Result<(), Box<dyn Error>> {
        self.sample.draw(area, (px(left), px(middle)))?;
        let place = (px(left + LENGTH + GAPS[0]), px(middle - 6));
        Ok(area.draw(&Text::new(self.label.to_string(), place, (FONT, px(15))))?)
    }
}

impl Sample {
    /// What a reader is told that it looks like.
    pub fn words(self) -> &'static str {
        match self {
            Sample::Line(stroke) => stroke.words(),
            Sample::Region(fill) => fill.words(),
            Sample::Point(sign) => sign.words(),
        }
    }

    fn draw(self, area: &Area<'_>, (left, middle): (i32, i32)) -> Result<(), Box<dyn Error>> {
        let length = px(LENGTH);
        match self {
            Sample::Line(stroke) => {
                let points = stroke.sample(length).map(|place| (left + place, middle));
                stroke.draw(area, &points)
            }
            Sample::Region(fill) => {
                let [right, top, bottom] = [left + length, middle - px(8), middle + px(8)];
                let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
                fill.draw(area, &corners)
            }
            Sample::Point(sign) => sign.draw(area, (left + length - px(8), middle)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_goes_to_the_next_row() {
        let labels = ["0123456789", "01234", &"long".repeat(100), "x"];
        let entries = labels.map(|label| Entry {
            sample: Sample::Line(Stroke::Solid),
            label,
        });
        let legend = Legend {
            entries: entries.into(),
            width: 220,
        };
        assert_eq!(legend.places(), [(0, 0), (138, 0), (0, 1), (0, 2)]);
        assert_eq!(legend.height(), 3 * ROW);
    }
}
