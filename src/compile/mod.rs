//! What a document derives becomes straight-line programs.

#![deny(clippy::float_arithmetic)]

pub mod circle;
pub mod constant;
pub mod door;
mod double;
pub mod doubt;
pub mod fingerprint;
pub mod fixed;
pub mod generation;
pub mod input;
pub mod operations;
pub mod point;
pub mod polynomial;
pub mod proof;
pub mod reading;
pub mod resolution;
pub mod specification;
pub mod system;
pub mod translation;
