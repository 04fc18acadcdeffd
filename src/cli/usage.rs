//! Arguments that the command does not have, and what is meant by them.

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Error};

use crate::stability::variable::Variable;

use super::Arguments;

/// What is wrong with the arguments, with how a quantity of a case is set where one is named as an option.
pub fn with_cure(mut error: Error) -> Error {
    let cure = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(option)) => cure(option),
        _ => None,
    };
    if let Some(cure) = cure {
        let cure = ContextValue::StyledStrs(vec![StyledStr::from(cure)]);
        error.insert(ContextKind::Suggested, cure);
    }
    error
}

/// How the quantity is set that an option names; `None` where the subcommand sets nothing, or has that option.
fn cure(option: &str) -> Option<String> {
    let command = Arguments::command();
    let name = std::env::args().find(|own| command.find_subcommand(own).is_some())?;
    let command = command.find_subcommand(name)?;
    let has = |name: &str| {
        command
            .get_arguments()
            .any(|own| own.get_long() == Some(name))
    };
    let bare = option.trim_start_matches('-');
    let variable = match bare {
        "alpha" => Variable::ANGLE,
        name => Variable::named(name)?,
    };
    let value = given(option).unwrap_or_else(|| "VALUE".to_string());
    (has("set") && !has(bare)).then(|| {
        format!(
            "a quantity of a case is set by `--set {}={value}`",
            variable.name
        )
    })
}

/// The number behind an option.
fn given(option: &str) -> Option<String> {
    let mut arguments = std::env::args().skip_while(|own| own != option);
    arguments.nth(1).filter(|own| own.parse::<f64>().is_ok())
}
