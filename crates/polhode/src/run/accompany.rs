//! How runs beside a run ("references") are begun, followed and compared with it, to estimate its error
//! (`crate::error_estimate`).
//!
//! References begin with the run, follow every action of the program, and are compared with the run at its present,
//! whenever they have come to the end of a step of theirs. Where they take more of the work of the run than they may,
//! the one that takes most ends; others begin when that part has grown enough. A reference that fails ends, and the
//! report says why; no other one of its kind begins then.

use crate::error::SimulationError;
use crate::error_estimate::budget::{Allowed, LEAST_COMPARISONS, allowed};
use crate::error_estimate::course::Course;
use crate::error_estimate::effort::ErrorEstimation;
use crate::error_estimate::growth::ROUNDING_OF_START;
use crate::error_estimate::references::{Reference, ReferenceBegin, References, StartOfRun};
use crate::model::plane_of_motion::PlanarBodies;
use crate::model::work;
use crate::report::observer::{BodySample, Unobserved};
use crate::report::run_error::{BodyError, ReferenceKind, RunError};
use crate::run::beside::ReferenceMethod;
use crate::run::simulation::Simulation;
use crate::snapshot::numbers::{read_states, write_states};
use crate::snapshot::{SnapshotError, content};
use polhode_spatial::DVec3;

/// Comparisons of a run under error control.
const COMPARISONS: f64 = 200.0;

/// Comparisons after which it is foreseen what a whole reference will cost.
const COMPARISONS_TO_FORESEE: u32 = 4;

/// Rows of a pair that touches, in three directions at four points.
const ROWS_OF_PAIR: usize = 12;

/// Rows of another method from which on each further one costs as much.
const ROWS_COUPLED_AT_ONCE: usize = 400;

/// Distances of the past fade within this part of the time that a reference has run (no unit, 0.05 to 0.5).
const FADES_WITHIN: f64 = 0.2;

/// The estimated error, of the size of a body, beyond which a warning says that its place is not known (no unit, 0.01
/// to 1).
const PLACE_UNKNOWN: f64 = 0.1;

/// The error of time steps in crowded events, in distances from a run with steps twice as long (no unit, 1 to 3).
const CROWDED_WEIGHT: f64 = 2.0;

/// Roundings of the run, each as large as that of the start of a disturbed run, that add up (no unit, 1 to 30).
const ROUNDINGS: f64 = 10.0;

/// The part of the tolerance of a step that the errors of all steps come to at least (no unit, 0.01 to 1).
const PART_OF_TOLERANCE: f64 = 0.3;

/// Rounding of a position, of its coordinates, and of an attitude, of the angle that a body has turned by (no unit).
const ROUNDING_OF_PLACES: f64 = 8.0 * f64::EPSILON;

impl Simulation {
    /// Estimates the error of the run so from now on. Before the first step references begin with the run; later they
    /// tell what happens from then on.
    pub fn set_error_estimation(&mut self, estimation: ErrorEstimation) {
        self.references.effort = estimation;
        if estimation == ErrorEstimation::Off {
            self.references.running.clear();
        }
    }

    /// The same simulation, whose error is estimated so.
    #[must_use]
    pub fn estimating(mut self, estimation: ErrorEstimation) -> Self {
        self.set_error_estimation(estimation);
        self
    }

    /// How the error of the run is estimated.
    pub fn error_estimation(&self) -> ErrorEstimation {
        self.references.effort
    }

    /// The estimated error of the run at its last comparison.
    pub fn error(&self) -> RunError {
        let References { effort, ref course, ref running, .. } = self.references;
        let work = |kind| running.iter().filter(|own| own.kind == kind).map(Reference::work).sum();
        let mut bodies = course.errors.clone();
        bodies.truncate(self.core.model.shown());
        RunError {
            estimation: effort,
            largest: course.largest(),
            bodies,
            horizon_s: course.growth.horizon_s,
            references: course.references(self.core.work, work),
        }
    }

