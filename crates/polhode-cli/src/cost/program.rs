//! The program as the host of a study: a bar on stderr, and instructions counted by running itself.

use super::instructions;
use crate::args::ChangeArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use polhode_scene::Override;
use polhode_study::source::Load;
use polhode_study::{Candidate, Host, Source, Study, StudyError};

/// The program while a study runs.
struct Program<'a> {
    text: &'a SceneText<'a>,
    changes: &'a ChangeArgs,
    given: Vec<Override>,
    progress: Progress,
}

impl Host for Program<'_> {
    fn phase(&self, what: &'static str, count: usize) {
        self.progress.phase(what, count);
    }

    fn part_done(&self) {
        self.progress.part_done();
    }

    fn instructions(&self, candidate: &Candidate, sampling: &Override) -> Result<u64, String> {
        let changes: Vec<&Override> = self.given.iter().chain(&candidate.changes).chain([sampling]).collect();
        instructions::count(self.text, scene::effects(self.changes), &changes)
    }
}

/// A scene as a study reads it, with the changes of a command.
pub(super) fn source<'a>(load: &'a Load<'a>, changes: &ChangeArgs, host: &'a dyn Host) -> Result<Source<'a>, Failure> {
    Ok(Source { load, given: scene::overrides(changes)?, effects: scene::effects(changes), host })
}

/// A study, whose progress is shown.
pub(super) fn study<'a>(
    text: &'a SceneText<'a>,
    changes: &'a ChangeArgs,
    run: impl FnOnce(&Source<'_>) -> Result<Study, StudyError>,
) -> Result<Study, Failure> {
    let given = scene::overrides(changes)?;
    let program = Program { text, changes, given, progress: Progress::new("reading the scene") };
    let load = |changes: &[Override]| text.load(changes);
    let study = run(&source(&load, changes, &program)?);
    Ok(study?)
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Scene(error) => error.into(),
            StudyError::Axis(fault) => Self::Usage(format!("error: --vary {fault}")),
            StudyError::NotReached { .. } => {
                Self::Check(format!("error: {error}; vary steps or tolerances with `polhode cost --vary`"))
            }
            error => Self::Check(format!("error: {error}")),
        }
    }
}
