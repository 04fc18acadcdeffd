//! What was found, as a person and as a program reads it.
//!
//! Every view says the same: [`details`] and [`summary`] put it into words once, and [`text`],
//! [`markdown`] and [`latex`] lay the words out. [`json`] is for programs and shortens nothing.
//! Curves are rows of a table and figures as well.

pub mod advice;
#[cfg(feature = "stability")]
pub mod closeness;
#[cfg(feature = "stability")]
pub mod columns;
#[cfg(feature = "stability")]
pub mod csv;
pub mod details;
pub mod evaluation;
#[cfg(feature = "stability")]
pub mod figure;
#[cfg(feature = "stability")]
pub mod gallery;
#[cfg(feature = "stability")]
pub mod html;
pub mod json;
pub mod latex;
pub mod markdown;
#[cfg(feature = "stability")]
mod markup;
#[cfg(feature = "stability")]
pub mod modes;
#[cfg(feature = "stability")]
pub mod mutation;
pub mod phrase;
pub mod premises;
#[cfg(feature = "stability")]
pub mod ranges;
pub mod refusals;
pub mod residuals;
pub mod shown;
#[cfg(feature = "stability")]
pub mod speeds;
#[cfg(feature = "stability")]
pub mod speeds_figure;
#[cfg(feature = "stability")]
pub mod stability;
#[cfg(feature = "stability")]
pub mod stability_figure;
pub mod summary;
pub mod sympy;
pub mod text;
#[cfg(feature = "stability")]
pub mod trajectory;
#[cfg(feature = "stability")]
pub mod validity;
#[cfg(feature = "stability")]
pub mod validity_figure;
pub mod words;
