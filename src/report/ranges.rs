//! The ranges of a quantity on which a system is stable, or not.

use crate::stability::system::critical::Ranges;

/// A system along a quantity.
#[derive(Clone, Debug)]
pub struct RangesFound {
    /// The system.
    pub system: String,
    /// The quantity.
    pub over: String,
    /// What was found.
    pub ranges: Ranges,
}
