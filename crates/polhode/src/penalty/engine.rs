//! A run of the tier `penalty`: groups are advanced through longest steps, booked together, and queried at the present.

use super::contact::{ContactSpring, Evaluated};
use super::groups::{Margins, groups};
use super::laws::Laws;
use super::run::{Group, GroupRun, Run, Segment};
use super::saved::{restored_laws, restored_report, restored_spring, save_laws, save_report, save_spring};
use super::{fixed, stepping};
use crate::collision::boxes::Boxes;
use crate::collision::touch::Touch;
use crate::collision::{contact_set, contact_view};
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::joints::{added, turns};
use crate::model::{Model, prescribed, tolerances};
use crate::report::acceleration::Acceleration;
use crate::report::frame::{ContactView, IslandView, JointView, MotionKind};
use crate::report::observer::Observer;
use crate::report::run_report::RunReport;
use crate::report::springs::SpringReport;
use crate::snapshot::numbers::{read_states, write_states};
use crate::snapshot::{SnapshotError, content, springs};
use crate::solve::joint_loads::joint_loads;
use crate::solve::joint_reactions::JointReactions;
use crate::tier::core::Core;
use crate::tier::fixed_steps::accelerations_under;
use crate::tier::sampling::emit_samples_before;
use crate::tier::{Reached, Tier};
use polhode_dynamics::BodyState;
use polhode_dynamics::state::WIDTH;
use polhode_response::ResponseError;
use polhode_spatial::{DVec3, Still};
use std::sync::Arc;

/// How often groups are made anew in a longest step because bodies have left their boxes; then the step is halved.
const MOST_ROUNDS: u32 = 8;

/// A run in progress.
#[derive(Debug)]
pub(crate) struct PenaltyEngine {
    /// States of all bodies at the present.
    states: Vec<BodyState>,
    /// The springs of all contacts, ascending.
    springs: Vec<ContactSpring>,
    laws: Laws,
    /// Length of step (s) that error control proposes next for each body's group.
    proposed: Vec<f64>,
    boxes: Boxes,
    /// Groups of the last step.
    islands: Vec<Vec<usize>>,
    measured: SpringReport,
}

impl PenaltyEngine {
    /// Prepares a run.
    pub(crate) fn new(core: &mut Core, states: Vec<BodyState>) -> Self {
        let laws = Laws::new(&core.model, core.settings.penalty, &states);
        let asked = core.settings.penalty.stiffness_n_m.is_none() && core.model.surfaces.may_collide();
        let is_linear = core.settings.penalty.law.unwrap_or_default() == crate::scene::SpringLaw::Linear;
        let measured = SpringReport {
            penetration_asked_m: (asked && is_linear).then_some(laws.depth_m),
            out_of_reach: core.model.scene.restitution_out_of_reach(),
            ..SpringReport::default()
        };
        core.stated_depth_m = measured.penetration_asked_m.unwrap_or(f64::INFINITY);
        Self {
            springs: Vec::new(),
            proposed: vec![core.settings.step_s; states.len()],
            boxes: Boxes::new(core.settings.broad_phase, states.len()),
            islands: Vec::new(),
            laws,
            measured,
            states,
        }
    }

