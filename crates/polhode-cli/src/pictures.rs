//! What a run is shown as: pages, pictures and models, which polhode-view makes.

use crate::abandoned;
use crate::drawing::Drawing;
use crate::failure::{self, Failure};
use crate::heading::Heading;
use crate::interrupt::Interrupt;
use crate::mechanism_figure;
use polhode::{BodyError, BodySample, Event, Flow, Frame, Observer, Simulation};
use polhode_scene::{AtomicFile, LoadedScene};
use polhode_view::animation::{FPS, Pace, Watcher, write_apng, write_gif, write_webp};
use polhode_view::camera::Viewpoint;
use polhode_view::glb::write_glb;
use polhode_view::overlay::Overlay;
use polhode_view::page::{AtFirst, MOST_FRAMES};
use polhode_view::raster::PictureSize;
use polhode_view::still::{still_with, write_png};
use polhode_view::{FrameSource, Page, PageRun, Recording, ViewError};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Endings of the files that show a run.
pub(crate) const ENDINGS: &str = ".html, .png, .gif, .apng, .webp, .glb";

/// How a run is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A page that plays it.
    Page,
    /// A picture of its last frame, as PNG.
    Still,
    /// A moving picture.
    Gif,
    /// A moving picture.
    Apng,
    /// A moving picture.
    WebP,
    /// An animated model, as binary glTF.
    Model,
}

impl Kind {
    /// The kind that the ending of a name says; none of a file that shows nothing.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
        match ending.as_str() {
            "html" => Some(Self::Page),
            "png" => Some(Self::Still),
            "gif" => Some(Self::Gif),
            "apng" => Some(Self::Apng),
            "webp" => Some(Self::WebP),
            "glb" => Some(Self::Model),
            _ => None,
        }
    }

    /// Whether it is a moving picture.
    pub(crate) fn moves(self) -> bool {
        matches!(self, Self::Gif | Self::Apng | Self::WebP)
    }

    /// Whether it is a picture, still or moving.
    pub(crate) fn is_picture(self) -> bool {
        self == Self::Still || self.moves()
    }
}

/// The files that show one or two runs, written while they go on.
pub(crate) struct Pictures {
    pages: Vec<(PathBuf, Page<AtomicFile>)>,
    page_runs: Vec<(PathBuf, PageRun<AtomicFile>)>,
    files: Vec<(Kind, AtomicFile)>,
    /// The temporary names of all of them.
    temporary: Vec<PathBuf>,
    recording: Option<Recording>,
    options: Options,
}

/// What the command line asks of them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Options {
    /// Least time between frames, s; without it what suits their kind.
    pub(crate) least_interval_s: Option<f64>,
    /// Width and height of pictures, pixels; without it what suits their kind.
    pub(crate) size: Option<[u32; 2]>,
    /// From where pictures are taken.
    pub(crate) viewpoint: Viewpoint,
    /// What is drawn over the bodies of pictures.
    pub(crate) overlays: Vec<Overlay>,
    /// What pages do at first.
    pub(crate) at_first: AtFirst,
}

impl Options {
    /// Width and height of a kind of picture.
    fn size_of(&self, kind: Kind) -> Result<PictureSize, ViewError> {
        let usual = if kind.moves() { PictureSize::MOVING } else { PictureSize::STILL };
        self.size.map_or(Ok(usual), |[width, height]| PictureSize::new(width, height))
    }
}

impl Pictures {
    /// Opens the files.
    ///
    /// # Errors
    /// When a name is given twice or a file cannot be opened.
    pub(crate) fn create(paths: &[PathBuf], heading: &Heading, options: Options) -> Result<Self, Failure> {
        let (pages, page_runs, files, temporary) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let at_first = options.at_first;
        let mut pictures = Self { pages, page_runs, files, temporary, recording: None, options };
        for (number, path) in paths.iter().enumerate() {
            if paths[..number].contains(path) {
                let what = format!("error: {} is named twice: every output needs a file of its own", path.display());
                return Err(Failure::Usage(what));
            }
            let Some(kind) = Kind::of(path) else { continue };
            let file = AtomicFile::create(path).map_err(|error| failure(path, ViewError::Write(error)))?;
            abandoned::note(file.left_behind());
            pictures.temporary.extend(file.temporary().map(Path::to_owned));
            match kind {
                Kind::Page => {
                    let page = Page::begin(file, &heading.title, &heading.description);
                    let page = page.map_err(|error| failure(path, error))?;
                    pictures.pages.push((path.clone(), page.at_first(at_first)));
                }
                kind => {
                    // Known before the run, not after it.
                    pictures.options.size_of(kind).map_err(|error| failure(path, error))?;
                    pictures.files.push((kind, file));
                }
            }
        }
        Ok(pictures)
    }

