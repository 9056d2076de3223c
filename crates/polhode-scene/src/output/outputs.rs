//! The observer that writes files.

use super::atomic_file::{AtomicFile, LeftBehind, Unfinished};
use super::csv::Csv;
use super::held_back::{HeldBack, Told};
use super::json::Json;
use super::npy::Npy;
use super::{ErrorColumns, Sink, TrajectoryFormat, contacts, cut_to_line, events, joints};
use polhode::{BodyError, BodySample, ContactSample, Event, Flow, JointSample, Observer, Scene};
use std::fs::File;
use std::io::{self, Cursor, Write as _};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why output could not be written.
#[derive(Debug, Error)]
pub enum OutputError {
    /// The ending of a file's name says no kind of trajectory.
    #[error("{}: unknown ending; accepted: .csv, .npy, .json", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The ending of a file's name says that it holds something else than events.
    #[error("{}: events, joints and contacts are written as CSV: name a file that ends in .csv", path.display())]
    EventsEnding {
        /// The file.
        path: PathBuf,
    },
    /// Two outputs have one name.
    #[error("{} is named twice: every output needs a file of its own", path.display())]
    Twice {
        /// The file.
        path: PathBuf,
    },
    /// A file could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file could not be written; what had been is kept.
    #[error("{fault}; what was written is kept in {}", list(kept))]
    Kept {
        /// Why the run stopped.
        fault: Box<Self>,
        /// The files.
        kept: Vec<PathBuf>,
    },
}

