//! Numbers for real sections: state matrix, companion matrix, closed forms, and modes that are followed.
//!
//! Every eigenvalue comes with a bound of its error, so that an answer is as good as it says.

mod ball;
pub mod closed_form;
pub mod companion;
pub mod coordinate;
pub mod eigenvalue;
mod enclosure;
pub mod error;
pub mod model;
pub mod modes;
mod schur;
pub mod section;
mod shape;
pub mod tracking;
