//! How documents are read and written.

mod expressions;
mod messages;
mod robustness;
mod statements;
