//! The command `sextic`.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    sextic::cli::run()
}
