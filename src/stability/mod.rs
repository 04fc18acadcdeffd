//! Numbers for real sections: state matrix, companion matrix, closed forms, and modes that are followed.
//!
//! Every eigenvalue comes with a bound of its error, so that an answer is as good as it says.

pub mod axis;
mod ball;
mod bernstein;
pub mod case;
pub mod closed_form;
pub mod closeness;
pub mod coefficient_table;
pub mod companion;
pub mod comparison;
pub mod coordinate;
pub mod critical_speed;
pub mod cubic;
pub mod eigenvalue;
mod enclosure;
mod equations;
pub mod error;
pub mod exact_modes;
pub mod exact_section;
pub mod forces;
mod given;
pub mod grid;
mod half_plane;
mod hurwitz;
mod in_speed;
pub mod input;
pub mod interpolation;
mod modal;
pub mod model;
mod neutral;
pub mod offset;
pub mod quantity;
mod recorded;
mod schur;
pub mod section;
pub mod sensitivity;
mod shape;
mod speed_search;
pub mod spline;
pub mod state_matrix;
pub mod system;
pub mod tracking;
pub mod uniform_form;
pub mod validity;
pub mod variable;
pub mod verdict;