    /// The engine of a snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &mut Core, saved: &springs::Penalty) -> Result<Self, SnapshotError> {
        let bodies = core.model.bodies.len();
        if saved.proposed.len() != bodies || saved.laws.blows.len() != bodies {
            return Err(SnapshotError::Invalid("it does not have one length of step and one blow for each body"));
        }
        let springs: Result<Vec<_>, _> = saved.springs.iter().map(|one| restored_spring(&core.model, one)).collect();
        let engine = Self {
            states: read_states(&saved.states, bodies)?,
            springs: springs?,
            laws: restored_laws(core.settings.penalty, &saved.laws),
            proposed: saved.proposed.clone(),
            boxes: Boxes::new(core.settings.broad_phase, bodies),
            islands: saved.islands.clone(),
            measured: restored_report(&saved.measured),
        };
        core.accounts.books.contact_energy_j = energy(core, &engine.states, &engine.springs);
        core.stated_depth_m = engine.measured.penetration_asked_m.unwrap_or(f64::INFINITY);
        Ok(engine)
    }

    /// Advances all groups to `t_next` (s), or less far where bodies scatter too fast to say which may meet.
    fn longest_step(
        &mut self,
        core: &mut Core,
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        let mut t_next = t_next;
        let mut margins = Margins::new(core, &self.states, t_next - core.t);
        let mut rounds = 0;
        let runs = loop {
            let found = groups(core, &self.states, (&margins, t_next - core.t), &mut self.boxes)?;
            let runs = found.into_iter().map(|group| self.run(core, group, t_next));
            let runs = runs.collect::<Result<Vec<GroupRun>, _>>()?;
            if !margins.grow(core, &self.states, &runs) {
                break runs;
            }
            rounds += 1;
            if rounds > MOST_ROUNDS {
                t_next = 0.5 * (core.t + t_next);
                margins = Margins::new(core, &self.states, t_next - core.t);
                rounds = 0;
            }
        };
        self.emit_samples_within(core, &runs, t_next, observer)?;
        self.take(core, runs, t_next)?;
        core.accounts.emit_events(core.t, observer);
        Ok(())
    }

    /// One group to `t_next` (s).
    fn run(&self, core: &Core, group: Group, t_next: f64) -> Result<GroupRun, SimulationError> {
        let own = |spring: &&ContactSpring| {
            let is_member = |body: usize| group.bodies.binary_search(&body).is_ok();
            is_member(spring.id.a) || is_member(spring.id.b)
        };
        let springs: Vec<ContactSpring> = self.springs.iter().filter(own).copied().collect();
        let proposed = group.bodies.iter().map(|&body| self.proposed[body]).fold(core.settings.step_s, f64::min);
        let run = Run::new(core, &self.laws, (group, springs), &self.states, proposed);
        if fixed::is_fixed(core.settings.integrator) {
            fixed::advance(run, t_next)
        } else {
            stepping::advance(run, t_next)
        }
    }

    /// Takes over what the groups have done up to `t_next` (s).
    fn take(&mut self, core: &mut Core, runs: Vec<GroupRun>, t_next: f64) -> Result<(), SimulationError> {
        self.springs.clear();
        self.islands.clear();
        for run in runs {
            for (&body, end) in run.group.bodies.iter().zip(&run.ends) {
                self.states[body] = *end;
                self.proposed[body] = run.proposed_s;
            }
            self.springs.extend(run.springs);
            core.accounts.books.enter(&run.books);
            self.measured.append(&run.measured);
            run.events.into_iter().for_each(|event| core.accounts.add_event(event));
            for of in &run.separations {
                core.note_separation(of.t_s, &self.states, of.pair, (of.distance, of.rate));
            }
            for of in &run.projections {
                core.book_projection(of.t_s, &self.states, &of.done, of.balances);
            }
            (0..run.steps).for_each(|_| core.accounts.count_step());
            if let Some(error) = run.largest_error {
                core.accounts.note_step_error(error);
            }
            self.islands.push(run.group.bodies);
        }
        self.springs.sort_by_key(|spring| spring.id);
        prescribed::prescribe(&core.model, t_next, &mut self.states);
        turns::count_all_turns(&mut core.model, &self.states)?;
        core.t = t_next;
        core.accounts.books.contact_energy_j = energy(core, &self.states, &self.springs);
        core.accounts.observe(&core.model, &self.states, core.t)?;
        Ok(())
    }

    /// Gives the observer the samples before `t_next` (s).
    fn emit_samples_within(
        &mut self,
        core: &mut Core,
        runs: &[GroupRun],
        t_next: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        let (springs, energy_j) = (self.springs.clone(), core.accounts.books.contact_energy_j);
        let emitted = emit_samples_before(t_next, self, core, observer, |engine, core, t| {
            let mut states = engine.states.clone();
            engine.springs.clear();
            for run in runs {
                let Some(segment) = run.segments.iter().find(|segment| segment.holds(t)) else { continue };
                for (place, &body) in run.group.bodies.iter().enumerate() {
                    states[body] = segment.state(place, t);
                }
                engine.springs.extend(segment.springs_at(run.group.bodies.len(), t));
            }
            prescribed::prescribe(&core.model, t, &mut states);
            engine.springs.sort_by_key(|spring| spring.id);
            core.accounts.books.contact_energy_j = energy(core, &states, &engine.springs);
            Ok(Some(Arc::new(states)))
        });
        self.springs = springs;
        core.accounts.books.contact_energy_j = energy_j;
        emitted
    }
}

