//! `polhode compare`: two trajectories, number by number, and their differences over time as plots.

use crate::abandoned;
use crate::args::{CompareArgs, ComparePlotArg};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::plots::{cannot_write, is_plot};
use crate::progress::Progress;
use crate::scene::load_changed;
use crate::{inputs, stdout, text};
use polhode_scene::{AtomicFile, Comparison, Tolerance, compare_rows};
use polhode_view::plot::{ComparePlot, ComparePlots};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Compares and prints the largest difference of every column; exit code 1 when they differ beyond the tolerance.
pub(crate) fn compare(args: &CompareArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let tolerance = Tolerance { absolute: args.atol, relative: args.rtol };
    let progress = Progress::new("comparing the trajectories");
    let temporary = |plots: &Plots| plots.file.temporary().map(Path::to_owned);
    let mut plots = interrupt.remove(|| Plots::create(args), |plots| plots.iter().filter_map(temporary).collect())?;
    let comparison = compare_rows(&args.a, &args.b, tolerance, |row| {
        if let (Some(plots), Some([a, b])) = (&mut plots, &row.samples) {
            plots.drawn.push(row.t_s, row.body, [a, b], row.errors);
        }
    })?;
    if let Some(plots) = plots {
        plots.finish(args, &comparison)?;
    }
    drop(progress);
    stdout::text(&text::comparison(&comparison))?;
    // What differs has been printed.
    if comparison.agrees() { Ok(()) } else { Err(Failure::Check(String::new())) }
}

/// The file of the plots, and what is drawn in it.
struct Plots {
    file: AtomicFile,
    drawn: ComparePlots,
}

impl Plots {
    /// Opens the file, when one is named.
    fn create(args: &CompareArgs) -> Result<Option<Self>, Failure> {
        let Some(path) = &args.output else { return Ok(None) };
        if !is_plot(path) {
            let what = format!("error: {}: unknown ending; accepted: .svg", path.display());
            return Err(Failure::Usage(what));
        }
        inputs::check_output(path, [&args.a, &args.b].into_iter().chain(&args.scene).map(PathBuf::as_path))?;
        let scene = args.scene.as_deref().map(|scene| load_changed(scene, &[])).transpose()?;
        let asked: Vec<ComparePlot> = match &args.plot {
            Some(asked) if !asked.is_empty() => asked.iter().copied().map(plot).collect(),
            _ => ComparePlot::ALL.into_iter().filter(|plot| *plot != ComparePlot::Energy || scene.is_some()).collect(),
        };
        if asked.contains(&ComparePlot::Energy) && scene.is_none() {
            let what = "error: --plot energy: a trajectory has no masses: name its scene with --scene SCENE".to_owned();
            return Err(Failure::Usage(what));
        }
        let drawn = ComparePlots::new(&asked, scene.as_ref().map(|loaded| &loaded.scene));
        let file = AtomicFile::create(path).map_err(|error| cannot_write(path, &error))?;
        abandoned::note(file.left_behind());
        Ok(Some(Self { file, drawn }))
    }

    fn finish(mut self, args: &CompareArgs, comparison: &Comparison) -> Result<(), Failure> {
        let name = |path: &Path| path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let ended = comparison.mismatch.as_ref().map(|mismatch| {
            format!("ended at line {}: the trajectories are not about the same samples", mismatch.line)
        });
        let svg = self.drawn.svg([&name(&args.a), &name(&args.b)], ended.as_deref());
        let written = self.file.write_all(svg.as_bytes()).and_then(|()| self.file.commit());
        written.map_err(|error| cannot_write(self.file.target(), &error))
    }
}

const fn plot(asked: ComparePlotArg) -> ComparePlot {
    match asked {
        ComparePlotArg::Positions => ComparePlot::Positions,
        ComparePlotArg::Attitudes => ComparePlot::Attitudes,
        ComparePlotArg::Velocities => ComparePlot::Velocities,
        ComparePlotArg::Energy => ComparePlot::Energy,
    }
}