    /// Begins the references that begin with the run, as far as they may cost what its beginning has cost.
    pub(super) fn begin_references(&mut self) {
        if self.references.course.has_begun || self.references.effort == ErrorEstimation::Off {
            return;
        }
        let start = self.start_at_present();
        let course = &mut self.references.course;
        course.has_begun = true;
        course.compared_s = start.t_s;
        course.start_s = start.t_s;
        course.beginning = self.core.work;
        course.start = self.tier.samples(&self.core).iter().map(place_of).collect();
        self.references.start = Some(start);
        self.begin_due();
        self.references.course.next_s = self.next_comparison();
    }

    /// The kinds of references of an effort.
    fn kinds(&self, effort: ErrorEstimation) -> impl Iterator<Item = ReferenceKind> + use<> {
        let tier = self.core.settings.tier;
        let repeats = tier.facts().second_opinion == tier && effort == ErrorEstimation::Quick;
        let is_fixed = self.core.settings.names_fixed_steps();
        // The same tier with a smaller tolerance costs more than the run.
        let is_used = move |kind: &ReferenceKind| *kind != ReferenceKind::OtherMethod || !repeats || is_fixed;
        let first = tier.facts().compared_first;
        let others = ReferenceKind::ALL.into_iter().filter(move |kind| *kind != first);
        std::iter::once(first).chain(others).filter(is_used)
    }

    /// When the run is compared next, s.
    fn next_comparison(&self) -> f64 {
        let (t, settings) = (self.core.t, &self.core.settings);
        if settings.tier.facts().controls_error() {
            return t + (self.scene.duration_s() / COMPARISONS).max(settings.step_s);
        }
        // The ends of the longer steps of a reference are ends of steps of the run.
        let long_step_s = settings.step_s * self.references.effort.step_factor(0);
        let several = (self.scene.duration_s() / (COMPARISONS * long_step_s)).floor().max(1.0);
        let interval_s = long_step_s * several;
        ((t / interval_s).floor() + 1.0) * interval_s
    }

    /// Begins a reference of a kind: with the run, if it can, else within it.
    fn begin_reference(&mut self, kind: ReferenceKind, start: Option<&StartOfRun>) {
        let number = self.references.course.of(kind).begun;
        let by = self.reference_method(kind, self.references.effort, number);
        let present = self.start_at_present();
        let from = start.unwrap_or(&present);
        let begun = if kind == ReferenceKind::Disturbed {
            let both =
                self.beside(&by, from, ROUNDING_OF_START).and_then(|run| Ok((run, self.beside(&by, from, 0.0)?)));
            both.map(|(run, partner)| (run, Some(Box::new(partner))))
        } else {
            self.beside(&by, from, 0.0).map(|run| (run, None))
        };
        let base = if start.is_some() { Vec::new() } else { self.references.course.errors.clone() };
        let own = self.references.course.of_mut(kind);
        match begun {
            Ok((run, partner)) => {
                own.begun += 1;
                own.method = by.words;
                own.ended = None;
                let (begun_s, is_whole, weight) = (from.t_s, start.is_some(), by.weight);
                let begin = ReferenceBegin { begun_s, number, is_whole, base, weight };
                self.references.running.push(Reference { partner, ..Reference::new(kind, Box::new(run), begin) });
            }
            Err(error) => {
                own.has_failed = true;
                own.ended = Some(error.to_string());
            }
        }
    }

    /// Compares the run with its references, where it is time to.
    pub(super) fn follow(&mut self) {
        if self.references.effort == ErrorEstimation::Off {
            return;
        }
        let is_due = self.core.t >= self.references.course.next_s - f64::EPSILON * self.core.t;
        if is_due || (self.ended && self.references.course.compared_s < self.core.t) {
            self.references.errors_before.clone_from(&self.references.course.errors);
            self.compare();
        }
    }

