//! Many points in blocks: what is the same at all of them is written down once, and nothing else is copied.

use sextic_evaluators::bounded::Bounded;

use crate::kernel::{Kernel, Source};
use crate::lanes::POINTS;

/// A quantity at all points.
#[derive(Clone, Copy)]
pub enum Column<'a> {
    /// It is the same everywhere.
    One(f64),
    /// Its value at each.
    Many(&'a [f64]),
}

impl Column<'_> {
    fn at(&self, point: usize) -> f64 {
        match self {
            Column::One(value) => *value,
            Column::Many(values) => values[point],
        }
    }
}

/// An input of the program at all points.
enum Input<'a> {
    /// It is the same everywhere, and its block is filled already.
    One,
    /// It is what the caller gives.
    Many(&'a [f64]),
    /// It is made at each point of some of what the caller gives.
    Made(&'a Source),
}

/// The outputs at all points, whose columns are of the length of the outputs.
pub fn run(kernel: &dyn Kernel, given: &[Column<'_>], outputs: &mut [&mut [f64]]) {
    let points = outputs.first().map_or(0, |own| own.len());
    let sources = kernel.sources();
    let mut blocks = vec![vec![0.0; points.min(POINTS)]; sources.len()];
    let mut values = vec![0.0; given.len()];
    let inputs = sources.iter().zip(&mut blocks);
    let inputs: Vec<Input> = inputs
        .map(|(own, block)| input(own, given, block))
        .collect();
    let same = inputs
        .iter()
        .zip(&blocks)
        .map(|(input, block)| match input {
            Input::One => block.first().copied(),
            Input::Many(_) | Input::Made(_) => None,
        });
    let mut prepared = kernel.prepared(&same.collect::<Vec<_>>());
    let mut start = 0;
    while start < points {
        let end = points.min(start + POINTS);
        for (input, block) in inputs.iter().zip(&mut blocks) {
            if let Input::Made(source) = input {
                let places = block.iter_mut().zip(start..end);
                places.for_each(|(own, point)| *own = made(source, given, point, &mut values));
            }
        }
        let inputs = inputs.iter().zip(&blocks);
        let slices: Vec<&[f64]> = inputs
            .map(|(input, block)| slice(input, block, start..end))
            .collect();
        let rooms = outputs.iter_mut().map(|own| &mut own[start..end]);
        prepared.run(&slices, &mut rooms.collect::<Vec<_>>());
        start = end;
    }
}

/// The outputs at all points, and bounds of their rounding.
pub fn run_bounded(
    kernel: &dyn Kernel,
    given: &[Column<'_>],
    outputs: &mut [&mut [f64]],
    errors: &mut [&mut [f64]],
) {
    let points = outputs.first().map_or(0, |own| own.len());
    let sources = kernel.sources();
    let mut values = vec![0.0; given.len()];
    for point in 0..points {
        let inputs = sources
            .iter()
            .map(|own| made(own, given, point, &mut values));
        let found = kernel.bounded(&inputs.collect::<Vec<_>>());
        for (place, Bounded { value, error }) in found.into_iter().enumerate() {
            (outputs[place][point], errors[place][point]) = (value, error);
        }
    }
}

/// What an input is; the block of what is the same everywhere is filled.
fn input<'a>(source: &'a Source, given: &[Column<'a>], block: &mut [f64]) -> Input<'a> {
    let is_one = |place: &usize| matches!(given[*place], Column::One(_));
    match source {
        Source::Given(place) => match given[*place] {
            Column::Many(values) => return Input::Many(values),
            Column::One(value) => block.fill(value),
        },
        Source::Made(of, _) if !of.iter().all(is_one) => return Input::Made(source),
        Source::Made(..) | Source::Fixed(_) => {
            block.fill(made(source, given, 0, &mut vec![0.0; given.len()]))
        }
    }
    Input::One
}

/// The values of a block.
fn slice<'b>(input: &Input<'b>, block: &'b [f64], range: std::ops::Range<usize>) -> &'b [f64] {
    match input {
        Input::Many(values) => &values[range],
        Input::One | Input::Made(_) => &block[..range.len()],
    }
}

/// The value of an input at a point; there is room for what it is made of.
fn made(source: &Source, given: &[Column<'_>], point: usize, room: &mut [f64]) -> f64 {
    match source {
        Source::Given(place) => given[*place].at(point),
        Source::Fixed(value) => *value,
        Source::Made(of, by) => {
            of.iter()
                .for_each(|place| room[*place] = given[*place].at(point));
            by(room)
        }
    }
}