impl PenaltyEngine {
    /// What the springs do to each body in these states: N, and N m about its centre of mass.
    fn loads_of_springs(&self, core: &Core, states: &[BodyState]) -> Vec<(DVec3, DVec3)> {
        let model = &core.model;
        let mut loads = vec![(DVec3::ZERO, DVec3::ZERO); model.bodies.len()];
        for spring in &self.springs {
            let at = Evaluated::new(model, states, spring.id, spring.friction.is_some());
            let Some(at) = at else { continue };
            let force = spring.force(&at);
            for (body, sign) in [(spring.id.a, 1.0), (spring.id.b, -1.0)] {
                let on = force.on_a * sign;
                loads[body].0 += on;
                loads[body].1 += (at.point - states[body].pose.translation).cross(on) + force.moment * sign;
            }
        }
        loads
    }

    /// Reactions of all joints at `t` (s) in these states; none without joints.
    fn joint_reactions(
        &self,
        core: &Core,
        t: f64,
        states: &[BodyState],
    ) -> Result<Option<JointReactions>, ResponseError> {
        let model = &core.model;
        if !model.joints.has_rows() {
            return Ok(None);
        }
        let springs = self.loads_of_springs(core, states).into_iter().enumerate();
        let of_springs = springs.map(|(body, (force, moment))| (body, force, moment));
        let loads = model.loads(t, states).with(of_springs);
        let bodies: Vec<usize> = model.movable.iter().copied().filter(|&body| model.bodies[body].moves()).collect();
        JointReactions::solve(model, (t, states), &bodies, &loads).map(Some)
    }
}

/// Elastic energy of springs in these states, J.
fn energy(core: &Core, states: &[BodyState], springs: &[ContactSpring]) -> f64 {
    let own = |spring: &ContactSpring| {
        let at = Evaluated::new(&core.model, states, spring.id, spring.friction.is_some());
        at.map_or(0.0, |at| spring.energy(&at))
    };
    springs.iter().map(own).sum()
}

impl Segment {
    /// Whether a time (s) is within the step.
    fn holds(&self, t: f64) -> bool {
        let (t0, h) = (self.dense.t0(), self.dense.h());
        t >= t0 && t <= t0 + h
    }

    fn flat(&self, t: f64) -> Vec<f64> {
        let mut flat = vec![0.0; self.dense.dimension()];
        self.dense.evaluate(t, &mut flat);
        flat
    }

    /// The state of a body, by its place in the group.
    pub(super) fn state(&self, place: usize, t: f64) -> BodyState {
        let flat = self.flat(t);
        let numbers = flat.as_chunks::<WIDTH>().0.get(place);
        numbers.map_or_else(|| BodyState::at_rest(polhode_spatial::Pose::IDENTITY), BodyState::from_array)
    }

    /// The springs with their vectors at a time (s), of a group of so many bodies.
    fn springs_at(&self, bodies: usize, t: f64) -> Vec<ContactSpring> {
        let flat = self.flat(t);
        let numbers = flat.get(bodies * WIDTH..).unwrap_or_default().chunks(super::contact::SPRING);
        self.springs.iter().zip(numbers).map(|(spring, own)| spring.with_numbers(own)).collect()
    }
}

impl PenaltyEngine {
    /// Keeps some of the springs. The energy of the others is what a program takes away.
    fn keep_springs(&mut self, core: &mut Core, keep: impl Fn(ContactId, &Model) -> bool) {
        let before = core.accounts.books.contact_energy_j;
        self.springs.retain(|spring| keep(spring.id, &core.model));
        core.accounts.books.contact_energy_j = energy(core, &self.states, &self.springs);
        core.accounts.books.fields_changed(before, core.accounts.books.contact_energy_j);
    }
}

impl Tier for PenaltyEngine {
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError> {
        while core.t < limit_s {
            let end = core.horizon(core.t).min(limit_s);
            let h = core.settings.step_s;
            let t_next = if h >= end - core.t { end } else { core.t + h };
            self.longest_step(core, t_next, observer)?;
        }
        Ok(Reached::Limit)
    }

    fn stride(&self, core: &Core) -> f64 {
        core.settings.step_s
    }

    fn states(&self, _core: &Core) -> Vec<BodyState> {
        self.states.clone()
    }

