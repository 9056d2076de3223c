//! The runs of a study: errors once for every candidate, times in rounds, instructions when they are asked for.

use super::candidate::Candidate;
use super::error::{Errors, energy_error};
use super::instructions;
use super::options::{Counting, Options};
use super::reference::{self, Reference};
use super::source::{Completed, Source};
use super::timing::{self, Effort, Timing};
use crate::progress::Progress;
use polhode::scene::Integrator;
use polhode::{Decision, Effect, EffectDecision, Plan, Scene};
use polhode_scene::Override;
use std::time::Duration;

/// Parts of a series' share of the time that one of its candidates may take: the next coarser ones have had the rest.
const SHARE_OF_ONE: f64 = 0.75;

/// Part of the whole time that the rounds of timing may take beyond the fewest.
const SHARE_OF_ROUNDS: f64 = 0.5;

/// How a run moves its bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solver {
    /// The integrator.
    pub(super) integrator: Integrator,
    /// Whether bodies fly in closed form where they can, or a closed form is a part of the method.
    pub(super) closed_form: bool,
}

impl Solver {
    /// From the plan that was followed.
    pub(super) fn of(plan: &Plan) -> Self {
        let flies = |found: &EffectDecision| (found.effect, found.decision) == (Effect::BallisticFlight, Decision::On);
        let is_closed = plan.integrator.is_exact_without_loads();
        Self { integrator: plan.integrator, closed_form: is_closed || plan.effects.iter().any(flies) }
    }

    /// Whether two share what an error of either could come from.
    pub(super) fn is_alike(self, other: Self) -> bool {
        self.integrator == other.integrator || (self.closed_form && other.closed_form)
    }
}

/// A candidate whose error is known, or why it is not.
pub(super) struct Compared {
    /// The candidate.
    pub(super) candidate: Candidate,
    /// Number of its reference.
    pub(super) reference: usize,
    /// The difference, or why there is none.
    pub(super) outcome: Result<Difference, String>,
}

/// How a run differs from its reference.
#[derive(Debug, Clone, Copy)]
pub(super) struct Difference {
    /// From the reference.
    pub(super) errors: Errors,
    /// `D_numerical`, relative.
    pub(super) energy_error: f64,
    /// Steps.
    pub(super) steps: u64,
    /// How it moved its bodies.
    pub(super) solver: Solver,
}

/// The runs of a study.
pub(super) struct Runs<'a> {
    source: &'a Source<'a>,
    options: &'a Options,
    progress: &'a Progress,
    spent: Spent,
}

impl<'a> Runs<'a> {
    /// Nothing run yet.
    pub(super) fn new(
        source: &'a Source<'a>,
        options: &'a Options,
        progress: &'a Progress,
        candidates: &[Candidate],
    ) -> Self {
        Self { source, options, progress, spent: Spent::new(candidates, options.budget_s) }
    }

    /// Runs every candidate once and compares it with its reference.
    pub(super) fn errors(&mut self, references: &[Reference], candidates: Vec<Candidate>) -> Vec<Compared> {
        self.progress.phase("errors", candidates.len());
        let mut compared = Vec::with_capacity(candidates.len());
        for candidate in candidates {
            let model = candidate.model();
            let reference = references.iter().position(|reference| reference.model == model).unwrap_or(0);
            let outcome = match references.get(reference) {
                Some(found) => self.error(found, &candidate),
                None => Err("there is no reference".to_owned()),
            };
            compared.push(Compared { candidate, reference, outcome });
            self.progress.part_done();
        }
        compared
    }

    fn error(&mut self, reference: &Reference, candidate: &Candidate) -> Result<Difference, String> {
        let rounds = self.options.effort.fewest_rounds + 1;
        self.spent.admit(candidate, rounds)?;
        let scene = self.scene(candidate, self.options.samples)?;
        let outcome = self.source.record(&scene, self.spent.limit(candidate));
        self.spent.note(candidate, outcome.as_ref().ok());
        let run = outcome?;
        let errors = reference.scales.errors(&reference.run.record, &run.record)?;
        if errors.headline().is_nan() {
            return Err("its motion is not a number".to_owned());
        }
        let (steps, solver) = (run.report.steps, Solver::of(&run.report.plan));
        Ok(Difference { errors, energy_error: energy_error(&run.report), steps, solver })
    }

    fn scene(&self, candidate: &Candidate, samples: u32) -> Result<Scene, String> {
        let scene = self.source.scene(&candidate.changes)?;
        let mut changes = candidate.changes.clone();
        changes.push(reference::sampling(&scene, samples));
        self.source.scene(&changes)
    }

