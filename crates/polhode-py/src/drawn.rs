//! All plots of a run, kept from when the scene was first simulated again.

use polhode::{Plan, RunReport};
use polhode_scene::{ended_line, methods_line};
use polhode_view::plot::{RunPlot, RunPlots};

/// All plots of a run.
#[derive(Debug)]
pub(crate) struct Drawn {
    plots: RunPlots,
    /// What stands below the title.
    line: String,
    /// Why the run ended before its time.
    why: Option<String>,
}

impl Drawn {
    /// Of a run that has ended with a report, or before its time.
    pub(crate) fn new(plots: RunPlots, plan: &Plan, ended: Result<&RunReport, &str>) -> Self {
        let (line, why) = match ended {
            Ok(report) => (ended_line(report), None),
            Err(why) => (methods_line(plan), Some(why.to_owned())),
        };
        Self { plots, line, why }
    }

    /// Those that are asked for, as SVG.
    pub(crate) fn svg(&self, asked: &[RunPlot]) -> String {
        self.plots.only(asked).svg(&self.line, self.why.as_deref())
    }
}