/// Makes a readable file of one that a killed program has left behind; one without samples has the length `empty`.
///
/// # Errors
/// When the file cannot be mended, or there is nothing in it.
fn mended(file: &mut File, empty: u64, mend: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    mend(file)?;
    if file.metadata()?.len() > empty { Ok(()) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
}

/// The length of a file of this kind without samples, bytes.
fn length_without_samples(format: &mut dyn TrajectoryFormat) -> io::Result<u64> {
    let mut empty = Cursor::new(Vec::new());
    format.begin(&mut empty)?;
    format.end(&mut empty)?;
    Ok(empty.get_ref().len() as u64)
}

/// Whether the ending of a name fits events: `.csv`, or none.
fn may_hold_events(path: &Path) -> bool {
    path.extension().is_none_or(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// Names of files, in a line.
fn list(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
}

impl OutputError {
    /// Whether writing failed, as opposed to what was asked for.
    pub fn is_input_output(&self) -> bool {
        matches!(self, Self::Write { .. } | Self::Kept { .. })
    }
}

/// Writes the samples and events of a run to files while it goes on.
///
/// The first fault stops the run at the end of the step; [`Outputs::finish`] returns it. All files reach the disk
/// together, at the ends of steps.
#[derive(Debug)]
pub struct Outputs {
    bodies: Vec<String>,
    trajectories: Vec<(AtomicFile, Box<dyn TrajectoryFormat>)>,
    events: Option<AtomicFile>,
    /// The file of joints, and their names.
    joints: Option<(AtomicFile, Vec<String>)>,
    contacts: Option<AtomicFile>,
    /// What waits for the errors of a sample; none where errors are not written.
    held: Option<HeldBack>,
    fault: Option<OutputError>,
}

impl Outputs {
    /// Opens files for the trajectory of `scene`, of the kinds their endings say, and for its events (CSV).
    ///
    /// # Errors
    /// When an ending is unknown or that of events is another than `.csv`, a name is given twice or a file cannot be
    /// opened.
    pub fn create(scene: &Scene, trajectories: &[PathBuf], events: Option<&Path>) -> Result<Self, OutputError> {
        Self::create_with(ErrorColumns::Absent, scene, trajectories, events)
    }

    /// The same of a trajectory with the estimated errors of the bodies. A sample is written when its errors are known.
    ///
    /// # Errors
    /// See [`Outputs::create`].
    pub fn create_with_errors(
        scene: &Scene,
        trajectories: &[PathBuf],
        events: Option<&Path>,
    ) -> Result<Self, OutputError> {
        let outputs = Self::create_with(ErrorColumns::Written, scene, trajectories, events)?;
        // Events and joints alone wait for nothing.
        let held = (!trajectories.is_empty()).then(HeldBack::default);
        Ok(Self { held, ..outputs })
    }

    fn create_with(
        error_columns: ErrorColumns,
        scene: &Scene,
        trajectories: &[PathBuf],
        events: Option<&Path>,
    ) -> Result<Self, OutputError> {
        let bodies: Vec<String> = scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let mut all: Vec<&Path> = trajectories.iter().map(PathBuf::as_path).chain(events).collect();
        all.sort();
        if let Some(pair) = all.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(OutputError::Twice { path: pair[0].to_owned() });
        }
        if let Some(path) = events.filter(|path| !may_hold_events(path)) {
            return Err(OutputError::EventsEnding { path: path.to_owned() });
        }
        let mut formats = Vec::with_capacity(trajectories.len());
        for path in trajectories {
            formats.push(format_of(path, scene.name(), &bodies, error_columns)?);
        }
        let mut outputs = Self {
            bodies,
            trajectories: Vec::new(),
            events: None,
            joints: None,
            contacts: None,
            held: None,
            fault: None,
        };
        for (path, mut format) in trajectories.iter().zip(formats) {
            let mut mender = format.mender();
            let file = AtomicFile::create_mending(path, |open| {
                let empty = length_without_samples(mender.as_mut())?;
                mended(open, empty, |open| mender.mend(open))
            });
            let mut file = file.map_err(|source| fault(path, source))?;
            format.begin(&mut file).map_err(|source| fault(path, source))?;
            outputs.trajectories.push((file, format));
        }
        if let Some(path) = events {
            outputs.events = Some(table(path, events::begin)?);
        }
        Ok(outputs)
    }

    /// The same with a file (CSV) of the joints, which have these names by their handles.
    ///
    /// # Errors
    /// When its ending is another than `.csv`, its name is that of another output, or it cannot be opened.
    pub fn with_joints(mut self, path: &Path, names: Vec<String>) -> Result<Self, OutputError> {
        let file = self.another_table(path, joints::begin)?;
        self.joints = Some((file, names));
        Ok(self)
    }

    /// The same with a file (CSV) of the contacts: points, normals, forces, and what of them is not unique.
    ///
    /// # Errors
    /// As [`Outputs::with_joints`].
    pub fn with_contacts(mut self, path: &Path) -> Result<Self, OutputError> {
        self.contacts = Some(self.another_table(path, contacts::begin)?);
        Ok(self)
    }

    /// A further table.
    fn another_table(
        &mut self,
        path: &Path,
        begin: impl Fn(&mut dyn Sink) -> io::Result<()>,
    ) -> Result<AtomicFile, OutputError> {
        if !may_hold_events(path) {
            return Err(OutputError::EventsEnding { path: path.to_owned() });
        }
        if self.files().any(|file| file.target() == path) {
            return Err(OutputError::Twice { path: path.to_owned() });
        }
        table(path, begin)
    }

    /// Completes all files and moves them to their names.
    ///
    /// # Errors
    /// The first fault of writing. No file then appears under its own name but those that were moved before the fault;
    /// what had been written of the others is kept as [`Outputs::keep_partial`] does.
    pub fn finish(mut self) -> Result<(), OutputError> {
        let written = match self.fault.take() {
            Some(fault) => Err(fault),
            None => self.complete(),
        };
        written.map_err(|fault| self.salvaged(fault))
    }

    fn complete(&mut self) -> Result<(), OutputError> {
        self.end()?;
        for file in self.files() {
            file.commit().map_err(|source| fault(file.target(), source))?;
        }
        Ok(())
    }

    /// The fault, and what could be kept of the files after it.
    fn salvaged(&mut self, fault: OutputError) -> OutputError {
        let mut kept = Vec::new();
        for (file, format) in &mut self.trajectories {
            kept.extend(file.salvage(|open| format.mend(open)));
        }
        kept.extend(self.events.as_mut().and_then(|file| file.salvage(cut_to_line).ok()));
        kept.extend(self.joints.as_mut().and_then(|(file, _)| file.salvage(cut_to_line).ok()));
        kept.extend(self.contacts.as_mut().and_then(|file| file.salvage(cut_to_line).ok()));
        if kept.is_empty() { fault } else { OutputError::Kept { fault: Box::new(fault), kept } }
    }

    /// What programs that were killed while they wrote the same files had left behind.
    pub fn left_behind(&self) -> Vec<LeftBehind> {
        let files = self.trajectories.iter().map(|(file, _)| file).chain(&self.events);
        let files = files.chain(self.joints.iter().map(|(file, _)| file)).chain(&self.contacts);
        files.flat_map(|file| file.left_behind().to_vec()).collect()
    }

    /// Where the files grow, for a program that must end at once.
    pub fn unfinished(&self) -> Vec<Unfinished> {
        let trajectories = self.trajectories.iter().filter_map(|(file, format)| {
            let mut mender = format.mender();
            file.unfinished(move |open| mender.mend(open))
        });
        let events = self.events.as_ref().and_then(|file| file.unfinished(cut_to_line));
        let joints = self.joints.as_ref().and_then(|(file, _)| file.unfinished(cut_to_line));
        let contacts = self.contacts.as_ref().and_then(|file| file.unfinished(cut_to_line));
        trajectories.chain(events).chain(joints).chain(contacts).collect()
    }

    /// After a run that failed: keeps what has been written under the names with `.partial` at their end, which are
    /// returned. What stood under the names themselves stays.
    ///
    /// # Errors
    /// As [`Outputs::finish`].
    pub fn keep_partial(mut self) -> Result<Vec<PathBuf>, OutputError> {
        let kept = match self.fault.take() {
            Some(fault) => Err(fault),
            None => self.kept(),
        };
        kept.map_err(|fault| self.salvaged(fault))
    }

    fn kept(&mut self) -> Result<Vec<PathBuf>, OutputError> {
        self.end()?;
        self.files().map(|file| file.keep_partial().map_err(|source| fault(file.target(), source))).collect()
    }

    /// Brings all files to the disk as soon as a part of one has come there: what a program that is killed leaves of
    /// samples, events, joints and contacts ends at the same time.
    fn flush_together(&mut self) -> Result<(), OutputError> {
        if !self.files().any(|file| file.has_spilled()) {
            return Ok(());
        }
        for file in self.files() {
            file.flush().map_err(|source| fault(file.target(), source))?;
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), OutputError> {
        self.release(f64::INFINITY, None);
        self.fault.take().map_or(Ok(()), Err)?;
        for (file, format) in &mut self.trajectories {
            format.end(file).map_err(|source| fault(file.target(), source))?;
        }
        Ok(())
    }

    fn files(&mut self) -> impl Iterator<Item = &mut AtomicFile> {
        let joints = self.joints.iter_mut().map(|(file, _)| file);
        let tables = self.events.iter_mut().chain(joints).chain(&mut self.contacts);
        self.trajectories.iter_mut().map(|(file, _)| file).chain(tables)
    }
}

impl Outputs {
    fn write_sample(&mut self, t: f64, bodies: &[BodySample], errors: Option<&[BodyError]>) {
        if self.fault.is_some() {
            return;
        }
        for (file, format) in &mut self.trajectories {
            if let Err(source) = format.sample(file, t, bodies, errors) {
                self.fault = Some(fault(file.target(), source));
                return;
            }
        }
    }

    fn write_event(&mut self, event: &Event) {
        if self.fault.is_some() {
            return;
        }
        if let Some(file) = &mut self.events
            && let Err(source) = events::row(file, event, &self.bodies)
        {
            self.fault = Some(fault(file.target(), source));
        }
    }

    fn write_joints(&mut self, t_s: f64, joints: &[JointSample]) {
        if self.fault.is_some() {
            return;
        }
        if let Some((file, names)) = &mut self.joints
            && let Err(source) = joints::rows(file, t_s, joints, names)
        {
            self.fault = Some(fault(file.target(), source));
        }
    }

    fn write_contacts(&mut self, t_s: f64, contacts: &[ContactSample]) {
        if self.fault.is_some() {
            return;
        }
        if let Some(file) = &mut self.contacts
            && let Err(source) = contacts::rows(file, t_s, contacts, &self.bodies)
        {
            self.fault = Some(fault(file.target(), source));
        }
    }

    /// Writes what was told until the sample at `t` (s), which has these errors.
    fn release(&mut self, t: f64, errors: Option<&[BodyError]>) {
        while let Some(told) = self.held.as_mut().and_then(|held| held.pop_until(t)) {
            match told {
                Told::Sample(sample_s, bodies) => {
                    self.write_sample(sample_s, &bodies, errors.filter(|_| sample_s == t));
                }
                Told::Event(event) => self.write_event(&event),
                Told::Joints(t_s, joints) => self.write_joints(t_s, &joints),
                Told::Contacts(t_s, contacts) => self.write_contacts(t_s, &contacts),
            }
        }
    }
}

impl Observer for Outputs {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        let Some(held) = &mut self.held else {
            self.write_sample(t, bodies, None);
            return;
        };
        held.push(Told::Sample(t, bodies.to_vec()));
        while let Some(first_s) = self.held.as_ref().and_then(HeldBack::overdue_s) {
            self.release(first_s, None);
        }
    }

    fn event(&mut self, event: &Event) {
        match &mut self.held {
            Some(held) => held.push(Told::Event(*event)),
            None => self.write_event(event),
        }
    }

    fn wants_joints(&self) -> bool {
        self.joints.is_some()
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        match &mut self.held {
            Some(held) => held.push(Told::Joints(t_s, joints.to_vec())),
            None => self.write_joints(t_s, joints),
        }
    }

    fn wants_contacts(&self) -> bool {
        self.contacts.is_some()
    }

    fn contacts(&mut self, t_s: f64, contacts: &[ContactSample]) {
        match &mut self.held {
            Some(held) => held.push(Told::Contacts(t_s, contacts.to_vec())),
            None => self.write_contacts(t_s, contacts),
        }
    }

    fn wants_errors(&self) -> bool {
        self.held.is_some()
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        self.release(t_s, errors);
    }

    fn progress(&mut self, _t: f64) -> Flow {
        // The events of a step are told after its samples: here both are.
        if self.fault.is_none() {
            self.fault = self.flush_together().err();
        }
        if self.fault.is_some() { Flow::Stop } else { Flow::Continue }
    }
}

/// Opens a table, with its first line.
fn table(path: &Path, begin: impl Fn(&mut dyn Sink) -> io::Result<()>) -> Result<AtomicFile, OutputError> {
    let file = AtomicFile::create_mending(path, |open| {
        let mut empty = Cursor::new(Vec::new());
        begin(&mut empty)?;
        mended(open, empty.position(), cut_to_line)
    });
    let mut file = file.map_err(|source| fault(path, source))?;
    begin(&mut file).map_err(|source| fault(path, source))?;
    Ok(file)
}

fn fault(path: &Path, source: io::Error) -> OutputError {
    OutputError::Write { path: path.to_owned(), source }
}

/// The kind of trajectory that the ending of a name says.
fn format_of(
    path: &Path,
    scene: &str,
    bodies: &[String],
    errors: ErrorColumns,
) -> Result<Box<dyn TrajectoryFormat>, OutputError> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("csv") => Ok(Box::new(Csv::new(bodies, errors).map_err(|source| fault(path, source))?)),
        Some("npy") => Ok(Box::new(Npy::new(bodies.len(), errors))),
        Some("json") => Ok(Box::new(Json::new(scene, bodies, errors))),
        _ => Err(OutputError::Ending { path: path.to_owned() }),
    }
}
