//! What a document derives becomes straight-line programs.

pub mod circle;
pub mod fixed;
pub mod input;
pub mod normal_form;
pub mod polynomial;
pub mod proof;
pub mod reading;
pub mod specification;
pub mod translation;
