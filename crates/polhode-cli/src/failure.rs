//! What went wrong, and the exit code it means.

use crate::harmless::harmless;
use crate::terminal;
use crate::verbosity::{self, Verbosity};
use polhode_scene::robot::RobotFileError;
use polhode_scene::{CheckpointError, CompareError, MeshFileError, OutputError, SceneFileError};
use std::io;
use std::process::ExitCode;

/// Exit code of a check that failed, or of a run that diverged or is degraded.
const CHECK: u8 = 1;

/// Exit code of a mistake on the command line or in a scene.
pub(crate) const USAGE: u8 = 2;

/// Exit code of input and output.
const INPUT_OUTPUT: u8 = 3;

/// Exit code of a run that Ctrl-C has ended: 128 and the number of the signal, as shells have it.
pub(crate) const INTERRUPTED: u8 = 130;

/// Exit code of a run that SIGTERM has ended: likewise.
#[cfg(unix)]
pub(crate) const TERMINATED: u8 = 143;

/// Why the program ends without success.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A check failed, or the run diverged or is degraded; the message may be empty when the result has been printed.
    Check(String),
    /// A run has not kept its promise; its report has been printed.
    Degraded(String),
    /// A mistake on the command line or in a scene.
    Usage(String),
    /// Reading or writing failed.
    InputOutput(String),
    /// Ctrl-C or SIGTERM: what was reached, and the exit code.
    Interrupted(String, u8),
    /// Whoever read the results has stopped reading.
    StdoutClosed,
}

impl Failure {
    /// What it says.
    pub(crate) fn message(&self) -> &str {
        match self {
            Self::Check(message)
            | Self::Degraded(message)
            | Self::Usage(message)
            | Self::InputOutput(message)
            | Self::Interrupted(message, _) => message,
            Self::StdoutClosed => "",
        }
    }

    /// The exit code that it means.
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Check(_) | Self::Degraded(_) => CHECK,
            Self::Usage(_) => USAGE,
            Self::InputOutput(_) => INPUT_OUTPUT,
            Self::Interrupted(_, code) => *code,
            Self::StdoutClosed => 0,
        }
    }

    /// Prints the message to stderr and gives the exit code.
    pub(crate) fn report(self) -> ExitCode {
        if !self.message().is_empty() {
            note(self.message());
        }
        ExitCode::from(self.code())
    }
}

/// Prints a message to stderr; when that is closed there is nobody to tell.
pub(crate) fn note(message: &str) {
    terminal::message(&harmless(message));
}

/// Prints what is good to know to stderr, unless the command line asks for quiet.
pub(crate) fn remark(message: &str) {
    if verbosity::asked() != Verbosity::Quiet {
        note(message);
    }
}

/// Prints what is being done to stderr, if the command line asks for it.
pub(crate) fn detail(message: &str) {
    if verbosity::asked() == Verbosity::Verbose {
        note(message);
    }
}

fn error(message: &impl ToString) -> String {
    format!("error: {}", message.to_string())
}

impl From<SceneFileError> for Failure {
    fn from(failure: SceneFileError) -> Self {
        // What is refused with its line is shown as it is: it begins with `error:` already.
        let is_shown =
            failure.refused().is_some() || matches!(failure, SceneFileError::Robot(RobotFileError::Refused(_)));
        let message = if is_shown { failure.to_string() } else { error(&failure) };
        if failure.is_input_output() { Self::InputOutput(message) } else { Self::Usage(message) }
    }
}

impl From<OutputError> for Failure {
    fn from(failure: OutputError) -> Self {
        if failure.is_input_output() { Self::InputOutput(error(&failure)) } else { Self::Usage(error(&failure)) }
    }
}

impl From<CheckpointError> for Failure {
    fn from(failure: CheckpointError) -> Self {
        match failure {
            CheckpointError::Scene(failure) => failure.into(),
            failure if failure.is_input_output() => Self::InputOutput(error(&failure)),
            failure => Self::Usage(error(&failure)),
        }
    }
}

impl From<MeshFileError> for Failure {
    fn from(failure: MeshFileError) -> Self {
        match failure {
            MeshFileError::Read { .. } => Self::InputOutput(error(&failure)),
            _ => Self::Usage(error(&failure)),
        }
    }
}

impl From<CompareError> for Failure {
    fn from(failure: CompareError) -> Self {
        match failure {
            CompareError::Read { .. } => Self::InputOutput(error(&failure)),
            CompareError::Content { .. } | CompareError::Tolerance(_) => Self::Usage(error(&failure)),
        }
    }
}

impl From<polhode_elastic::ElasticError> for Failure {
    fn from(failure: polhode_elastic::ElasticError) -> Self {
        Self::Usage(error(&failure))
    }
}

impl From<polhode::spatial::MassPropertiesError> for Failure {
    fn from(failure: polhode::spatial::MassPropertiesError) -> Self {
        Self::Usage(error(&failure))
    }
}

impl From<polhode::mesh::MeshError> for Failure {
    fn from(failure: polhode::mesh::MeshError) -> Self {
        Self::Usage(error(&failure))
    }
}

impl From<polhode::mesh::MonteCarloError> for Failure {
    fn from(failure: polhode::mesh::MonteCarloError) -> Self {
        Self::Usage(error(&failure))
    }
}

impl From<io::Error> for Failure {
    /// An error of writing to stdout.
    fn from(failure: io::Error) -> Self {
        match failure.kind() {
            io::ErrorKind::BrokenPipe => Self::StdoutClosed,
            _ => Self::InputOutput(format!("error: cannot write to stdout: {failure}")),
        }
    }
}
