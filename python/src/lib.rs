//! The part of the Python package that is Rust: audits, evaluators over arrays, systems in numbers.
//!
//! What users see is in `sextic/`; here stands what needs the library, with as few words as it takes.
#![deny(unsafe_code)]

mod columns;
mod compiled;
mod document;
mod evaluator;
mod failure;
mod kernel;
mod lanes;
mod section;
mod shipped;
mod system;
mod tape;

/// What the package calls of it.
#[pyo3::pymodule]
mod _sextic {
    #[pymodule_export]
    use crate::document::{Document, audit_file, audit_shipped, audit_text, shipped_documents};
    #[pymodule_export]
    use crate::evaluator::{Evaluator, meant, shipped_evaluator, shipped_evaluators};
    #[pymodule_export]
    use crate::section::Section;
    #[pymodule_export]
    use crate::system::System;
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
