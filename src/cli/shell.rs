//! `sextic completions`, `sextic man`: what a shell and a reader of manuals are given.

use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use super::Outcome;
use super::output::{finish, reason, wrong};

/// Writes what lets a shell complete the command
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  sextic completions bash > ~/.local/share/bash-completion/completions/sextic
  sextic completions zsh > ~/.zfunc/_sextic
  sextic completions fish > ~/.config/fish/completions/sextic.fish";

/// Writes the completions of a shell.
pub fn completions(arguments: &Arguments) -> Outcome {
    let (mut command, mut script) = (super::Arguments::command(), Vec::new());
    generate(arguments.shell, &mut command, "sextic", &mut script);
    finish(&String::from_utf8_lossy(&script), Outcome::AsExpected)
}

/// Writes the manual, for `man`.
pub fn manual() -> Outcome {
    let mut page = Vec::new();
    match Man::new(super::Arguments::command()).render(&mut page) {
        Ok(()) => finish(&String::from_utf8_lossy(&page), Outcome::AsExpected),
        Err(error) => wrong(
            &format!("the manual cannot be written: {}", reason(&error)),
            "`sextic --help` says the same",
        ),
    }
}
