//! The integration tests of the generator, in one binary.

mod rust;
mod samples;
