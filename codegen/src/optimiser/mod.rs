//! Passes that make a program cheaper without changing what it computes over the rationals.

pub mod fold;
pub mod hoist;
pub mod prune;
pub mod reciprocal;
pub mod share;
pub mod specialise;

use crate::program::Program;

/// All passes in an order that lets each prepare the next, until nothing changes.
#[must_use]
pub fn optimise(program: &Program) -> Program {
    let mut program = program.clone();
    loop {
        let next = prune::prune(&reciprocal::reciprocals(&share::share(&fold::fold(
            &program,
        ))));
        if next == program {
            return program;
        }
        program = next;
    }
}
