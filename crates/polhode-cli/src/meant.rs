//! The command that was meant by one that does not exist, or that has an option which another one was given.
//!
//! clap suggests commands that are alike by the measure of Jaro, for which two letters exchanged in a short word
//! (`rnu`) are no likeness at all. Here a slip of the pen is a letter too many or too few, another one, or two
//! neighbours exchanged.

use clap::Command;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};

/// The error of a command line, with the command that was meant where clap names none.
pub(crate) fn with_suggestion(mut error: Error, program: &Command) -> Error {
    if error.kind() == ErrorKind::UnknownArgument {
        if let Some(tip) = commands_with(&error, program) {
            error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
        }
        return error;
    }
    if error.kind() != ErrorKind::InvalidSubcommand || error.get(ContextKind::SuggestedSubcommand).is_some() {
        return error;
    }
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else { return error };
    let names = program.get_subcommands().filter(|command| !command.is_hide_set()).map(Command::get_name);
    let near: Vec<String> = names.filter(|name| polhode_scene::is_slip_of(word, name)).map(str::to_owned).collect();
    if !near.is_empty() {
        error.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(near));
    }
    error
}

/// Which commands have the option that one has been given and does not have.
fn commands_with(error: &Error, program: &Command) -> Option<String> {
    let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidArg) else { return None };
    let option = given.strip_prefix("--")?.split('=').next()?;
    let has = |command: &&Command| command.get_arguments().any(|own| own.get_long() == Some(option));
    let shown = program.get_subcommands().filter(|command| !command.is_hide_set());
    let named: Vec<String> = shown.filter(has).map(|command| format!("`polhode {}`", command.get_name())).collect();
    let last = named.last()?;
    let list = match &named[..named.len() - 1] {
        [] => format!("{last} has"),
        others => format!("{} and {last} have", others.join(", ")),
    };
    Some(format!("{list} --{option}"))
}