    /// Begins a run; pictures and models are of the first.
    ///
    /// # Errors
    /// When the scene has no bodies.
    pub(crate) fn begin_run(&mut self, loaded: &LoadedScene, name: &str, source: FrameSource) -> Result<(), Failure> {
        for (path, page) in self.pages.drain(..) {
            let run = page.begin_run(&loaded.scene, name, source).map_err(|error| failure(&path, error))?;
            let run = run.shown_as(loaded.appearance());
            self.page_runs.push((path, run.with_least_interval(self.options.least_interval_s.unwrap_or_default())));
        }
        if let (Some((_, file)), None) = (self.files.first(), &self.recording) {
            self.recording = Some(self.recording_of(loaded).map_err(|error| failure(file.target(), error))?);
        }
        Ok(())
    }

    /// Looks at a simulation before it begins: pages show what of its bodies at rest would move first.
    pub(crate) fn begin_simulation(&mut self, loaded: &LoadedScene, simulation: &Simulation) {
        let is_first = self.page_runs.iter().all(|(_, run)| run.is_first());
        if self.page_runs.is_empty() || !is_first {
            return;
        }
        if let Some(figure) = mechanism_figure::at_start(loaded, simulation) {
            self.page_runs.iter_mut().for_each(|(_, run)| run.show_mechanism(&figure.caption, &figure.svg));
        }
    }

    /// Takes a recording that has ended for the motion of the scene.
    pub(crate) fn take(&mut self, recording: Recording) {
        self.recording = Some(recording);
    }

    /// The recording that pictures and models are made from: of a picture alone only the last frame counts.
    fn recording_of(&self, loaded: &LoadedScene) -> Result<Recording, ViewError> {
        let (scene, least) = (&loaded.scene, self.options.least_interval_s);
        let recording = if self.files.iter().all(|(kind, _)| *kind == Kind::Still) {
            Recording::for_still(scene)
        } else if self.files.iter().any(|(kind, _)| kind.moves()) {
            Recording::new(scene, least.unwrap_or(1.0 / FPS))
        } else {
            Recording::new(scene, least.unwrap_or_default().max(scene.duration_s() / MOST_FRAMES))
        };
        let recording = recording?.shown_as(loaded.appearance());
        Ok(if self.options.overlays.contains(&Overlay::Forces) { recording.with_forces() } else { recording })
    }

    /// Ends the run.
    ///
    /// # Errors
    /// When it has no frame, or something could not be written.
    pub(crate) fn end_run(&mut self, outcome: &str) -> Result<(), Failure> {
        for (path, run) in self.page_runs.drain(..) {
            let page = run.end(outcome).map_err(|error| failure(&path, error))?;
            self.pages.push((path, page));
        }
        Ok(())
    }

    /// The temporary names under which pages, pictures and models grow.
    pub(crate) fn temporary(&self) -> &[PathBuf] {
        &self.temporary
    }

    /// Completes the files and moves them to their names.
    ///
    /// # Errors
    /// When something cannot be written, or drawing is stopped.
    pub(crate) fn finish(mut self, report: &Value, interrupt: &Interrupt) -> Result<(), Failure> {
        for (path, page) in self.pages {
            let mut file = page.finish(report).map_err(|error| failure(&path, error))?;
            file.commit().map_err(|error| failure(&path, ViewError::Write(error)))?;
        }
        let Some(mut recording) = self.recording.take() else { return Ok(()) };
        let drawing = Drawing::watched_by(interrupt);
        for (number, (kind, mut file)) in self.files.into_iter().enumerate() {
            let ended = if number == 0 { recording.end() } else { Ok(()) };
            if ended.is_ok() && kind.moves() {
                note_turns(&recording, file.target());
            }
            ended
                .and_then(|()| encode(&recording, kind, &self.options, &drawing, &mut file))
                .and_then(|()| file.commit().map_err(ViewError::Write))
                .map_err(|error| match error {
                    ViewError::Stopped { .. } => Failure::Interrupted(said(file.target(), &error), drawing.code()),
                    error => failure(file.target(), error),
                })?;
        }
        Ok(())
    }

