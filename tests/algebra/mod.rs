//! Exact algebra: laws on arbitrary elements, tables of cases, and an oracle that shares no code with it.

mod laws;
mod ring;
mod support;
mod tables;
