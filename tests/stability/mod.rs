//! Numbers for sections, against exact arithmetic.

mod closed_form;
mod eigenvalues;
mod oracle;
mod sections;
mod tracking;
