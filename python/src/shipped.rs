//! The evaluators that come with the program, as they are checked in.
#![allow(non_snake_case)]

use sextic_evaluators::bounded::Bounded;
use sextic_evaluators::dispatch::Mode;
use sextic_evaluators::*;

use crate::kernel::{Blocks, Kernel, Quantity, Source};

/// Inputs and outputs as slices; whether they have one length.
type Batch = fn(&[&[f64]], &mut [&mut [f64]]) -> bool;

/// An evaluator, as it is read off its text.
pub struct Shipped {
    name: &'static str,
    text: &'static str,
    asked: &'static [(&'static str, &'static str)],
    origins: &'static [Origin],
    outputs: &'static [(&'static str, &'static str)],
    /// Whether all slices have one length.
    batch: Batch,
    bounded: fn(&[f64]) -> Vec<Bounded>,
}

/// Where an input comes from.
enum Origin {
    /// From what is asked for, by its place.
    Given(usize),
    /// It is a sine or cosine of what has these places.
    Made(&'static [usize], fn(&[f64]) -> f64),
}

include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// The evaluator of this name.
pub fn find(name: &str) -> Option<&'static Shipped> {
    SHIPPED.iter().find(|own| own.name == name)
}

/// The names of all of them.
pub fn names() -> Vec<&'static str> {
    SHIPPED.iter().map(|own| own.name).collect()
}

fn quantities(pairs: &[(&str, &str)]) -> Vec<Quantity> {
    let all = pairs.iter();
    all.map(|(name, text)| Quantity::new(*name, *text))
        .collect()
}

impl Kernel for &'static Shipped {
    fn name(&self) -> &str {
        self.name
    }

    fn text(&self) -> String {
        self.text.to_string()
    }

    fn asked(&self) -> Vec<Quantity> {
        quantities(self.asked)
    }

    fn outputs(&self) -> Vec<Quantity> {
        quantities(self.outputs)
    }

    fn sources(&self) -> Vec<Source> {
        let sources = self.origins.iter().map(|own| match *own {
            Origin::Given(place) => Source::Given(place),
            Origin::Made(of, by) => Source::Made(of.to_vec(), Box::new(by)),
        });
        sources.collect()
    }

    fn prepared<'k>(&'k self, _: &[Option<f64>]) -> Box<dyn Blocks + 'k> {
        Box::new(*self)
    }

    fn bounded(&self, inputs: &[f64]) -> Vec<Bounded> {
        (self.bounded)(inputs)
    }
}

impl Blocks for &'static Shipped {
    fn run(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        let is_whole = (self.batch)(inputs, outputs);
        debug_assert!(is_whole, "slices of one length");
    }
}
