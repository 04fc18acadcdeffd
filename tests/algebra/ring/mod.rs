//! The ring layer, against exact values at points of its relations.

mod calculus;
mod field;
mod matrices;
mod normal_forms;
mod oracle;
mod presentation;
mod roots;
mod series;
mod signs;
mod terms;
mod trigonometry;
