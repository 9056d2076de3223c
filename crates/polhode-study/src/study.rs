//! A study: every candidate's error and cost, and which of them are worth their cost.

use crate::candidate::{Axis, Candidate};
use crate::difference::Errors;
use crate::error::StudyError;
use crate::front::{self, Point};
use crate::law::OtherLaw;
use crate::options::{Counting, Options};
use crate::reference::{self, Reference};
use crate::runs::{Compared, Difference, Runs, Solver};
use crate::source::Source;
use crate::timing::Timing;
use crate::{candidate, ladder};
use polhode::Flow;
use polhode::scene::Integrator;
use polhode_scene::names;

/// Ratios of time that are closer than this cannot be told apart from run to run (relative).
const TIME_RESOLUTION: f64 = 0.1;

/// Largest difference of two ways that agree, of the scene's length or in rad: a hundredth is seen with the naked eye.
const AGREEMENT: f64 = 1e-2;

/// Whether a run in another way that differs by this error agrees with the reference.
pub fn confirms(error: f64) -> bool {
    error <= AGREEMENT
}

/// What was measured.
#[derive(Debug)]
pub struct Study {
    /// Name of the scene.
    pub scene: String,
    /// Simulated time, s.
    pub duration_s: f64,
    /// What candidates were compared with: one for every model.
    pub references: Vec<Reference>,
    /// Every candidate, also those that failed.
    pub entries: Vec<Entry>,
    /// The candidate whose time is the unit, when any ran.
    pub base: Option<usize>,
    /// What cost is measured in.
    pub counting: Counting,
    /// Samples that errors were taken from.
    pub samples: u32,
}

/// A candidate and what came of it.
#[derive(Debug)]
pub struct Entry {
    /// The candidate.
    pub candidate: Candidate,
    /// Number of its reference.
    pub reference: usize,
    /// What was measured, or why not.
    pub outcome: Result<Measured, String>,
}

/// Error and cost of a candidate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// How far it is from the reference.
    pub errors: Errors,
    /// `D_numerical`, relative.
    pub energy_error: f64,
    /// Steps.
    pub steps: u64,
    /// How it moved its bodies.
    pub solver: Solver,
    /// Its law of contact, where that is not the scene's.
    pub law: Option<OtherLaw>,
    /// The error that it tells of itself, by runs beside it, in the measure of its error; none where it tells none, or
    /// that would have taken too long.
    pub estimated: Option<f64>,
    /// Its time.
    pub timing: Timing,
    /// Instructions, when they were counted.
    pub instructions: Option<u64>,
    /// Whether it is on the Pareto front.
    pub on_front: bool,
}

impl Measured {
    /// Its cost.
    pub fn cost(&self) -> f64 {
        self.instructions.map_or(self.timing.ratio, |count| count as f64)
    }

    /// The costs between which half of the measurements are: instructions repeat exactly.
    pub fn spread(&self) -> [f64; 2] {
        self.instructions.map_or(self.timing.spread, |count| [count as f64; 2])
    }
}

impl Study {
    /// Runs, times and judges the candidates of `axes`, or the default ones when there are none.
    ///
    /// # Errors
    /// When the scene, `axes` or the target are refused, there is no reference to compare with, or the host ends the
    /// study.
    pub fn run(source: &Source<'_>, axes: &[Axis], options: &Options) -> Result<Self, StudyError> {
        if let Some(value) = options.target.filter(|target| !(*target > 0.0 && target.is_finite())) {
            return Err(StudyError::Accuracy { value });
        }
        let scene = source.loaded()?.scene;
        let asked = candidate::product(axes).map_err(StudyError::Axis)?;
        source.host.phase("reference", 1);
        let (mut references, candidates) = if axes.is_empty() {
            let reference = reference::find(source, &[], options.samples, None).map_err(StudyError::NoReference)?;
            let candidates = ladder::candidates(&reference.facts, &source.given, options.range);
            (vec![reference], candidates)
        } else {
            (references(source, &asked, options.samples)?, asked)
        };
        let mut runs = Runs::new(source, options, &candidates, references.len());
        let mut errors = runs.errors(&mut references, candidates);
        if let (Some(target), true) = (options.target, axes.is_empty()) {
            runs.refine(&mut references, &mut errors, target);
        }
        let base = base(&errors);
        let timings = runs.timings(&mut errors, base);
        let counts = runs.instructions(&errors);
        // Runs that were ended early are no answer.
        if source.host.flow() == Flow::Stop {
            return Err(StudyError::Stopped);
        }
        let entries = judged(errors, timings, counts, &references, options.counting);
        let (scene, duration_s) = (scene.name().to_owned(), scene.duration_s());
        Ok(Self { scene, duration_s, references, entries, base, counting: options.counting, samples: options.samples })
    }

