//! What turns in a sweep.

use serde::Deserialize;

/// What turns when the angle of attack α = α_0 + θ_0 changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Turn {
    /// The section: θ_0 = α, α_0 = 0.
    Section,
    /// The wind: α_0 = α, θ_0 = 0.
    Wind,
}
