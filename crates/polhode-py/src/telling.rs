//! What pages and plots tell of a run, kept while it goes on.

use crate::drawn::Drawn;
use polhode::{BodyError, BodySample, Event, Flow, Frame, JointSample, Observer, Plan, RunReport};
use polhode_scene::{LoadedScene, page_report_json, shown_failure, shown_outcome};
use polhode_view::page::MOST_FRAMES;
use polhode_view::plot::{RunPlot, RunPlots};
use polhode_view::{FrameSource, Page, PageRun, ViewError};
use serde_json::Value;

/// What a run has told: its report, or why it ended before its time.
pub(crate) type Ended = Result<Box<RunReport>, String>;

/// That a run was ended before its time.
pub(crate) fn interrupted(report: &RunReport) -> String {
    format!("interrupted at t = {} s of {} s", report.simulated_s, report.duration_s)
}

/// The time between frames of a page (s) for which frames at least so far apart were asked.
fn interval(loaded: &LoadedScene, least_s: f64) -> f64 {
    let scene = &loaded.scene;
    least_s.max(scene.duration_s() / MOST_FRAMES).max(scene.output_interval_s())
}

/// Keeps what a page and all plots tell of a run.
#[derive(Debug)]
pub(crate) struct Telling {
    page: PageRun<Vec<u8>>,
    plots: RunPlots,
    interval_s: f64,
}

impl Telling {
    /// Of a scene, with frames of the page at least this far apart, s.
    ///
    /// # Errors
    /// When the scene has no bodies.
    pub(crate) fn of(loaded: &LoadedScene, least_s: f64) -> Result<Self, ViewError> {
        let scene = &loaded.scene;
        let page = Page::begin(Vec::new(), &loaded.title(), &loaded.description().unwrap_or_default())?;
        let page = page.begin_run(scene, scene.name(), FrameSource::Simulation)?;
        let page = page.shown_as(loaded.appearance()).with_least_interval(least_s);
        let of_joints = if scene.joints().is_empty() { &[][..] } else { &RunPlot::OF_JOINTS };
        let plots = RunPlots::new(scene, 0.0, &[&RunPlot::ALL, of_joints].concat());
        let plots = plots.with_joint_names(loaded.joint_names());
        Ok(Self { page, plots, interval_s: interval(loaded, least_s) })
    }

    /// Ends it.
    ///
    /// # Errors
    /// When a frame was not one of the scene, or there was none.
    pub(crate) fn end(self, plan: &Plan, ended: &Ended) -> Result<(Unread, Drawn), ViewError> {
        let (outcome, report) = match ended {
            Ok(report) => (shown_outcome(report), page_report_json(report)),
            Err(why) => (shown_failure(why), Value::Null),
        };
        let drawn = Drawn::new(self.plots, plan, ended.as_deref().map_err(String::as_str));
        let page = self.page.end(&outcome)?;
        Ok((Unread { page, report, interval_s: self.interval_s }, drawn))
    }
}

/// A page that nobody has asked for yet: without the viewer.
#[derive(Debug)]
pub(crate) struct Unread {
    page: Page<Vec<u8>>,
    report: Value,
    interval_s: f64,
}

impl Unread {
    /// Whether it is the page with frames at least this far apart, s.
    pub(crate) fn is_of(&self, loaded: &LoadedScene, least_s: f64) -> bool {
        self.interval_s == interval(loaded, least_s)
    }

    /// The page.
    ///
    /// # Errors
    /// None: it is written to memory.
    pub(crate) fn html(self) -> Result<String, ViewError> {
        String::from_utf8(self.page.finish(&self.report)?).map_err(|error| ViewError::Encoding(error.to_string()))
    }
}

impl Observer for Telling {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.page.sample(t_s, bodies);
    }

    fn event(&mut self, event: &Event) {
        self.page.event(event);
        self.plots.event(event);
    }

    fn wants_errors(&self) -> bool {
        true
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        self.page.errors(t_s, errors);
    }

    fn wants_frames(&self) -> bool {
        true
    }

    fn frame(&mut self, frame: &Frame) {
        self.page.frame(frame);
        self.plots.frame(frame);
    }

    fn wants_joints(&self) -> bool {
        self.plots.wants_joints()
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        self.plots.joints(t_s, joints);
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        // What cannot be shown stops no run: it is told when it is to be shown.
        self.plots.progress(t_s)
    }
}