    fn state(&self, _core: &Core, body: usize) -> BodyState {
        self.states[body]
    }

    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        let mut forces = self.loads_of_springs(core, &self.states);
        let reactions = self.joint_reactions(core, core.t, &self.states);
        let reactions = reactions.map_err(|source| SimulationError::of_response(core.t, source))?;
        for (bilateral, reaction) in reactions.iter().flat_map(JointReactions::reactions) {
            for (body, force, moment) in bilateral.loads(reaction) {
                forces[body].0 += force;
                forces[body].1 += moment;
            }
        }
        let model = &core.model;
        let load_of = |place: usize| forces.get(*model.movable.get(place)?).copied();
        Ok(accelerations_under(core, &self.states, load_of))
    }

    fn joint_loads(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<JointView> {
        let Ok(Some(found)) = self.joint_reactions(core, t, states) else { return Vec::new() };
        let assembly = found.assembly.with_supports(&core.model);
        let Ok(least) = assembly.least(&found.forces) else { return Vec::new() };
        joint_loads(&core.model, states, (&assembly, &least), std::iter::empty()).into_values().collect()
    }

    fn contacts(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<ContactView> {
        let mut boxes = Boxes::new(core.settings.broad_phase, states.len());
        for (body, state) in states.iter().enumerate().filter(|(body, _)| !core.model.bodies[*body].removed) {
            boxes.set(&core.model, body, &Still(state.pose), (t, t), 0.0);
        }
        let mut pairs = Vec::new();
        if boxes.all_pairs(&core.model, |a, b| pairs.push((a.min(b), a.max(b)))).is_err() {
            return Vec::new();
        }
        pairs.sort_unstable();
        let mut views = Vec::new();
        for (a, b) in pairs {
            let reach = tolerances::rounding(&core.model, states, a, b);
            for found in contact_set::contacts_of_pair(&core.model, states, a, b, reach) {
                let own = self.springs.iter().find(|spring| spring.id == found.id);
                let force = own.and_then(|spring| {
                    let at = Evaluated::new(&core.model, states, spring.id, spring.friction.is_some())?;
                    let force = spring.force(&at);
                    Some((force.normal, force.tangential))
                });
                contact_view::view_contact(
                    &core.model,
                    states,
                    &Touch::from(found),
                    force.unwrap_or_default(),
                    &mut views,
                );
            }
        }
        views
    }

    fn motions(&self, core: &Core) -> Vec<MotionKind> {
        let kind = |moves: bool| if moves { MotionKind::Integrated } else { MotionKind::Given };
        core.model.bodies.iter().map(|body| kind(body.moves())).collect()
    }

    fn islands(&self, core: &Core) -> Vec<IslandView> {
        let kept = |body: &usize| core.model.bodies[*body].moves();
        let islands = self.islands.iter().map(|bodies| bodies.iter().copied().filter(kept).map(BodyId::new).collect());
        islands.filter(|bodies: &Vec<BodyId>| !bodies.is_empty()).map(|bodies| IslandView { bodies }).collect()
    }

    fn states_mut(&mut self) -> &mut [BodyState] {
        &mut self.states
    }

    fn resume(&mut self, core: &mut Core, moved: &[usize]) -> Result<(), SimulationError> {
        // What springs hold when a program moves their bodies is the program's.
        let is_moved = |body: usize| moved.contains(&body);
        self.keep_springs(core, |contact, _| !is_moved(contact.a) && !is_moved(contact.b));
        Ok(())
    }

    fn change_joint(&mut self, core: &mut Core, pair: (usize, usize)) {
        self.keep_springs(core, |contact, model| (contact.a, contact.b) != pair || added::may_have(model, contact));
    }

    fn add_body(&mut self, core: &Core, state: BodyState) {
        self.states.push(state);
        self.laws.add_body(tolerances::point_speed(&core.model, &self.states, self.states.len() - 1));
        self.proposed.push(core.settings.step_s);
        self.boxes.make_room();
    }

    fn remove_body(&mut self, body: usize) {
        self.boxes.put(body, None);
        self.springs.retain(|spring| spring.id.a != body && spring.id.b != body);
    }

    fn touching_pairs(&self) -> usize {
        let mut pairs: Vec<(usize, usize)> = self.springs.iter().map(|spring| (spring.id.a, spring.id.b)).collect();
        pairs.dedup();
        pairs.len()
    }

    fn fill(&self, report: &mut RunReport) {
        report.springs = Some(self.measured.clone());
    }

    fn save(&self) -> content::Tier {
        content::Tier::Penalty(springs::Penalty {
            states: write_states(&self.states),
            springs: self.springs.iter().map(save_spring).collect(),
            laws: save_laws(&self.laws),
            proposed: self.proposed.clone(),
            islands: self.islands.clone(),
            measured: save_report(&self.measured),
        })
    }
}
