//! Where the two routes meet: verdicts, their witnesses, audits and explanations.

pub mod audit;
pub mod claim;
pub mod explanation;
pub mod judge;