    /// The cheapest candidate that is known to be within `target` of the limit of the scene's law, and does not say
    /// otherwise of itself where it was asked: what another law makes of the scene counts here.
    pub fn cheapest(&self, target: f64) -> Option<&Entry> {
        let points = points(&self.entries, &self.references, Charged::MethodAndLaw);
        front::cheapest(&points, target).and_then(|number| self.entries.get(number))
    }

    /// The cheapest candidate that reaches `target`, or why there is none.
    ///
    /// # Errors
    /// [`StudyError::NotReached`], with the most accurate candidate.
    pub fn answer(&self, target: f64) -> Result<&Entry, StudyError> {
        self.cheapest(target).ok_or_else(|| {
            let best = match self.most_accurate() {
                Some((error, entry)) => {
                    format!("the most accurate, {}, is known to {error:.1e}", entry.candidate.name())
                }
                None => "none ran".to_owned(),
            };
            StudyError::NotReached { asked: target, best }
        })
    }

    /// The others that reach `target`, and whose cost cannot be told from that of the cheapest: within the noise of
    /// timing, or because they made the same run.
    pub fn ties(&self, target: f64) -> Vec<&Entry> {
        let Some(cheapest) = self.cheapest(target) else { return Vec::new() };
        let Ok(least) = &cheapest.outcome else { return Vec::new() };
        let is_tie = |entry: &&Entry| {
            let reaches = self.error_and_law(entry).is_some_and(|error| error <= target);
            let costs = is_same_run(entry, cheapest)
                || entry.outcome.as_ref().is_ok_and(|other| front::is_tie(other.spread(), least.spread()));
            reaches && costs && !std::ptr::eq(*entry, cheapest)
        };
        self.entries.iter().filter(is_tie).collect()
    }

    /// Time of the candidate whose time is the unit, s.
    pub fn base_seconds(&self) -> Option<f64> {
        let entry = self.entries.get(self.base?)?;
        entry.outcome.as_ref().ok().map(|measured| measured.timing.seconds)
    }

    /// Microseconds that a candidate takes for each simulated second.
    pub fn microseconds(&self, measured: &Measured) -> f64 {
        let seconds = self.base_seconds().map_or(measured.timing.seconds, |base| base * measured.timing.ratio);
        seconds * 1e6 / self.duration_s
    }

    /// The largest distance (mm) and angle (degrees) of a candidate from its reference.
    pub fn errors_in_units(&self, entry: &Entry, errors: &Errors) -> [f64; 2] {
        let length_m = self.references.get(entry.reference).map_or(f64::NAN, |reference| reference.scales.length_m);
        [errors.position * length_m * 1e3, errors.attitude.to_degrees()]
    }

    /// The smallest error that any candidate is known to reach, with that candidate.
    pub fn most_accurate(&self) -> Option<(f64, &Entry)> {
        let known = self.entries.iter().filter_map(|entry| {
            let error = self.known_error(entry)?;
            error.is_finite().then_some((error, entry))
        });
        known.min_by(|(a, _), (b, _)| a.total_cmp(b))
    }

    /// An error relative to the length of the scene (no unit), relative to the size of its smallest body.
    pub fn of_smallest_body(&self, error: f64) -> f64 {
        error * self.references.first().map_or(1.0, |reference| reference.scales.lengths_of_smallest_body())
    }

    /// How close to a reference a candidate comes that integrates in another way, with its name.
    pub fn closest_other(&self, reference: usize) -> Option<(f64, String)> {
        let own = Solver::of(&self.references.get(reference)?.run.report.plan);
        let others = self.entries.iter().filter(|entry| entry.reference == reference).filter_map(|entry| {
            let measured = entry.outcome.as_ref().ok()?;
            let error = measured.errors.headline();
            (!measured.solver.is_alike(own) && error.is_finite()).then(|| (error, entry.candidate.name()))
        });
        others.min_by(|(a, _), (b, _)| a.total_cmp(b))
    }

    /// A candidate's error, or that of its reference where that is larger.
    pub fn known_error(&self, entry: &Entry) -> Option<f64> {
        let measured = entry.outcome.as_ref().ok()?;
        Some(crate::difference::worst(measured.errors.headline(), self.references.get(entry.reference)?.error))
    }

