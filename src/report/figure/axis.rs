//! An axis: what it shows, where it is marked, and the numbers at its marks.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};

/// Marks on an axis, at least and at most, but for very short ranges.
const FEWEST: f64 = 5.0;
const MOST: f64 = 12.5;

/// A range of numbers and where it is marked.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    range: Range<f64>,
    marks: Vec<f64>,
}

impl Axis {
    /// An axis that is marked at multiples of 1, 2 or 5 of a power of ten, or of parts of a right angle if it
    /// shows degrees and they are not too far apart.
    pub(super) fn new(range: Range<f64>, is_angle: bool) -> Self {
        let marks = marks(&range, is_angle);
        Axis { range, marks }
    }
}

impl Axis {
    /// An axis of powers of ten, marked at whole ones; its numbers are the exponents.
    pub(super) fn of_powers(range: Range<f64>) -> Self {
        let (first, last) = (range.start.ceil() as i64, range.end.floor() as i64);
        let marks = (first..=last).map(|power| power as f64).collect();
        Axis { range, marks }
    }
}

impl Ranged for Axis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        start + (share * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.marks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// From the least to the largest, and a little of both if they are one.
pub(super) fn extent(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (least, largest) = numbers.fold(
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

/// A twentieth more on both sides.
pub(super) fn with_margin(range: Range<f64>) -> Range<f64> {
    let margin = 0.05 * (range.end - range.start);
    range.start - margin..range.end + margin
}

/// Ranges around the same middles, of one scale, so that both fit.
pub(super) fn to_scale(
    x: Range<f64>,
    y: Range<f64>,
    [width, height]: [f64; 2],
) -> (Range<f64>, Range<f64>) {
    let pixel = ((x.end - x.start) / width).max((y.end - y.start) / height);
    let around = |range: Range<f64>, pixels: f64| {
        let (middle, half) = ((range.start + range.end) / 2.0, pixels * pixel / 2.0);
        middle - half..middle + half
    };
    (around(x, width), around(y, height))
}

fn marks(range: &Range<f64>, is_angle: bool) -> Vec<f64> {
    let length = range.end - range.start;
    if !(length > 0.0 && length.is_finite()) {
        return Vec::new();
    }
    let power = 10_f64.powf(length.log10().floor());
    let decimal = [0.1, 0.2, 0.5, 1.0].map(|part| part * power);
    let angles = [15.0, 30.0, 45.0, 90.0];
    let fits = |step: &f64| (FEWEST..=MOST).contains(&(length / step));
    let of_angles = angles.into_iter().filter(|_| is_angle).find(fits);
    let step = of_angles.or_else(|| decimal.into_iter().find(|step| length / step <= MOST));
    let step = step.unwrap_or(power);
    let (first, last) = (
        (range.start / step - 1e-9).ceil() as i64,
        (range.end / step + 1e-9).floor() as i64,
    );
    (first..=last).map(|count| count as f64 * step).collect()
}

/// A number on an axis: no zeros at its end, and a minus sign as wide as a plus.
pub(super) fn tick(number: &f64) -> String {
    let text = format!("{:.6}", number + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" => "0".to_string(),
        _ => text.replace('-', "\u{2212}"),
    }
}

/// A power of ten with its exponent: `10^{−3}`.
pub(super) fn power(exponent: &f64) -> String {
    format!("10^{{{}}}", tick(exponent))
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
    fn powers_have_their_exponents() {
        assert_eq!(
            [power(&-3.0), power(&0.0), power(&12.0)],
            ["10^{\u{2212}3}", "10^{0}", "10^{12}"]
        );
        assert_eq!(Axis::of_powers(-3.5..0.2).marks, [-3.0, -2.0, -1.0, 0.0]);
    }

    #[test]
    fn axes_are_marked_at_round_numbers() {
        let marked = |range: Range<f64>, is_angle| marks(&range, is_angle);
        assert_eq!(
            marked(0.0..180.0, true),
            (0..=12)
                .map(|own| 15.0 * f64::from(own))
                .collect::<Vec<_>>()
        );
        assert_eq!(marked(-180.0..180.0, true).len(), 13);
        assert_eq!(marked(0.0..4.0, true), marked(0.0..4.0, false));
        assert_eq!(
            marked(-0.1..1.1, false),
            (-1..=11)
                .map(|own| f64::from(own) * 0.1)
                .collect::<Vec<_>>()
        );
        assert_eq!(marked(1.0..1.0, false), Vec::<f64>::new());
    }
}