    /// Times the candidates that ran; one that now fails loses its errors.
    pub(super) fn timings(&self, compared: &mut [Compared], base: Option<usize>) -> Vec<Option<Timing>> {
        let mut timings = vec![None; compared.len()];
        let (mut numbers, mut scenes) = (Vec::new(), Vec::new());
        for (number, entry) in compared.iter_mut().enumerate().filter(|(_, entry)| entry.outcome.is_ok()) {
            match self.scene(&entry.candidate, 1) {
                Ok(scene) => {
                    numbers.push(number);
                    scenes.push(scene);
                }
                Err(reason) => entry.outcome = Err(reason),
            }
        }
        let base = numbers.iter().position(|&number| Some(number) == base).unwrap_or(0);
        let enough_s = SHARE_OF_ROUNDS * self.options.budget_s / scenes.len().max(1) as f64;
        let effort = Effort { enough_s: self.options.effort.enough_s.min(enough_s), ..self.options.effort };
        self.progress.phase("timing", scenes.len() * effort.most_rounds);
        let timed = timing::interleaved(self.source, &scenes, base, effort, || self.progress.part_done());
        for (number, timing) in numbers.into_iter().zip(timed) {
            match timing {
                Ok(timing) => timings[number] = Some(timing),
                Err(reason) => compared[number].outcome = Err(reason),
            }
        }
        timings
    }

    /// Counts instructions of the candidates that ran, when they are asked for.
    pub(super) fn instructions(&self, compared: &[Compared]) -> Vec<Option<Result<u64, String>>> {
        if self.options.counting == Counting::Time {
            return vec![None; compared.len()];
        }
        self.progress.phase("instructions", compared.len());
        let count = |entry: &Compared| {
            self.progress.part_done();
            entry.outcome.is_ok().then(|| {
                let sampling: Override = reference::sampling(&self.source.scene(&entry.candidate.changes)?, 1);
                instructions::count(self.source, &entry.candidate, &sampling)
            })
        };
        compared.iter().map(count).collect()
    }
}

/// What the series have taken, so that a ladder ends before it takes too long.
#[derive(Debug)]
struct Spent {
    share_s: f64,
    last: Option<(String, f64)>,
}

impl Spent {
    fn new(candidates: &[Candidate], budget_s: f64) -> Self {
        let mut series: Vec<_> = candidates.iter().map(|candidate| &candidate.series).collect();
        series.dedup();
        Self { share_s: budget_s / series.len().max(1) as f64, last: None }
    }

    /// Whether a candidate may run `rounds` times.
    ///
    /// # Errors
    /// About how long it would take, when that is too long.
    fn admit(&mut self, candidate: &Candidate, rounds: usize) -> Result<(), String> {
        let (Some(growth), Some((series, took_s))) = (candidate.growth, &mut self.last) else { return Ok(()) };
        let expected_s = *took_s * growth;
        if *series != candidate.series || expected_s * rounds as f64 <= SHARE_OF_ONE * self.share_s {
            return Ok(());
        }
        // What comes after it takes longer still.
        *took_s = expected_s;
        Err(format!("left out: about {expected_s:.1} s a run; a larger --budget, or --vary, includes it"))
    }

    /// How long a candidate may run: the first of a series, and one that is asked for, to its end.
    fn limit(&self, candidate: &Candidate) -> Option<Duration> {
        candidate.growth.and_then(|_| Duration::try_from_secs_f64(self.share_s).ok())
    }

    fn note(&mut self, candidate: &Candidate, run: Option<&Completed>) {
        // A run that failed says nothing about how long the next one takes.
        if let Some(run) = run {
            self.last = Some((candidate.series.clone(), run.took.as_secs_f64()));
        }
    }
}

#[cfg(test)]
mod tests {
    //! What confirms what, and when a ladder ends.
    use super::*;

    fn candidate(series: &str, growth: Option<f64>) -> Candidate {
        Candidate { series: series.to_owned(), rung: String::new(), changes: Vec::new(), growth }
    }

    #[test]
    fn what_shares_a_closed_form_confirms_nothing() {
        let solver = |integrator, closed_form| Solver { integrator, closed_form };
        let exact = solver(Integrator::Exact, true);
        assert!(exact.is_alike(solver(Integrator::ExactStrang, true)));
        assert!(exact.is_alike(solver(Integrator::Dop853, true)), "where it flies in closed form");
        assert!(!exact.is_alike(solver(Integrator::Cf4, false)));
        assert!(solver(Integrator::Cf4, false).is_alike(solver(Integrator::Cf4, false)));
    }

    #[test]
    fn a_ladder_ends_before_it_takes_too_long() {
        let ladder = [candidate("a", None), candidate("a", Some(4.0)), candidate("a", Some(4.0)), candidate("b", None)];
        let mut spent = Spent::new(&ladder, 20.0);
        assert_eq!(spent.share_s, 10.0);
        spent.last = Some(("a".to_owned(), 0.4));
        assert!(spent.admit(&ladder[1], 4).is_ok());
        spent.last = Some(("a".to_owned(), 1.6));
        assert!(spent.admit(&ladder[2], 4).is_err());
        assert!(spent.admit(&ladder[3], 4).is_ok(), "another series has its own share");
        assert!(spent.admit(&candidate("a", None), 4).is_ok(), "what is asked for runs");
    }
}
