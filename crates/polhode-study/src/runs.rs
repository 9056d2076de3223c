//! The runs of a study: errors once for every candidate, times in rounds, instructions when they are asked for.

use crate::candidate::Candidate;
use crate::difference::{Errors, energy_error};
use crate::ladder;
use crate::law::{Law, OtherLaw};
use crate::options::{Counting, Options};
use crate::reference::{self, Reference};
use crate::source::{Completed, Source};
use crate::timing::{self, Effort, Timing};
use polhode::scene::Integrator;
use polhode::{Decision, Effect, EffectDecision, ErrorEstimation, Plan, Scene};
use polhode_scene::Override;
use std::time::Duration;

/// Parts of a series' share of the time that one of its candidates may take: the next coarser ones have had the rest.
const SHARE_OF_ONE: f64 = 0.75;

/// Part of the whole time that the rounds of timing may take beyond the fewest.
const SHARE_OF_ROUNDS: f64 = 0.5;

/// How a run moves its bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// The integrator.
    pub integrator: Integrator,
    /// Whether bodies fly in closed form where they can, or a closed form is a part of the method.
    pub closed_form: bool,
}

impl Solver {
    /// From the plan that was followed.
    pub fn of(plan: &Plan) -> Self {
        let flies = |found: &EffectDecision| (found.effect, found.decision) == (Effect::BallisticFlight, Decision::On);
        let is_closed = plan.integrator.is_exact_without_loads();
        Self { integrator: plan.integrator, closed_form: is_closed || plan.effects.iter().any(flies) }
    }

    /// Whether two share what an error of either could come from.
    pub fn is_alike(self, other: Self) -> bool {
        self.integrator == other.integrator || (self.closed_form && other.closed_form)
    }
}

/// A candidate whose error is known, or why it is not.
pub(crate) struct Compared {
    /// The candidate.
    pub(crate) candidate: Candidate,
    /// Number of its reference.
    pub(crate) reference: usize,
    /// The difference, or why there is none.
    pub(crate) outcome: Result<Difference, String>,
}

/// How a run differs from its reference.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Difference {
    /// From the reference.
    pub(crate) errors: Errors,
    /// `D_numerical`, relative.
    pub(crate) energy_error: f64,
    /// Steps.
    pub(crate) steps: u64,
    /// How it moved its bodies.
    pub(crate) solver: Solver,
    /// Its law of contact, where that is not the scene's.
    pub(crate) law: Option<OtherLaw>,
    /// The error that the run tells of itself, where that was asked for and took not too long.
    pub(crate) estimated: Option<f64>,
}

/// A run of a law of which only methods of its own know the limit.
struct OfOwnLaw {
    number: usize,
    law: Law,
    run: Completed,
}

/// The runs of a study.
pub(crate) struct Runs<'a> {
    source: &'a Source<'a>,
    options: &'a Options,
    spent: Spent,
    /// Number of the references that were asked for; those after them are of laws that methods turned out to have.
    asked: usize,
}

impl<'a> Runs<'a> {
    /// Nothing run yet.
    pub(crate) fn new(source: &'a Source<'a>, options: &'a Options, candidates: &[Candidate], asked: usize) -> Self {
        Self { source, options, spent: Spent::new(candidates, options.budget_s), asked }
    }

    /// Runs every candidate once and compares it with the reference of its law, which is added where there is none yet.
    pub(crate) fn errors(&mut self, references: &mut Vec<Reference>, candidates: Vec<Candidate>) -> Vec<Compared> {
        self.source.host.phase("errors", candidates.len());
        let mut compared = Vec::with_capacity(candidates.len());
        let mut of_own_law = Vec::new();
        for (number, candidate) in candidates.into_iter().enumerate() {
            let model = candidate.model();
            let asked = &references[..self.asked.min(references.len())];
            let reference = asked.iter().position(|reference| reference.model == model).unwrap_or(0);
            let outcome = self.run(&candidate).and_then(|run| {
                let law = Law::of(&run.report.plan);
                let found = references.get(reference).ok_or("there is no reference")?;
                let is_other = found.facts.contact && law != Law::of(&found.run.report.plan);
                let own = if is_other { self.own_reference(references, reference, law) } else { reference };
                let mut difference = difference(references, [reference, own], &run)?;
                difference.estimated = self.estimated(&candidate, &run, references.get(own));
                if is_other && law.model().is_none() {
                    of_own_law.push(OfOwnLaw { number, law, run });
                }
                Ok((own, difference))
            });
            let (reference, outcome) = match outcome {
                Ok((own, difference)) => (own, Ok(difference)),
                Err(reason) => (reference, Err(reason)),
            };
            compared.push(Compared { candidate, reference, outcome });
            self.source.host.part_done();
        }
        judge_by_own_finest(references, &mut compared, of_own_law);
        compared
    }

