//! The first route: expressions become elements of the ring, and assertions are found true or not.

#![deny(clippy::float_arithmetic)]

pub mod assertion;
pub mod condition;
pub mod domain;
pub mod elaboration;
pub mod foundation;
pub mod function;
pub mod matching;
pub mod presentation;
pub mod quantity;
pub mod scope;
pub mod shown;
mod system;
