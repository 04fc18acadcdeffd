//! Verdicts and matchings for a terminal.
//!
//! Colours are always written, as ANSI codes; the stream that they are written to strips them where
//! nobody would see them.

mod audit;
mod claim;
mod explanation;
mod expression;
mod matching;
mod page;
mod palette;
mod prose;
mod run;

pub use audit::audit;
pub use explanation::explanation;
pub use matching::matching;
