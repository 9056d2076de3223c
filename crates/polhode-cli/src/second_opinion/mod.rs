//! `polhode run --second-opinion`: a run repeated by another method, and how far the two are
//! apart, body by body.
//!
//! A method that is consistently wrong agrees with itself at any step; another one does not. The whole run is repeated,
//! however long that takes, and compared at its samples. What the second one computes is held against the first one,
//! whichever of them is right: they differ by the error of both.
//!
//! | module | holds |
//! |---|---|
//! | `proposal` | by which method, and in which setting of the scene |
//! | `apart` | how far the bodies of two runs are apart |
//! | `told` | what is told of it, as text and JSON |

mod apart;
mod proposal;
mod told;

use crate::interrupt::Interrupt;
use crate::progress::Progress;
use apart::BodyApart;
use polhode::{BodySample, Effects, Flow, Observer, Outcome, Recorder, RunReport, Scene, Simulation};
use proposal::Proposal;

/// A second opinion that is asked for: what it will be compared with.
#[derive(Debug)]
pub(crate) struct Asked {
    effects: Effects,
    recorder: Recorder,
}

/// A second opinion.
#[derive(Debug)]
pub(crate) struct Opinion {
    /// By what it was found; none when nothing could be asked.
    method: Option<String>,
    /// What was to be asked and could not, and what the second run says of itself.
    notes: Vec<String>,
    /// Why it does not reach the end of the run.
    ended: Option<String>,
    /// Up to which time both were compared, s.
    compared_s: Option<f64>,
    /// The bodies that forces move, the farthest first.
    bodies: Vec<BodyApart>,
    /// How far they may be apart, of their size.
    limit: f64,
}

impl Asked {
    pub(crate) fn new(effects: Effects) -> Self {
        Self { effects, recorder: Recorder::default() }
    }

    /// Who keeps the samples of the run.
    pub(crate) fn observer(&mut self) -> &mut dyn Observer {
        &mut self.recorder
    }

    /// Repeats the run that has given this report, and compares.
    pub(crate) fn answer(self, scene: &Scene, report: &RunReport, interrupt: &Interrupt) -> Opinion {
        let limit = report.plan.promise.error;
        let mut notes = Vec::new();
        for proposal in proposal::all(scene, report) {
            let prepared = proposal.map_err(|error| error.to_string()).and_then(|proposal| {
                let simulation = Simulation::with_effects(&proposal.scene, self.effects);
                let refused = |error| format!("{}: {error}", proposal.told);
                simulation.map_err(refused).map(|simulation| (simulation, proposal))
            });
            match prepared {
                Ok((simulation, proposal)) => return self.ask(scene, simulation, &proposal, (notes, limit), interrupt),
                // Several settings may be refused for one reason.
                Err(reason) if notes.contains(&reason) => {}
                Err(reason) => notes.push(reason),
            }
        }
        Opinion { method: None, notes, ended: None, compared_s: None, bodies: Vec::new(), limit }
    }

    fn ask(
        &self,
        scene: &Scene,
        mut simulation: Simulation,
        proposal: &Proposal,
        (mut notes, limit): (Vec<String>, f64),
        interrupt: &Interrupt,
    ) -> Opinion {
        let mut bar = Progress::new("asking for a second opinion");
        bar.run(0.0, scene.duration_s());
        let mut listener = Listener { recorder: Recorder::default(), bar: &bar, interrupt };
        let answered = simulation.run_observed(&mut listener);
        let mut other = listener.recorder;
        bar.clear();
        for samples in &mut other.samples {
            *samples = proposal.copy.undone(samples);
        }
        let ended = match answered {
            Err(error) => Some(error.to_string()),
            Ok(_) if interrupt.has_come() => Some("it was interrupted".to_owned()),
            Ok(second) => {
                if second.outcome == Outcome::Degraded {
                    let first = second.warnings.first().map_or("", String::as_str);
                    notes.push(format!("the second run has not kept what its own method promises: {first}"));
                }
                None
            }
        };
        let (compared_s, bodies) = apart::compare(scene, &self.recorder, &other);
        Opinion { method: Some(proposal.told.clone()), notes, ended, compared_s, bodies, limit }
    }
}

impl Opinion {
    /// Whether all that was compared agrees within the limit.
    fn agrees(&self) -> bool {
        self.bodies.iter().all(|body| body.of_size <= self.limit)
    }
}

/// Keeps the samples of the second run, shows how far it is, and stops it at Ctrl-C.
struct Listener<'a> {
    recorder: Recorder,
    bar: &'a Progress,
    interrupt: &'a Interrupt,
}

impl Observer for Listener<'_> {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.recorder.sample(t_s, bodies);
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        self.bar.advance(t_s);
        if self.interrupt.has_come() { Flow::Stop } else { Flow::Continue }
    }
}