    /// Brings the references to the present of the run, and compares it with them.
    fn compare(&mut self) {
        let t = self.core.t;
        let mut running = std::mem::take(&mut self.references.running);
        let (now, first) = (self.allowed(), self.core.settings.tier.facts().compared_first);
        for place in (0..running.len()).rev() {
            let kind = running[place].kind;
            let (before, from_s) = (running[place].work(), running[place].run.core.t);
            // What others have cost in vain does not end the first one, by which the error is known.
            let in_vain = if kind == first { 0 } else { self.references.course.spent() };
            let reached = running[place].bring_to(t, now.ahead - in_vain as f64);
            let way_s = running[place].run.core.t - from_s;
            if way_s > 0.0 {
                self.references.course.of_mut(kind).per_second = (running[place].work() - before) as f64 / way_s;
            }
            let of_rest = self.references.course.of(kind).per_second * (self.scene.duration_s() - t);
            let reference = &mut running[place];
            reference.comparisons += 1;
            let is_foreseen = reference.is_whole && reference.comparisons == COMPARISONS_TO_FORESEE;
            match reached {
                // A whole one that cannot be paid for to the end leaves what is left to others.
                Ok(true) if is_foreseen && of_rest > now.of_rest + now.at_once - reference.work() as f64 => {
                    self.end_reference(&mut running, place, None);
                }
                Ok(true) => {}
                Ok(false) => self.end_reference(&mut running, place, None),
                Err(error) => self.end_reference(&mut running, place, Some(error)),
            }
        }
        while spent(&self.references.course, &running) > now.ahead {
            let rate = |own: &Reference<Self>| own.work() as f64 / (t - own.begun_s);
            let others = running.iter().enumerate().filter(|(_, own)| own.kind != first);
            let Some((place, _)) = others.max_by(|a, b| rate(a.1).total_cmp(&rate(b.1))) else { break };
            self.end_reference(&mut running, place, None);
        }
        self.references.running = running;
        self.note_distances();
        if self.ended && self.references.course.errors.is_empty() {
            self.repeat_with_other_steps();
            self.note_distances();
        }
        // One that begins at the end has nothing to follow.
        if !self.ended {
            self.begin_due();
        }
        self.references.course.next_s = self.next_comparison();
    }

    /// Ends the reference at this place, because of an error or of what it costs.
    fn end_reference(&mut self, running: &mut Vec<Reference<Self>>, place: usize, error: Option<SimulationError>) {
        let reference = running.remove(place);
        let course = &mut self.references.course;
        let length_s = course.compared_s - reference.begun_s;
        if length_s > 0.0 && reference.kind != ReferenceKind::Disturbed {
            course.rates = reference.since.iter().map(|since| since.times(1.0 / length_s)).collect();
        }
        let own = course.of_mut(reference.kind);
        own.spent += reference.work();
        match error {
            Some(error) => {
                own.has_failed = true;
                own.ended = Some(error.to_string());
            }
            None => own.ended = Some("it costs more than the estimate may".to_owned()),
        }
    }

    /// Repeats a run that has ended with other steps, where it was too short for anything else: one that costs more
    /// than the estimate may is better than none.
    fn repeat_with_other_steps(&mut self) {
        let Some(start) = self.references.start.take() else { return };
        self.begin_reference(ReferenceKind::OtherSteps, Some(&start));
        let mut running = std::mem::take(&mut self.references.running);
        if let Some(Err(error)) = running.last_mut().map(|own| own.bring_to(self.core.t, f64::INFINITY)) {
            let last = running.len() - 1;
            self.end_reference(&mut running, last, Some(error));
        }
        self.references.running = running;
    }

    /// What references may have taken by now.
    fn allowed(&self) -> Allowed {
        let begun_s = self.references.course.start_s;
        allowed(self.references.effort, self.core.work, (self.core.t - begun_s) / (self.scene.duration_s() - begun_s))
    }

