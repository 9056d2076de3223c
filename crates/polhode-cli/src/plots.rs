//! Plots of a run over time: the SVG files of `polhode run` and `polhode resume`.

use crate::abandoned;
use crate::failure::Failure;
use crate::quantity_plots::{QuantityPlots, Wanted};
use polhode::{
    BodySample, ContactSample, Energy, Event, Flow, Frame, JointSample, Observer, Plan, RunReport, Simulation,
};
use polhode_scene::{AtomicFile, LoadedScene, ended_line, methods_line};
use polhode_view::plot::{RunPlot, RunPlots};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The files, and what is drawn in them; nothing where none are asked for.
pub(crate) struct Plots {
    files: Vec<AtomicFile>,
    asked: Vec<RunPlot>,
    quantities: QuantityPlots,
    drawn: Option<RunPlots>,
}

/// Whether a file holds plots, by its ending.
pub(crate) fn is_plot(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

impl Plots {
    /// Opens the files. What is asked for are the words of `--plot` and `--against`.
    ///
    /// # Errors
    /// When a word is no plot and no quantity of the scene, plots are asked for and no file is, or a file cannot be
    /// opened.
    pub(crate) fn create(
        paths: &[PathBuf],
        (asked, against): (&[String], Option<&str>),
        loaded: &LoadedScene,
    ) -> Result<Self, Failure> {
        let Wanted { panels, quantities } = Wanted::of(asked, against, loaded)?;
        if let (Some(_), []) = (asked.first(), paths) {
            let what = "error: --plot: no file is named for the plots: add -o FILE.svg".to_owned();
            return Err(Failure::Usage(what));
        }
        let open = |path: &PathBuf| AtomicFile::create(path).map_err(|error| cannot_write(path, &error));
        let files: Vec<AtomicFile> = paths.iter().map(open).collect::<Result<_, _>>()?;
        for file in &files {
            abandoned::note(file.left_behind());
        }
        let asked = if asked.is_empty() { RunPlot::ALL.to_vec() } else { panels };
        Ok(Self { files, asked, quantities, drawn: None })
    }

    /// The temporary names of the files.
    pub(crate) fn temporary(&self) -> Vec<PathBuf> {
        self.files.iter().filter_map(|file| file.temporary().map(Path::to_owned)).collect()
    }

    /// Begins at the present time of a simulation.
    pub(crate) fn begin(&mut self, loaded: &LoadedScene, simulation: &Simulation) {
        if !self.files.is_empty() {
            let drawn = RunPlots::new(&loaded.scene, simulation.time(), &self.asked);
            self.drawn = Some(drawn.with_joint_names(loaded.joint_names()));
        }
    }

    /// Draws the plots of a run that has ended, and moves the files to their names.
    ///
    /// # Errors
    /// When something cannot be written.
    pub(crate) fn finish(self, report: &RunReport) -> Result<(), Failure> {
        self.write(&ended_line(report), None)
    }

    /// Draws the plots of a run that ended before its time, up to there, with the reason.
    ///
    /// # Errors
    /// When something cannot be written.
    pub(crate) fn finish_stopped(self, plan: &Plan, reason: &str) -> Result<(), Failure> {
        self.write(&methods_line(plan), Some(reason.trim_start_matches("error: ")))
    }

    fn write(mut self, subtitle: &str, stopped: Option<&str>) -> Result<(), Failure> {
        let Some(drawn) = self.drawn else { return Ok(()) };
        let is_against = self.quantities.is_against();
        let curves = self.quantities.finished();
        let svg = if is_against {
            let why = stopped.map_or_else(String::new, |reason| format!("; ended early: {reason}"));
            curves.svg(&format!("{subtitle}{why}"))
        } else {
            drawn.svg_with(curves.panels(), subtitle, stopped)
        };
        for mut file in self.files {
            let written = file.write_all(svg.as_bytes()).and_then(|()| file.commit());
            written.map_err(|error| cannot_write(file.target(), &error))?;
        }
        Ok(())
    }
}

/// That a file of plots cannot be written.
pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::InputOutput(format!("error: cannot write {}: {error}", path.display()))
}

impl Plots {
    /// Those who are told of the run: none where nothing is drawn.
    fn told(&mut self) -> impl Iterator<Item = &mut dyn Observer> {
        let quantities = (!self.files.is_empty() && !self.quantities.is_empty()).then_some(&mut self.quantities);
        let drawn = self.drawn.as_mut().map(|own| own as &mut dyn Observer);
        drawn.into_iter().chain(quantities.map(|own| own as &mut dyn Observer))
    }

    fn wants(&self, wants: impl Fn(&dyn Observer) -> bool) -> bool {
        self.drawn.as_ref().is_some_and(|own| wants(own)) || (!self.files.is_empty() && wants(&self.quantities))
    }
}

impl Observer for Plots {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.told().for_each(|own| own.sample(t_s, bodies));
    }

    fn event(&mut self, event: &Event) {
        self.told().for_each(|own| own.event(event));
    }

    fn wants_frames(&self) -> bool {
        self.wants(|own| own.wants_frames())
    }

    fn frame(&mut self, frame: &Frame) {
        self.told().for_each(|own| own.frame(frame));
    }

    fn wants_joints(&self) -> bool {
        self.wants(|own| own.wants_joints())
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        self.told().for_each(|own| own.joints(t_s, joints));
    }

    fn wants_contacts(&self) -> bool {
        self.wants(|own| own.wants_contacts())
    }

    fn contacts(&mut self, t_s: f64, contacts: &[ContactSample]) {
        self.told().for_each(|own| own.contacts(t_s, contacts));
    }

    fn wants_energies(&self) -> bool {
        self.wants(|own| own.wants_energies())
    }

    fn energy(&mut self, t_s: f64, energy: &Energy) {
        self.told().for_each(|own| own.energy(t_s, energy));
    }

    fn progress(&mut self, t: f64) -> Flow {
        self.drawn.as_mut().map_or(Flow::Continue, |drawn| drawn.progress(t))
    }
}
