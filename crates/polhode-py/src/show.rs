//! A run as a page, pictures and plots.
//!
//! Pictures are drawn from the samples of the run. What pages and plots tell besides (contacts, their forces, the
//! ledger, steps) no run keeps unless it was asked to: the scene is simulated again for them, once, which gives the
//! same bits.

use crate::drawn::Drawn;
use crate::job::{self, Watch};
use crate::recorder::OF_BODY;
use crate::recording::{Recording, Source};
use crate::telling::{self, Telling, Unread};
use crate::{arguments, errors};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{BodyError, BodySample, Event, Flow, Frame, JointSample, Observer, Simulation, SimulationError};
use polhode_view::ViewError;
use polhode_view::animation::{FPS, Pace, Watcher, write_gif};
use polhode_view::camera::{PRESETS, Standpoint, Viewpoint};
use polhode_view::plot::RunPlot;
use polhode_view::raster::PictureSize;
use polhode_view::still::{still_from, write_png};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// Why something cannot be shown.
enum Fault {
    View(ViewError),
    Simulation(SimulationError),
}

impl From<ViewError> for Fault {
    fn from(error: ViewError) -> Self {
        Self::View(error)
    }
}

impl Fault {
    fn into_exception(self, py: Python<'_>, source: &Source) -> PyErr {
        match self {
            Self::View(error) => errors::view(py, &source.scene, &error),
            Self::Simulation(error) => errors::simulation(py, &source.scene, error),
        }
    }
}

/// A run that is made again for what is told of it.
struct Again {
    source: Source,
    /// The time of its last sample, s, where it was ended before its time.
    cut_s: Option<f64>,
}

impl Again {
    /// That of a recording.
    fn of(recording: &Recording, py: Python<'_>) -> PyResult<Self> {
        let Source { scene, effects, is_cut } = &recording.source;
        let last_s = recording.read(py, |times, _| times.last().copied())?;
        let last_s = last_s.ok_or_else(|| no_samples(py, recording))?;
        let source = Source { scene: Arc::clone(scene), effects: *effects, is_cut: *is_cut };
        Ok(Self { source, cut_s: is_cut.then_some(last_s) })
    }

    /// Makes it again: what a page with frames at least this far apart (s) and all plots tell.
    fn tell(&self, least_s: f64, watch: &Watch) -> Result<(Unread, Drawn), Fault> {
        let scene = &self.source.scene.scene;
        let mut telling = Telling::of(&self.source.scene, least_s)?;
        let mut simulation = Simulation::with_effects(scene, self.source.effects).map_err(Fault::Simulation)?;
        let plan = simulation.plan().clone();
        let duration_s = scene.duration_s();
        let mut again = Watched { telling: &mut telling, watch, duration_s, cut_s: self.cut_s };
        let ended = match simulation.run_observed(&mut again) {
            Ok(report) if self.cut_s.is_none() => Ok(Box::new(report)),
            Ok(report) => Err(telling::interrupted(&report)),
            Err(error) => Err(format!("{}: {error}", scene.name())),
        };
        Ok(telling.end(&plan, &ended)?)
    }
}

/// Keeps what is told, and tells whoever waits.
struct Watched<'a> {
    telling: &'a mut Telling,
    watch: &'a Watch,
    duration_s: f64,
    /// When it is to end before its time, s.
    cut_s: Option<f64>,
}

impl Observer for Watched<'_> {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.telling.sample(t_s, bodies);
    }

    fn event(&mut self, event: &Event) {
        self.telling.event(event);
    }

    fn wants_errors(&self) -> bool {
        self.telling.wants_errors()
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        self.telling.errors(t_s, errors);
    }

    fn wants_frames(&self) -> bool {
        self.telling.wants_frames()
    }

    fn frame(&mut self, frame: &Frame) {
        self.telling.frame(frame);
    }

    fn wants_joints(&self) -> bool {
        self.telling.wants_joints()
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        self.telling.joints(t_s, joints);
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        let flows = [self.telling.progress(t_s), self.watch.reached(t_s, self.duration_s)];
        let is_over = self.cut_s.is_some_and(|cut_s| t_s >= cut_s);
        if is_over || flows.contains(&Flow::Stop) { Flow::Stop } else { Flow::Continue }
    }
}

/// That a run has told nothing.
fn no_samples(py: Python<'_>, recording: &Recording) -> PyErr {
    let name = recording.source.scene.scene.name();
    errors::plain(py, "ViewError", &format!("{name}: the run has no samples: there is nothing to show"))
}

