//! Numbers for sections, against exact arithmetic.

mod aerodynamic_stiffness;
mod cases;
mod closed_form;
mod comparison;
mod critical_speeds;
mod eigenvalues;
mod error_table;
mod exact_modes;
mod grid;
mod interpolation;
mod mean_twist;
mod oracle;
mod reference;
mod sections;
mod sensitivity;
mod square_section;
mod tracking;
mod uniform_form;
mod validity;
mod verdicts;