    /// Adds, to every series that one rung brings to `target` and the rung before does not, the setting between the
    /// two, while the time of the series allows it. A law of its own keeps its rungs: the finest of them is its
    /// reference.
    pub(crate) fn refine(&mut self, references: &mut Vec<Reference>, compared: &mut Vec<Compared>, target: f64) {
        let mut added = Vec::new();
        for (place, pair) in compared.windows(2).enumerate() {
            let [Ok(coarse), Ok(fine)] = [&pair[0].outcome, &pair[1].outcome] else { continue };
            let is_own = |difference: &Difference| difference.law.is_some_and(|other| other.law.model().is_none());
            let reaches = |difference: &Difference| {
                difference.errors.headline() + difference.law.map_or(0.0, |law| law.difference) <= target
            };
            let duration_s = references.first().map_or(0.0, |reference| reference.facts.duration_s);
            let crosses = !reaches(coarse) && reaches(fine) && !is_own(coarse);
            if let Some(between) =
                ladder::between(&pair[0].candidate, &pair[1].candidate, duration_s).filter(|_| crosses)
            {
                added.push((place + 1, between));
            }
        }
        let (places, candidates): (Vec<usize>, Vec<Candidate>) = added.into_iter().unzip();
        let between = self.errors(references, candidates);
        // The last first, so that the places of the others stay.
        for (place, entry) in places.into_iter().zip(between).rev() {
            compared.insert(place, entry);
        }
    }

    fn run(&mut self, candidate: &Candidate) -> Result<Completed, String> {
        let rounds = self.options.effort.fewest_rounds + 1;
        self.spent.admit(candidate, rounds)?;
        let scene = self.scene(candidate, self.options.samples)?;
        let outcome = self.source.record(&scene, self.spent.limit(candidate));
        self.spent.note(candidate, outcome.as_ref().ok());
        outcome
    }

    /// The error that a run tells of itself, in the measure of its reference: the run is made once more for that, where
    /// the time of its series allows it.
    fn estimated(&self, candidate: &Candidate, run: &Completed, reference: Option<&Reference>) -> Option<f64> {
        let estimation = self.options.estimation;
        let rounds = self.options.effort.fewest_rounds + 2;
        if estimation == ErrorEstimation::Off || !self.spent.affords(candidate, run.took, rounds) {
            return None;
        }
        let scene = self.scene(candidate, self.options.samples).ok()?;
        let told = self.source.record_estimating(&scene, self.spent.limit(candidate), estimation).ok()?;
        reference?.scales.estimated(&told.report.error)
    }

    /// Number of the reference of a law that is not the scene's; that of the scene where it has none.
    fn own_reference(&self, references: &mut Vec<Reference>, base: usize, law: Law) -> usize {
        let Some(impact) = law.model() else { return base };
        let mut model = references.get(base).map_or_else(Vec::new, |reference| reference.model.clone());
        model.push(impact);
        if let Some(known) = references.iter().position(|reference| reference.model == model) {
            return known;
        }
        match reference::find(self.source, &model, self.options.samples, None) {
            Ok(found) => {
                references.push(found);
                references.len() - 1
            }
            Err(_) => base,
        }
    }

    fn scene(&self, candidate: &Candidate, samples: u32) -> Result<Scene, String> {
        let scene = self.source.scene(&candidate.changes)?;
        let mut changes = candidate.changes.clone();
        changes.push(reference::sampling(&scene, samples));
        self.source.scene(&changes)
    }

    /// Times the candidates that ran; one that now fails loses its errors.
    pub(crate) fn timings(&self, compared: &mut [Compared], base: Option<usize>) -> Vec<Option<Timing>> {
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
        self.source.host.phase("timing", scenes.len() * effort.most_rounds);
        let timed = timing::interleaved(self.source, &scenes, base, effort);
        for (number, timing) in numbers.into_iter().zip(timed) {
            match timing {
                Ok(timing) => timings[number] = Some(timing),
                Err(reason) => compared[number].outcome = Err(reason),
            }
        }
        timings
    }

