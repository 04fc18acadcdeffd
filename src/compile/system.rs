//! The matrices of a system become a program.

use crate::language::syntax::{Approximated, Part};
use crate::language::system::System;
use crate::verdict::audit::Audit;

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
    /// The program of the matrices of a system of an audited document, or of one that it imports and an
    /// evaluator approximates: then after the replacements that this names.
    ///
    /// # Errors
    ///
    /// [`Refusal`] where no program computes an entry.
    pub fn of(
        system: &System,
        approximated: Option<&Approximated>,
        audit: &Audit,
    ) -> Result<Self, Refusal> {
        let place = approximated.and_then(|own| own.place.as_ref());
        let specification = Specification::of(&system.evaluator(place), audit, &[]);
        let specification = specification.map_err(|refusal| match (refusal, approximated) {
            // The system may stand in another document.
            (Refusal::Document(mut error), Some(own)) => {
                error.secondary.clear();
                Refusal::Document(Box::new(error.moved_to(&own.system.span, "in this system")))
            }
            (refusal, _) => refusal,
        })?;
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