    /// Begins references that the run can pay for now: whole ones, from its start, if it can pay for all of their way,
    /// else pieces.
    fn begin_due(&mut self) {
        let t = self.core.t;
        for kind in self.kinds(self.references.effort) {
            let allowed = self.allowed();
            let interval_s = self.next_comparison() - t;
            let touching_pairs = self.tier.touching_pairs();
            let references = &mut self.references;
            let known = references.course.of(kind);
            let is_needless = match kind {
                ReferenceKind::OtherMethod => false,
                ReferenceKind::OtherSteps => {
                    let is_best = |own: &Reference<Self>| own.kind == ReferenceKind::OtherMethod && own.is_whole;
                    references.effort == ErrorEstimation::Quick && references.running.iter().any(is_best)
                }
                // How an error grows is of no use where none is known.
                ReferenceKind::Disturbed => references.running.is_empty() && references.course.errors.is_empty(),
            };
            if references.runs(kind) || known.has_failed || is_needless {
                continue;
            }
            let per_second = known.per_second;
            let left = allowed.at_once - spent(&references.course, &references.running);
            let to_begin = beginning(kind, references.course.beginning, touching_pairs);
            let of_rest = per_second * (self.scene.duration_s() - t).max(0.0);
            let start = references.start.take_if(|start| {
                let needed = to_begin + per_second * (t - start.t_s);
                left >= needed
                    && of_rest <= allowed.of_rest + left - needed
                    && self.core.model.joints.released.is_empty()
            });
            // What has never run begins with the run, if it can.
            let is_piece = kind != ReferenceKind::Disturbed && (per_second > 0.0 || references.start.is_none());
            let of_piece = to_begin.max(LEAST_COMPARISONS * per_second * interval_s);
            if start.is_some() || (is_piece && left >= of_piece) {
                self.begin_reference(kind, start.as_ref());
            }
            self.references.start = self.references.start.take().or(start);
        }
    }

    /// Notes how far the run is from its references at the present, and what that says of its errors.
    fn note_distances(&mut self) {
        let (t, model) = (self.core.t, &self.core.model);
        let samples = self.tier.samples(&self.core);
        let sizes: Vec<f64> = model.bodies.iter().map(|body| body.size).collect();
        let is_crowded = self.core.accounts.has_crowded();
        let References { running, course, .. } = &mut self.references;
        let since_s = t - course.compared_s;
        let (mut growth, mut amplified) = (1.0, Vec::new());
        for reference in running.iter_mut() {
            let others = reference.run.tier.samples(&reference.run.core);
            let own = reference.partner.as_ref().map(|partner| partner.tier.samples(&partner.core));
            let own = own.as_ref().unwrap_or(&samples);
            let distances: Vec<BodyError> = own.iter().zip(&others).map(|(a, b)| distance(a, b)).collect();
            let largest = distances.iter().zip(&sizes).map(|(own, &size)| own.of_size(size)).fold(0.0, f64::max);
            let known = course.of_mut(reference.kind);
            known.largest = known.largest.max(largest);
            let way_s = t - reference.begun_s;
            known.covered_s = if reference.is_whole { way_s } else { known.covered_s + since_s.min(way_s) };
            if reference.kind == ReferenceKind::Disturbed {
                let is_alike = reference.run.core.settings.tier == self.core.settings.tier;
                growth = course.growth.note(t, largest, is_alike);
                amplified = distances;
                continue;
            }
            let fade = (1.0 - since_s / (FADES_WITHIN * (t - reference.begun_s))).max(0.0);
            let weight = weight(reference, is_crowded);
            reference.since.resize(distances.len(), BodyError::default());
            for (since, distance) in reference.since.iter_mut().zip(&distances) {
                *since = since.times(fade).max(distance.times(weight));
            }
        }
        let (mut whole, mut pieces) = (None::<Vec<BodyError>>, None::<Vec<BodyError>>);
        for reference in running.iter_mut().filter(|own| own.kind != ReferenceKind::Disturbed) {
            reference.base.iter_mut().for_each(|base| *base = base.times(growth));
            // A whole run by another method, which comes first, is better than any by other steps.
            if !reference.is_whole {
                pieces = Some(larger(pieces, reference.errors()));
            } else if whole.is_none() {
                whole = Some(reference.errors());
            }
        }
        let errors = match (whole, pieces) {
            (Some(whole), Some(pieces)) => larger(Some(whole), pieces),
            (Some(errors), None) | (None, Some(errors)) => errors,
            (None, None) if course.errors.is_empty() => return,
            (None, None) => course.grown(growth, since_s, samples.len()),
        };
        // Local errors of steps under error control may add up to a part of their tolerance.
        let controlled = self.core.accounts.certificate.max_step_error.map_or(0.0, |_| self.core.settings.tolerance);
        let local = self.core.accounts.crowded.errors().max(PART_OF_TOLERANCE * controlled);
        let of_body = |(body, error): (usize, BodyError)| {
            let (sample, size) = (&samples[body], sizes[body]);
            let start = course.start.get(body).map_or(sample.pose.translation, |at| DVec3::from_array(*at));
            let way = (sample.pose.translation - start).length() + size;
            let most = BodyError::new(way, std::f64::consts::PI);
            let of_steps = BodyError::new(local * size, 0.0);
            let rounded = amplified.get(body).map_or(BodyError::default(), |own: &BodyError| own.times(ROUNDINGS));
            error.min(most).max(rounding(sample, size, t)).max(of_steps).max(rounded)
        };
        let errors = errors.into_iter().enumerate().map(of_body).collect();
        course.note(t, errors, &sizes);
    }

