//! How a table is to be read, where a case says so.

use std::collections::BTreeMap;

/// What a case says of its table; by default nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// What columns with unusual names mean: their names, by the usual ones.
    pub columns: BTreeMap<String, String>,
    /// Whether the table is half of a symmetric one, and is continued by symmetry.
    pub mirror: bool,
    /// Whether derivatives are those of the columns `dCL`, `dCD` and `dCM`.
    pub slopes: bool,
}
