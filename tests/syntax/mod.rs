//! How documents are read and written.

mod expressions;
mod hidden;
mod messages;
mod robustness;
mod statements;
