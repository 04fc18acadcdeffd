//! The integration tests of the generator, in one binary.
#![allow(clippy::unwrap_used)]

mod c;
mod consumer;
mod literals;
mod optimiser;
mod printers;
mod python;
mod rounding;
mod rust;
mod samples;
