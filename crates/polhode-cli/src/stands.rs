//! `polhode stands`: whether bodies stand, how firmly, what moves first, and what each contact carries; or up to which
//! value of a key they stand. The answers are those of [`polhode_study::stands`].

use crate::abandoned;
use crate::args::StandsArgs;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::mechanism_figure;
use crate::plots::{cannot_write, is_plot};
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::stdout;
use crate::text::stands;
use polhode::Scene;
use polhode_scene::{AtomicFile, Override};
use polhode_study::stands::{Interval, Question, Standing, StandsError, bisection_json, standing_json};
use std::io::Write as _;
use std::path::Path;

/// Says whether the bodies stand; exit code 1 where they do not.
pub(crate) fn stands(args: &StandsArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let text = SceneText::of(&args.scene.scene)?;
    let given = scene::overrides(&args.scene.changes)?;
    let load = |changes: &[Override]| text.load(changes);
    let question = Question { load: &load, given: &given };
    if let Some(interval) = &args.bisect {
        return bisect(args, &question, interval, interrupt);
    }
    if let Some(path) = args.picture.as_deref().filter(|path| !is_plot(path)) {
        return Err(Failure::Usage(format!("error: {}: unknown ending; accepted: .svg", path.display())));
    }
    let progress = Progress::new("looking for what holds the bodies");
    let (loaded, standing) = question.standing()?;
    drop(progress);
    if let Some(path) = &args.picture {
        draw(path, &loaded.scene, &standing)?;
    }
    if args.json {
        stdout::json(&standing_json(&loaded.scene, &standing))?;
    } else {
        stdout::text(&stands::page(&loaded.scene, &standing, args.contacts))?;
    }
    if standing.stands() { Ok(()) } else { Err(Failure::Check(String::new())) }
}

/// Finds the limit of a key.
fn bisect(args: &StandsArgs, question: &Question<'_>, interval: &str, interrupt: &Interrupt) -> Result<(), Failure> {
    let interval = Interval::parse(interval)?;
    let name = question.loaded(&[])?.scene.name().to_owned();
    let mut progress = Progress::new("looking for the limit");
    interrupt.wait_for_steps();
    let found = interval
        .bisect(question, args.digits, || if interrupt.has_come() { Err(StandsError::Stopped) } else { Ok(()) });
    progress.clear();
    match found {
        Err(StandsError::Stopped) => Err(Failure::Interrupted("the search was stopped".to_owned(), interrupt.code())),
        found => {
            let found = found?;
            if args.json {
                return stdout::json(&bisection_json(&name, &found));
            }
            stdout::text(&stands::limit(&name, &found))
        }
    }
}

/// Draws the mechanism.
fn draw(path: &Path, scene: &Scene, standing: &Standing) -> Result<(), Failure> {
    let title = stands::answer(scene, standing);
    let figure = mechanism_figure::of(scene, standing.mechanism.as_ref(), &title);
    let mut file = AtomicFile::create(path).map_err(|error| cannot_write(path, &error))?;
    abandoned::note(file.left_behind());
    let written = file.write_all(figure.as_bytes()).and_then(|()| file.commit());
    written.map_err(|error| cannot_write(path, &error))
}

impl From<StandsError> for Failure {
    fn from(error: StandsError) -> Self {
        match error {
            StandsError::Scene(error) => (*error).into(),
            StandsError::Simulation { .. } => Self::Check(format!("error: {error}")),
            StandsError::Interval(_) | StandsError::SameAtBothEnds { .. } => {
                Self::Usage(format!("error: --bisect {error}"))
            }
            error => Self::Usage(format!("error: {error}")),
        }
    }
}
