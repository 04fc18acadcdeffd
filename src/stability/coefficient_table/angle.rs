//! When two angles are one.

/// What is closer to 360° than this, in degrees, is 360°.
pub(in crate::stability) const WHOLE: f64 = 1e-9;

/// The ends of a table are one angle, or are at an axis, if they are apart by less than this share of the steps
/// beside.
pub(super) const ONE_ANGLE: f64 = 0.01;