    /// The same with the difference of its law.
    fn error_and_law(&self, entry: &Entry) -> Option<f64> {
        let law = entry.outcome.as_ref().ok()?.law.map_or(0.0, |law| law.difference);
        Some(self.known_error(entry)? + law)
    }

    /// The laws that are not the scene's, each once, in the order of the candidates.
    pub fn other_laws(&self) -> Vec<OtherLaw> {
        let mut laws: Vec<OtherLaw> = Vec::new();
        for law in self.entries.iter().filter_map(|entry| entry.outcome.as_ref().ok()?.law) {
            if !laws.iter().any(|known| known.law == law.law) {
                laws.push(law);
            }
        }
        laws
    }

    /// Name of the candidate whose time is the unit.
    pub fn base_name(&self) -> String {
        let entry = self.base.and_then(|base| self.entries.get(base));
        entry.map_or_else(|| "none".to_owned(), |entry| entry.candidate.name())
    }

    /// What the numbers of cost are.
    pub fn cost_unit(&self) -> String {
        match self.counting {
            Counting::Time => format!("time, relative to {}", self.base_name()),
            Counting::Instructions => "instructions".to_owned(),
        }
    }
}

/// One reference for every model among the candidates, in the order in which they occur.
fn references(source: &Source<'_>, candidates: &[Candidate], samples: u32) -> Result<Vec<Reference>, StudyError> {
    let steps = candidates.iter().filter_map(|candidate| candidate.value("method.step")?.parse::<f64>().ok());
    let finest_step_s = steps.filter(|&step| step > 0.0).min_by(f64::total_cmp);
    let mut references: Vec<Reference> = Vec::new();
    for candidate in candidates {
        let model = candidate.model();
        if !references.iter().any(|reference| reference.model == model) {
            let found = reference::find(source, &model, samples, finest_step_s);
            references.push(found.map_err(|fault| StudyError::NoReference(format!("{}: {fault}", candidate.name())))?);
        }
    }
    Ok(references)
}

/// The candidate whose time is the unit: RK4, the thesis's method, at its middle step; else the first that ran.
fn base(compared: &[Compared]) -> Option<usize> {
    let rk4 = names::integrator(Integrator::Rk4);
    let ran = |series: Option<&str>| -> Vec<usize> {
        let is =
            |entry: &Compared| entry.outcome.is_ok() && series.is_none_or(|series| entry.candidate.series == series);
        compared.iter().enumerate().filter(|(_, entry)| is(entry)).map(|(number, _)| number).collect()
    };
    let steps = ran(Some(rk4));
    steps.get(steps.len() / 2).or(ran(None).first()).copied()
}

/// Everything together, with the Pareto front.
fn judged(
    compared: Vec<Compared>,
    timings: Vec<Option<Timing>>,
    counts: Vec<Option<Result<u64, String>>>,
    references: &[Reference],
    counting: Counting,
) -> Vec<Entry> {
    let resolution = if counting == Counting::Time { TIME_RESOLUTION } else { 0.0 };
    let mut entries: Vec<Entry> = Vec::with_capacity(compared.len());
    for ((entry, timing), count) in compared.into_iter().zip(timings).zip(counts) {
        let outcome = entry.outcome.and_then(|Difference { errors, energy_error, steps, solver, law, estimated }| {
            let timing = timing.ok_or_else(|| "it was not timed".to_owned())?;
            let instructions = count.transpose()?;
            Ok(Measured { errors, energy_error, steps, solver, law, estimated, timing, instructions, on_front: false })
        });
        entries.push(Entry { candidate: entry.candidate, reference: entry.reference, outcome });
    }
    let points = points(&entries, references, Charged::Method);
    for (entry, is_on) in entries.iter_mut().zip(front::front(&points, resolution)) {
        if let Ok(measured) = &mut entry.outcome {
            measured.on_front = is_on;
        }
    }
    entries
}

/// What counts as error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Charged {
    /// What the method makes of its own law.
    Method,
    /// That, and how far its law is from the scene's.
    MethodAndLaw,
}