    /// Counts instructions of the candidates that ran, when they are asked for.
    pub(crate) fn instructions(&self, compared: &[Compared]) -> Vec<Option<Result<u64, String>>> {
        if self.options.counting == Counting::Time {
            return vec![None; compared.len()];
        }
        self.source.host.phase("instructions", compared.len());
        let count = |entry: &Compared| {
            self.source.host.part_done();
            entry.outcome.is_ok().then(|| {
                let sampling: Override = reference::sampling(&self.source.scene(&entry.candidate.changes)?, 1);
                self.source.host.instructions(&entry.candidate, &sampling)
            })
        };
        compared.iter().map(count).collect()
    }
}

/// How a run differs from the second reference, which is that of its own law; the first is that of the scene's.
fn difference(references: &[Reference], [base, own]: [usize; 2], run: &Completed) -> Result<Difference, String> {
    let (scene, limit) = (&references[base], &references[own]);
    let errors = scene.scales.errors(&limit.run.record, &run.record)?;
    if errors.headline().is_nan() {
        return Err("its motion is not a number".to_owned());
    }
    let law = if base == own {
        None
    } else {
        let law = Law::of(&limit.run.report.plan);
        Some(OtherLaw { law, difference: scene.scales.errors(&scene.run.record, &limit.run.record)?.headline() })
    };
    let (steps, solver) = (run.report.steps, Solver::of(&run.report.plan));
    Ok(Difference { errors, energy_error: energy_error(&run.report), steps, solver, law, estimated: None })
}

/// Judges runs of laws of which no other method knows the limit by the finest run of their series. The finest itself is
/// as far from the limit as the second finest is from it, at the most.
fn judge_by_own_finest(references: &mut Vec<Reference>, compared: &mut [Compared], mut runs: Vec<OfOwnLaw>) {
    while let Some(finest) = runs.pop() {
        let series = compared[finest.number].candidate.series.clone();
        let is_other = |run: &mut OfOwnLaw| compared[run.number].candidate.series == series;
        let coarser: Vec<OfOwnLaw> = runs.extract_if(.., is_other).collect();
        let base = compared[finest.number].reference;
        let (Some(scene), Some(second)) = (references.get(base), coarser.last()) else { continue };
        let (scales, facts) = (scene.scales.clone(), scene.facts);
        let of_law = scales.errors(&scene.run.record, &finest.run.record);
        let (Ok(of_law), Ok(step)) = (of_law, scales.errors(&finest.run.record, &second.run.record)) else { continue };
        let law = Some(OtherLaw { law: finest.law, difference: of_law.headline() });
        for run in coarser.iter().chain([&finest]) {
            let errors = scales.errors(&finest.run.record, &run.run.record).ok();
            if let (Some(errors), Ok(difference)) = (errors, &mut compared[run.number].outcome) {
                difference.errors = if run.number == finest.number { step } else { errors };
                difference.law = law;
            }
            compared[run.number].reference = references.len();
        }
        let (name, before) = (&compared[finest.number].candidate, &compared[second.number].candidate);
        references.push(Reference {
            kind: reference::Kind::Finest,
            method: name.name(),
            error: step.headline(),
            basis: format!("the finest of its own runs, from which {} differs by that", before.name()),
            scales,
            model: name.changes.clone(),
            facts,
            run: finest.run,
        });
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
        Err(format!(
            "left out: about {expected_s:.1} s a run; a larger budget, or a list of values to vary, includes it"
        ))
    }

    /// Whether a run that has taken so long may be made so many times: any that was asked for may.
    fn affords(&self, candidate: &Candidate, took: Duration, rounds: usize) -> bool {
        candidate.growth.is_none() || took.as_secs_f64() * rounds as f64 <= SHARE_OF_ONE * self.share_s
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
        let second = Duration::from_secs(1);
        assert!(spent.affords(&ladder[1], second, 7) && !spent.affords(&ladder[1], second, 8));
        assert!(spent.affords(&ladder[0], 100 * second, 8), "what is asked for tells its error");
    }
}
