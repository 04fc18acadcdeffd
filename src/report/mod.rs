//! What was found, as a person and as a program reads it.