/// A run as a page that plays it, with frames at least this far apart, s.
#[pyfunction]
pub(crate) fn page(
    py: Python<'_>,
    recording: &Recording,
    least_interval: f64,
    told: Option<Py<PyAny>>,
) -> PyResult<String> {
    let source = &recording.source;
    let page = if let Some(page) = recording.take(least_interval) {
        page
    } else {
        let again = Again::of(recording, py)?;
        let made = job::work(py, told, move |watch| again.tell(least_interval, watch))?.whole()?;
        let (page, drawn) = made.map_err(|fault| fault.into_exception(py, source))?;
        recording.keep(drawn);
        page
    };
    page.html().map_err(|error| errors::view(py, &source.scene, &error))
}

/// Plots of a run over time, as SVG; all that every scene has where none are named.
#[pyfunction]
pub(crate) fn plot(
    py: Python<'_>,
    recording: &Recording,
    names: &Bound<'_, PyAny>,
    told: Option<Py<PyAny>>,
) -> PyResult<String> {
    let all = || RunPlot::ALL.into_iter().chain(RunPlot::OF_JOINTS);
    let known: Vec<&str> = all().map(RunPlot::name).collect();
    let named = |name: &String| {
        all().find(|plot| plot.name() == name).ok_or_else(|| errors::unknown_name(py, "plot", name, &known))
    };
    let names: Vec<String> = names.extract()?;
    let asked: Vec<RunPlot> = names.iter().map(named).collect::<PyResult<_>>()?;
    let asked = if asked.is_empty() { RunPlot::ALL.to_vec() } else { asked };
    let scene = &recording.source.scene.scene;
    if let (Some(of_joints), []) = (asked.iter().find(|plot| RunPlot::OF_JOINTS.contains(plot)), scene.joints()) {
        let said = format!("{}: there are no joints: nothing to plot as `{}`", scene.name(), of_joints.name());
        return Err(errors::plain(py, "ViewError", &said));
    }
    if let Some(drawn) = recording.drawn() {
        return Ok(drawn.svg(&asked));
    }
    let again = Again::of(recording, py)?;
    let made = job::work(py, told, move |watch| again.tell(0.0, watch))?.whole()?;
    let (_, drawn) = made.map_err(|fault| fault.into_exception(py, &recording.source))?;
    Ok(recording.keep(drawn).svg(&asked))
}

/// How a picture is asked for.
#[derive(FromPyObject)]
pub(crate) struct Asked<'py> {
    #[pyo3(item)]
    size: Option<Bound<'py, PyAny>>,
    #[pyo3(item)]
    camera: Option<Bound<'py, PyAny>>,
    #[pyo3(item)]
    look_at: Option<Bound<'py, PyAny>>,
}

impl Asked<'_> {
    /// Size and point of view of a picture of a recording.
    fn of(
        py: Python<'_>,
        asked: &Bound<'_, PyAny>,
        recording: &Recording,
        usual: PictureSize,
    ) -> PyResult<(PictureSize, Viewpoint)> {
        let asked: Asked<'_> = asked.extract()?;
        let size = asked.size(usual)?.map_err(|error| errors::view(py, &recording.source.scene, &error))?;
        Ok((size, asked.viewpoint(py)?))
    }

    fn size(&self, usual: PictureSize) -> PyResult<Result<PictureSize, ViewError>> {
        let Some(size) = &self.size else { return Ok(Ok(usual)) };
        let (width, height) = size.extract().map_err(|_| {
            let shown = arguments::shown(size);
            PyTypeError::new_err(format!("size: width and height are needed, whole numbers of pixels, found {shown}"))
        })?;
        Ok(PictureSize::new(width, height))
    }

    fn viewpoint(&self, py: Python<'_>) -> PyResult<Viewpoint> {
        let target = self.look_at.as_ref().map(|place| arguments::vector("look_at", place)).transpose()?;
        let standpoint = match &self.camera {
            None => None,
            Some(camera) => Some(match camera.extract::<String>() {
                Ok(name) => {
                    let found = Standpoint::named(&name);
                    found.ok_or_else(|| errors::unknown_name(py, "camera", &name, &PRESETS.map(|(known, _)| known)))?
                }
                Err(_) => Standpoint::Eye(arguments::vector("camera", camera)?),
            }),
        };
        Ok(Viewpoint { standpoint, target })
    }
}

