//! Certificates: what a document says, as theorems that Coq checks without believing a line of this program.
//!
//! The statements are printed from what the document says, not from a normal form. What cannot be said in the
//! words of the kernel is withheld, with the reason, and never weakened.

#![deny(clippy::float_arithmetic)]

mod claim;
mod composer;
pub mod document;
pub mod entry;
pub mod expression;
pub mod kernel;
mod misfit;
pub mod name;
mod point;
mod program;
pub mod theorem;
mod unit;
