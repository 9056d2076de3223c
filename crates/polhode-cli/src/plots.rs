//! Plots of a run over time: the SVG files of `polhode run` and `polhode resume`.

use crate::abandoned;
use crate::args::RunPlotArg;
use crate::failure::Failure;
use polhode::{BodySample, Event, Flow, Frame, JointSample, Observer, Plan, RunReport, Simulation};
use polhode_scene::{AtomicFile, LoadedScene, ended_line, methods_line};
use polhode_view::plot::{RunPlot, RunPlots};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The files, and what is drawn in them; nothing where none are asked for.
pub(crate) struct Plots {
    files: Vec<AtomicFile>,
    asked: Vec<RunPlot>,
    drawn: Option<RunPlots>,
}

/// Whether a file holds plots, by its ending.
pub(crate) fn is_plot(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

impl Plots {
    /// Opens the files.
    ///
    /// # Errors
    /// When plots are asked for and no file is, or a file cannot be opened.
    pub(crate) fn create(paths: &[PathBuf], asked: &[RunPlotArg]) -> Result<Self, Failure> {
        if let (Some(_), []) = (asked.first(), paths) {
            let what = "error: --plot: no file is named for the plots: add -o FILE.svg".to_owned();
            return Err(Failure::Usage(what));
        }
        let open = |path: &PathBuf| AtomicFile::create(path).map_err(|error| cannot_write(path, &error));
        let files: Vec<AtomicFile> = paths.iter().map(open).collect::<Result<_, _>>()?;
        for file in &files {
            abandoned::note(file.left_behind());
        }
        let asked = if asked.is_empty() { RunPlot::ALL.to_vec() } else { asked.iter().copied().map(plot).collect() };
        Ok(Self { files, asked, drawn: None })
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

    fn write(self, subtitle: &str, stopped: Option<&str>) -> Result<(), Failure> {
        let Some(drawn) = self.drawn else { return Ok(()) };
        let svg = drawn.svg(subtitle, stopped);
        for mut file in self.files {
            let written = file.write_all(svg.as_bytes()).and_then(|()| file.commit());
            written.map_err(|error| cannot_write(file.target(), &error))?;
        }
        Ok(())
    }
}

const fn plot(asked: RunPlotArg) -> RunPlot {
    match asked {
        RunPlotArg::Energy => RunPlot::Energy,
        RunPlotArg::Ledger => RunPlot::Ledger,
        RunPlotArg::Penetration => RunPlot::Penetration,
        RunPlotArg::Contacts => RunPlot::Contacts,
        RunPlotArg::Steps => RunPlot::Steps,
        RunPlotArg::JointCoordinates => RunPlot::JointCoordinates,
        RunPlotArg::JointRates => RunPlot::JointRates,
        RunPlotArg::JointForces => RunPlot::JointForces,
        RunPlotArg::JointMoments => RunPlot::JointMoments,
        RunPlotArg::JointPowers => RunPlot::JointPowers,
    }
}

/// That a file of plots cannot be written.
pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::InputOutput(format!("error: cannot write {}: {error}", path.display()))
}

impl Observer for Plots {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn event(&mut self, event: &Event) {
        if let Some(drawn) = &mut self.drawn {
            drawn.event(event);
        }
    }

    fn wants_frames(&self) -> bool {
        self.drawn.as_ref().is_some_and(Observer::wants_frames)
    }

    fn frame(&mut self, frame: &Frame) {
        if let Some(drawn) = &mut self.drawn {
            drawn.frame(frame);
        }
    }

    fn wants_joints(&self) -> bool {
        self.drawn.as_ref().is_some_and(Observer::wants_joints)
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        if let Some(drawn) = &mut self.drawn {
            drawn.joints(t_s, joints);
        }
    }

    fn progress(&mut self, t: f64) -> Flow {
        self.drawn.as_mut().map_or(Flow::Continue, |drawn| drawn.progress(t))
    }
}

#[cfg(test)]
mod tests {
    //! The names of plots are those of the library.
    use super::*;
    use clap::ValueEnum;

    #[test]
    fn plots_have_the_names_of_the_library() {
        let all: Vec<RunPlot> = RunPlotArg::value_variants().iter().copied().map(plot).collect();
        assert_eq!(all, [RunPlot::ALL, RunPlot::OF_JOINTS].concat());
        for own in RunPlotArg::value_variants() {
            let name = own.to_possible_value().map(|value| value.get_name().to_owned());
            assert_eq!(name.as_deref(), Some(plot(*own).name()));
        }
    }
}
