//! The integration tests of the generator, in one binary.
#![allow(clippy::unwrap_used)]

mod c;
mod consumer;
mod divisions;
mod documentation;
mod laws;
mod literals;
mod names;
mod octave;
mod optimiser;
mod origins;
mod pairs;
mod printers;
mod programs;
mod python;
mod rounding;
mod rust;
mod samples;