    fn observers(&mut self) -> impl Iterator<Item = &mut dyn Observer> {
        let pages = self.page_runs.iter_mut().map(|(_, run)| run as &mut dyn Observer);
        pages.chain(self.recording.iter_mut().map(|recording| recording as &mut dyn Observer))
    }
}

impl Observer for Pictures {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.observers().for_each(|observer| observer.sample(t, bodies));
    }

    fn event(&mut self, event: &Event) {
        self.observers().for_each(|observer| observer.event(event));
    }

    fn wants_frames(&self) -> bool {
        let has_recording = self.recording.as_ref().is_some_and(Observer::wants_frames);
        has_recording || self.page_runs.iter().any(|(_, run)| run.wants_frames())
    }

    fn frame(&mut self, frame: &Frame) {
        self.observers().for_each(|observer| observer.frame(frame));
    }

    fn wants_errors(&self) -> bool {
        self.page_runs.iter().any(|(_, run)| run.wants_errors())
    }

    fn errors(&mut self, t: f64, errors: Option<&[BodyError]>) {
        self.observers().for_each(|observer| observer.errors(t, errors));
    }

    fn progress(&mut self, t: f64) -> Flow {
        let stops = self.observers().any(|observer| observer.progress(t) == Flow::Stop);
        if stops { Flow::Stop } else { Flow::Continue }
    }
}

/// Says of a moving picture that a body turns too far from frame to frame for its sense to be seen.
fn note_turns(recording: &Recording, path: &Path) {
    let Some((body, angle)) = recording.largest_turn().filter(|(_, angle)| *angle > std::f64::consts::PI) else {
        return;
    };
    let turns = angle / std::f64::consts::TAU;
    failure::remark(&format!(
        "note: {}: body {body} turns up to {turns:.2} times from frame to frame, and may seem to turn backwards; \
         `polhode view --fps` with more frames, or a page (.html), shows how it turns",
        path.display()
    ));
}

/// Writes a recording into a file of a kind.
fn encode(
    recording: &Recording,
    kind: Kind,
    options: &Options,
    drawing: &Drawing<'_>,
    file: &mut AtomicFile,
) -> Result<(), ViewError> {
    let size = options.size_of(kind)?;
    let told = |drawn| drawing.reached(drawn);
    let pace = || {
        drawing.begin(recording.times().len());
        let pace = Pace::new(recording, size)?.seen_from(&options.viewpoint)?;
        Ok::<_, ViewError>(pace.with_overlays(&options.overlays).watched_by(Watcher(&told)))
    };
    match kind {
        Kind::Still => {
            let last = recording.times().len().saturating_sub(1);
            write_png(&still_with(recording, last, &options.viewpoint, size, &options.overlays)?, file)
        }
        Kind::Gif => write_gif(&pace()?, file),
        Kind::Apng => write_apng(&pace()?, file),
        Kind::WebP => write_webp(&pace()?, file),
        Kind::Model => write_glb(recording, file),
        // Pages are written while the run goes on.
        Kind::Page => Ok(()),
    }
}

/// A message about this file.
fn said(path: &Path, error: &ViewError) -> String {
    format!("{}: {error}", path.display())
}

/// A failure of making this file.
fn failure(path: &Path, error: ViewError) -> Failure {
    match error {
        ViewError::Write(error) => Failure::InputOutput(format!("error: cannot write {}: {error}", path.display())),
        error @ ViewError::Encoding(_) => Failure::InputOutput(format!("error: {}", said(path, &error))),
        error => Failure::Usage(format!("error: {}", said(path, &error))),
    }
}