    /// Repeats an action of the program on the references.
    pub(crate) fn repeat_beside(&mut self, mut action: impl FnMut(&mut Self) -> Result<(), SimulationError>) {
        let t = self.core.t;
        // One that begins later would not have taken part in it.
        self.references.start = None;
        let mut running = std::mem::take(&mut self.references.running);
        for place in (0..running.len()).rev() {
            let reference = &mut running[place];
            let mut done = reference.bring_to(t, f64::INFINITY).and_then(|_| action(&mut reference.run));
            if let (Ok(()), Some(partner)) = (&done, &mut reference.partner) {
                done = action(partner);
            }
            if let Err(error) = done {
                self.end_reference(&mut running, place, Some(error));
            }
        }
        self.references.running = running;
    }

    /// What a warning says where an estimated error leaves a body in no known place; none where all are known.
    pub(super) fn unknown_motion(&self, error: &RunError) -> Option<String> {
        let sized = error.bodies.iter().zip(&self.core.model.bodies);
        let relative = sized.map(|(error, body)| (error.of_size(body.size), &body.name));
        let (relative, name) = relative.max_by(|a, b| a.0.total_cmp(&b.0))?;
        (relative > PLACE_UNKNOWN).then(|| {
            format!("where {name} is at the end is not known: the estimated error is {relative:.2} of its size")
        })
    }

    /// The references as plain data.
    pub(super) fn save_references(&self) -> content::ErrorEstimate {
        let save = |reference: &Reference<Self>| content::Reference {
            kind: reference.kind,
            run: reference.run.save_beside(),
            partner: reference.partner.as_ref().map(|partner| partner.save_beside()),
            begun_s: reference.begun_s,
            is_whole: reference.is_whole,
            comparisons: reference.comparisons,
            number: reference.number,
            base: reference.base.clone(),
            since: reference.since.clone(),
        };
        let course = self.references.course.clone();
        content::ErrorEstimate {
            effort: self.references.effort,
            start: self.references.start.as_ref().map(|start| content::StartOfRun {
                t_s: start.t_s,
                states: write_states(&start.states),
                rested: start.rested.clone(),
            }),
            course,
            running: self.references.running.iter().map(save).collect(),
        }
    }

    /// The start of the run in a snapshot.
    ///
    /// # Errors
    /// When it is of another number of bodies.
    fn restored_start(&self, saved: &content::StartOfRun) -> Result<StartOfRun, SnapshotError> {
        let states = read_states(&saved.states, self.core.model.bodies.len())?;
        Ok(StartOfRun { t_s: saved.t_s, states, rested: saved.rested.clone() })
    }

    /// This run beside a run as plain data.
    fn save_beside(&self) -> content::RunBeside {
        content::RunBeside { content: Box::new(self.content()), planar: self.planar_at_start.parts() }
    }

    /// A run by this method beside this one.
    ///
    /// # Errors
    /// When its content contradicts itself.
    fn restored_beside(&self, saved: &content::RunBeside, by: &ReferenceMethod) -> Result<Box<Self>, SimulationError> {
        let at_start = PlanarBodies::of_parts(saved.planar.as_ref());
        let twin = self.twin_by(&saved.content, by.settings, (self.reference_model(by)?.0, at_start))?;
        Ok(Box::new(Self { scene: self.scene.clone().with_method(by.method.clone()), ..twin }))
    }

