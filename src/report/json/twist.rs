//! `"twist": {"deg", "error_deg", "stiffness", "balance"}`.

use serde::Serialize;

use crate::stability::mean_twist::Twist;

/// A mean twist.
#[derive(Serialize)]
pub(super) struct TwistFound {
    deg: f64,
    /// It is certain within this.
    error_deg: f64,
    /// Of the turn, that of the wind included, over that of its springs.
    stiffness: f64,
    balance: &'static str,
}

impl From<&Twist> for TwistFound {
    fn from(own: &Twist) -> Self {
        TwistFound {
            deg: own.angle.to_degrees(),
            error_deg: own.error.to_degrees(),
            stiffness: own.stiffness,
            balance: own.word(),
        }
    }
}