/// Cost and error of the entries; not a number for one that failed. Entries that made the same run cost the same: what
/// timing makes of them differs by noise alone, and the smallest is nearest to the truth.
fn points(entries: &[Entry], references: &[Reference], charged: Charged) -> Vec<Point> {
    let cost = |entry: &Entry| entry.outcome.as_ref().map_or(f64::NAN, Measured::cost);
    let of = |entry: &Entry| {
        let Ok(measured) = &entry.outcome else { return Point::new(f64::NAN, f64::NAN, f64::NAN) };
        let floor = references.get(entry.reference).map_or(f64::NAN, |reference| reference.error);
        let law = measured.law.filter(|_| charged == Charged::MethodAndLaw).map_or(0.0, |law| law.difference);
        // A run that tells a larger error of itself would be held not to have reached a target.
        let told = measured.estimated.filter(|_| charged == Charged::MethodAndLaw).unwrap_or(0.0);
        let error = crate::difference::worst(measured.errors.headline() + law, told);
        let same = entries.iter().filter(|other| is_same_run(other, entry));
        Point::new(same.map(cost).fold(measured.cost(), f64::min), error, floor + law)
    };
    entries.iter().map(of).collect()
}

/// Whether two settings of one method made the same run: a tolerance that nothing needs changes neither the steps nor a
/// bit of the errors.
fn is_same_run(a: &Entry, b: &Entry) -> bool {
    let (Ok(one), Ok(other)) = (&a.outcome, &b.outcome) else { return false };
    let run = |measured: &Measured| {
        let Errors { position, attitude, final_position, final_attitude, final_velocity } = measured.errors;
        [position, attitude, final_position, final_attitude, final_velocity, measured.energy_error].map(f64::to_bits)
    };
    a.candidate.series == b.candidate.series
        && a.reference == b.reference
        && one.solver == other.solver
        && one.steps == other.steps
        && run(one) == run(other)
}

#[cfg(test)]
mod tests {
    //! Which candidate is the unit of time.
    use super::*;

    fn compared(series: &str, runs: bool) -> Compared {
        let candidate = Candidate { series: series.to_owned(), rung: String::new(), changes: Vec::new(), growth: None };
        let solver = Solver { integrator: Integrator::Rk4, closed_form: false };
        let (errors, energy_error, steps) = (Errors::default(), 0.0, 1);
        let difference = Difference { errors, energy_error, steps, solver, law: None, estimated: None };
        let outcome = if runs { Ok(difference) } else { Err(String::new()) };
        Compared { candidate, reference: 0, outcome }
    }

    /// Four tolerances that made one run are ties, whatever their times; the first of them is named, and no other
    /// method is a tie for that. (Before, the one whose time happened to be least was named alone.)
    #[test]
    fn the_same_run_is_a_tie_whatever_its_time() {
        let entry = |series: &str, rung: &str, ratio: f64, steps: u64| {
            let timing = Timing { ratio, spread: [ratio, ratio], seconds: ratio, rounds: 3 };
            let solver = Solver { integrator: Integrator::Rk4, closed_form: false };
            let (errors, energy_error) = (Errors { position: 1e-9, ..Errors::default() }, 0.0);
            let measured = Measured {
                errors,
                energy_error,
                steps,
                solver,
                law: None,
                estimated: None,
                timing,
                instructions: None,
                on_front: false,
            };
            let (series, rung, changes) = (series.to_owned(), rung.to_owned(), Vec::new());
            let candidate = Candidate { series, rung, changes, growth: None };
            Entry { candidate, reference: 0, outcome: Ok(measured) }
        };
        let entries = vec![
            entry("accurate", "1e-6", 1.3, 100),
            entry("accurate", "1e-8", 1.0, 100),
            entry("accurate", "1e-10", 1.2, 101),
            entry("stepped", "0.1", 1.5, 100),
        ];
        let study = Study {
            scene: String::new(),
            duration_s: 1.0,
            references: Vec::new(),
            entries,
            base: Some(1),
            counting: Counting::Time,
            samples: 1,
        };
        let names = |found: Vec<&Entry>| found.iter().map(|entry| entry.candidate.rung.clone()).collect::<Vec<_>>();
        let same: Vec<&Entry> = study.entries.iter().filter(|entry| is_same_run(entry, &study.entries[0])).collect();
        assert_eq!(names(same), ["1e-6", "1e-8"]);
        let points = points(&study.entries, &[], Charged::Method);
        assert_eq!(points[0].cost(), 1.0);
        assert_eq!(points.iter().map(|point| point.cost()).collect::<Vec<_>>(), [1.0, 1.0, 1.2, 1.5]);
    }

    #[test]
    fn the_unit_is_rk4_at_its_middle_step() {
        let all = [compared("cf4", true), compared("rk4", true), compared("rk4", true), compared("rk4", true)];
        assert_eq!(base(&all), Some(2));
        assert_eq!(base(&[compared("rk4", false), compared("cf4", false), compared("exact", true)]), Some(2));
        assert_eq!(base(&[compared("rk4", false)]), None);
    }
}
