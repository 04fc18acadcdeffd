//! Verdicts and matchings for a terminal.
//!
//! Colours are always written, as ANSI codes; the stream that they are written to strips them where
//! nobody would see them.

mod audit;
mod claim;
#[cfg(feature = "stability")]
mod closeness;
mod evaluation;
mod explanation;
mod expression;
mod generation;
mod ledger;
mod matching;
#[cfg(feature = "stability")]
mod modes;
#[cfg(feature = "stability")]
mod mutation;
mod page;
mod palette;
mod prose;
#[cfg(feature = "stability")]
mod ranges;
mod run;
mod shown;
#[cfg(feature = "stability")]
mod speeds;
#[cfg(feature = "stability")]
mod stability;
#[cfg(feature = "stability")]
mod validity;

pub use audit::audit;
#[cfg(feature = "stability")]
pub use closeness::closeness;
pub use evaluation::{evaluation, evaluators};
pub use explanation::explanation;
pub use generation::{difference, generated};
pub use ledger::ledger;
pub use matching::matching;
#[cfg(feature = "stability")]
pub use modes::modes;
#[cfg(feature = "stability")]
pub use mutation::mutations;
#[cfg(feature = "stability")]
pub use ranges::ranges;
pub use shown::shown;
#[cfg(feature = "stability")]
pub use speeds::speeds;
#[cfg(feature = "stability")]
pub use stability::comparison;
#[cfg(feature = "stability")]
pub use validity::validity;
