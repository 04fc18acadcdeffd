//! Where the two routes meet: verdicts, their witnesses, audits and explanations.

#![deny(clippy::float_arithmetic)]

pub mod audit;
pub mod claim;
pub mod explanation;
pub mod judge;
pub mod mutation;