    /// The references of a snapshot.
    ///
    /// # Errors
    /// When the content of one contradicts itself.
    pub(super) fn restored_references(
        &self,
        saved: &content::ErrorEstimate,
    ) -> Result<References<Self>, SimulationError> {
        let start = saved.start.as_ref().map(|start| self.restored_start(start)).transpose()?;
        let mut references = References { start, course: saved.course.clone(), ..References::new(saved.effort) };
        for own in &saved.running {
            let by = self.reference_method(own.kind, saved.effort, own.number);
            let run = self.restored_beside(&own.run, &by)?;
            let partner = own.partner.as_ref().map(|partner| self.restored_beside(partner, &by)).transpose()?;
            let (begun_s, is_whole, base) = (own.begun_s, own.is_whole, own.base.clone());
            let begin = ReferenceBegin { begun_s, number: own.number, is_whole, base, weight: by.weight };
            let reference = Reference::new(own.kind, run, begin);
            let (comparisons, since) = (own.comparisons, own.since.clone());
            references.running.push(Reference { partner, comparisons, since, ..reference });
        }
        Ok(references)
    }
}

impl Reference<Simulation> {
    /// Units of work so far.
    fn work(&self) -> u64 {
        self.run.core.work + self.partner.as_ref().map_or(0, |partner| partner.core.work)
    }

    /// Advances it to a time (s), unless its work exceeds what is left. Whether it got there.
    ///
    /// # Errors
    /// When it cannot go on.
    fn bring_to(&mut self, t: f64, left: f64) -> Result<bool, SimulationError> {
        for run in std::iter::once(&mut self.run).chain(&mut self.partner) {
            let duration = run.scene.duration_s();
            loop {
                let limit = if run.ended { t } else { t.min(duration) };
                let step = run.advance(limit, &mut Unobserved)?;
                if step.t_s >= t && !step.is_event() {
                    break;
                }
                if run.core.work as f64 > left {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The errors of the bodies of the run that it says.
    fn errors(&self) -> Vec<BodyError> {
        let base = |body: usize| self.base.get(body).copied().unwrap_or_default();
        self.since.iter().enumerate().map(|(body, since)| base(body).plus(*since)).collect()
    }
}

/// What the distance from a reference is multiplied by. Where time steps pass crowded events, their error is larger
/// than that of all else.
fn weight(reference: &Reference<Simulation>, is_crowded: bool) -> f64 {
    if is_crowded && reference.kind == ReferenceKind::OtherSteps { CROWDED_WEIGHT } else { reference.weight }
}

/// Units of work of all references so far.
fn spent(course: &Course, running: &[Reference<Simulation>]) -> f64 {
    (course.spent() + running.iter().map(Reference::work).sum::<u64>()) as f64
}

/// Units of work that a reference of a kind may need to begin, where the beginning of the run has taken `own` and so
/// many pairs touch. The first step of another method solves for their contact forces at every stage.
fn beginning(kind: ReferenceKind, own: u64, touching_pairs: usize) -> f64 {
    let rows = ROWS_OF_PAIR * touching_pairs;
    let first_step = work::OF_STEP * rows * rows.min(ROWS_COUPLED_AT_ONCE) / work::ROWS_OF_UNIT;
    match kind {
        ReferenceKind::OtherMethod => own as f64 + first_step as f64,
        ReferenceKind::OtherSteps => own as f64,
        ReferenceKind::Disturbed => 2.0 * own as f64,
    }
}

/// Where a body is, m.
fn place_of(sample: &BodySample) -> [f64; 3] {
    sample.pose.translation.to_array()
}

/// The larger errors of both.
fn larger(one: Option<Vec<BodyError>>, other: Vec<BodyError>) -> Vec<BodyError> {
    let Some(one) = one else { return other };
    one.into_iter().zip(other).map(|(a, b)| a.max(b)).collect()
}

/// How far a body is from where another run has it.
fn distance(one: &BodySample, other: &BodySample) -> BodyError {
    let apart = (one.pose.translation - other.pose.translation).length();
    BodyError::new(apart, one.pose.rotation.angle_to(other.pose.rotation))
}

/// What rounding alone may have done to a body of this size (m) until `t` (s).
fn rounding(sample: &BodySample, size: f64, t: f64) -> BodyError {
    let speed = sample.velocity.linear.length();
    let turn = sample.velocity.angular.length();
    let way = sample.pose.translation.abs().max_element() + speed * t + size;
    BodyError::new(ROUNDING_OF_PLACES * way, ROUNDING_OF_PLACES * (1.0 + turn * t))
}
