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
use crate::error_estimate::growth::ROUNDING_OF_START;
use crate::error_estimate::references::{Part, Reference, ReferenceBegin, References, StartOfRun};
use crate::model::plane_of_motion::PlanarBodies;
use crate::model::work;
use crate::report::observer::{BodySample, Unobserved};
use crate::report::run_error::{ReferenceKind, RunError};
use crate::run::beside::ReferenceMethod;
use crate::run::simulation::Simulation;
use crate::scene::ErrorEstimation;
use crate::snapshot::numbers::{read_states, write_states};
use crate::snapshot::{SnapshotError, content};

/// Comparisons of a run under error control.
const COMPARISONS: f64 = 100.0;

/// Comparisons after which it is foreseen what a whole reference will cost.
const COMPARISONS_TO_FORESEE: u32 = 4;

/// Points at which a pair touches.
const POINTS_OF_PAIR: usize = 4;

/// Rows of another method from which on each further one costs as much.
const ROWS_COUPLED_AT_ONCE: usize = 400;

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
            exceeds_s: course.exceeds_s,
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
        // Beside another method the first step shows what the start has to settle.
        self.references.course.next_s = if self.begins_with_method() { self.core.t } else { self.next_comparison() };
    }

    /// Whether a run by another method is the first to begin. Others begin after it has been compared once: their first
    /// step would be no longer than that of the run.
    fn begins_with_method(&self) -> bool {
        self.core.settings.tier.facts().compared_first == ReferenceKind::OtherMethod
    }

    /// The kinds of references of an effort.
    pub(super) fn kinds(&self, effort: ErrorEstimation) -> impl Iterator<Item = ReferenceKind> + use<> {
        let tier = self.core.settings.tier;
        let repeats = tier.facts().second_opinion == tier && effort == ErrorEstimation::Quick;
        let is_fixed = self.core.settings.names_fixed_steps();
        // The same tier with a smaller tolerance costs more than the run.
        let is_used = move |kind: &ReferenceKind| *kind != ReferenceKind::OtherMethod || !repeats || is_fixed;
        // A disturbed run costs what the run does, which a full estimate can pay for beside others.
        let second = (effort == ErrorEstimation::Full).then_some(ReferenceKind::Disturbed);
        let before = [Some(tier.facts().compared_first), second];
        let others = ReferenceKind::ALL.into_iter().filter(move |kind| !before.contains(&Some(*kind)));
        before.into_iter().flatten().chain(others).filter(is_used)
    }

    /// When the run is compared next, s.
    fn next_comparison(&self) -> f64 {
        let (t, settings) = (self.core.t, &self.core.settings);
        if settings.tier.facts().controls_error() {
            return t + (self.scene.duration_s() / COMPARISONS).max(settings.step_s);
        }
        // The ends of the longer steps of a reference are ends of steps of the run.
        let long_step_s = self.reference_method(ReferenceKind::OtherSteps, self.references.effort, 0).settings.step_s;
        let several = (self.scene.duration_s() / (COMPARISONS * long_step_s)).floor().max(1.0);
        let interval_s = long_step_s * several;
        ((t / interval_s).floor() + 1.0) * interval_s
    }

    /// Begins a reference of a kind there. A piece goes on from the errors that are known then.
    pub(super) fn begin_reference(&mut self, kind: ReferenceKind, from: &StartOfRun, part: Part) {
        let is_shared = |own: &&Reference<Self>| kind == ReferenceKind::Disturbed && own.begun_s == from.t_s;
        let disturbs_itself = self.disturbs_itself(self.references.effort);
        let shared = self.references.by_steps().filter(is_shared).filter(|_| !disturbs_itself);
        // A disturbed run is compared with the one by other steps, and has its steps.
        let number = shared.map_or(self.references.course.of(kind).begun, |own| own.number);
        let is_shared = shared.is_some();
        let by = self.reference_method(kind, self.references.effort, number);
        let disturbed_by = if kind == ReferenceKind::Disturbed { ROUNDING_OF_START } else { 0.0 };
        let needs_partner = kind == ReferenceKind::Disturbed && !is_shared && !disturbs_itself;
        let begun = self.beside(&by, from, disturbed_by).and_then(|run| {
            let partner = needs_partner.then(|| self.beside(&by, from, 0.0)).transpose()?;
            Ok((run, partner.map(Box::new)))
        });
        let course = &self.references.course;
        let base = match part {
            Part::Whole => Vec::new(),
            Part::Piece if kind == ReferenceKind::OtherMethod => course.pieces.errors.clone(),
            Part::Piece => course.errors.clone(),
        };
        let own = self.references.course.of_mut(kind);
        match begun {
            Ok((run, partner)) => {
                own.begun += 1;
                own.method = by.words;
                own.ended = None;
                let (begun_s, is_whole, weight) = (from.t_s, part == Part::Whole, by.weight);
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
        self.begin_piece();
        let t = self.core.t;
        let mut running = std::mem::take(&mut self.references.running);
        let (now, first) = (self.allowed(), self.core.settings.tier.facts().compared_first);
        let is_full = self.references.effort == ErrorEstimation::Full;
        // A disturbed run costs what the run does, which a full estimate can pay for.
        let is_kept = |kind| kind == first || (is_full && kind == ReferenceKind::Disturbed);
        for place in (0..running.len()).rev() {
            let kind = running[place].kind;
            let (before, from_s) = (running[place].work(), running[place].run.core.t);
            let others = if is_kept(kind) { 0.0 } else { of_running(&running) - running[place].work() as f64 };
            // What others have cost in vain ends none: it lets none begin.
            let reached = running[place].bring_to(t, now.ahead - others);
            let way_s = running[place].run.core.t - from_s;
            if way_s > 0.0 {
                self.references.course.of_mut(kind).per_second = (running[place].work() - before) as f64 / way_s;
            }
            let rest_s = self.scene.duration_s() - t;
            let of_rest: f64 = running.iter().map(|own| self.references.course.of(own.kind).per_second * rest_s).sum();
            let reference = &mut running[place];
            reference.comparisons += 1;
            // Longer fixed steps cost a known part of the run: they go on while they can.
            let may_cost_anything = kind == ReferenceKind::OtherMethod || self.core.settings.controls_error();
            let is_foreseen =
                may_cost_anything && reference.is_whole && reference.comparisons == COMPARISONS_TO_FORESEE;
            match reached {
                // A whole one that cannot be paid for to the end beside the others leaves what is left to them.
                Ok(true) if is_foreseen && of_rest > now.of_rest + now.at_once - of_running(&running) => {
                    self.end_reference(&mut running, place, Ending::TooCostly);
                }
                Ok(true) => {}
                Ok(false) => self.end_reference(&mut running, place, Ending::TooCostly),
                Err(error) => self.end_reference(&mut running, place, Ending::Failed(error)),
            }
        }
        while of_running(&running) > now.ahead {
            let rate = |own: &Reference<Self>| own.work() as f64 / (t - own.begun_s);
            let others = running.iter().enumerate().filter(|(_, own)| !is_kept(own.kind));
            let Some((place, _)) = others.max_by(|a, b| rate(a.1).total_cmp(&rate(b.1))) else { break };
            self.end_reference(&mut running, place, Ending::TooCostly);
        }
        self.end_without_partner(&mut running);
        self.references.running = running;
        self.note_distances();
        if self.ended && self.references.course.errors.is_empty() {
            self.repeat_with_other_steps();
            self.note_distances();
        }
        self.end_pieces();
        // One that begins at the end has nothing to follow.
        if !self.ended {
            self.begin_due();
        }
        self.references.course.next_s = self.next_comparison();
    }

    /// Ends the reference at this place.
    pub(super) fn end_reference(&mut self, running: &mut Vec<Reference<Self>>, place: usize, ending: Ending) {
        let reference = running.remove(place);
        let course = &mut self.references.course;
        let length_s = course.compared_s - reference.begun_s;
        match reference.kind {
            ReferenceKind::OtherSteps if length_s > 0.0 => {
                course.rates = reference.since.iter().map(|since| since.times(1.0 / length_s)).collect();
            }
            ReferenceKind::OtherMethod => {
                let covered_s = course.of(reference.kind).covered_s;
                course.pieces.note_end(reference.errors(), &reference.since, (length_s, covered_s));
            }
            _ => {}
        }
        let own = course.of_mut(reference.kind);
        own.spent += reference.work();
        own.ended = match ending {
            Ending::Failed(error) => {
                own.has_failed = true;
                Some(error.to_string())
            }
            Ending::TooCostly => Some("it costs more than the estimate may".to_owned()),
            Ending::Apart => Some("it accompanies contacts only".to_owned()),
        };
    }

    /// Ends a disturbed run whose partner, the one by other steps, has ended.
    fn end_without_partner(&mut self, running: &mut Vec<Reference<Self>>) {
        let has_partner = running.iter().any(|own| own.kind == ReferenceKind::OtherSteps && own.is_whole);
        if has_partner || self.disturbs_itself(self.references.effort) {
            return;
        }
        let is_alone = |own: &Reference<Self>| own.kind == ReferenceKind::Disturbed && own.partner.is_none();
        if let Some(place) = running.iter().position(is_alone) {
            self.end_reference(running, place, Ending::TooCostly);
        }
    }

    /// Repeats a run that has ended with other steps, where it was too short for anything else: one that costs as much
    /// as the run is better than none.
    fn repeat_with_other_steps(&mut self) {
        let Some(start) = self.references.start.take() else { return };
        self.begin_reference(ReferenceKind::OtherSteps, &start, Part::Whole);
        let most = self.allowed().ahead + self.core.work as f64;
        let mut running = std::mem::take(&mut self.references.running);
        let ending = match running.last_mut().map(|own| own.bring_to(self.core.t, most)) {
            Some(Err(error)) => Some(Ending::Failed(error)),
            Some(Ok(false)) => Some(Ending::TooCostly),
            _ => None,
        };
        if let Some(ending) = ending {
            let last = running.len() - 1;
            self.end_reference(&mut running, last, ending);
        }
        self.references.running = running;
    }

    /// What references may have taken by now.
    pub(super) fn allowed(&self) -> Allowed {
        let course = &self.references.course;
        let part = (self.core.t - course.start_s) / (self.scene.duration_s() - course.start_s);
        allowed(self.references.effort, (self.core.work, course.beginning), part)
    }

    /// Units of work that a reference of a kind may need to begin. The first step of another method solves for the
    /// contact forces of the pairs that touch at every stage.
    pub(super) fn beginning(&self, kind: ReferenceKind) -> f64 {
        let own = self.references.course.beginning as f64;
        if kind != ReferenceKind::OtherMethod {
            return own;
        }
        let directions = if self.core.model.surfaces.have_friction() { 3 } else { 1 };
        let rows = POINTS_OF_PAIR * directions * self.tier.touching_pairs();
        own + (work::OF_STEP * rows * rows.min(ROWS_COUPLED_AT_ONCE) / work::ROWS_OF_UNIT) as f64
    }

    /// Begins references that the run can pay for now: whole ones, from its start, if it can pay for all of their way,
    /// else pieces.
    fn begin_due(&mut self) {
        let t = self.core.t;
        for kind in self.kinds(self.references.effort) {
            let allowed = self.allowed();
            let interval_s = self.next_comparison() - t;
            let (disturbs_itself, begins_with_method) =
                (self.disturbs_itself(self.references.effort), self.begins_with_method());
            let of_beginning = self.beginning(kind);
            let references = &mut self.references;
            let known = references.course.of(kind);
            let is_too_soon = begins_with_method && t == references.course.start_s;
            let is_needless = match kind {
                ReferenceKind::OtherMethod => false,
                _ if is_too_soon => true,
                ReferenceKind::OtherSteps => {
                    let is_best = |own: &Reference<Self>| own.kind == ReferenceKind::OtherMethod && own.is_whole;
                    references.effort == ErrorEstimation::Quick && references.running.iter().any(is_best)
                }
                ReferenceKind::Disturbed if references.effort == ErrorEstimation::Full => false,
                // How an error grows is of no use where none is known, and what it costs is known by other steps.
                ReferenceKind::Disturbed => match references.by_steps() {
                    Some(steps) => steps.comparisons < COMPARISONS_TO_FORESEE,
                    None => references.running.is_empty() && references.course.errors.is_empty(),
                },
            };
            if references.runs(kind) || known.has_failed || is_needless {
                continue;
            }
            let is_disturbed = kind == ReferenceKind::Disturbed;
            let runs = if is_disturbed && !disturbs_itself && references.by_steps().is_none() { 2.0 } else { 1.0 };
            // A disturbed run costs what the run or one by other steps does.
            let own_rate = self.core.work as f64 / (t - references.course.start_s);
            let alike = match is_disturbed {
                true if t == references.course.start_s => 0.0,
                true if disturbs_itself => own_rate,
                true => runs * own_rate / references.effort.step_factor(known.begun),
                false => 0.0,
            };
            let per_second = known.per_second.max(alike);
            let left = allowed.at_once - spent(&references.course, &references.running);
            let to_begin = runs * of_beginning;
            let of_rest = per_second * (self.scene.duration_s() - t).max(0.0);
            let start = references.start.take_if(|start| {
                let needed = to_begin + per_second * (t - start.t_s);
                left >= needed
                    && of_rest <= allowed.of_rest + left - needed
                    && self.core.model.joints.released.is_empty()
            });
            // What has never run begins with the run, if it can. Pieces by another method begin elsewhere.
            let is_piece = kind == ReferenceKind::OtherSteps && (per_second > 0.0 || references.start.is_none());
            let of_piece = to_begin.max(LEAST_COMPARISONS * per_second * interval_s);
            if let Some(start) = &start {
                self.begin_reference(kind, start, Part::Whole);
            } else if is_piece && left >= of_piece {
                self.begin_reference(kind, &self.start_at_present(), Part::Piece);
            }
            self.references.start = self.references.start.take().or(start);
        }
    }

    /// Repeats an action of the program on the references.
    pub(crate) fn repeat_beside(&mut self, mut action: impl FnMut(&mut Self) -> Result<(), SimulationError>) {
        let t = self.core.t;
        // One that begins later would not have taken part in it.
        (self.references.start, self.references.before) = (None, None);
        let mut running = std::mem::take(&mut self.references.running);
        for place in (0..running.len()).rev() {
            let reference = &mut running[place];
            let mut done = reference.bring_to(t, f64::INFINITY).and_then(|_| action(&mut reference.run));
            if let (Ok(()), Some(partner)) = (&done, &mut reference.partner) {
                done = action(partner);
            }
            if let Err(error) = done {
                self.end_reference(&mut running, place, Ending::Failed(error));
            }
        }
        self.end_without_partner(&mut running);
        self.references.running = running;
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
            start: self.references.start.as_ref().map(save_start),
            before: self.references.before.as_ref().map(save_start),
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
        let restored = |start: &Option<_>| start.as_ref().map(|start| self.restored_start(start)).transpose();
        let (start, before) = (restored(&saved.start)?, restored(&saved.before)?);
        let mut references =
            References { start, before, course: saved.course.clone(), ..References::new(saved.effort) };
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
                // Within a step too: one that jams does not hold up the run.
                run.core.model.work.allow((left - run.core.work as f64).max(0.0) as u64);
                let step = match run.advance(limit, &mut Unobserved) {
                    Err(SimulationError::TooMuchWork { .. }) => return Ok(false),
                    step => step?,
                };
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
}

/// Why a reference ends.
#[derive(Debug)]
pub(super) enum Ending {
    /// It cannot go on.
    Failed(SimulationError),
    /// It costs more than it may.
    TooCostly,
    /// Bodies have come apart, and it accompanies contacts.
    Apart,
}

/// The start of references as plain data.
fn save_start(start: &StartOfRun) -> content::StartOfRun {
    content::StartOfRun { t_s: start.t_s, states: write_states(&start.states), rested: start.rested.clone() }
}

/// Units of work of all references so far.
pub(super) fn spent(course: &Course, running: &[Reference<Simulation>]) -> f64 {
    course.spent() as f64 + of_running(running)
}

/// Units of work of the references that run.
fn of_running(running: &[Reference<Simulation>]) -> f64 {
    running.iter().map(Reference::work).sum::<u64>() as f64
}

/// Where a body is, m.
fn place_of(sample: &BodySample) -> [f64; 3] {
    sample.pose.translation.to_array()
}