/// The bodies of a sample.
fn bodies(states: &[f64]) -> Vec<BodySample> {
    let vector = |numbers: &[f64]| DVec3::from_slice(numbers);
    states
        .chunks_exact(OF_BODY)
        .map(|of_body| {
            let wxyz = [of_body[3], of_body[4], of_body[5], of_body[6]];
            // What is no rotation is no number either, and the recording refuses its place.
            let turned = Rotation::from_wxyz(wxyz);
            let place = if turned.is_ok() { vector(&of_body[..3]) } else { DVec3::NAN };
            let pose = Pose::new(turned.unwrap_or(Rotation::IDENTITY), place);
            BodySample { pose, velocity: Velocity::new(vector(&of_body[7..10]), vector(&of_body[10..13])) }
        })
        .collect()
}

/// The run at the sample nearest to a time (s), as a picture in the format PNG.
#[pyfunction]
pub(crate) fn still<'py>(
    py: Python<'py>,
    recording: &Recording,
    t: Option<f64>,
    asked: &Bound<'py, PyAny>,
    told: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let source = &recording.source;
    let refused = |error: ViewError| errors::view(py, &source.scene, &error);
    let (size, viewpoint) = Asked::of(py, asked, recording, PictureSize::STILL)?;
    let shown = recording.read(py, |times, states| {
        let (first, last) = times.first().zip(times.last()).ok_or_else(|| no_samples(py, recording))?;
        let t = t.unwrap_or(*last);
        if !(*first..=*last).contains(&t) {
            let said = format!("{}: t = {t} s: the motion is from {first} s to {last} s", source.scene.scene.name());
            return Err(errors::plain(py, "ViewError", &said));
        }
        let after = times.partition_point(|&time| time < t);
        let nearest = after - usize::from(after > 0 && t - times[after - 1] < times[after] - t);
        let width = states.len() / times.len();
        let sample = |number: usize| bodies(&states[number * width..(number + 1) * width]);
        let mut shown = polhode_view::Recording::for_still(&source.scene.scene)
            .map_err(refused)?
            .shown_as(source.scene.appearance());
        for number in 0..nearest {
            shown.sample(times[number], &sample(number));
        }
        shown.end_at(times[nearest], &sample(nearest)).map_err(refused)?;
        Ok(shown)
    })??;
    let draw = move |_: &Watch| {
        let mut png = Vec::new();
        let last = shown.times().len().saturating_sub(1);
        write_png(&still_from(&shown, last, &viewpoint, size)?, &mut png).map(|()| png)
    };
    Ok(PyBytes::new(py, &job::work(py, told, draw)?.whole()?.map_err(refused)?))
}

/// The run as a moving picture in the format GIF, of so many frames a second.
#[pyfunction]
pub(crate) fn gif<'py>(
    py: Python<'py>,
    recording: &Recording,
    fps: Option<f64>,
    asked: &Bound<'py, PyAny>,
    told: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let source = &recording.source;
    let refused = |error: ViewError| errors::view(py, &source.scene, &error);
    let (size, viewpoint) = Asked::of(py, asked, recording, PictureSize::MOVING)?;
    let fps = fps.unwrap_or(FPS);
    if !(fps.is_finite() && fps > 0.0) {
        let said = format!("fps={fps}: a positive number of frames a second is needed");
        return Err(errors::plain(py, "ViewError", &said));
    }
    let shown = recording.read(py, |times, states| {
        let mut shown =
            polhode_view::Recording::new(&source.scene.scene, 1.0 / fps)?.shown_as(source.scene.appearance());
        for (number, &time) in times.iter().enumerate() {
            let width = states.len() / times.len();
            shown.sample(time, &bodies(&states[number * width..(number + 1) * width]));
        }
        shown.end().map(|()| shown)
    })?;
    let shown = shown.map_err(refused)?;
    let draw = move |watch: &Watch| {
        let all = shown.times().len() as f64;
        let told = |drawn: usize| watch.reached(drawn as f64, all);
        let mut gif = Vec::new();
        write_gif(&Pace::new(&shown, size)?.seen_from(&viewpoint)?.watched_by(Watcher(&told)), &mut gif).map(|()| gif)
    };
    Ok(PyBytes::new(py, &job::work(py, told, draw)?.whole()?.map_err(refused)?))
}
