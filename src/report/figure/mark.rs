//! What is marked: points, and a case's own value of what is swept.

use std::error::Error;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::stroke::ink;
use super::{Area, FONT, LEFT, RIGHT, WIDTH, px, script};

/// A point that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where it is.
    pub place: (f64, f64),
    /// How it is drawn.
    pub sign: Sign,
    /// What stands beside it.
    pub letter: String,
    /// On which side of it that stands.
    pub side: Side,
    /// Its name in the legend.
    pub label: String,
}

/// How a point is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// A hollow circle.
    Ring,
    /// A full circle.
    Disc,
    /// Two strokes.
    Cross,
    /// A cross in a circle, which is seen on every shade.
    Target,
}

/// Where the letter of a mark stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// To the right, above it.
    Above,
    /// To the right.
    Beside,
}

/// The value that a case has of what is swept: a line across the figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Own {
    /// Where on the horizontal axis.
    pub value: f64,
    /// What stands above the line.
    pub label: String,
}

const INK: RGBColor = RGBColor(200, 80, 0);

impl Sign {
    /// Draws it at a place of the drawing.
    pub(super) fn draw(self, area: &Area<'_>, place: (i32, i32)) -> Result<(), Box<dyn Error>> {
        match self {
            Sign::Ring => {
                area.draw(&Circle::new(place, px(6), WHITE.filled()))?;
                area.draw(&Circle::new(place, px(6), ink(BLACK, 2)))?;
            }
            // It is seen within a ring.
            Sign::Disc => area.draw(&Circle::new(place, px(4), BLACK.filled()))?,
            Sign::Cross => area.draw(&Cross::new(place, px(6), ink(INK, 3)))?,
            Sign::Target => {
                area.draw(&Circle::new(place, px(7), WHITE.filled()))?;
                area.draw(&Circle::new(place, px(7), ink(INK, 2)))?;
                area.draw(&Cross::new(place, px(5), ink(INK, 2)))?;
            }
        }
        Ok(())
    }

    /// What a reader is told that it looks like.
    pub(super) fn words(self) -> &'static str {
        match self {
            Sign::Ring => "Ring",
            Sign::Disc => "Disc",
            Sign::Cross => "Cross",
            Sign::Target => "Ring with a cross",
        }
    }
}

impl Mark {
    /// Its letter, beside the sign at a place of the drawing.
    pub(super) fn draw_letter(
        &self,
        area: &Area<'_>,
        (x, y): (i32, i32),
    ) -> Result<(), Box<dyn Error>> {
        let place = match self.side {
            Side::Above => (x + px(9), y - px(26)),
            Side::Beside => (x + px(12), y - px(9)),
        };
        Ok(area.draw(&Text::new(self.letter.clone(), place, (FONT, px(19))))?)
    }
}

impl Own {
    /// Its label, above the upper end of the line in the drawing, and as a whole within the figure.
    pub(super) fn draw_label(
        &self,
        area: &Area<'_>,
        (x, y): (i32, i32),
    ) -> Result<(), Box<dyn Error>> {
        let half = px(7 * script::length(&self.label) as i32 / 2);
        let anchor = match x {
            _ if x - half < px(LEFT) => HPos::Left,
            _ if x + half > px(WIDTH - RIGHT) => HPos::Right,
            _ => HPos::Center,
        };
        let style = TextStyle::from((FONT, px(15)).into_font());
        let style = style.pos(Pos::new(anchor, VPos::Bottom));
        let place = (x, y - px(4));
        Ok(area.draw(&Text::new(self.label.clone(), place, style))?)
    }
}
