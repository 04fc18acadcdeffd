//! The command line: one file a subcommand; nothing else reads or writes files.

mod audit;
#[cfg(feature = "stability")]
mod case;
mod certify;
mod colour;
#[cfg(feature = "stability")]
mod compare;
mod evaluate;
#[cfg(feature = "stability")]
mod figures;
#[cfg(feature = "stability")]
mod file;
mod folder;
mod generate;
mod match_coefficients;
#[cfg(feature = "stability")]
mod modes;
#[cfg(feature = "stability")]
mod mutate;
mod new;
mod output;
#[cfg(feature = "stability")]
mod partial;
#[cfg(feature = "stability")]
mod picture;
mod progress;
#[cfg(feature = "stability")]
mod report;
mod shell;
mod show;
mod source;
#[cfg(feature = "stability")]
mod speeds;
#[cfg(feature = "stability")]
mod stability;
#[cfg(feature = "stability")]
mod sweep;
#[cfg(feature = "stability")]
mod system;
#[cfg(feature = "stability")]
mod usage;
#[cfg(feature = "stability")]
mod validity;
#[cfg(feature = "stability")]
mod view;
mod vocabulary;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use colour::Colour;

/// What a command found, in the order in which one outweighs another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    /// All is as the documents expect.
    AsExpected,
    /// A verdict differs, or a check fails.
    Differs,
    /// The input is wrong.
    WrongInput,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        ExitCode::from(match outcome {
            Outcome::AsExpected => 0,
            Outcome::Differs => 1,
            Outcome::WrongInput => 2,
        })
    }
}

/// Derives and audits closed-form stability criteria, exactly.
///
/// A derivation is a Markdown document whose equations, in blocks fenced as `sextic`, are checked by
/// exact algebra. Documents come with the command; a path names one of your own. What they derive is
/// compared with numbers: `sextic stability` shows where a section gallops.
#[derive(Debug, Parser)]
#[command(name = "sextic", version, after_help = EXIT_STATUS)]
struct Arguments {
    /// Whether text has colours: auto (where a terminal shows them), always, or never
    #[arg(
        long,
        global = true,
        value_enum,
        default_value_t = Colour::Auto,
        value_name = "WHEN",
        display_order = 1000,
        hide_possible_values = true,
        hide_default_value = true
    )]
    color: Colour,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Audit(audit::Arguments),
    Match(match_coefficients::Arguments),
    Certify(certify::Arguments),
    Show(show::Arguments),
    #[cfg(feature = "stability")]
    Mutate(mutate::Arguments),
    Generate(generate::Arguments),
    Evaluate(evaluate::Arguments),
    #[cfg(feature = "stability")]
    Stability(stability::Arguments),
    #[cfg(feature = "stability")]
    Sweep(sweep::Arguments),
    #[cfg(feature = "stability")]
    Speeds(speeds::Arguments),
    #[cfg(feature = "stability")]
    Modes(modes::Arguments),
    #[cfg(feature = "stability")]
    Compare(compare::Arguments),
    #[cfg(feature = "stability")]
    Validity(validity::Arguments),
    #[cfg(feature = "stability")]
    Figures(figures::Arguments),
    #[cfg(feature = "stability")]
    Report(report::Arguments),
    Completions(shell::Arguments),
    /// Writes the manual of the command, for `man -l -`
    #[command(hide = true)]
    Man,
}

const EXIT_STATUS: &str = "\
Exit status:
  0  all is as the document expects, also where it asserts nothing, which is said
  1  a verdict differs, or a check fails
  2  the input is wrong, or has no `sextic` block; a file cannot be written

Results go to standard output, diagnostics to standard error; `-` in place of a document is
standard input. NO_COLOR is honoured.";

/// Runs the command that the arguments of the process ask for.
pub fn run() -> ExitCode {
    let arguments = Arguments::try_parse();
    #[cfg(feature = "stability")]
    let arguments = arguments.map_err(usage::with_cure);
    let arguments = arguments.unwrap_or_else(|error| error.exit());
    arguments.color.apply();
    let outcome = match arguments.command {
        Command::New(arguments) => new::run(&arguments),
        Command::Audit(arguments) => audit::run(&arguments),
        Command::Match(arguments) => match_coefficients::run(&arguments),
        Command::Certify(arguments) => certify::run(&arguments),
        Command::Show(arguments) => show::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Mutate(arguments) => mutate::run(&arguments),
        Command::Generate(arguments) => generate::run(&arguments),
        Command::Evaluate(arguments) => evaluate::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Stability(arguments) => stability::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Sweep(arguments) => sweep::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Speeds(arguments) => speeds::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Modes(arguments) => modes::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Compare(arguments) => compare::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Validity(arguments) => validity::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Figures(arguments) => figures::run(&arguments),
        #[cfg(feature = "stability")]
        Command::Report(arguments) => report::run(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments),
        Command::Man => shell::manual(),
    };
    outcome.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    /// Longer lines would be broken within a table or an example.
    #[test]
    fn help_is_no_wider_than_it_is_shown() {
        const COLUMNS: usize = 100;
        for command in Arguments::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string);
            for line in help.unwrap_or_default().lines() {
                let name = command.get_name();
                assert!(line.chars().count() <= COLUMNS, "{name}: {line}");
            }
        }
    }

    #[test]
    fn wrong_input_outweighs_all() {
        assert!(Outcome::WrongInput > Outcome::Differs);
        assert!(Outcome::Differs > Outcome::AsExpected);
    }
}
