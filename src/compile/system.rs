//! The matrices of a system become a program.

use crate::language::syntax::{Part, Place};
use crate::language::system::System;
use crate::verdict::audit::Audit;

use super::fixed::Fixed;
use super::specification::{Refusal, Specification};

/// A system whose matrices are a program.
#[derive(Clone, Debug)]
pub struct CompiledSystem {
    /// What is computed: the outputs of its program are the entries of M, then those of each part of C, then
    /// those of each part of K, each matrix row by row.
    pub specification: Specification,
    /// The coordinates by name, in order.
    pub coordinates: Vec<String>,
    /// The names of the parts of C; empty where one has none.
    pub damping: Vec<String>,
    /// The names of the parts of K; empty where one has none.
    pub stiffness: Vec<String>,
}

impl CompiledSystem {
    /// The program of the matrices of a system of an audited document, after replacements if there are some,
    /// with some quantities fixed.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where no program computes an entry.
    pub fn of(
        system: &System,
        place: Option<&Place>,
        fixed: &[Fixed],
        audit: &mut Audit,
    ) -> Result<Self, Refusal> {
        let specification = Specification::of(&system.evaluator(place), audit, fixed)?;
        let coordinates = system.coordinates.iter();
        Ok(CompiledSystem {
            specification,
            coordinates: coordinates.map(|name| name.value.ascii.clone()).collect(),
            damping: names(&system.damping),
            stiffness: names(&system.stiffness),
        })
    }
}

fn names(parts: &[Part]) -> Vec<String> {
    let name = |part: &Part| {
        let name = part.name.as_ref();
        name.map(|name| name.value.ascii.clone())
            .unwrap_or_default()
    };
    parts.iter().map(name).collect()
}
