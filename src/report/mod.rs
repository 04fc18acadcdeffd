//! What was found, as a person and as a program reads it.
//!
//! Every view says the same: [`details`] and [`summary`] put it into words once, and [`text`],
//! [`markdown`] and [`latex`] lay the words out. [`json`] is for programs and shortens nothing.

pub mod details;
pub mod evaluation;
pub mod json;
pub mod latex;
pub mod markdown;
pub mod phrase;
pub mod residuals;
pub mod summary;
pub mod text;
pub mod words;
